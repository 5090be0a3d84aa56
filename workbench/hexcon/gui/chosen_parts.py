# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where faces of a solid and named groups of a mesh lie, to be drawn: points and polygons of each by its name."""
import numpy as np

from hexcon.files.femmesh_contents import mesh_of_object
from hexcon.freecad_compat import shape_in_whole

SAG = 0.01      # of the solid's size: how far the triangles of a face may lie off it


class ChosenParts:
    """Each is looked at once it is asked for.

    solid        a document object, or None;  mesh_object  whose groups have names
    """

    def __init__(self, solid, mesh_object):
        self._solid, self._mesh_object, self._mesh, self._known = solid, mesh_object, None, {}

    def polygons(self, name):
        """(points (V,3), polygons (n,3|4)) of Face3, or of a group; of a group of nodes the quads that it covers."""
        if name not in self._known:
            number = int(name[4:]) if name.startswith("Face") and name[4:].isdigit() else 0
            self._known[name] = self._of_face(number) if number and self._solid is not None else self._of_group(name)
        return self._known[name]

    def _of_face(self, number):
        shape = shape_in_whole(self._solid)
        points, triangles = shape.Faces[number - 1].tessellate(SAG * shape.BoundBox.DiagonalLength)
        return np.array([tuple(point) for point in points]), np.array(triangles, int).reshape(-1, 3)

    def _of_group(self, name):
        if self._mesh is None:
            self._mesh = mesh_of_object(self._mesh_object)
        mesh, quads = self._mesh, self._mesh.quads[:, :4]
        if name in mesh.quad_groups:
            return mesh.points, quads[mesh.quad_groups[name]]
        if name.startswith("Face") and name[4:].isdigit():
            return mesh.points, quads[mesh.face_of_quad == int(name[4:])]
        return mesh.points, quads[np.isin(quads, mesh.node_groups.get(name, ())).all(axis=1)]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The inside of a hex mesh in the 3D view: whole hexes, coloured by scaled Jacobian."""
from hexcon.freecad_compat import DRAWN_BY_FEM, shape_of
from hexcon.inspection.opening import Opening
from hexcon.inspection.tessellation import edges_in_pieces, tessellated
from hexcon.pictures.palette import quality_colours

from .camera import look_at
from .colour_bar import colour_bar
from .drawing import Drawing, Drawings
from .nodes import Faces, edges_on_top

CHOSEN = (1.0, 0.0, 0.75)  # no scaled Jacobian's colour
CHOSEN_WIDTH = 4

drawings = Drawings()


class Inside(Drawing):
    """The drawing of one opened mesh.

    mesh        the InspectedMesh
    opening     the Opening that is seen;  kept (H,) bool: the hexes it leaves;  face_count: faces drawn of them
    element     the number of the hex that is outlined, or None
    """

    def __init__(self, mesh_object, mesh):
        super().__init__(mesh_object, _in_the_way_of(mesh_object))
        self.mesh = mesh
        self._colours = quality_colours(mesh.scaled_jacobian)
        self.faces = Faces()
        self.add(self.faces.node)
        self.add(colour_bar(mesh.quality.min))
        self._outline = self.element = None
        self.open(Opening())

    def open(self, opening):
        """See the mesh opened so."""
        self.kept = opening.keep(self.mesh)
        points, faces, hex_of_face = opening.drawn(self.mesh, self.kept)
        points, quads, face_of_quad, edges = tessellated(points, faces)
        self.faces.show(points, quads, self._colours[hex_of_face[face_of_quad]], edges)
        self.face_count = len(faces)
        self.opening = opening

    def choose(self, element):
        """Outline the hex with this number over everything else; None: no hex."""
        row = None if element is None else self.mesh.row_of(element)
        outline = None if row is None else edges_on_top(*edges_in_pieces(self.mesh.points[self.mesh.nodes[row]]),
                                                        CHOSEN, CHOSEN_WIDTH)
        self._outline = self.instead(self._outline, outline)
        self.element = element

    def zoom(self, element):
        """Move the camera to the hex with this number."""
        row = self.mesh.row_of(element)
        look_at(self.mesh_object.Document, self.mesh.points[self.mesh.hexes[row]])


def _in_the_way_of(mesh_object):
    """What is at the mesh's place: its solid and its quads, and the other meshes and results of its analysis."""
    near = {thing.Name: thing for thing in mesh_object.OutListRecursive}
    for analysis in mesh_object.InListRecursive:
        if analysis.isDerivedFrom("Fem::FemAnalysis"):
            near.update({thing.Name: thing for thing in analysis.OutListRecursive})
    return [thing for thing in near.values() if thing != mesh_object and (
        any(map(thing.isDerivedFrom, DRAWN_BY_FEM)) or shape_of(thing) is not None)]


def show(mesh_object, mesh, opening, element=None):
    """Draw the mesh of an object, an InspectedMesh, opened so, and outline a hex; returns the Inside."""
    # may raise: before the view is touched
    opening.keep(mesh)
    if element is not None:
        mesh.row_of(element)
    drawing = drawings.find(mesh_object) or drawings.put(mesh_object, lambda: Inside(mesh_object, mesh))
    drawing.open(opening)
    drawing.choose(element)
    return drawing

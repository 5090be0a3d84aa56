# SPDX-License-Identifier: LGPL-2.1-or-later
"""A FEM mesh object of hexes into a file of any format that files.write has; FreeCAD's own export knows fewer."""
from hexcon import files
from hexcon.judging.report import read_mesh_object


def export_hex_mesh(mesh_object, path, *, allow_topological=False):
    """Write a FEM mesh object made of hexes; the ending of path decides the format: hexcon.files.WRITERS.

    The whole boundary is written, its groups by the object's face groups Face1, Face2 ...; the document stays as it is.
    Raises ToolError: BAD_MESH for other elements, and those of files.write.
    """
    found = read_mesh_object(mesh_object)
    named = None if found.quads is None else (found.quads, found.face_of_quad)
    mesh = files.with_boundary(found.points, found.hexes, named)
    mesh.topological = found.topological
    files.write(mesh, path, allow_topological=allow_topological)

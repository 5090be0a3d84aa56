# SPDX-License-Identifier: LGPL-2.1-or-later
"""A FEM mesh object of hexes into a file of any format that files.write has; FreeCAD's own export knows fewer."""
from hexcon import files
from hexcon.femmesh.element_types import chosen_type
from hexcon.files.femmesh_contents import mesh_of_object


def export_hex_mesh(mesh_object, path, *, allow_topological=False):
    """Write a FEM mesh object made of hexes; the ending of path decides the format: hexcon.files.WRITERS.

    The whole boundary is written, with the object's groups of faces and nodes; the document stays as it is.
    Raises ToolError: BAD_MESH for other elements, and those of files.write.
    """
    mesh = mesh_of_object(mesh_object)
    chosen = chosen_type(mesh_object) if files.ending_of(path) == ".inp" else None
    files.write(mesh, path, allow_topological=allow_topological, **({"element": chosen} if chosen else {}))

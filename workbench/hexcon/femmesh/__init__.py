# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hex mesh to FEM: FemMesh, document object, nodes of CAD faces.

Importing this needs numpy alone; FreeCAD is imported by the calls that use it.
"""
from .convert import from_femmesh, to_femmesh
from .document import add_to_document
from .elements import elements_of

__all__ = ["add_to_document", "elements_of", "face_nodes", "from_femmesh", "to_femmesh"]


def face_nodes(mesh, face_number, order=None):
    """Sorted 0-based node ids on the 1-based CAD face, middle nodes included at order 2.

    Raises ToolError(BAD_OPTION) where the mesh has no such face."""
    return elements_of(mesh, order).nodes_of_face(face_number)

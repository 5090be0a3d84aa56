# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a FEM mesh object of hexes is worth: certified or not, and where not.

These are calls for macros; hexcon.gui.actions has them too.
"""
from hexcon.judging.report import CheckReport, check_mesh, read_mesh_object

from .prepared import taken

__all__ = ["CheckReport", "check_mesh", "check_mesh_object", "read_mesh_object"]


def check_mesh_object(mesh_object):
    """Certify a FEM mesh object made of hexes; returns a CheckReport.

    Changes nothing. Raises HexconError: ToolError(BAD_MESH) for other elements, and those of
    hexcon_native.certify.
    """
    return taken() or check_mesh(read_mesh_object(mesh_object))

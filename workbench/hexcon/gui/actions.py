# SPDX-License-Identifier: LGPL-2.1-or-later
"""Everything the window does, as calls that a macro or a batch script can make.

    import hexcon.gui.actions
    mesh = hexcon.gui.actions.mesh_solid_object(FreeCAD.ActiveDocument.Box, 2.5, order=2)
    print(hexcon.gui.actions.check_mesh_object(mesh))

Each is one undo step and all or nothing: on a HexconError the document is as it was.
"""
from hexcon.document.analyses import into_analysis, load_and_solve, show_displacement
from hexcon.document.checking import CheckReport, check_mesh_object
from hexcon.document.example_documents import EXAMPLES, open_example
from hexcon.document.exporting import export_hex_mesh
from hexcon.document.making_hexes import make_hex_mesh, make_quality_report, mesh_solid_object, update_hex_mesh
from hexcon.document.making_quads import default_size, import_quad_surface, make_quad_surface, update_quad_surface
from hexcon.document.repairing import repair_hex_mesh

from .looking import (
    hide_inside,
    hide_loops,
    inspect_mesh_object,
    loops_of_object,
    mark_hexes,
    show_inside,
    show_loops,
    zoom_to_hex,
)

__all__ = ["EXAMPLES", "CheckReport", "check_mesh_object", "default_size", "export_hex_mesh", "hide_inside",
           "hide_loops", "import_quad_surface", "inspect_mesh_object", "into_analysis", "load_and_solve", "loops_of_object",
           "make_hex_mesh", "make_quad_surface", "make_quality_report", "mark_hexes", "mesh_solid_object",
           "open_example", "repair_hex_mesh", "show_displacement", "show_inside", "show_loops", "update_hex_mesh", "update_quad_surface",
           "zoom_to_hex"]

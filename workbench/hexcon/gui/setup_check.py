# SPDX-License-Identifier: LGPL-2.1-or-later
"""What HexCon needs besides FreeCAD, whether it is there, and how to get it."""
import os
from dataclasses import dataclass

from hexcon import freecad_compat, preferences
from hexcon.calculix import find_ccx
from hexcon.errors import ToolError
from hexcon.gmsh_process import gmsh_python


@dataclass
class Finding:
    """One thing that is needed: its name, whether it is there, and where, or how to get it."""

    name: str
    present: bool
    words: str


def check_setup():
    """Findings for the native core, gmsh and CalculiX, in this order. Raises nothing."""
    import hexcon_native
    return [Finding("native core", True, os.path.dirname(hexcon_native.__file__)),
            _sought("gmsh", lambda: gmsh_python(
                os.environ.get("HEXCON_GMSH_PYTHON") or preferences.value("GmshPython") or None)),
            _sought("CalculiX", lambda: find_ccx(freecad_compat.ccx_preference()))]


def _sought(name, seek):
    try:
        return Finding(name, True, seek())
    except ToolError as fault:
        return Finding(name, False, str(fault))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the commands say where the native core is missing, and how it is built."""
import glob
import importlib
import os

import FreeCAD

from .message import show_message
from .place import ROOT

translate = FreeCAD.Qt.translate


def core_is_there():
    """True if the core can be used; otherwise the user has been told how to build it."""
    importlib.invalidate_caches()  # it may have been built a moment ago
    try:
        import hexcon.gui.actions  # noqa: F401  all that commands need, and the core below it
    except ImportError as fault:
        _tell(how_to_build(fault))
        return False
    return True


def how_to_build(fault):
    """Words for the user, of the ImportError that tells that the core is missing."""
    lines = [translate("HexCon", "HexCon cannot work yet: its native core is missing."), "",
             translate("HexCon", "Run the command"), "    make build",
             translate("HexCon", "in the folder"), f"    {ROOT}",
             translate("HexCon", "and try again.")]
    native = os.path.join(glob.escape(ROOT), "hexcon_native")
    if glob.glob(os.path.join(native, "_core*")) or glob.glob(os.path.join(native, "built", "*")):
        # one is there and does not load, or is of another system
        lines += ["", translate("HexCon", "Python says: {words}").format(
            words=fault.__cause__ or fault)]
    return "\n".join(lines)


def _tell(message):
    FreeCAD.Console.PrintError(message + "\n")
    show_message("HexConMissingCore", message)

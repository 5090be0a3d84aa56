# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calls that land in the macro recorder and may fail."""
import FreeCAD
import FreeCADGui

from . import actions


def run(call, arguments):
    """Result of hexcon.gui.actions.<call>(<arguments as text>); recorded if it succeeds.

    FreeCAD's doCommand would print a traceback for a fault that is to be told in words. So the
    call is made first, and what is recorded runs while its name stands for the result.
    """
    real = getattr(actions, call)
    result = eval(f"call({arguments})", {"call": real, "FreeCAD": FreeCAD})
    FreeCADGui.addModule("hexcon.gui.actions")
    setattr(actions, call, lambda *_, **__: result)
    try:
        FreeCADGui.doCommand(f"hexcon.gui.actions.{call}({arguments})")
    finally:
        setattr(actions, call, real)
    return result

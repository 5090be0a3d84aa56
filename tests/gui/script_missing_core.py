# SPDX-License-Identifier: LGPL-2.1-or-later
"""The addon without its native core: words, no traceback; once it is built, everything works.

The session ends by FreeCAD's own exit, in the middle of a meshing.
"""
import os
import shutil

import FreeCAD
import FreeCADGui
from PySide import QtGui
from session import find, gmsh_runs, is_idle, leave, mesh, open_panel, picture, run, select, settle, wait, words

ADDON, CORE = os.environ["HEXCON_TEST_ADDON"], os.environ["HEXCON_TEST_CORE"]


def message():
    settle()
    boxes = FreeCADGui.getMainWindow().findChildren(QtGui.QMessageBox, "HexConMissingCore")
    shown = [box for box in boxes if box.isVisible()]
    assert len(shown) < 2
    return shown[0] if shown else None


def activating_tells_how_to_build():
    FreeCADGui.activateWorkbench("HexConWorkbench")
    box = wait(message, "the message")
    assert "make build" in box.text() and ADDON in box.text(), box.text()
    assert not box.isModal()
    picture("missing_core.png")


def a_command_tells_it_too():
    doc = FreeCAD.newDocument("Missing")
    doc.addObject("Part::Box", "Box")
    doc.recompute()
    select(doc.Box)
    FreeCADGui.runCommand("HexCon_MeshSolid")
    box = wait(message, "the message")
    assert "make build" in box.text()
    assert not FreeCADGui.Control.activeDialog()
    box.close()
    wait(lambda: not message(), "the message to go")


def once_built_it_works_without_a_restart():
    shutil.copy(CORE, os.path.join(ADDON, "hexcon_native"))
    open_panel("HexCon_MeshSolid")
    mesh(5.0)
    wait(is_idle, "the box to be meshed")
    assert "certified:" in words() and not message()


def freecad_may_close_while_it_works():
    mesh(0.05)
    wait(gmsh_runs, "gmsh")
    assert find(QtGui.QProgressBar, "progress").isVisible()


run(activating_tells_how_to_build, a_command_tells_it_too, once_built_it_works_without_a_restart,
    freecad_may_close_while_it_works, end=leave)

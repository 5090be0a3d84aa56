# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the menu of an object in the tree offers: the steps that can follow, and making it anew."""
import sys

import FreeCAD
import FreeCADGui
from PySide import QtGui

from .icons import icon_path

translate = FreeCAD.Qt.translate

# Commands by what an object is, in the order of the work.
OF_SURFACE = ("HexCon_HexMesh", "HexCon_Loops")
OF_MESH = ("HexCon_Inspect", "HexCon_Solve", "HexCon_Export", "HexCon_Check", "HexCon_Quality", "HexCon_Repair")


def add_entries(menu, obj, names, panel=None):
    """Entries above those of FreeCAD for commands by name, about obj alone.

    menu   the QMenu that FreeCAD hands to a view provider
    panel  function: a task panel that makes obj anew, for an entry that does so with its settings; None: no such entry
    """
    sys.modules["hexcon_gui_commands"].register()       # of InitGui.py; FEM may have been shown alone
    first = menu.actions()[0] if menu.actions() else None

    def add(name, icon, text, call):
        entry = QtGui.QAction(QtGui.QIcon(icon_path(icon)), text, menu)
        entry.setObjectName(name)
        entry.setEnabled(not FreeCADGui.Control.activeDialog())
        entry.triggered.connect(lambda *_: call())
        menu.insertAction(first, entry)     # None: at the end

    if panel:
        add("HexCon_Update", "HexCon_Update", translate("HexCon", "Update"), lambda: _update(panel()))
    for name in names:
        text = FreeCAD.Qt.translate(name, FreeCADGui.Command.get(name).getInfo()["menuText"])
        add(name, name, text.replace("&", ""), lambda name=name: _run(obj, name))
    if first is not None:
        menu.insertSeparator(first)


def _run(obj, name):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(obj.Document.Name, obj.Name)
    FreeCADGui.runCommand(name)


def _update(panel):
    """In the open panel, for its progress and its words."""
    FreeCADGui.Control.showDialog(panel)
    panel.start()

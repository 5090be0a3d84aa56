# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands in FreeCAD: its toolbars and menus, the FEM workbench, the preferences."""
import os

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .examples import EXAMPLES, Examples
from .place import ROOT
from .preferences import PreferencesPage
from .recorded import Export, Import, IntoAnalysis, Quality, Repair
from .selection import is_ours, selected_solid
from .with_panel import Check, HexMesh, Inspect, Loops, MeshSolid, QuadSurface, Solve

COMMANDS = (Examples(), QuadSurface(), Import(), HexMesh(), MeshSolid(), Check(), Inspect(), Loops(),
            Quality(), Repair(), Export(), IntoAnalysis(), Solve())
NAMES = [command.name for command in COMMANDS]
_registered = []


def register():
    """Make the commands known to FreeCAD, once; returns their names."""
    # FreeCAD takes the file that calls addCommand for a module, and writes "import <its name>"
    # into every macro that runs the command: "import commands" would be there for nobody
    add = compile("add(command.name, command)", os.path.join(ROOT, "workbench", "hexcon"), "exec")
    for command in () if _registered else EXAMPLES + COMMANDS:
        exec(add, {"add": FreeCADGui.addCommand, "command": command})
        _registered.append(command.name)
    return NAMES


def in_context_menu():
    """Names of the commands for what is selected, where no view provider of ours offers them."""
    selected = FreeCADGui.Selection.getSelection()
    if len(selected) != 1 or is_ours(selected[0]):
        return []
    offered = (MeshSolid, QuadSurface) if selected_solid() else (Inspect, Solve, Export, Check, Quality, Repair)
    return [command.name for command in offered if command.selected() is not None]


def add_menu_to_fem(workbench):
    """HexCon's menu in FreeCAD's FEM workbench, each time that is shown.

    FreeCAD 0.20 has no call for this (addWorkbenchManipulator came later), and makes its menus
    anew with every change of the workbench.
    """
    bar = FreeCADGui.getMainWindow().menuBar()
    for action in bar.actions():
        if action.objectName() == "HexConInFem":
            bar.removeAction(action)
    group = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/HexCon")
    if workbench != "FemWorkbench" or not group.GetBool("FemMenu", True):
        return
    register()
    menu = bar.addMenu("HexCon")
    menu.menuAction().setObjectName("HexConInFem")
    for command in COMMANDS:
        _add_entry(menu, command)


def _add_entry(menu, command):
    """A command's entry; of a group, a menu of its members.

    Entries of our own: FreeCAD has none before a command's first toolbar is there, and those of a group are its
    members'.
    """
    said = command.GetResources()
    icon, text = QtGui.QIcon(said["Pixmap"]), FreeCAD.Qt.translate(command.name, said["MenuText"])
    if hasattr(command, "members"):
        inner = menu.addMenu(icon, text)
        for member in command.members:
            _add_entry(inner, member)
        return
    entry = menu.addAction(icon, text)
    entry.setObjectName(command.name)   # as FreeCAD names those of its own menus
    entry.setToolTip(FreeCAD.Qt.translate(command.name, said["ToolTip"]))
    entry.triggered.connect(lambda *_: FreeCADGui.runCommand(command.name))
    menu.aboutToShow.connect(lambda: entry.setEnabled(bool(command.IsActive())))


def join_freecad():
    """At FreeCAD's start: the preferences page, and the menu in the FEM workbench."""
    FreeCADGui.addIconPath(os.path.join(ROOT, "resources", "icons"))
    FreeCADGui.addLanguagePath(os.path.join(ROOT, "resources", "translations"))
    FreeCADGui.addPreferencePage(PreferencesPage, "HexCon")
    window = FreeCADGui.getMainWindow()
    window.workbenchActivated.connect(add_menu_to_fem)
    window.workbenchActivated.connect(_watch_menus)


def _watch_menus(*_):
    """F1 on an entry of HexCon's menus opens the command's page; FreeCAD makes its menus anew with each workbench."""
    for menu in FreeCADGui.getMainWindow().menuBar().findChildren(QtGui.QMenu):
        if menu.title().replace("&", "") == "HexCon" and not menu.property("hexcon_help"):
            menu.setProperty("hexcon_help", True)
            menu.aboutToShow.connect(lambda menu=menu: _watch(menu))


def _watch(menu):
    if menu.findChild(QtCore.QObject, "HexConHelpKey") is None:
        try:
            from hexcon.gui.help_page import HelpKey
        except ImportError:     # the core is missing
            return
        key = HelpKey(menu, lambda: _command_of(menu.activeAction()))
        key.setObjectName("HexConHelpKey")
        key.watch(menu)


def _command_of(action):
    """The name of an entry's command; None where it is none of ours."""
    name = action.objectName() if action else ""
    return name if name.startswith("HexCon_") else None

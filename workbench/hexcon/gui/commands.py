# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench, and what they say where the native core is missing.

InitGui.py loads this file by its path, outside the package hexcon: it imports nothing of HexCon
before a command runs.
"""
import glob
import importlib
import os

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
translate = FreeCAD.Qt.translate

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(
    os.path.abspath(__file__)))))


# -------------------------------------------------------------------------------- the native core

def core_is_there():
    """True if the core can be used; otherwise the user has been told how to build it."""
    importlib.invalidate_caches()  # it may have been built a moment ago
    try:
        import hexcon.gui.actions  # noqa: F401  all that commands need, and the core below it
    except ImportError as fault:
        _tell(_how_to_build(fault))
        return False
    return True


def _how_to_build(fault):
    lines = [translate("HexCon", "HexCon cannot work yet: its native core is missing."), "",
             translate("HexCon", "Run the command"), "    make build",
             translate("HexCon", "in the folder"), f"    {ROOT}",
             translate("HexCon", "and try again.")]
    if glob.glob(os.path.join(glob.escape(ROOT), "hexcon_native", "_core*")):
        # it is there and does not load: only Python knows why
        lines += ["", translate("HexCon", "Python says: {words}").format(
            words=fault.__cause__ or fault)]
    return "\n".join(lines)


def _tell(message):
    FreeCAD.Console.PrintError(message + "\n")
    window = FreeCADGui.getMainWindow()
    # one box at a time, and one that stops nothing: FreeCAD may be starting up
    for old in window.findChildren(QtGui.QMessageBox, "HexConMissingCore"):
        old.close()
    box = QtGui.QMessageBox(QtGui.QMessageBox.Warning, "HexCon", message,
                            QtGui.QMessageBox.Ok, window)
    box.setObjectName("HexConMissingCore")
    box.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    box.setAttribute(QtCore.Qt.WA_DeleteOnClose)
    box.setWindowModality(QtCore.Qt.NonModal)
    box.show()


# -------------------------------------------------------------------------------------- selection

def _selected():
    """(object, names of its selected parts) if exactly one object is selected, else (None, ())."""
    selection = FreeCADGui.Selection.getSelectionEx()
    if len(selection) != 1 or selection[0].Object is None:
        return None, ()
    return selection[0].Object, selection[0].SubElementNames


def _finished_body(feature):
    """The PartDesign body whose result this feature is, or the object itself."""
    parent = feature.getParentGeoFeatureGroup()
    is_tip = getattr(parent, "Tip", None) == feature
    return parent if is_tip and parent.isDerivedFrom("PartDesign::Body") else feature


def selected_solid():
    """The one selected object with exactly one solid (or one face of it is selected), or None."""
    found, parts = _selected()
    if found is None or len(parts) > 1 or not all(part.startswith("Face") for part in parts):
        return None
    found = _finished_body(found)
    solids = getattr(getattr(found, "Shape", None), "Solids", ())
    return found if len(solids) == 1 else None


def selected_hex_mesh():
    """The one selected FEM mesh object that holds hexes, or None."""
    found, _ = _selected()
    if found is None or not found.isDerivedFrom("Fem::FemMeshObject"):
        return None
    return found if found.FemMesh.HexaCount else None


def selected_quads():
    """The one selected FEM mesh object that has quads, if only on the outside of its hexes, or None."""
    found, _ = _selected()
    if found is None or not found.isDerivedFrom("Fem::FemMeshObject"):
        return None
    return found if found.FemMesh.QuadrangleCount or found.FemMesh.HexaCount else None


# --------------------------------------------------------------------------------------- commands

class _Command:
    """What the commands share: a panel for the one selected object."""

    name = menu_text = tool_tip = icon = ""
    selected = None  # function: the object the command is for, or None
    panel = None     # function of that object: a task panel, imported as late as this

    def GetResources(self):
        return {"MenuText": self.menu_text, "ToolTip": self.tool_tip,
                "Pixmap": os.path.join(ROOT, "resources", "icons", self.icon)}

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog() and self.selected() is not None

    def Activated(self):
        if core_is_there():
            FreeCADGui.Control.showDialog(self.panel(self.selected()))


class MeshSolid(_Command):
    """Opens the panel that meshes the selected solid."""

    name = "HexCon_MeshSolid"
    menu_text = QT_TRANSLATE_NOOP("HexCon_MeshSolid", "Hex mesh from solid")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_MeshSolid", "Fill the selected solid with certified hexahedra for the FEM "
        "workbench: select one object with one solid, or a face of it")
    icon = "HexCon_MeshSolid.svg"
    selected = staticmethod(selected_solid)

    def panel(self, solid):
        from hexcon.gui.mesh_panel import MeshPanel
        return MeshPanel(solid)


class Check(_Command):
    """Certifies the selected mesh and shows where it is not valid."""

    name = "HexCon_Check"
    menu_text = QT_TRANSLATE_NOOP("HexCon_Check", "Certify hex mesh")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_Check", "Prove that every hexahedron of the selected FEM mesh is valid, or show "
        "those that are not")
    icon = "HexCon_Check.svg"
    selected = staticmethod(selected_hex_mesh)

    def panel(self, mesh_object):
        from hexcon.gui.check_panel import CheckPanel
        return CheckPanel(mesh_object)


class Inspect(_Command):
    """Opens the selected mesh, coloured by the quality of its hexes."""

    name = "HexCon_Inspect"
    menu_text = QT_TRANSLATE_NOOP("HexCon_Inspect", "Inspect hex mesh")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_Inspect", "Look into the selected FEM mesh: cut it, peel layers off, see the scaled "
        "Jacobians and the worst hexahedra")
    icon = "HexCon_Inspect.svg"
    selected = staticmethod(selected_hex_mesh)

    def panel(self, mesh_object):
        from hexcon.gui.inspect_panel import InspectPanel
        return InspectPanel(mesh_object)


class Loops(_Command):
    """Draws the dual loops of the selected mesh's surface."""

    name = "HexCon_Loops"
    menu_text = QT_TRANSLATE_NOOP("HexCon_Loops", "Show dual loops")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_Loops", "Draw the dual loops of the selected quad surface, or of the boundary of the "
        "selected hex mesh, and where they cross themselves")
    icon = "HexCon_Loops.svg"
    selected = staticmethod(selected_quads)

    def panel(self, mesh_object):
        from hexcon.gui.loops_panel import LoopsPanel
        return LoopsPanel(mesh_object)


def register():
    """Make the commands known to FreeCAD; returns their names."""
    commands = (MeshSolid(), Check(), Inspect(), Loops())
    # FreeCAD takes the file that calls addCommand for a module, and writes "import <its name>"
    # into every macro that runs the command: "import commands" would be there for nobody
    add = compile("add(command.name, command)", os.path.join(ROOT, "workbench", "hexcon"), "exec")
    for command in commands:
        exec(add, {"add": FreeCADGui.addCommand, "command": command})
    return [command.name for command in commands]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands without a panel: each is one call that the macro recorder keeps."""
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .message import show_message
from .missing_core import core_is_there
from .selection import selected_hex_mesh
from .with_panel import PanelCommand

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


def run_recorded(call, arguments):
    """One call of hexcon.gui.actions, kept by the macro recorder; its fault told in words."""
    from hexcon.gui import recording, work
    QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    try:
        recording.run(call, arguments)
    except Exception as error:
        fault = str(work.in_words(error))
    else:
        return
    finally:
        QtGui.QApplication.restoreOverrideCursor()
    FreeCAD.Console.PrintError(f"HexCon: {fault}\n")
    show_message("HexConFault", fault)


class CallCommand(PanelCommand):
    """A command without a panel: one recorded call about the selected hex mesh."""

    call = ""  # a name in hexcon.gui.actions
    selected = staticmethod(selected_hex_mesh)

    def Activated(self):
        if core_is_there():
            thing = self.selected()
            run_recorded(self.call, f"FreeCAD.ActiveDocument.getObject({thing.Name!r})")


class Quality(CallCommand):
    """Makes a quality report about the selected mesh."""

    name, call = "HexCon_Quality", "make_quality_report"
    keys = "H, R"
    menu_text = QT_TRANSLATE_NOOP("HexCon_Quality", "Quality report")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_Quality", "An object with the least, 5 % and mean scaled Jacobian of the selected FEM "
        "mesh, its worst elements and its certificate; it follows the mesh")


class Repair(CallCommand):
    """Makes a repaired mesh beside the selected one."""

    name, call = "HexCon_Repair", "repair_hex_mesh"
    keys = "H, F"
    menu_text = QT_TRANSLATE_NOOP("HexCon_Repair", "Repair hex mesh")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_Repair", "Another mesh beside the selected one: hexes in reversed node order turned, unused points "
        "dropped, inverted hexes untangled; its boundary and groups stay")


class IntoAnalysis(CallCommand):
    """Puts the selected mesh into an analysis."""

    name, call = "HexCon_IntoAnalysis", "into_analysis"
    keys = "H, N"
    menu_text = QT_TRANSLATE_NOOP("HexCon_IntoAnalysis", "Into analysis")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_IntoAnalysis", "Put the selected hex mesh into the active analysis of the FEM workbench, "
        "or make one with a CalculiX solver, steel, and constraints to fill in")


class Export(PanelCommand):
    """Writes the selected mesh into a file."""

    name = "HexCon_Export"
    keys = "H, E"
    menu_text = QT_TRANSLATE_NOOP("HexCon_Export", "Export hex mesh")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_Export", "Write the selected hex mesh, with its face groups, into a file for a solver or another "
        "program: CalculiX, Nek5000, SPECFEM3D, Exodus, gmsh, VTK ...")
    selected = staticmethod(selected_hex_mesh)

    def Activated(self):
        if core_is_there():
            from hexcon.gui.mesh_files import choose_export
            mesh = self.selected()
            path = choose_export(mesh, translate(self.name, self.menu_text))
            if path:
                run_recorded("export_hex_mesh", f"FreeCAD.ActiveDocument.getObject({mesh.Name!r}), {path!r}")


class Import(PanelCommand):
    """Reads quads from a file."""

    name = "HexCon_Import"
    keys = "H, O"
    menu_text = QT_TRANSLATE_NOOP("HexCon_Import", "Import quad surface")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_Import", "Read the quads of a mesh file, of gmsh, Abaqus, Nastran, Medit, VTK and other programs")

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog()

    def Activated(self):
        if core_is_there():
            from hexcon.gui.mesh_files import choose_import
            path = choose_import(translate(self.name, self.menu_text))
            if path:
                run_recorded("import_quad_surface", repr(path))

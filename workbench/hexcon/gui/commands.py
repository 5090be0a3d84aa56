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
    show_message("HexConMissingCore", message)


def show_message(name, message):
    """A box with the words that stops nobody; the older one of the same name goes."""
    for old in FreeCADGui.getMainWindow().findChildren(QtGui.QMessageBox, name):
        old.close()
    box = QtGui.QMessageBox(QtGui.QMessageBox.Warning, "HexCon", message, QtGui.QMessageBox.Ok,
                            FreeCADGui.getMainWindow())
    box.setObjectName(name)
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


def _selected_mesh_source():
    """The one selected object to take quads from: a solid, or a FEM mesh."""
    found, _ = _selected()
    if found is not None and found.isDerivedFrom("Fem::FemMeshObject"):
        return None if _has(found, "SelfCrossings") else found
    return selected_solid()


def _has(thing, name):
    """Whether the object has this property, which tells our kinds apart without the core."""
    return thing is not None and name in thing.PropertiesList


def selected_quad_surface():
    """The one selected quad surface object, or None."""
    found, _ = _selected()
    return found if _has(found, "SelfCrossings") else None


class QuadSurface(_Command):
    """Opens the panel that meshes the surface of the selected solid with quads."""

    name = "HexCon_QuadSurface"
    menu_text = QT_TRANSLATE_NOOP("HexCon_QuadSurface", "Quad surface")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_QuadSurface", "Mesh the surface of the selected solid with quads, or take the quads "
        "of the selected FEM mesh; see them before they are made")
    icon = "HexCon_QuadSurface.svg"
    selected = staticmethod(_selected_mesh_source)

    def panel(self, source):
        from hexcon.gui.surface_panel import SurfacePanel
        return SurfacePanel(source)


class HexMesh(_Command):
    """Opens the panel that fills the selected quad surface."""

    name = "HexCon_HexMesh"
    menu_text = QT_TRANSLATE_NOOP("HexCon_HexMesh", "Hex mesh from quads")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_HexMesh", "Fill the selected quad surface with certified hexahedra whose boundary is "
        "exactly its quads")
    icon = "HexCon_HexMesh.svg"
    selected = staticmethod(selected_quad_surface)

    def panel(self, surface):
        from hexcon.gui.hex_mesh_panel import HexMeshPanel
        return HexMeshPanel(surface)


class Solve(_Command):
    """Opens the panel that holds, loads and solves."""

    name = "HexCon_Solve"
    menu_text = QT_TRANSLATE_NOOP("HexCon_Solve", "Hold, load and solve")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_Solve", "Click a face that is held and one that is loaded; CalculiX solves, and the "
        "displacements are shown")
    icon = "HexCon_Solve.svg"
    selected = staticmethod(selected_hex_mesh)

    def panel(self, mesh_object):
        from hexcon.gui.load_panel import LoadPanel
        return LoadPanel(mesh_object)


class _Call(_Command):
    """A command without a panel: one recorded call about the selected object."""

    call = ""  # a name in hexcon.gui.actions

    def Activated(self):
        if core_is_there():
            thing = self.selected()
            run_recorded(self.call, f"FreeCAD.ActiveDocument.getObject({thing.Name!r})")


class Quality(_Call):
    """Makes a quality report about the selected mesh."""

    name, call, icon = "HexCon_Quality", "make_quality_report", "HexCon_Quality.svg"
    menu_text = QT_TRANSLATE_NOOP("HexCon_Quality", "Quality report")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_Quality", "An object with the least, 5 % and mean scaled Jacobian of the selected FEM "
        "mesh, its worst elements and its certificate; it follows the mesh")
    selected = staticmethod(selected_hex_mesh)


class IntoAnalysis(_Call):
    """Puts the selected mesh into an analysis."""

    name, call, icon = "HexCon_IntoAnalysis", "into_analysis", "HexCon_IntoAnalysis.svg"
    menu_text = QT_TRANSLATE_NOOP("HexCon_IntoAnalysis", "Into analysis")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_IntoAnalysis", "Put the selected hex mesh into the active analysis of the FEM workbench, "
        "or make one with a CalculiX solver, steel, and constraints to fill in")
    selected = staticmethod(selected_hex_mesh)


class Import(_Command):
    """Reads quads from a file."""

    name, icon = "HexCon_Import", "HexCon_Import.svg"
    menu_text = QT_TRANSLATE_NOOP("HexCon_Import", "Import quad surface")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_Import", "Read the quads of a mesh file: .msh .inp .unv .vtk .vtu .obj .mesh")

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog()

    def Activated(self):
        if core_is_there():
            from hexcon.quads.files import MESH_ENDINGS
            endings = " ".join(f"*{ending}" for ending in MESH_ENDINGS)
            path, _ = QtGui.QFileDialog.getOpenFileName(
                FreeCADGui.getMainWindow(), translate("HexCon", self.menu_text), "",
                translate("HexCon", "Meshes ({endings})").format(endings=endings))
            if path:
                run_recorded("import_quad_surface", repr(path))


class Example(_Command):
    """Opens one example in a document of its own."""

    def __init__(self, key, title):
        self.key, self.name, self.menu_text, self.tool_tip = key, f"HexCon_Example_{key}", title, title
        self.icon = "HexCon_Examples.svg"

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog()

    def Activated(self):
        if core_is_there():
            run_recorded("open_example", repr(self.key))


# Names as hexcon.gui.example_documents.EXAMPLES has them: the menu must be there without the core.
EXAMPLES = (
    Example("box", QT_TRANSLATE_NOOP("HexCon_Examples", "Box")),
    Example("wedge", QT_TRANSLATE_NOOP("HexCon_Examples", "Wedge")),
    Example("bracket", QT_TRANSLATE_NOOP("HexCon_Examples", "Bracket")),
    Example("shaft_segment", QT_TRANSLATE_NOOP("HexCon_Examples", "Shaft segment")),
    Example("schneiders", QT_TRANSLATE_NOOP("HexCon_Examples", "Schneiders' pyramid, 16 quads")),
    Example("octahedron", QT_TRANSLATE_NOOP("HexCon_Examples", "Quadrilateral octahedron, 8 quads")),
    Example("eppstein-16", QT_TRANSLATE_NOOP("HexCon_Examples", "Eppstein's cube, 16 quads")),
    Example("eppstein-18", QT_TRANSLATE_NOOP("HexCon_Examples", "Eppstein's cube, 18 quads")),
    Example("eppstein-20", QT_TRANSLATE_NOOP("HexCon_Examples", "Eppstein's cube, 20 quads")),
    Example("eppstein-22", QT_TRANSLATE_NOOP("HexCon_Examples", "Eppstein's cube, 22 quads")),
)


class Examples:
    """The examples behind one button."""

    name = "HexCon_Examples"

    def GetResources(self):
        return {"MenuText": QT_TRANSLATE_NOOP("HexCon_Examples", "Examples"),
                "ToolTip": QT_TRANSLATE_NOOP("HexCon_Examples", "Open a part or a surface of the "
                                             "literature in a document of its own"),
                "Pixmap": os.path.join(ROOT, "resources", "icons", "HexCon_Examples.svg")}

    def GetCommands(self):
        return tuple(example.name for example in EXAMPLES)

    def GetDefaultCommand(self):
        return 0

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog()


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


# ---------------------------------------------------------------------------- preferences and FEM

class PreferencesPage:
    """FreeCAD's preferences show this; without the core it says how to build it."""

    def __init__(self, parent=None):
        self.form = QtGui.QWidget()
        self._load = self._save = lambda: None
        try:
            from hexcon.gui.preferences_page import build
        except ImportError as fault:
            QtGui.QVBoxLayout(self.form).addWidget(QtGui.QLabel(_how_to_build(fault)))
        else:
            self._load, self._save = build(self.form)

    def loadSettings(self):
        self._load()

    def saveSettings(self):
        self._save()


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
    for name in NAMES:
        menu.addActions(FreeCADGui.Command.get(name).getAction()[:1])


def join_freecad():
    """At FreeCAD's start: the preferences page, and the menu in the FEM workbench."""
    FreeCADGui.addIconPath(os.path.join(ROOT, "resources", "icons"))
    FreeCADGui.addLanguagePath(os.path.join(ROOT, "resources", "translations"))
    FreeCADGui.addPreferencePage(PreferencesPage, "HexCon")
    window = FreeCADGui.getMainWindow()
    window.workbenchActivated.connect(add_menu_to_fem)


COMMANDS = (Examples(), QuadSurface(), Import(), HexMesh(), MeshSolid(), Check(), Inspect(), Loops(),
            Quality(), IntoAnalysis(), Solve())
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

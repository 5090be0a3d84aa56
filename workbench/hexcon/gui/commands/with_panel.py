# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that open a task panel about the selected object.

Each imports its panel when it runs: the command is there without the core, its panel is not.
"""
import FreeCAD
import FreeCADGui

from .missing_core import core_is_there
from .place import icon_path
from .selection import selected_hex_mesh, selected_mesh_source, selected_quad_surface, selected_quads, selected_solid

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class PanelCommand:
    """What they share: a panel for the one selected object."""

    name = menu_text = tool_tip = ""
    keys = ""        # one after the other, as FreeCAD's own: H stands for hexes
    icon = ""        # of another name than the command
    selected = None  # function: the object the command is for, or None
    panel = None     # function of that object: a task panel, imported as late as this

    def GetResources(self):
        return {"MenuText": self.menu_text, "ToolTip": self.tool_tip, "Accel": self.keys,
                "Pixmap": icon_path(self.icon or f"{self.name}.svg")}

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog() and self.selected() is not None

    def Activated(self):
        if core_is_there():
            FreeCADGui.Control.showDialog(self.panel(self.selected()))


class MeshSolid(PanelCommand):
    """Opens the panel that meshes the selected solid."""

    name = "HexCon_MeshSolid"
    keys = "H, M"
    menu_text = QT_TRANSLATE_NOOP("HexCon_MeshSolid", "Hex mesh from solid")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_MeshSolid", "Fill the selected solid with certified hexahedra for the FEM "
        "workbench: select one object with one solid, or a face of it")
    selected = staticmethod(selected_solid)

    def panel(self, solid):
        from hexcon.gui.mesh_panel import MeshPanel
        return MeshPanel(solid)


class Check(PanelCommand):
    """Certifies the selected mesh and shows where it is not valid."""

    name = "HexCon_Check"
    keys = "H, C"
    menu_text = QT_TRANSLATE_NOOP("HexCon_Check", "Certify hex mesh")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_Check", "Prove that every hexahedron of the selected FEM mesh is valid, or show "
        "those that are not")
    selected = staticmethod(selected_hex_mesh)

    def panel(self, mesh_object):
        from hexcon.gui.check_panel import CheckPanel
        return CheckPanel(mesh_object)


class Inspect(PanelCommand):
    """Opens the selected mesh, coloured by the quality of its hexes."""

    name = "HexCon_Inspect"
    keys = "H, I"
    menu_text = QT_TRANSLATE_NOOP("HexCon_Inspect", "Inspect hex mesh")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_Inspect", "Look into the selected FEM mesh: cut it, peel layers off, see the scaled "
        "Jacobians and the worst hexahedra")
    selected = staticmethod(selected_hex_mesh)

    def panel(self, mesh_object):
        from hexcon.gui.inspect_panel import InspectPanel
        return InspectPanel(mesh_object)


class Loops(PanelCommand):
    """Draws the dual loops of the selected mesh's surface."""

    name = "HexCon_Loops"
    keys = "H, L"
    menu_text = QT_TRANSLATE_NOOP("HexCon_Loops", "Show dual loops")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_Loops", "Draw the dual loops of the selected quad surface, or of the boundary of the "
        "selected hex mesh, and where they cross themselves")
    selected = staticmethod(selected_quads)

    def panel(self, mesh_object):
        from hexcon.gui.loops_panel import LoopsPanel
        return LoopsPanel(mesh_object)


class QuadSurface(PanelCommand):
    """Opens the panel that meshes the surface of the selected solid with quads."""

    name = "HexCon_QuadSurface"
    keys = "H, Q"
    menu_text = QT_TRANSLATE_NOOP("HexCon_QuadSurface", "Quad surface")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_QuadSurface", "Mesh the surface of the selected solid with quads, or take the quads "
        "of the selected FEM mesh; see them before they are made")
    selected = staticmethod(selected_mesh_source)

    def panel(self, source):
        from hexcon.gui.surface_panel import SurfacePanel
        return SurfacePanel(source)


class HexMesh(PanelCommand):
    """Opens the panel that fills the selected quad surface."""

    name = "HexCon_HexMesh"
    keys = "H, H"
    menu_text = QT_TRANSLATE_NOOP("HexCon_HexMesh", "Hex mesh from quads")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_HexMesh", "Fill the selected quad surface with certified hexahedra whose boundary is "
        "exactly its quads")
    selected = staticmethod(selected_quad_surface)

    def panel(self, surface):
        from hexcon.gui.hex_mesh_panel import HexMeshPanel
        return HexMeshPanel(surface)


class Solve(PanelCommand):
    """Opens the panel that holds, loads and solves."""

    name = "HexCon_Solve"
    keys = "H, S"
    menu_text = QT_TRANSLATE_NOOP("HexCon_Solve", "Hold, load and solve")
    tool_tip = QT_TRANSLATE_NOOP(
        "HexCon_Solve", "Click a face that is held and one that is loaded; CalculiX solves, and the "
        "displacements are shown")
    selected = staticmethod(selected_hex_mesh)

    def panel(self, mesh_object):
        from hexcon.gui.load_panel import LoadPanel
        return LoadPanel(mesh_object)

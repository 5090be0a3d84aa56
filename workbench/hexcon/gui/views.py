# SPDX-License-Identifier: LGPL-2.1-or-later
"""View providers: icons that tell when an object is not up to date, and a panel on double click.

Saved documents name these classes: never rename or move them.
"""
import FreeCADGui

from .icons import icon_path


class _View:
    """What the view providers share. icon: without ending; "_fault" is added where needed."""

    icon = ""

    def __init__(self, view):
        view.Proxy = self
        self.attach(view)

    def attach(self, view):
        self.object = view.Object

    def getIcon(self):
        obj = getattr(self, "object", None)
        status = getattr(obj, "Status", "Up to date") if obj is not None else "Up to date"
        kind = "" if status == "Up to date" else "_fault"
        return icon_path(self.icon + kind)

    def updateData(self, obj, name):
        if name == "Status" and getattr(obj, "ViewObject", None) is not None:
            obj.ViewObject.signalChangeIcon()

    def doubleClicked(self, view):
        if not FreeCADGui.Control.activeDialog():
            FreeCADGui.Control.showDialog(self.panel(view.Object))
        return True

    def setEdit(self, view, mode=0):
        """Only by the menu's Edit; the panel needs none of FreeCAD's edit mode, so it is not entered."""
        self.doubleClicked(view)
        return False

    def setupContextMenu(self, view, menu):
        """FreeCAD asks for it each time the object's menu is shown."""
        from .context_menu import add_entries
        names, anew = self.entries(view.Object)
        add_entries(menu, view.Object, names, (lambda: self.panel(view.Object)) if anew else None)

    def entries(self, obj):
        """(names of commands in the object's menu, whether its panel makes it anew)."""
        return (), False

    def panel(self, obj):
        """The task panel of the object."""
        raise NotImplementedError

    def dumps(self):
        return None

    def loads(self, state):
        return None

    __getstate__ = dumps

    def __setstate__(self, state):
        return None


class QuadSurfaceView(_View):
    """Of a quad surface."""

    icon = "HexCon_QuadSurface"

    def entries(self, obj):
        from .context_menu import OF_SURFACE
        return OF_SURFACE, True

    def panel(self, obj):
        from .surface_panel import SurfacePanel
        return SurfacePanel(obj)


class HexMeshView(_View):
    """Of a hex mesh, parametric or of an older document: the latter can but be judged."""

    icon = "HexCon_HexMesh"

    def entries(self, obj):
        from .context_menu import OF_MESH
        return OF_MESH, getattr(obj, "Surface", None) is not None

    def panel(self, obj):
        if getattr(obj, "Surface", None) is not None:
            from .hex_mesh_panel import HexMeshPanel
            return HexMeshPanel(obj)
        from .check_panel import CheckPanel
        return CheckPanel(obj)


class QualityReportView(_View):
    """Of a quality report; its panel is that of the mesh's check."""

    icon = "HexCon_Quality"

    def doubleClicked(self, view):
        return super().doubleClicked(view) if view.Object.Mesh is not None else True

    def panel(self, obj):
        from .check_panel import CheckPanel
        return CheckPanel(obj.Mesh)

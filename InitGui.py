# SPDX-License-Identifier: LGPL-2.1-or-later
"""HexCon's start in a FreeCAD with a window: the workbench.

FreeCAD executes this text inside a function of its own: methods see none of the names defined
here, so each imports what it needs.
"""
import FreeCADGui


class HexConWorkbench(FreeCADGui.Workbench):
    """Solids to certified hex meshes for the FEM workbench."""

    def __init__(self):
        import importlib.util
        import os
        import sys

        from FreeCAD import Qt

        package = os.path.dirname(os.path.abspath(importlib.util.find_spec("hexcon").origin))
        root = os.path.dirname(os.path.dirname(package))
        self.__class__.Icon = os.path.join(root, "resources", "icons", "hexcon.svg")
        self.__class__.MenuText = Qt.translate("HexCon", "HexCon")
        self.__class__.ToolTip = Qt.translate(
            "HexCon", "Hexahedral meshes that keep a given quad surface, certified")
        # By its path: to import the package hexcon needs the native core, and without it the
        # commands have to be there to tell what is missing.
        spec = importlib.util.spec_from_file_location(
            "hexcon_gui_commands", os.path.join(package, "gui", "commands", "__init__.py"))
        self._commands = sys.modules[spec.name] = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(self._commands)
        self._commands.join_freecad()

    def GetClassName(self):
        return "Gui::PythonWorkbench"

    def Initialize(self):
        from FreeCAD import Qt

        names = self._commands.register()
        self.appendToolbar(Qt.QT_TRANSLATE_NOOP("Workbench", "HexCon"), names)
        self.appendMenu(Qt.QT_TRANSLATE_NOOP("Workbench", "HexCon"), names)

    def ContextMenu(self, recipient):
        """In the tree and the 3D view; objects of HexCon have a menu of their own, in every workbench."""
        names = self._commands.in_context_menu()
        if names:
            self.appendContextMenu("", names)

    def Activated(self):
        self._commands.core_is_there()


FreeCADGui.addWorkbench(HexConWorkbench())

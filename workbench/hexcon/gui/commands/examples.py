# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples behind one button."""
import FreeCAD
import FreeCADGui

from .missing_core import core_is_there
from .place import icon_path
from .recorded import run_recorded
from .with_panel import PanelCommand

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class Example(PanelCommand):
    """Opens one example in a document of its own."""

    def __init__(self, key, title):
        self.key, self.name, self.menu_text, self.tool_tip = key, f"HexCon_Example_{key}", title, title
        self.icon = "HexCon_Examples.svg"

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog()

    def Activated(self):
        if core_is_there():
            run_recorded("open_example", repr(self.key))


# Names as hexcon.document.example_documents.EXAMPLES has them: the menu must be there without the core.
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
    members = EXAMPLES

    def GetResources(self):
        # FreeCAD does not translate the words of a group
        return {"MenuText": FreeCAD.Qt.translate("HexCon_Examples", "Examples"),
                "ToolTip": FreeCAD.Qt.translate("HexCon_Examples", "Open a part or a surface of the "
                                                "literature in a document of its own"),
                "Pixmap": icon_path("HexCon_Examples.svg")}

    def GetCommands(self):
        return tuple(example.name for example in self.members)

    def GetDefaultCommand(self):
        return 0

    def IsActive(self):
        return not FreeCADGui.Control.activeDialog()

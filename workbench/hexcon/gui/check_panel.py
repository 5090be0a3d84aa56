# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of "Certify hex mesh"."""
import FreeCAD
import FreeCADGui
from PySide import QtGui

from hexcon.document.prepared import prepared
from hexcon.judging import words
from hexcon.judging.report import check_mesh, read_mesh_object
from hexcon_native import HexconError

from .icons import icon_path
from .looking import mark_hexes
from .panel import Panel, hourglass

translate = FreeCAD.Qt.translate


class CheckPanel(Panel):
    """Works as soon as it opens; then the words, and the hexes at fault in red: not positive, or overlapping."""

    failed = FreeCAD.Qt.QT_TRANSLATE_NOOP("HexCon", "Not checked")
    command = "HexCon_Check"

    def __init__(self, mesh_object):
        super().__init__(mesh_object, translate("HexCon", "Certify hex mesh"), icon_path("HexCon_Check"))
        self._at_fault = []
        try:
            with hourglass():
                found = read_mesh_object(mesh_object)
        except HexconError as fault:
            self.show_fault(fault)
        else:
            self.begin(lambda progress: check_mesh(found, progress))

    def fill(self, layout):
        self.name = QtGui.QLabel(self.about().Label)
        self.mark = QtGui.QCheckBox(translate("HexCon", "Mark the hexes at fault"))
        self.mark.setObjectName("mark")
        self.mark.setChecked(True)
        self.mark.hide()
        self.mark.toggled.connect(self.on_mark)
        layout.addWidget(self.name)
        layout.addWidget(self.mark)

    def on_mark(self, wanted):
        """Colour the hexes, or take the colour away."""
        mesh_object = self.about()
        if mesh_object is not None:
            mark_hexes(mesh_object, self._at_fault if wanted else [])

    def succeed(self, result):
        """Record the call, show what it says."""
        FreeCADGui.addModule("hexcon.gui.actions")
        with prepared(result):
            FreeCADGui.doCommand(
                f"print(hexcon.gui.actions.check_mesh_object({self.reference()}))")
        self._at_fault = sorted({*result.nonpositive, *result.overlapping})
        if self._at_fault:
            FreeCADGui.Selection.clearSelection()  # its green would hide the red
        self.mark.setVisible(bool(self._at_fault))
        self.on_mark(self.mark.isChecked())
        return words.of_check(result)

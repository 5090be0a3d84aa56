# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of "Show dual loops"."""
import FreeCAD
from PySide import QtGui

from hexcon.inspection.dual_loops import LoopedSurface
from hexcon.judging import words
from hexcon.pictures.palette import loop_colours
from hexcon.quads.documents import surface_from_object
from hexcon_native import HexconError

from .drawing_panel import DrawingPanel, choice_table, fill_table
from .icons import icon_path

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

MOST_LISTED = 200


class LoopsPanel(DrawingPanel):
    """The loops in their colours, those that cross themselves first; the pairing, if it is wanted."""

    failed = QT_TRANSLATE_NOOP("HexCon", "Not shown")
    command = "HexCon_Loops"
    hide = "hide_loops"

    def __init__(self, mesh_object):
        self._looped, self._listed = None, []
        super().__init__(mesh_object, translate("HexCon", "Show dual loops"),
                         icon_path("HexCon_Loops"))

    def fill(self, layout):
        self.controls = QtGui.QWidget()
        column = QtGui.QVBoxLayout(self.controls)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(QtGui.QLabel(self.about().Label))
        self.pairs = QtGui.QCheckBox(translate("HexCon", "Pairs of quads"))
        self.pairs.setObjectName("pairs")
        self.pairs.setToolTip(translate(
            "HexCon", "Every quad with one neighbour as its partner: the paired partition that cells are built on"))
        self.pairs.toggled.connect(self.on_pairs)
        self.loops = choice_table("loops", [translate("HexCon", "Quads"), translate("HexCon", "Crosses itself")])
        self.loops.setMinimumHeight(160)
        self.loops.setToolTip(translate("HexCon", "Choose a loop to draw it thick"))
        self.loops.itemSelectionChanged.connect(self.draw)
        column.addWidget(self.pairs)
        column.addWidget(self.loops)
        layout.addWidget(self.controls)

    def job(self, mesh_object):
        surface = surface_from_object(mesh_object)
        return lambda: LoopedSurface(surface)

    def succeed(self, result):
        self._looped = result
        self.controls.setEnabled(True)
        found, colours = result.loops, loop_colours(len(result.loops))
        # those that cross themselves first, then the longest
        self._listed = sorted(range(len(found)), key=lambda row: (-len(found[row].crossings), -len(found[row])))
        del self._listed[MOST_LISTED:]
        blocked = self.loops.blockSignals(True)
        fill_table(self.loops, [(words.count(len(found[row])), words.times(len(found[row].crossings)))
                                for row in self._listed], colours[self._listed])
        self.loops.clearSelection()
        self.loops.blockSignals(blocked)
        self.perform("show_loops", result, **self._settings())
        return words.of_loops(result)

    def _settings(self):
        """What differs from show_loops' defaults."""
        used = {"pairs": True} if self.pairs.isChecked() else {}
        rows = self.loops.selectionModel().selectedRows()
        if rows:
            used["loop"] = self._listed[rows[0].row()]
        return used

    def draw(self, *_):
        self.perform("show_loops", **self._settings())

    def on_pairs(self, wanted):
        try:
            if wanted:
                self._looped.pairs
        except HexconError as fault:
            self.pairs.setChecked(False)
            self.show_fault(fault)
        else:
            self.draw()

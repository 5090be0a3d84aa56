# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of "Inspect hex mesh"."""
import math

import FreeCAD
import numpy as np
from PySide import QtCore, QtGui

from hexcon.femmesh import from_femmesh
from hexcon.inspection.cutting import AXES
from hexcon.inspection.figures import worst
from hexcon.inspection.opening import InspectedMesh
from hexcon.judging import words
from hexcon.objects.hex_mesh import stages_of_object
from hexcon.pictures.palette import quality_colours

from . import inside, looking
from .camera import line_of_sight
from .drawing_panel import DrawingPanel, choice_table, fill_table
from .histogram import Histogram
from .icons import icon_path

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

STEPS = 1000         # of the slider
MOST_SHRUNK = 50     # per cent
MOST_LISTED = 1000   # of the worst
MOST_STAGES = 5      # seen at once


class InspectPanel(DrawingPanel):
    """The mesh opened by a plane or peeled, its scaled Jacobians, and the worst of its hexes."""

    failed = QT_TRANSLATE_NOOP("HexCon", "Not shown")
    command = "HexCon_Inspect"
    hide = "hide_inside"

    def __init__(self, mesh_object):
        self._mesh = None
        super().__init__(mesh_object, translate("HexCon", "Inspect hex mesh"),
                         icon_path("HexCon_Inspect"))

    # ---------------------------------------------------------------------------------- the widgets

    def fill(self, layout):
        self.controls = QtGui.QWidget()
        column = QtGui.QVBoxLayout(self.controls)
        column.setContentsMargins(0, 0, 0, 0)
        rows = QtGui.QFormLayout()
        rows.setHorizontalSpacing(4)
        rows.addRow(translate("HexCon", "Mesh"), QtGui.QLabel(self.about().Label))
        self._make_cut(rows)
        self._make_peel(rows)
        column.addLayout(rows)
        self.histogram = Histogram()
        column.addWidget(self.histogram)
        self._make_worst(column)
        layout.addWidget(self.controls)

    def _make_cut(self, rows):
        self.axis = QtGui.QComboBox()
        self.axis.setObjectName("axis")
        self.axis.addItem(translate("HexCon", "none"), None)
        for axis in AXES:
            self.axis.addItem(axis.upper(), axis)
        self.axis.setToolTip(translate("HexCon", "The plane's normal; each hexahedron stays or goes as a whole"))
        self.flip = QtGui.QCheckBox(translate("HexCon", "Other side"))
        self.flip.setObjectName("flip")
        self.slider = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.slider.setObjectName("slider")
        self.slider.setRange(0, STEPS)
        self.slider.setPageStep(STEPS // 20)
        self.offset = QtGui.QDoubleSpinBox()
        self.offset.setObjectName("offset")
        self.offset.setSuffix(" mm")
        self.offset.setKeyboardTracking(False)
        beside = QtGui.QHBoxLayout()
        beside.addWidget(self.axis)
        beside.addWidget(self.flip)
        rows.addRow(translate("HexCon", "Cut"), beside)
        rows.addRow("", self.slider)
        rows.addRow("", self.offset)
        self.axis.currentIndexChanged.connect(self.on_axis)
        self.slider.valueChanged.connect(self.on_slider)
        self.slider.sliderReleased.connect(self.draw)
        self.offset.valueChanged.connect(self.on_offset)
        self.flip.toggled.connect(self.draw)

    def _make_peel(self, rows):
        self.peel = QtGui.QSpinBox()
        self.peel.setObjectName("peel")
        self.peel.setToolTip(translate("HexCon", "Layers of hexahedra to take away, from the boundary inwards"))
        self.peel.valueChanged.connect(self.draw)
        self.shrink = QtGui.QSpinBox()
        self.shrink.setObjectName("shrink")
        self.shrink.setRange(0, MOST_SHRUNK)
        self.shrink.setSingleStep(5)
        self.shrink.setSuffix(" %")
        self.shrink.setToolTip(translate("HexCon", "Draws each hexahedron smaller, so that they stand apart"))
        self.shrink.valueChanged.connect(self.draw)
        rows.addRow(translate("HexCon", "Peel"), self.peel)
        rows.addRow(translate("HexCon", "Explode"), self.shrink)
        self.stages = QtGui.QListWidget()
        self.stages.setObjectName("stages")
        self.stages.setToolTip(translate("HexCon", "What the method put in, from outside to inside; what has no tick is "
                                                   "taken away"))
        self.stages.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)      # it would lie over the last one
        self.stages.itemChanged.connect(self.draw)
        self.stages_name = QtGui.QLabel(translate("HexCon", "Stages"))
        rows.addRow(self.stages_name, self.stages)

    def _make_worst(self, column):
        self.count = QtGui.QSpinBox()
        self.count.setObjectName("count")
        self.count.setRange(1, MOST_LISTED)
        self.count.setValue(10)
        self.count.valueChanged.connect(self.on_count)
        self.cut_here = QtGui.QPushButton(translate("HexCon", "Cut here"))
        self.cut_here.setObjectName("cut_here")
        self.cut_here.setToolTip(translate("HexCon", "Cut away what hides the chosen hexahedron"))
        self.cut_here.setEnabled(False)
        self.cut_here.clicked.connect(self.on_cut_here)
        head = QtGui.QHBoxLayout()
        head.addWidget(QtGui.QLabel(translate("HexCon", "Worst")))
        head.addWidget(self.count)
        head.addWidget(self.cut_here)
        head.addStretch()
        self.worst = choice_table("worst", [translate("HexCon", "Element"), translate("HexCon", "Scaled Jacobian")])
        self.worst.setFixedHeight(150)
        self.worst.itemSelectionChanged.connect(self.on_worst)
        column.addLayout(head)
        column.addWidget(self.worst)

    # -------------------------------------------------------------------------------------- the mesh

    def job(self, mesh_object):
        found = from_femmesh(mesh_object.FemMesh)
        stages = stages_of_object(mesh_object)
        return lambda: InspectedMesh(found, stages)

    def succeed(self, result):
        """Draw the mesh that was read; a mesh that replaces another is opened as that was, but for the cut's place."""
        self._mesh = result
        self.controls.setEnabled(True)
        self._quietly(self.peel.setRange, 0, max(0, result.thickness - 1))
        self._quietly(self.list_stages)
        self._range_of_cut()
        self.histogram.show_values(result.scaled_jacobian)
        self.list_worst()
        return self._draw(result)

    def list_stages(self):
        """All of them shown, but for those that were hidden of the mesh before. One alone is not worth the room."""
        hidden = self._hidden()
        self.stages.clear()
        for name, hexes in self._mesh.stages:
            item = QtGui.QListWidgetItem(words.stage_of_hexes(name, hexes))
            item.setData(QtCore.Qt.UserRole, name)
            item.setCheckState(QtCore.Qt.Unchecked if name in hidden else QtCore.Qt.Checked)
            item.setToolTip(item.text())    # where the panel is narrower
            self.stages.addItem(item)
        row = max(self.stages.sizeHintForRow(0), 1)
        self.stages.setFixedHeight(row * min(self.stages.count(), MOST_STAGES) + 2 * self.stages.frameWidth())
        for widget in (self.stages, self.stages_name):
            widget.setVisible(self.stages.count() > 1)

    def _hidden(self):
        """Names of the stages without a tick."""
        items = [self.stages.item(row) for row in range(self.stages.count())]
        return tuple(item.data(QtCore.Qt.UserRole) for item in items if item.checkState() != QtCore.Qt.Checked)

    def on_count(self, *_):
        had = self._chosen()
        self.list_worst()
        if had is not None:  # none is chosen now, so none is outlined
            self.draw()

    def list_worst(self):
        rows = worst(self._mesh.scaled_jacobian, self.count.value())
        self._listed = self._mesh.hex_ids[rows].tolist()
        values = self._mesh.scaled_jacobian[rows]
        self._quietly(fill_table, self.worst, [(str(element), f"{value:.4f}") for element, value in zip(
            self._listed, values)], quality_colours(values))
        self._quietly(self.worst.clearSelection)
        self.cut_here.setEnabled(False)

    def _quietly(self, call, *arguments):
        """The call, without any of its widgets' signals: what they would draw follows."""
        widgets = (self.axis, self.flip, self.slider, self.offset, self.peel, self.shrink, self.worst,
                   self.stages)
        before = [widget.blockSignals(True) for widget in widgets]
        call(*arguments)
        for widget, blocked in zip(widgets, before):
            widget.blockSignals(blocked)

    # --------------------------------------------------------------------------------------- the cut

    def _reach(self):
        return self._mesh.reach(self.axis.currentData() or "x")

    def _range_of_cut(self):
        """The offset's range for this axis, and the plane in its middle."""
        low, high = self._reach()
        for widget in (self.slider, self.offset, self.flip):
            widget.setEnabled(self.axis.currentData() is not None)
        span = max(high - low, 1e-9)
        self._quietly(self.offset.setDecimals, max(1, 3 - math.floor(math.log10(span))))
        self._quietly(self.offset.setRange, low, high)
        self._quietly(self.offset.setSingleStep, span / 50)
        self._set_offset((low + high) / 2)

    def _set_offset(self, value):
        low, high = self._reach()
        self._quietly(self.offset.setValue, value)
        self._quietly(self.slider.setValue, round(STEPS * (value - low) / ((high - low) or 1.0)))

    def on_axis(self, *_):
        self._range_of_cut()
        self.draw()

    def on_slider(self, step):
        """Every move is seen; the recorder is told where the slider is left."""
        low, high = self._reach()
        self._quietly(self.offset.setValue, low + (high - low) * step / STEPS)
        if self.slider.isSliderDown():
            looking.show_inside(self.about(), **self._settings())
            self._say()
        else:
            self.draw()

    def on_offset(self, value):
        self._set_offset(value)
        self.draw()

    def _settings(self):
        """What differs from show_inside's defaults."""
        used = {}
        if self.axis.currentData() is not None:
            used.update(axis=self.axis.currentData(), offset=round(self.offset.value(), self.offset.decimals()))
            if self.flip.isChecked():
                used["flip"] = True
        if self.peel.value():
            used["peel"] = self.peel.value()
        if self.shrink.value():
            used["shrink"] = self.shrink.value() / 100
        if self._hidden():
            used["hidden"] = self._hidden()
        if self._chosen() is not None:
            used["element"] = self._chosen()
        return used

    def draw(self, *_):
        self._draw()
        self._say()

    def _draw(self, prepared=None):
        self.perform("show_inside", prepared, **self._settings())
        drawing = inside.drawings.find(self.about())
        return words.of_opening(self._mesh, drawing.kept, drawing.face_count)

    def _say(self):
        drawing = inside.drawings.find(self.about())
        self.result.setText(words.as_html(words.of_opening(self._mesh, drawing.kept, drawing.face_count)))

    # ------------------------------------------------------------------------------------- the worst

    def _chosen(self):
        """The number of the chosen element, or None."""
        rows = self.worst.selectionModel().selectedRows()
        return self._listed[rows[0].row()] if rows else None

    def on_worst(self):
        element = self._chosen()
        self.cut_here.setEnabled(element is not None)
        self.draw()
        if element is not None:
            self.perform("zoom_to_hex", element=element)

    def on_cut_here(self):
        """A plane through the chosen hex's centre, across the axis nearest to the line of sight: what lies between
        the hex and the user goes."""
        centre = self._mesh.centres[self._mesh.row_of(self._chosen())]
        ahead = line_of_sight(self.about().Document)
        axis = int(np.argmax(np.abs(ahead)))
        self._quietly(self.axis.setCurrentIndex, self.axis.findData("xyz"[axis]))
        self._range_of_cut()
        self._quietly(self.flip.setChecked, bool(ahead[axis] > 0))
        self._set_offset(float(centre[axis]))
        self.draw()

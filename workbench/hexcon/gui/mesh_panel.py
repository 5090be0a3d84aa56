# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of "Hex mesh from solid"."""
import os

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from hexcon.errors import FaultCode, ToolError
from hexcon.meshing import mesh_solid
from hexcon.quads import METHODS as SURFACE_METHODS
from hexcon_native import METHODS

from . import actions, words
from .commands import ROOT
from .panel import Panel, hourglass

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

SURFACE_METHOD_WORDS = {
    "auto": QT_TRANSLATE_NOOP("HexCon", "automatic"),
    "sweep": QT_TRANSLATE_NOOP("HexCon", "sweep"),
    "subdivided": QT_TRANSLATE_NOOP("HexCon", "subdivided quads"),
    "subdivided-triangles": QT_TRANSLATE_NOOP("HexCon", "subdivided triangles"),
    "blossom": QT_TRANSLATE_NOOP("HexCon", "blossom"),
    "transfinite": QT_TRANSLATE_NOOP("HexCon", "transfinite"),
}
METHOD_WORDS = {
    "auto": QT_TRANSLATE_NOOP("HexCon", "automatic"),
    "swept": QT_TRANSLATE_NOOP("HexCon", "swept"),
    "cells": QT_TRANSLATE_NOOP("HexCon", "cells"),
}
MOST_LAYERS = 10
CELL_HEXES = 45  # hexes a quad in cells and the tetrahedra below them, without layers: for a guess


def _narrow_box(name):
    """A combo box that does not push the panel's right edge out of FreeCAD's narrow dock."""
    box = QtGui.QComboBox()
    box.setObjectName(name)
    box.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
    box.setMinimumContentsLength(8)
    return box


def _choice_of(name, choices, said):
    """A narrow box with these choices, under their names in words."""
    box = _narrow_box(name)
    for choice in choices:
        box.addItem(translate("HexCon", said.get(choice, choice)), choice)
    return box


def _guess(number):
    """A number of hexes that is not known better than to two digits, in words."""
    return words.count(max(1, round(float(f"{number:.2g}"))))


class MeshPanel(Panel):
    """Size, methods, layers and order; a certified mesh in the document, or the reason why not."""

    failed = QT_TRANSLATE_NOOP("HexCon", "No mesh")

    def __init__(self, solid):
        self._shape = solid.Shape
        super().__init__(solid, translate("HexCon", "Hex mesh from solid"),
                         os.path.join(ROOT, "resources", "icons", "HexCon_MeshSolid.svg"))
        self._estimate()

    def fill(self, layout):
        rows = QtGui.QFormLayout()
        rows.setHorizontalSpacing(4)
        rows.addRow(translate("HexCon", "Solid"), QtGui.QLabel(self.about().Label))
        self._make_size()
        self._make_choices()
        self.mesh = QtGui.QPushButton(translate("HexCon", "Mesh"))
        self.mesh.setObjectName("mesh")
        self.mesh.clicked.connect(self.on_mesh)
        rows.addRow(translate("HexCon", "Size"), self.size)
        rows.addRow("", self.expected)
        rows.addRow(translate("HexCon", "Surface"), self.surface_method)
        rows.addRow(translate("HexCon", "Method"), self.method)
        rows.addRow(translate("HexCon", "Layers"), self.layers)
        rows.addRow(translate("HexCon", "Order"), self.order)
        layout.addLayout(rows)
        layout.addWidget(self.mesh)

    def _make_size(self):
        self.size = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
        self.size.setObjectName("size")
        self.size.setMinimumWidth(60)
        self.size.setProperty("unit", "mm")
        self.size.setProperty("minimum", 0.0)
        self.size.setProperty("rawValue", actions.default_size(self._shape))
        self.size.setToolTip(translate("HexCon", "Wanted length of the edges of the hexahedra"))
        # the widget's other signal of this name carries a type Python does not know
        QtCore.QObject.connect(self.size, QtCore.SIGNAL("valueChanged(double)"), self._estimate)
        self.expected = QtGui.QLabel()
        self.expected.setWordWrap(True)

    def _make_choices(self):
        self.surface_method = _choice_of("surface_method", SURFACE_METHODS, SURFACE_METHOD_WORDS)
        self.surface_method.setToolTip(translate(
            "HexCon", "How the surface is meshed with quads; automatic sweeps where it can"))
        self.method = _choice_of("method", METHODS, METHOD_WORDS)
        self.method.setToolTip(translate(
            "HexCon", "How the surface is filled with hexes: swept from cap to cap, or cells, which "
            "fill any convex or star-shaped body with many more hexes; automatic sweeps where it "
            "can"))
        self.method.currentIndexChanged.connect(self._on_method)
        self.layers = QtGui.QSpinBox()
        self.layers.setObjectName("layers")
        self.layers.setRange(0, MOST_LAYERS)
        self.layers.setToolTip(translate(
            "HexCon", "At least so many layers of plain hexes under the surface; a swept mesh has "
            "none, so that automatic then takes cells"))
        self.layers.valueChanged.connect(self._estimate)
        self.order = _choice_of("order", words.ORDERS, words.ORDERS)

    def _settings(self):
        method = self.method.currentData()
        return {"size": float(self.size.property("rawValue")),
                "surface_method": self.surface_method.currentData(),
                "method": method,
                "layers": 0 if method == "swept" else self.layers.value(),
                "order": self.order.currentData()}

    def _on_method(self, *_):
        self.layers.setEnabled(self.method.currentData() != "swept")
        self._estimate()

    def _estimate(self, *_):
        settings = self._settings()
        size, method = settings["size"], settings["method"]
        if size <= 0.0:
            self.expected.clear()
            return
        swept = _guess(self._shape.Volume / size ** 3)
        cells = _guess(self._shape.Area / size ** 2 * (CELL_HEXES + settings["layers"]))
        if method == "auto" and not settings["layers"]:
            text = translate("HexCon", "about {swept} hexes swept, {cells} in cells")
        else:  # layers are asked of cells only
            text = translate("HexCon", "about {count} hexes")
        self.expected.setText(text.format(swept=swept, cells=cells,
                                          count=swept if method == "swept" else cells))

    def on_mesh(self):
        self._used = self._settings()
        solid = self.about()
        try:
            shape = actions.solid_shape(solid)
        except ToolError as fault:
            self.show_fault(fault)
            return
        self._shape = solid.Shape
        options = dict(self._used, timeout=actions.TIMEOUT)
        self.begin(lambda progress: mesh_solid(shape, progress=progress, **options))

    def _set_running(self, running):
        super()._set_running(running)
        for widget in (self.size, self.surface_method, self.method, self.layers, self.order,
                       self.mesh):
            widget.setEnabled(not running)
        if not running:
            self._on_method()

    def succeed(self, result):
        """Put the mesh into the document by the call that the macro recorder keeps."""
        solid = self.about()
        if solid is None or not solid.Shape.isSame(self._shape):
            raise ToolError(translate(
                "HexCon", "the solid changed while it was meshed; press Mesh again"),
                FaultCode.BAD_SHAPE)
        used = self._used
        FreeCADGui.addModule("hexcon.gui.actions")
        with hourglass(), actions.prepared(result):
            FreeCADGui.doCommand(
                f"hexcon.gui.actions.mesh_solid_object({self.reference()}, {used['size']!r}, "
                f"surface_method={used['surface_method']!r}, method={used['method']!r}, "
                f"layers={used['layers']!r}, order={used['order']!r})")
        rows = words.of_mesh(result)
        FreeCAD.Console.PrintMessage(f"HexCon: {words.as_text(rows)}\n")
        return rows

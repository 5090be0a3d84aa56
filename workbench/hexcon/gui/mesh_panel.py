# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of "Hex mesh from solid"."""
import os

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from hexcon.errors import FaultCode, ToolError
from hexcon.meshing import mesh_solid
from hexcon.quads import METHODS as SURFACE_METHODS
from hexcon_native import METHODS, TOPOLOGICAL_METHODS

from . import actions, words
from .commands import ROOT
from .panel import Panel, hourglass

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

SURFACE_METHOD_WORDS = {
    "auto": QT_TRANSLATE_NOOP("HexCon", "automatic"),
    "sweep": QT_TRANSLATE_NOOP("HexCon", "sweep"),
    "blocks": QT_TRANSLATE_NOOP("HexCon", "blocks"),
    "subdivided": QT_TRANSLATE_NOOP("HexCon", "subdivided quads"),
    "subdivided-triangles": QT_TRANSLATE_NOOP("HexCon", "subdivided triangles"),
    "blossom": QT_TRANSLATE_NOOP("HexCon", "blossom"),
    "transfinite": QT_TRANSLATE_NOOP("HexCon", "transfinite"),
}
METHOD_WORDS = {
    "auto": QT_TRANSLATE_NOOP("HexCon", "automatic"),
    "swept": QT_TRANSLATE_NOOP("HexCon", "swept"),
    "cells": QT_TRANSLATE_NOOP("HexCon", "cells"),
    "sheets": QT_TRANSLATE_NOOP("HexCon", "sheets"),
    "diced": QT_TRANSLATE_NOOP("HexCon", "diced"),
    "four-split": QT_TRANSLATE_NOOP("HexCon", "four-split"),
    "pyramid": QT_TRANSLATE_NOOP("HexCon", "pyramid"),
    "pyramid-alt": QT_TRANSLATE_NOOP("HexCon", "pyramid, alternative"),
    "geode": QT_TRANSLATE_NOOP("HexCon", "geode"),
    "geode-alt": QT_TRANSLATE_NOOP("HexCon", "geode, alternative"),
    "pillowed": QT_TRANSLATE_NOOP("HexCon", "pillowed"),
    "smallest": QT_TRANSLATE_NOOP("HexCon", "smallest"),
}
LAYERED_METHODS = ("auto", "cells")
MOST_LAYERS = 10
CELL_HEXES = 45  # hexes a quad in cells and the tetrahedra below them, without layers: for a guess
DICED_HEXES = 10  # the same of diced subdivided quads: of subdivided triangles it is 3
# The same of the topological methods that always make as many.
TOPOLOGICAL_HEXES = {"pyramid": 76, "pyramid-alt": 58, "geode": 130, "geode-alt": 112}


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


def _choice_of_method():
    """The methods whose meshes can be solved, then those of topology only, marked as such."""
    box = _choice_of("method", sorted(METHODS, key=lambda method: method in TOPOLOGICAL_METHODS),
                     METHOD_WORDS)
    for row in range(box.count()):
        if box.itemData(row) in TOPOLOGICAL_METHODS:
            box.setItemText(row, translate("HexCon", "{method} (topology only)").format(
                method=box.itemText(row)))
    box.view().setMinimumWidth(box.view().sizeHintForColumn(0))  # the list may be wider than the box
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
        rows.addRow(self.allow_topological)
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
            "HexCon", "How the surface is meshed with quads: swept from cap to cap; in blocks, for "
            "round solids and those with three edges at each corner; or by gmsh, for any solid. "
            "Automatic takes the first that can be"))
        self.method = _choice_of_method()
        self.method.setToolTip(translate(
            "HexCon", "How the surface is filled with hexes: swept from cap to cap, or cells, which "
            "fill any convex or star-shaped body with many more hexes; automatic sweeps where it "
            "can. Topology only: to look at; no solver must be given such a mesh"))
        self.method.currentIndexChanged.connect(self._on_method)
        self.layers = QtGui.QSpinBox()
        self.layers.setObjectName("layers")
        self.layers.setRange(0, MOST_LAYERS)
        self.layers.setToolTip(translate(
            "HexCon", "At least so many layers of plain hexes under the surface; a swept mesh has "
            "none, so that automatic then takes cells"))
        self.layers.valueChanged.connect(self._estimate)
        self.order = _choice_of("order", words.ORDERS, words.ORDERS)
        self.allow_topological = QtGui.QCheckBox(translate(
            "HexCon", "Topology only: not for solving"))
        self.allow_topological.setObjectName("allow_topological")
        self.allow_topological.setToolTip(translate(
            "HexCon", "Make a FEM mesh object although some of its Jacobians are zero or negative; "
            "the object is marked as topological"))
        self.allow_topological.hide()

    def _settings(self):
        method = self.method.currentData()
        return {"size": float(self.size.property("rawValue")),
                "surface_method": self.surface_method.currentData(),
                "method": method,
                "layers": self.layers.value() if method in LAYERED_METHODS else 0,
                "order": self.order.currentData()}

    def _on_method(self, *_):
        method = self.method.currentData()
        self.layers.setEnabled(method in LAYERED_METHODS)
        topological = method in TOPOLOGICAL_METHODS
        self.allow_topological.setVisible(topological)
        if not topological:  # what nobody sees is not ticked for the next time
            self.allow_topological.setChecked(False)
        self._estimate()

    def _estimate(self, *_):
        settings = self._settings()
        size, method = settings["size"], settings["method"]
        hexes_a_quad = DICED_HEXES if method == "diced" else \
            TOPOLOGICAL_HEXES.get(method, CELL_HEXES + settings["layers"])
        if size <= 0.0 or (method in TOPOLOGICAL_METHODS and method not in TOPOLOGICAL_HEXES):
            self.expected.clear()
            return
        swept = _guess(self._shape.Volume / size ** 3)
        cells = _guess(self._shape.Area / size ** 2 * hexes_a_quad)
        if method == "auto" and not settings["layers"]:
            text = translate("HexCon", "about {swept} hexes swept, {cells} in cells")
        else:  # layers are asked of cells only
            text = translate("HexCon", "about {count} hexes")
        self.expected.setText(text.format(swept=swept, cells=cells,
                                          count=swept if method == "swept" else cells))

    def on_mesh(self):
        self._used = self._settings()
        self._allowed = self.allow_topological.isChecked()
        solid = self.about()
        try:
            self._refuse_topological()
            shape = actions.solid_shape(solid)
        except ToolError as fault:
            self.show_fault(fault)
            return
        self._shape = solid.Shape
        options = dict(self._used, timeout=actions.TIMEOUT)
        self.begin(lambda progress: mesh_solid(shape, progress=progress, **options))

    def _refuse_topological(self):
        """Raise ToolError(TOPOLOGICAL_MESH) for a topological method without the tick."""
        if self._used["method"] in TOPOLOGICAL_METHODS and not self._allowed:
            raise ToolError(translate(
                "HexCon", "this method gives topology only: some Jacobians are zero or negative, "
                "so CalculiX must not be given its mesh. Choose method cells, or tick \"{tick}\" "
                "to get it anyway").format(tick=self.allow_topological.text()),
                FaultCode.TOPOLOGICAL_MESH)

    def _set_running(self, running):
        super()._set_running(running)
        for widget in (self.size, self.surface_method, self.method, self.layers, self.order,
                       self.allow_topological, self.mesh):
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
        allowed = ", allow_topological=True" if self._allowed else ""
        FreeCADGui.addModule("hexcon.gui.actions")
        with hourglass(), actions.prepared(result):
            FreeCADGui.doCommand(
                f"hexcon.gui.actions.mesh_solid_object({self.reference()}, {used['size']!r}, "
                f"surface_method={used['surface_method']!r}, method={used['method']!r}, "
                f"layers={used['layers']!r}, order={used['order']!r}{allowed})")
        rows = words.of_mesh(result)
        FreeCAD.Console.PrintMessage(f"HexCon: {words.as_text(rows)}\n")
        return rows

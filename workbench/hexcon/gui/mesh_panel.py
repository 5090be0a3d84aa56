# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of "Hex mesh from solid"."""
import os

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from hexcon.errors import FaultCode, ToolError
from hexcon.meshing import mesh_solid
from hexcon.quads import METHODS

from . import actions, words
from .commands import ROOT
from .panel import Panel, hourglass

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

METHOD_WORDS = {
    "auto": QT_TRANSLATE_NOOP("HexCon", "automatic"),
    "sweep": QT_TRANSLATE_NOOP("HexCon", "sweep"),
    "subdivided": QT_TRANSLATE_NOOP("HexCon", "subdivided quads"),
    "subdivided-triangles": QT_TRANSLATE_NOOP("HexCon", "subdivided triangles"),
    "blossom": QT_TRANSLATE_NOOP("HexCon", "blossom"),
    "transfinite": QT_TRANSLATE_NOOP("HexCon", "transfinite"),
}


def _narrow_box(name):
    """A combo box that does not push the panel's right edge out of FreeCAD's narrow dock."""
    box = QtGui.QComboBox()
    box.setObjectName(name)
    box.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
    box.setMinimumContentsLength(8)
    return box


class MeshPanel(Panel):
    """Size, method and order; a certified mesh in the document, or the reason why not."""

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
        self.surface_method = _narrow_box("surface_method")
        self.surface_method.setToolTip(translate(
            "HexCon", "How the surface is meshed with quads; automatic sweeps where it can"))
        for name in METHODS:
            self.surface_method.addItem(translate("HexCon", METHOD_WORDS.get(name, name)), name)
        self.order = _narrow_box("order")
        for order, text in words.ORDERS.items():
            self.order.addItem(translate("HexCon", text), order)
        self.mesh = QtGui.QPushButton(translate("HexCon", "Mesh"))
        self.mesh.setObjectName("mesh")
        self.mesh.clicked.connect(self.on_mesh)
        rows.addRow(translate("HexCon", "Size"), self.size)
        rows.addRow("", self.expected)
        rows.addRow(translate("HexCon", "Surface"), self.surface_method)
        rows.addRow(translate("HexCon", "Order"), self.order)
        layout.addLayout(rows)
        layout.addWidget(self.mesh)

    def _settings(self):
        return {"size": float(self.size.property("rawValue")),
                "surface_method": self.surface_method.currentData(),
                "order": self.order.currentData()}

    def _estimate(self, *_):
        size = self._settings()["size"]
        if size > 0.0:
            number = max(1, round(float(f"{self._shape.Volume / size ** 3:.2g}")))
            self.expected.setText(translate("HexCon", "about {count} hexes").format(
                count=words.count(number)))
        else:
            self.expected.clear()

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
        for widget in (self.size, self.surface_method, self.order, self.mesh):
            widget.setEnabled(not running)

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
                f"surface_method={used['surface_method']!r}, order={used['order']!r})")
        rows = words.of_mesh(result)
        FreeCAD.Console.PrintMessage(f"HexCon: {words.as_text(rows)}\n")
        return rows

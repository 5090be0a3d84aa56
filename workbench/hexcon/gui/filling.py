# SPDX-License-Identifier: LGPL-2.1-or-later
"""The widgets that say how a quad surface is filled: method, layers, pillow, order, time budget."""
import FreeCAD
from PySide import QtCore, QtGui

from hexcon.errors import FaultCode, ToolError
from hexcon.judging import words
from hexcon.pillows import CHOICES
from hexcon.quads import METHOD_TABLE as SURFACE_METHOD_TABLE
from hexcon_native import METHOD_CHOICES, METHOD_TABLE

from . import last_used

translate = FreeCAD.Qt.translate

MOST_LAYERS = 10
LONGEST_BUDGET = 86400  # seconds


def narrow_box(name):
    """A combo box that does not push the panel's right edge out of FreeCAD's narrow dock."""
    box = QtGui.QComboBox()
    box.setObjectName(name)
    box.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
    box.setMinimumContentsLength(8)
    return box


def choice_of(name, choices, said):
    """A narrow box with these choices, under their names in words."""
    box = narrow_box(name)
    for choice in choices:
        box.addItem(translate("HexCon", said.get(choice, choice)), choice)
    return box


def choice_of_methods(name, rows):
    """A narrow box with methods of a table, hexcon_native's or hexcon.quads'; each tells what it is for."""
    box = choice_of(name, [row.name for row in rows], {row.name: row.label for row in rows})
    for place, row in enumerate(rows):
        box.setItemData(place, sentence(translate("HexCon", row.purpose)), QtCore.Qt.ToolTipRole)
    return box


def sentence(purpose):
    """A purpose as a sentence."""
    return purpose[:1].upper() + purpose[1:] + "."


def choose(box, data):
    """Select the choice with this data; an unknown one leaves the box as it is."""
    row = box.findData(data)
    if row >= 0:
        box.setCurrentIndex(row)


def _choice_of_method():
    """The methods whose meshes can be solved, then those of topology only, marked as such."""
    box = choice_of_methods("method", [METHOD_TABLE[name] for name in METHOD_CHOICES])
    for row in range(box.count()):
        if METHOD_TABLE[box.itemData(row)].topological:
            box.setItemText(row, translate("HexCon", "{method} (topology only)").format(
                method=box.itemText(row)))
    box.view().setMinimumWidth(box.view().sizeHintForColumn(0))  # the list may be wider than the box
    return box


class Filling:
    """The widgets; on_change is called without arguments after every change."""

    def __init__(self, on_change=lambda: None):
        self.on_change = on_change
        self.method = _choice_of_method()
        self.method.setToolTip(translate(
            "HexCon", "How the surface is filled with hexes; the list says what each method is for. "
            "Topology only: to look at; no solver must be given such a mesh"))
        self.order = choice_of("order", words.ORDERS, words.ORDERS)
        self._make_pillow()
        self._make_numbers()
        self.allow_topological = QtGui.QCheckBox(translate(
            "HexCon", "Topology only: not for solving"))
        self.allow_topological.setObjectName("allow_topological")
        self.allow_topological.setToolTip(translate(
            "HexCon", "Make a FEM mesh object although some of its Jacobians are zero or negative; "
            "the object is marked as topological"))
        self.allow_topological.hide()
        self.method.currentIndexChanged.connect(self.follow_method)

    def _make_pillow(self):
        self.pillow = choice_of("pillow", CHOICES, words.PILLOWS)
        self.pillow.setToolTip(translate(
            "HexCon", "A sheet of hexes under the whole surface; automatic lays one where it makes a poor worst hex "
            "clearly better"))

    def _make_numbers(self):
        self.layers = QtGui.QSpinBox()
        self.layers.setObjectName("layers")
        self.layers.setRange(0, MOST_LAYERS)
        self.layers.setToolTip(translate(
            "HexCon", "At least so many layers of plain hexes under the surface; automatic then tries "
            "only methods that lay them"))
        self.layers.valueChanged.connect(lambda _: self.on_change())
        self.budget = QtGui.QSpinBox()
        self.budget.setObjectName("budget")
        self.budget.setRange(0, LONGEST_BUDGET)
        self.budget.setSuffix(translate("HexCon", " s"))
        self.budget.setSpecialValueText(translate("HexCon", "no limit"))
        self.budget.setToolTip(translate(
            "HexCon", "After this time the best mesh found until then is taken"))

    def add_to(self, rows):
        """Add the widgets to a QFormLayout."""
        rows.addRow(translate("HexCon", "Method"), self.method)
        rows.addRow(translate("HexCon", "Layers"), self.layers)
        rows.addRow(translate("HexCon", "Pillow"), self.pillow)
        rows.addRow(translate("HexCon", "Order"), self.order)
        rows.addRow(translate("HexCon", "Time limit"), self.budget)
        rows.addRow(self.allow_topological)

    def follow_method(self, *_):
        """Show what matters for the method."""
        method = self.chosen()
        self.layers.setEnabled(method.layers)
        self.pillow.setEnabled(method.pillow)
        topological = method.topological
        self.allow_topological.setVisible(topological)
        if not topological:  # what nobody sees is not ticked for the next time
            self.allow_topological.setChecked(False)
        self.on_change()

    def chosen(self):
        """The hexcon_native.Method that is chosen."""
        return METHOD_TABLE[self.method.currentData()]

    def settings(self):
        """dict: method, layers, pillow, order, budget, as the calls of actions.py take them."""
        method = self.chosen()
        return {"method": method.name,
                "layers": self.layers.value() if method.layers else 0,
                "pillow": self.pillow.currentData() if method.pillow else "auto",
                "order": self.order.currentData(), "budget": float(self.budget.value())}

    def show_settings(self, method, layers, order, budget, allow_topological=False, pillow="auto"):
        """Set the widgets."""
        choose(self.method, method)
        self.layers.setValue(layers)
        choose(self.order, order)
        choose(self.pillow, str(pillow))
        self.budget.setValue(int(budget))
        self.allow_topological.setChecked(allow_topological)

    def remember(self, surface_method=None):
        """What was used is what the next panel begins with; not what is for topology only."""
        if self.chosen().topological:
            return
        last_used.keep(Method=self.chosen().name, Order=self.order.currentData())
        if surface_method:
            last_used.keep(SurfaceMethod=surface_method)

    def allowed(self):
        return self.allow_topological.isChecked()

    def refuse_topological(self):
        """Raise ToolError(TOPOLOGICAL_MESH) for a topological method without the tick."""
        if self.chosen().topological and not self.allowed():
            raise ToolError(translate(
                "HexCon", "this method gives topology only: some Jacobians are zero or negative, "
                "so CalculiX must not be given its mesh. Choose method cells, or tick \"{tick}\" "
                "to get it anyway").format(tick=self.allow_topological.text()),
                FaultCode.TOPOLOGICAL_MESH)

    def enable(self, enabled):
        for widget in (self.method, self.layers, self.pillow, self.order, self.budget, self.allow_topological):
            widget.setEnabled(enabled)
        if enabled:
            self.follow_method()

    def hexes_a_quad(self, surface_method=""):
        """A guess for quads of a surface method; None where the volume tells, or nothing does."""
        method, layers = self.chosen(), self.settings()["layers"]
        if layers and not method.hexes_a_quad:  # automatic takes a method that lays them
            method = next(row for row in METHOD_TABLE.values() if row.layers and row.hexes_a_quad)
        surface = SURFACE_METHOD_TABLE.get(surface_method)
        if surface and not layers and method.name in ("auto", surface.filled_by):
            return surface.hexes_a_quad
        return method.hexes_a_quad and method.hexes_a_quad + layers


def guess(number):
    """A number of hexes that is not known better than to two digits, in words."""
    return words.count(max(1, round(float(f"{number:.2g}"))))


def written(settings, allowed=False):
    """The settings as keywords in a Python call; what has its default value is left out but for
    method, layers and order."""
    said = [f"method={settings['method']!r}", f"layers={settings['layers']!r}", f"order={settings['order']!r}"]
    if settings["pillow"] != "auto":
        said.append(f"pillow={settings['pillow']!r}")
    if settings["budget"]:
        said.append(f"budget={settings['budget']!r}")
    if allowed:
        said.append("allow_topological=True")
    return ", ".join(said)

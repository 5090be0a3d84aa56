# SPDX-License-Identifier: LGPL-2.1-or-later
"""The widgets that say how a solid's surface is meshed with quads: size and method."""
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from hexcon.quads import METHOD_TABLE

from . import method_pictures
from .filling import choice_of_methods

translate = FreeCAD.Qt.translate


def quantity_box(name, unit, value):
    """FreeCAD's box for a quantity of at least 0: it shows a unit, and takes any other of the same kind."""
    box = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
    box.setObjectName(name)
    box.setMinimumWidth(60)
    box.setProperty("unit", unit)
    box.setProperty("minimum", 0.0)
    box.setProperty("rawValue", FreeCAD.Units.Quantity(f"{value!r} {unit}").Value)
    return box


def in_unit(box, unit):
    """A quantity_box's value in this unit."""
    return float(box.property("rawValue")) / FreeCAD.Units.Quantity(f"1 {unit}").Value


def size_box(size, on_change):
    """A box for a length in mm, called "size"; on_change is called with one argument."""
    box = quantity_box("size", "mm", size)
    box.setToolTip(translate("HexCon", "Wanted length of the edges of the hexahedra"))
    # the widget's other signal of this name carries a type Python does not know
    QtCore.QObject.connect(box, QtCore.SIGNAL("valueChanged(double)"), on_change)
    return box


def method_box():
    """A box with the surface methods, called "surface_method"."""
    box = choice_of_methods("surface_method", list(METHOD_TABLE.values()))
    box.setIconSize(QtCore.QSize(method_pictures.WIDTH, method_pictures.HEIGHT))
    for place in range(box.count()):
        drawn = method_pictures.picture(box.itemData(place))
        if drawn is not None:
            box.setItemIcon(place, QtGui.QIcon(drawn))
    box.view().setIconSize(box.iconSize())      # a theme may have made it small
    box.view().setMinimumWidth(box.view().sizeHintForColumn(0) + 24)     # the list may be wider than the box
    box.setToolTip(translate(
        "HexCon", "How the surface is meshed with quads; the list says what each method is for. "
        "Automatic takes the first that can be"))
    return box

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The widgets that say how a solid's surface is meshed with quads: size and method."""
import FreeCAD
import FreeCADGui
from PySide import QtCore

from hexcon.quads import METHOD_TABLE

from .filling import choice_of_methods

translate = FreeCAD.Qt.translate


def size_box(size, on_change):
    """A box for a length in mm, called "size"; on_change is called with one argument."""
    box = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
    box.setObjectName("size")
    box.setMinimumWidth(60)
    box.setProperty("unit", "mm")
    box.setProperty("minimum", 0.0)
    box.setProperty("rawValue", size)
    box.setToolTip(translate("HexCon", "Wanted length of the edges of the hexahedra"))
    # the widget's other signal of this name carries a type Python does not know
    QtCore.QObject.connect(box, QtCore.SIGNAL("valueChanged(double)"), on_change)
    return box


def method_box():
    """A box with the surface methods, called "surface_method"."""
    box = choice_of_methods("surface_method", list(METHOD_TABLE.values()))
    box.setToolTip(translate(
        "HexCon", "How the surface is meshed with quads; the list says what each method is for. "
        "Automatic takes the first that can be"))
    return box

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The widgets that say how a solid's surface is meshed with quads: size and method."""
import FreeCAD
import FreeCADGui
from PySide import QtCore

from hexcon.quads import METHODS

from .filling import choice_of

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

METHOD_WORDS = {
    "auto": QT_TRANSLATE_NOOP("HexCon", "automatic"),
    "sweep": QT_TRANSLATE_NOOP("HexCon", "sweep"),
    "blocks": QT_TRANSLATE_NOOP("HexCon", "blocks"),
    "subdivided": QT_TRANSLATE_NOOP("HexCon", "subdivided quads"),
    "subdivided-triangles": QT_TRANSLATE_NOOP("HexCon", "subdivided triangles"),
    "blossom": QT_TRANSLATE_NOOP("HexCon", "blossom"),
    "transfinite": QT_TRANSLATE_NOOP("HexCon", "transfinite"),
}


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
    box = choice_of("surface_method", METHODS, METHOD_WORDS)
    box.setToolTip(translate(
        "HexCon", "How the surface is meshed with quads: swept from cap to cap; in blocks, for "
        "round solids and those with three edges at each corner; or by gmsh, for any solid. "
        "Automatic takes the first that can be"))
    return box

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run inside FreeCAD's window: HexCon in German, its menu, its panel, its results."""
import os
import sys

import FreeCAD
import FreeCADGui
from PySide import QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from session import find, is_idle, mesh, open_panel, picture, run, say, see_all, select, settle, wait, words  # noqa: E402


def all_is_german():
    FreeCADGui.setLocale("German")
    FreeCADGui.activateWorkbench("HexConWorkbench")
    settle()
    doc = FreeCAD.newDocument("Deutsch")
    box = doc.addObject("Part::Box", "Box")
    doc.recompute()
    see_all()
    menus = FreeCADGui.getMainWindow().menuBar().findChildren(QtGui.QMenu)
    menu = next(one for one in menus if one.title().replace("&", "") == "HexCon")
    texts = [action.text().split("\t")[0].replace("&", "") for action in menu.actions()]
    say(texts)
    assert "Beispiele" in texts
    assert "Hexaedernetz aus K\u00f6rper" in texts and "Halten, belasten und l\u00f6sen" in texts
    select(box)
    open_panel("HexCon_MeshSolid")
    labels = [label.text() for label in find(QtGui.QWidget, "mesh").parentWidget().findChildren(QtGui.QLabel)]
    assert {"K\u00f6rper", "Gr\u00f6\u00dfe", "Oberfl\u00e4che", "Verfahren", "Ordnung"} <= set(labels), labels
    assert find(QtGui.QPushButton, "mesh").text() == "Vernetzen"
    box = find(QtGui.QComboBox, "surface_method")
    assert [box.itemText(k) for k in range(5)] == ["automatisch", "Sweep", "Bl\u00f6cke", "Drehteil", "Lagen"]
    mesh(2.5)
    wait(is_idle, "the box to be meshed")
    for expected in ("zertifiziert: jede Jacobi-Determinante", "64, erste Ordnung (C3D8)",
                     "16 Vierecke der Deckfl\u00e4che", "Skalierte Jacobi-Determinante"):
        assert expected in words(), (expected, words())
    picture("german.png")


run(all_is_german)

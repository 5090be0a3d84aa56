# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of "Inspect hex mesh" on a grid of about 10^5 hexes: make bench-window prints them."""
import os
import sys
import time

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtGui
from session import close_panel, find, open_panel, run, say, see_all, select, settle, wait, words

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from hex_grids import block, distorted  # noqa: E402

N = 46
MOVES = range(0, 1001, 50)


def redraw():
    """Let the 3D view draw, as after every move of the mouse."""
    FreeCADGui.ActiveDocument.ActiveView.redraw()
    settle()


def seconds(what, *calls):
    """Run the calls, and say what they took: median and worst."""
    took = []
    for call in calls:
        started = time.perf_counter()
        call()
        took.append(time.perf_counter() - started)
    say(f"{what}: {np.median(took):.3f} s" + (f", at most {max(took):.3f} s" if len(took) > 1 else ""))


def a_large_mesh():
    import hexcon
    doc = FreeCAD.newDocument("Large")
    made = doc.addObject("Fem::FemMeshObject", "Grid")
    made.FemMesh = hexcon.to_femmesh(distorted(block(N, N, N, (46.0, 46.0, 46.0)), 0.25))
    FreeCADGui.activateWorkbench("HexConWorkbench")
    see_all()
    settle()
    say(f"{made.FemMesh.HexaCount} hexes")
    select(made)


def opened():
    def panel():
        open_panel("HexCon_Inspect")
        wait(words, "the mesh to be shown")
    seconds("to open the panel, until the mesh is drawn", panel)


def cut():
    axis, slider = find(QtGui.QComboBox, "axis"), find(QtGui.QSlider, "slider")
    axis.setCurrentIndex(axis.findData("x"))
    slider.setSliderDown(True)
    seconds("a move of the cut", *(lambda step=step: slider.setValue(step) for step in MOVES))
    seconds("a move of the cut and its picture (no graphics card)",
            *(lambda step=step: (slider.setValue(step), redraw()) for step in MOVES))
    slider.setSliderDown(False)
    seconds("a picture of the same", *[redraw] * 5)


def peeled():
    axis, peel = find(QtGui.QComboBox, "axis"), find(QtGui.QSpinBox, "peel")
    axis.setCurrentIndex(0)
    seconds("a layer peeled", *(lambda layers=layers: peel.setValue(layers) for layers in range(1, 20)))
    peel.setValue(0)
    seconds("hexes set apart", lambda: find(QtGui.QSpinBox, "shrink").setValue(20))
    close_panel()


run(a_large_mesh, opened, cut, peeled)

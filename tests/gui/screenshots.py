# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pictures of docs/guide.md, from the real program: make screenshots.

A picture more: a step more here, and its name in the guide.
"""
import os
import subprocess

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui
from session import (
    OUT,
    button,
    close_panel,
    find,
    is_idle,
    mesh,
    open_panel,
    run,
    say,
    see_all,
    select,
    settle,
    wait,
    words,
)

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
WIDTH, HEIGHT = 1200, 820
MOST = 100_000  # bytes of a picture


def shoot(name):
    """The window as it is, in few colours: its shades are flat."""
    settle()
    path, window = os.path.join(OUT, name), FreeCADGui.getMainWindow()
    subprocess.run(["import", "-window", str(int(window.winId())), "-dither", "None", "-colors", "128", "-strip",
                    f"PNG8:{path}"], check=True)
    size = os.path.getsize(path)
    say(f"{path}: {size} bytes")
    assert size < MOST, name


def see():
    """All of it, from the usual side, and nothing green because it is selected."""
    see_all()
    FreeCADGui.Selection.clearSelection()
    settle()


def new_document(name):
    """The only one, so that no picture shows another's tab."""
    for other in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(other)
    document = FreeCAD.newDocument(name)
    FreeCADGui.activateWorkbench("HexConWorkbench")
    FreeCADGui.updateGui()
    return document


# ---------------------------------------------------------------------------------------- the steps

def a_plain_window():
    view = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    for name, value in (("Simple", True), ("Gradient", False)):
        view.SetBool(name, value)
    view.SetUnsigned("BackgroundColor", 0xF4F6F8FF)
    window = FreeCADGui.getMainWindow()
    window.showNormal()
    window.setGeometry(0, 0, WIDTH, HEIGHT)
    for area in window.findChildren(QtGui.QMdiSubWindow):  # the start page
        area.close()
    combo = window.findChild(QtGui.QDockWidget, "Combo View")
    window.resizeDocks([combo], [300], QtCore.Qt.Horizontal)
    settle()


def bracket():
    import Part
    solid = new_document("Bracket").addObject("Part::Feature", "Bracket")
    solid.Shape = Part.read(os.path.join(ROOT, "resources", "examples", "bracket.step"))
    select(solid)
    return solid


def quads_are_seen_before_they_are_made():
    bracket()
    open_panel("HexCon_QuadSurface")
    find(QtGui.QAbstractSpinBox, "size").setProperty("rawValue", 6.0)
    button("preview").click()
    wait(is_idle, "the preview")
    see()
    shoot("guide-quads.png")
    close_panel()


def a_solid_becomes_a_mesh():
    bracket()
    open_panel("HexCon_MeshSolid")
    mesh(5.0, order=2)
    wait(is_idle, "the bracket to be meshed")
    see()
    shoot("guide-mesh.png")


def it_is_held_loaded_and_solved():
    button("solve").click()
    wait(lambda: button("run"), "the panel of loads")
    solid = FreeCAD.ActiveDocument.Bracket
    heights = [face.CenterOfMass.z for face in solid.Shape.Faces]
    for kind, row in (("held", heights.index(min(heights))), ("loaded", heights.index(max(heights)))):
        button(kind).click()
        FreeCADGui.Selection.addSelection(solid.Document.Name, solid.Name, f"Face{row + 1}")
    button("run").click()
    wait(words, "CalculiX")
    see()
    shoot("guide-solve.png")
    close_panel()


def a_ball_is_cut_open():
    document = new_document("Ball")
    solid = document.addObject("Part::Sphere", "Ball")
    document.recompute()
    select(solid)
    open_panel("HexCon_MeshSolid")
    mesh(1.6, method="cells", layers=1)
    wait(is_idle, "the ball to be meshed")
    close_panel()
    select(document.Objects[-1])
    open_panel("HexCon_Inspect")
    wait(words, "the mesh to be shown")
    axis = find(QtGui.QComboBox, "axis")
    axis.setCurrentIndex(axis.findData("y"))
    find(QtGui.QCheckBox, "flip").click()
    # not the middle: a row of quads has its centres there, and rounding would take some and leave others
    find(QtGui.QDoubleSpinBox, "offset").setValue(0.5)
    see()
    shoot("guide-cut.png")


def its_layers_are_taken_off():
    axis = find(QtGui.QComboBox, "axis")
    axis.setCurrentIndex(axis.findData(None))
    stages = find(QtGui.QListWidget, "stages")
    stages.item(0).setCheckState(QtCore.Qt.Unchecked)
    see()
    shoot("guide-stages.png")
    stages.item(0).setCheckState(QtCore.Qt.Checked)
    axis.setCurrentIndex(axis.findData("y"))
    find(QtGui.QDoubleSpinBox, "offset").setValue(0.5)


def its_worst_hex_is_shown():
    find(QtGui.QTableWidget, "worst").selectRow(0)
    find(QtGui.QPushButton, "cut_here").click()
    shoot("guide-worst.png")
    close_panel()


def dual_loops_of_schneiders():
    import Fem

    import hexcon
    document, surface, femmesh = new_document("Loops"), hexcon.example("schneiders"), Fem.FemMesh()
    for node, place in enumerate(surface.points.tolist(), 1):
        femmesh.addNode(*place, node)
    for quad in (surface.quads + 1).tolist():
        femmesh.addFace(quad)
    made = document.addObject("Fem::FemMeshObject", "Schneiders")
    made.FemMesh = femmesh
    select(made)
    open_panel("HexCon_Loops")
    wait(words, "the loops")
    find(QtGui.QTableWidget, "loops").selectRow(0)
    see()
    shoot("guide-loops.png")
    find(QtGui.QTableWidget, "loops").clearSelection()
    find(QtGui.QCheckBox, "pairs").click()
    see()
    shoot("guide-pairs.png")
    close_panel()


run(a_plain_window, quads_are_seen_before_they_are_made, a_solid_becomes_a_mesh, it_is_held_loaded_and_solved,
    a_ball_is_cut_open, its_layers_are_taken_off, its_worst_hex_is_shown, dual_loops_of_schneiders)

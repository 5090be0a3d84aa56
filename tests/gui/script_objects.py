# SPDX-License-Identifier: LGPL-2.1-or-later
"""A user's session with the parametric objects: every panel by clicks, pictures looked at by colour."""
import os
import resource
import signal
import time

import FreeCAD
import FreeCADGui
import numpy as np
from mouse import Mouse
from PySide import QtCore, QtGui
from session import (
    OUT, button, close_panel, displacements_by_clicks, find, held_at, open_panel, picture, run, say, select,
    settle, wait, words,
)

state = {}


def document():
    return FreeCAD.ActiveDocument


def colours(name):
    """Share of pixels of the 3D view by colour: red, yellow (the preview), any but white."""
    path = os.path.join(OUT, name)
    view = FreeCADGui.ActiveDocument.ActiveView
    settle()
    view.saveImage(path, 400, 300, "White")
    image = QtGui.QImage(path)
    pixels = [QtGui.QColor(image.pixel(x, y)) for x in range(0, 400, 2) for y in range(0, 300, 2)]
    shares = {"red": lambda c: c.red() > 150 and c.green() < 80 and c.blue() < 80,
              "blue": lambda c: c.blue() > 90 and c.red() < 90 and c.green() < 90,
              "yellow": lambda c: c.red() > 200 and 150 < c.green() < 225 and c.blue() < 120,
              "green": lambda c: c.green() > 120 and c.red() < 60 and c.blue() < 60,
              "grey": lambda c: 100 < c.red() < 220 and max(c.getRgb()[:3]) - min(c.getRgb()[:3]) < 12,
              "dark": lambda c: c.red() < 80 and c.green() < 80 and c.blue() < 90,
              "drawn": lambda c: c != QtGui.QColor("white")}
    return {kind: sum(map(test, pixels)) / len(pixels) for kind, test in shares.items()}


def report_view():
    view = FreeCADGui.getMainWindow().findChild(QtGui.QTextEdit, "Report view")
    return view.toPlainText() if view else ""


def idle():
    return button("mesh").isEnabled() and words()


# ------------------------------------------------------------------------------------------ steps

def an_example_is_opened():
    FreeCADGui.activateWorkbench("HexConWorkbench")
    FreeCADGui.runCommand("HexCon_Example_bracket")
    assert document().Objects[0].Shape.Solids
    assert FreeCADGui.Selection.getSelection() == [document().Objects[0]]
    assert colours("example.png")["drawn"] > 0.05


def quads_are_previewed_then_made():
    doc = document()
    open_panel("HexCon_QuadSurface")
    find(QtGui.QAbstractSpinBox, "size").setProperty("rawValue", 10.0)
    button("preview").click()
    wait(idle, "the preview")
    picture("surface_preview.png")
    assert "an even number" in words() and "cross themselves" in words(), words()
    assert len(doc.Objects) == 1 and doc.UndoCount <= 1
    seen = colours("preview.png")
    assert seen["yellow"] > 0.05 and seen["dark"] > 0.01, seen  # quads and their edges
    find(QtGui.QAbstractSpinBox, "size").setProperty("rawValue", 8.0)
    assert colours("preview_gone.png")["yellow"] < 0.01  # it is of another size
    button("mesh").click()
    wait(lambda: doc.getObject("QuadSurface") and idle(), "the quads")
    state["quads"] = doc.QuadSurface.Quads
    assert state["quads"] == doc.QuadSurface.FemMesh.FaceCount > 100
    assert not doc.Bracket.ViewObject.Visibility
    close_panel()
    assert FreeCADGui.Selection.getSelection() == [doc.QuadSurface]


def a_cancelled_mesh_leaves_no_trace():
    from hexcon.meshing import Strategy
    doc, undos = document(), document().UndoCount
    open_panel("HexCon_HexMesh")
    with held_at("placement", Strategy, "of_surface") as (reached, go_on):
        button("mesh").click()
        wait(reached.is_set, "points to be placed")
        wait(lambda: "placing" in find(QtGui.QProgressBar, "progress").format(), "the stage")
        picture("hexes_working.png")
        button("cancel").click()
        go_on.set()
        wait(idle, "the work to stop")
    assert "Cancelled" in words() and len(doc.Objects) == 2 and doc.UndoCount == undos


def the_quads_are_filled():
    doc = document()
    button("mesh").click()
    wait(lambda: doc.getObject("HexMesh") and idle(), "the hexes")
    picture("hexes_made.png")
    say(words())
    assert "certified: every Jacobian" in words()
    assert doc.HexMesh.Hexes == doc.HexMesh.FemMesh.HexaCount and doc.HexMesh.Certified
    close_panel()


def a_double_click_changes_the_mesh():
    doc = document()
    doc.HexMesh.ViewObject.Proxy.doubleClicked(doc.HexMesh.ViewObject)
    wait(lambda: find(QtGui.QLabel, "result"), "the panel")
    order = find(QtGui.QComboBox, "order")
    order.setCurrentIndex(order.findData(2))
    button("mesh").click()
    wait(idle, "the hexes")
    assert doc.HexMesh.Order == "2" and len(doc.Objects) == 3
    assert len(doc.HexMesh.FemMesh.getElementNodes(1)) == 20
    close_panel()
    doc.undo()
    assert doc.HexMesh.Order == "1" and len(doc.HexMesh.FemMesh.getElementNodes(1)) == 8
    assert doc.HexMesh.Status == "Up to date"


def the_quality_is_an_object():
    doc = document()
    select(doc.HexMesh)
    FreeCADGui.runCommand("HexCon_Quality")
    assert doc.QualityReport.Hexes == doc.HexMesh.Hexes and doc.QualityReport.Certified
    doc.QualityReport.ViewObject.Proxy.doubleClicked(doc.QualityReport.ViewObject)
    wait(words, "the check")
    picture("quality.png")
    close_panel()


def faults_mark_their_quads():
    """The paper's octahedron is no sweep: quads where the attempt failed are red."""
    FreeCADGui.runCommand("HexCon_Example_octahedron")
    doc = document()
    open_panel("HexCon_HexMesh")
    method = find(QtGui.QComboBox, "method")
    method.setCurrentIndex(method.findData("diced"))
    button("mesh").click()
    wait(idle, "the refusal")
    picture("fault.png")
    say(words())
    assert "No mesh:" in words() and "Marked in red: quads " in words(), words()
    assert colours("fault_view.png")["red"] > 0.005
    assert len(doc.Objects) == 1
    close_panel()
    assert colours("fault_gone.png")["red"] == 0
    FreeCAD.closeDocument(doc.Name)


def a_recompute_meshes_anew_and_can_be_cancelled():
    from hexcon.objects import quad_surface
    doc = FreeCAD.newDocument("Recompute")
    doc.addObject("Part::Box", "Box")
    doc.recompute()
    import hexcon.gui.actions as actions
    actions.mesh_solid_object(doc.Box, 5.0)
    doc.Box.Length = 20
    doc.recompute()
    assert doc.HexMesh.FemMesh.HexaCount == 16 == doc.HexMesh.Hexes

    real = quad_surface.surface_from_solid

    def cancelled(*given, progress, **options):
        limit = time.monotonic() + 30
        while time.monotonic() < limit:  # until the dialog's Cancel makes it raise
            progress("mesh", 0.5)
            time.sleep(0.01)
        raise AssertionError("nobody cancelled")
    quad_surface.surface_from_solid = cancelled

    def press(click):
        shown = [dialog for dialog in FreeCADGui.getMainWindow().findChildren(
            QtGui.QProgressDialog, "HexConWaiting") if dialog.isVisible()]
        if not shown:
            QtCore.QTimer.singleShot(50, lambda: press(click))
            return
        picture("recompute.png")
        click(shown[0].findChild(QtGui.QPushButton))
    # FreeCAD swallows the mouse's clicks while it recomputes: those of Qt alone would prove little
    for length, click in ((30, Mouse().click), (40, QtGui.QPushButton.click)):
        QtCore.QTimer.singleShot(50, lambda click=click: press(click))
        doc.Box.Length = length
        doc.recompute()
        assert doc.QuadSurface.Status == "Out of date: cancelled", doc.QuadSurface.Status
        assert doc.HexMesh.FemMesh.HexaCount == 16
    quad_surface.surface_from_solid = real
    doc.Box.Length = 30
    assert doc.QuadSurface.ViewObject.Proxy.getIcon().endswith("_fault.svg")
    doc.QuadSurface.touch()
    doc.recompute()
    assert doc.HexMesh.FemMesh.HexaCount == 24 and doc.HexMesh.Status == "Up to date"


def saved_and_reloaded():
    doc = document()
    path = os.path.join(OUT, "recompute.FCStd")
    doc.saveAs(path)
    FreeCAD.closeDocument(doc.Name)
    doc = FreeCAD.openDocument(path)
    settle()
    assert doc.HexMesh.FemMesh.HexaCount == 24 and doc.HexMesh.ViewObject.Visibility
    assert not doc.QuadSurface.ViewObject.Visibility
    doc.Box.Height = 15
    doc.recompute()
    assert doc.HexMesh.FemMesh.HexaCount == 36
    doc.HexMesh.ViewObject.Proxy.doubleClicked(doc.HexMesh.ViewObject)
    wait(lambda: find(QtGui.QLabel, "result"), "the panel of the reloaded mesh")
    close_panel()


def older_documents_open():
    """The plain mesh objects of version 0.1.0: as they were, and a double click judges them."""
    import hexcon
    from hexcon.femmesh import add_to_document
    doc = FreeCAD.newDocument("Older")
    box = doc.addObject("Part::Box", "Box")
    doc.recompute()
    made = add_to_document(doc, hexcon.mesh_solid(box.Shape, 5.0), box)
    made.ViewObject.Proxy = 0  # as that version left it
    path = os.path.join(OUT, "older.FCStd")
    doc.saveAs(path)
    FreeCAD.closeDocument(doc.Name)
    doc = FreeCAD.openDocument(path)
    settle()
    box, made = doc.Box, doc.HexMesh
    box.Length = 20
    doc.recompute()
    assert made.FemMesh.HexaCount == 8 and made.ViewObject.Visibility
    made.ViewObject.Proxy.doubleClicked(made.ViewObject)
    wait(words, "the check")
    assert "every Jacobian is proved positive" in words()
    close_panel()
    FreeCAD.closeDocument(doc.Name)
    FreeCAD.setActiveDocument("recompute")


def a_full_disk_loses_nothing():
    """FreeCAD's save fails as on a full disk: the old file and the document are whole."""
    doc = document()
    old = open(doc.FileName, "rb").read()
    before, limits = signal.signal(signal.SIGXFSZ, signal.SIG_IGN), resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (4096, limits[1]))
    try:
        doc.save()
        fault = ""
    except Exception as error:
        fault = str(error)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
        signal.signal(signal.SIGXFSZ, before)
    say("full disk:", fault)
    assert fault, "a full disk was not noticed"
    assert open(doc.FileName, "rb").read() == old and doc.HexMesh.FemMesh.HexaCount == 36


def from_an_empty_document_to_displacements():
    """The path of the README, click by click."""
    doc = displacements_by_clicks()
    the_displacements_are_seen(doc)
    close_panel()
    assert [o for o in doc.Objects if o.isDerivedFrom("Fem::FemAnalysis")]


def the_displacements_are_seen(doc):
    """In colours from blue to red and no grey, with a legend from 0 to the largest."""
    seen = colours("displacement.png")
    assert seen["red"] > 0.001 and seen["blue"] > 0.005 and seen["drawn"] > 0.05, seen
    assert seen["green"] > 0.005 and seen["grey"] < 0.002, seen
    (result,) = [o for o in doc.Objects if o.isDerivedFrom("Fem::FemResultObject")]
    figures, bar = legend_of(result.Mesh), beside_the_body("displacement.png")
    say("legend", figures, "largest", max(result.DisplacementLengths))
    assert figures[0] == 0.0 and abs(figures[-1] / max(result.DisplacementLengths) - 1) < 1e-2, figures
    assert np.ptp(np.diff(figures)) < 1e-2 * figures[-1]
    # from above to below: red, yellow, green, cyan, blue
    for place, colour in enumerate(((255, 0, 0), (255, 255, 0), (0, 255, 0), (0, 255, 255), (0, 0, 255))):
        height = min(int(place / 4 * len(bar)), len(bar) - 1)
        assert np.abs(bar[height] - colour).max() < 30, (place, bar[height])


def legend_of(mesh_object):
    """The legend's figures, as they stand in the scene, from the lowest place up."""
    from pivy import coin
    (switch,) = [child for child in mesh_object.ViewObject.RootNode.getChildren()
                 if child.getName() == "HexConLegend"]
    assert switch.whichChild.getValue() == mesh_object.ViewObject.SwitchNode.whichChild.getValue() >= 0
    search = coin.SoSearchAction()
    search.setType(coin.SoText2.getClassTypeId())
    search.setInterest(coin.SoSearchAction.ALL)
    search.apply(switch)
    found = search.getPaths()
    texts = [coin.cast(found[k].getTail(), "SoText2").string[0].getString() for k in range(found.getLength())]
    return [float(text) for text in texts if text.replace(".", "").replace("e-", "").isdigit()]


def beside_the_body(name):
    """(h, 3) colours of the legend's bar from above to below."""
    image = QtGui.QImage(os.path.join(OUT, name))
    middle = round((1 - 0.9475) / 2 * image.width())  # the bar's place in legend.py
    column = np.array([QtGui.QColor(image.pixel(middle, y)).getRgb()[:3] for y in range(image.height())])
    vivid = np.flatnonzero(np.ptp(column, axis=1) > 200)
    return column[vivid.min():vivid.max() + 1]


def one_mesh_is_inspected():
    """After solving: the mesh, and not that of the results as well."""
    doc = document()
    select(doc.HexMesh)
    open_panel("HexCon_Inspect")
    wait(words, "the mesh to be shown")
    FreeCADGui.Selection.clearSelection()
    picture("inspect_solved.png")
    (result,) = [o for o in doc.Objects if o.isDerivedFrom("Fem::FemResultObject")]
    shown = [o.Label for o in doc.Objects if any(map(o.isDerivedFrom, ("Fem::FemMeshObject", "Fem::FemPostObject")))
             and o.ViewObject.SwitchNode.whichChild.getValue() >= 0]
    assert shown == [], shown  # but for what Inspect draws
    both = colours("inspected.png")
    from hexcon.gui import inside
    assert inside.drawings.find(doc.HexMesh) and both["drawn"] > 0.05 and both["green"] == 0, both
    close_panel()
    assert result.Mesh.ViewObject.SwitchNode.whichChild.getValue() >= 0


def quads_are_taken_from_a_mesh():
    """Whose Shape is a link to its solid from 1.0 on, and no shape."""
    doc = document()
    select(doc.HexMesh)
    open_panel("HexCon_QuadSurface")
    assert not find(QtGui.QAbstractSpinBox, "size")
    button("mesh").click()
    wait(idle, "the quads")
    made = doc.Objects[-1]
    assert made.Quads > 100 and made.Source == doc.HexMesh and "an even number" in words(), words()
    close_panel()
    doc.removeObject(made.Name)


def the_mesh_goes_into_an_analysis():
    FreeCADGui.runCommand("HexCon_Example_box")
    doc = document()
    import hexcon.gui.actions as actions
    select(actions.mesh_solid_object(doc.Objects[0], 5.0))
    FreeCADGui.runCommand("HexCon_IntoAnalysis")
    import FemGui
    analysis = FemGui.getActiveAnalysis()
    assert doc.HexMesh in analysis.Group
    select(doc.HexMesh)
    FreeCADGui.runCommand("HexCon_IntoAnalysis")
    assert sum(o.isDerivedFrom("Fem::FemAnalysis") for o in doc.Objects) == 1


def fem_has_the_menu_and_preferences_the_page():
    FreeCADGui.activateWorkbench("FemWorkbench")
    settle()
    bar = FreeCADGui.getMainWindow().menuBar()
    menus = [action for action in bar.actions() if action.objectName() == "HexConInFem"]
    assert len(menus) == 1 and len(menus[0].menu().actions()) == 13
    first = menus[0].menu().actions()[0]
    members = [action.text() for action in first.menu().actions()]
    assert first.text() == "Examples" and len(members) == 10 and members[:2] == ["Box", "Wedge"], members
    FreeCADGui.Selection.clearSelection()
    menus[0].menu().aboutToShow.emit()
    first.menu().aboutToShow.emit()
    enabled = [action.text() for action in menus[0].menu().actions() if action.isEnabled()]
    assert enabled == ["Examples", "Import quad surface"], enabled
    before = list(FreeCAD.listDocuments())
    first.menu().actions()[1].trigger()
    assert len(FreeCAD.listDocuments()) == len(before) + 1 and document().Objects[0].Name == "Wedge"
    assert [action.text() for action in menus[0].menu().actions()[1:3]] == ["Quad surface", "Import quad surface"]
    FreeCADGui.activateWorkbench("HexConWorkbench")
    settle()
    assert not [action for action in bar.actions() if action.objectName() == "HexConInFem"]
    from hexcon.gui.commands import PreferencesPage
    page = PreferencesPage()
    page.loadSettings()
    page.form.findChild(QtGui.QWidget, "ccx").setProperty("fileName", "/nowhere/ccx")
    page.form.findChild(QtGui.QPushButton, "check_setup").click()
    page.form.resize(420, 520)
    page.form.grab().save(os.path.join(OUT, "preferences.png"))
    told = page.form.findChild(QtGui.QLabel, "setup").text()
    assert "native core" in told and "/nowhere/ccx" in told, told
    page.form.findChild(QtGui.QWidget, "ccx").setProperty("fileName", "")
    getter = page.form.findChild(QtGui.QPushButton, "get_gmsh")
    assert getter.isHidden()
    page.form.findChild(QtGui.QWidget, "GmshPython").setProperty("fileName", "/nowhere/python")
    page.form.findChild(QtGui.QPushButton, "check_setup").click()
    assert not getter.isHidden()
    page.form.findChild(QtGui.QWidget, "GmshPython").setProperty("fileName", "")
    page.saveSettings()


def no_traceback_was_shown():
    say(report_view()[-1500:])
    assert "Traceback" not in report_view()


run(an_example_is_opened, quads_are_previewed_then_made, a_cancelled_mesh_leaves_no_trace, the_quads_are_filled,
    a_double_click_changes_the_mesh, the_quality_is_an_object, faults_mark_their_quads,
    a_recompute_meshes_anew_and_can_be_cancelled, saved_and_reloaded, older_documents_open, a_full_disk_loses_nothing,
    from_an_empty_document_to_displacements, one_mesh_is_inspected, quads_are_taken_from_a_mesh,
    the_mesh_goes_into_an_analysis, fem_has_the_menu_and_preferences_the_page, no_traceback_was_shown)

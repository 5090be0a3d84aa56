# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run inside FreeCAD's window: menus in the tree, F1, advice, what is remembered, units, files, chosen faces."""
import os
import sys

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(1, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from session import (  # noqa: E402
    OUT,
    button,
    close_panel,
    find,
    is_idle,
    mesh,
    open_panel,
    picture,
    run,
    say,
    see_all,
    select,
    settle,
    wait,
)

from hexcon import preferences  # noqa: E402

state = {}


def newest():
    return state["doc"].Objects[-1]


def shown_menu(entries):
    """A menu with these entries on the screen, for the picture."""
    menu = QtGui.QMenu(FreeCADGui.getMainWindow())
    menu.addAction("Toggle visibility")
    entries(menu)
    menu.popup(QtCore.QPoint(300, 300))
    settle()
    return menu


def help_window():
    page = FreeCADGui.getMainWindow().findChild(QtGui.QTextBrowser, "HexConHelp")
    return page if page is not None and page.isVisible() else None


def press_f1(widget):
    """As FreeCAD hands it on: whether the widget takes it comes first, for FreeCAD has a shortcut of its own."""
    override = QtGui.QKeyEvent(QtCore.QEvent.ShortcutOverride, QtCore.Qt.Key_F1, QtCore.Qt.NoModifier)
    override.ignore()
    QtGui.QApplication.sendEvent(widget, override)
    assert override.isAccepted()
    QtGui.QApplication.sendEvent(widget, QtGui.QKeyEvent(QtCore.QEvent.KeyPress, QtCore.Qt.Key_F1,
                                                         QtCore.Qt.NoModifier))
    settle()


# ------------------------------------------------------------------------------------------ steps

def solids_have_entries_in_the_tree():
    FreeCADGui.activateWorkbench("HexConWorkbench")
    doc = state["doc"] = FreeCAD.newDocument("Conventions")
    box = doc.addObject("Part::Box", "Box")
    doc.recompute()
    see_all()
    select(box)
    offered = sys.modules["hexcon_gui_commands"].in_context_menu()
    assert offered == ["HexCon_MeshSolid", "HexCon_QuadSurface"]
    assert FreeCADGui.Command.get("HexCon_MeshSolid").getInfo()["shortcut"].replace(" ", "") == "H,M"


def surface_methods_have_pictures():
    open_panel("HexCon_MeshSolid")
    box = find(QtGui.QComboBox, "surface_method")
    drawn = [box.itemIcon(k).pixmap(44, 34).toImage() for k in range(box.count())]
    assert all(not image.isNull() for image in drawn)
    assert all(a != b for k, a in enumerate(drawn) for b in drawn[:k])
    box.showPopup()
    settle()
    picture("surface_methods.png")
    box.hidePopup()


def settings_are_remembered():
    mesh(5.0, order=2)
    wait(is_idle, "the box to be meshed")
    close_panel()
    state["mesh"] = newest()
    select(state["doc"].Box)
    open_panel("HexCon_MeshSolid")
    assert find(QtGui.QComboBox, "order").currentData() == 2
    assert abs(find(QtGui.QAbstractSpinBox, "size").property("rawValue") - 5.0) < 1e-9
    close_panel()


def meshes_have_entries_in_the_tree():
    view = state["mesh"].ViewObject
    menu = shown_menu(lambda menu: view.Proxy.setupContextMenu(view, menu))
    names = [action.objectName() for action in menu.actions() if action.objectName()]
    say(names)
    assert names[:4] == ["HexCon_Update", "HexCon_Inspect", "HexCon_Solve", "HexCon_Export"]
    assert all(action.isEnabled() for action in menu.actions())
    picture("context_menu.png")
    entry = next(action for action in menu.actions() if action.objectName() == "HexCon_Inspect")
    menu.close()
    entry.trigger()
    wait(lambda: find(QtGui.QLabel, "result"), "the panel of the entry")
    close_panel()
    surface = state["mesh"].Surface.ViewObject
    other = shown_menu(lambda menu: surface.Proxy.setupContextMenu(surface, menu))
    assert [a.objectName() for a in other.actions() if a.objectName()][:2] == ["HexCon_Update", "HexCon_HexMesh"]
    other.close()


def an_entry_makes_it_anew():
    view, before = state["mesh"].ViewObject, state["doc"].UndoCount
    menu = QtGui.QMenu(FreeCADGui.getMainWindow())
    view.Proxy.setupContextMenu(view, menu)
    menu.actions()[0].trigger()
    wait(is_idle, "the mesh to be made anew")
    assert state["mesh"].FemMesh.HexaCount == 8 and state["doc"].UndoCount == before + 1
    close_panel()


def f1_opens_the_page():
    select(state["doc"].Box)
    open_panel("HexCon_MeshSolid")
    press_f1(find(QtGui.QAbstractSpinBox, "size"))
    page = wait(help_window, "the page")
    assert page.textCursor().selectedText() == "From a solid to a hex mesh"
    picture("help.png")
    page.close()
    close_panel()
    menus = FreeCADGui.getMainWindow().menuBar().findChildren(QtGui.QMenu)
    menu = next(one for one in menus if one.title().replace("&", "") == "HexCon")
    menu.popup(QtCore.QPoint(300, 100))
    settle()
    entry = next(action for action in menu.actions() if action.objectName() == "HexCon_Import")
    wait(entry.isEnabled, "FreeCAD to see that the panel is closed")
    menu.setActiveAction(entry)
    press_f1(menu)
    assert wait(help_window, "the page of the entry").page == "files.md"
    menu.close()
    help_window().close()


def chosen_faces_stay_in_their_colours():
    """Both, after a click elsewhere; the force has a unit, and takes others."""
    select(state["mesh"])
    open_panel("HexCon_Solve")
    doc, force = state["doc"], find(QtGui.QWidget, "force")
    FreeCADGui.Selection.addSelection(doc.Name, "Box", "Face2")
    button("loaded").click()
    FreeCADGui.Selection.addSelection(doc.Name, "Box", "Face6")
    FreeCADGui.Selection.clearSelection()
    assert find(QtGui.QLabel, "held_faces").text() == "Face2" and find(QtGui.QLabel, "loaded_faces").text() == "Face6"
    settle()
    graph = FreeCADGui.ActiveDocument.ActiveView.getSceneGraph()
    names = [str(graph.getChild(k).getName()) for k in range(graph.getNumChildren())]
    assert "HexConOverlay" in names
    assert "N" in force.property("text") or "N" in force.text()
    force.setProperty("rawValue", 2.5e6)     # FreeCAD's own unit: mN
    picture("chosen_faces.png")
    from hexcon.gui.sizing import in_unit
    assert abs(in_unit(force, "N") - 2500.0) < 1e-9
    button("run").click()
    wait(lambda: "Solved" in words_now(), "the results")
    assert preferences.value("Force") == 2500.0
    close_panel()


def words_now():
    from session import words
    return words()


def poor_hexes_are_told_before_they_are_solved():
    doc = state["doc"]
    cone = doc.addObject("Part::Cone", "Cone")
    cone.Radius1, cone.Radius2, cone.Height = 5, 2, 10
    doc.recompute()
    select(cone)
    open_panel("HexCon_MeshSolid")
    mesh(4.0, surface_method="subdivided-triangles", method="diced")
    wait(is_idle, "the cone to be meshed")
    advice = find(QtGui.QLabel, "advice")
    assert advice.isVisible() and "diced" in advice.text() and "2 mm" in advice.text() and "order 2" in advice.text()
    see_all()
    picture("advice.png")
    press_f1(button("mesh"))
    assert wait(help_window, "the page of designs").page == "design.md"
    picture("help_design.png")
    help_window().close()
    close_panel()
    select(newest())
    open_panel("HexCon_Solve")
    assert find(QtGui.QLabel, "advice").isVisible()
    close_panel()


def files_are_chosen():
    from hexcon.gui import mesh_files
    filters = mesh_files.export_filters()
    endings = {ending for row in filters.values() for ending in row.endings}
    assert {".inp", ".msh", ".vtu", ".unv", ".med", ".exo", ".re2"} <= endings and ".fcstd" not in endings
    path, real = os.path.join(OUT, "out"), QtGui.QFileDialog.getSaveFileName
    for name, row in filters.items():
        QtGui.QFileDialog.getSaveFileName = staticmethod(lambda *_, name=name: (path, name))
        try:
            select(state["mesh"])
            FreeCADGui.runCommand("HexCon_Export")
        finally:
            QtGui.QFileDialog.getSaveFileName = real
        assert os.path.exists(path + row.endings[0]), row.name
    assert preferences.value("Folder") == OUT
    from hexcon.gui.commands.preferences import PreferencesPage
    page = PreferencesPage()
    page.loadSettings()
    field = page.form.findChild(QtGui.QWidget, "GmshPython")
    assert field.findChild(QtGui.QPushButton) is not None
    page.form.resize(420, 560)
    page.form.show()
    settle()
    picture("preferences.png")
    page.form.close()


run(solids_have_entries_in_the_tree, surface_methods_have_pictures, settings_are_remembered,
    meshes_have_entries_in_the_tree, an_entry_makes_it_anew, f1_opens_the_page, chosen_faces_stay_in_their_colours,
    poor_hexes_are_told_before_they_are_solved, files_are_chosen)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A user's session: mesh solids through the panel, cancel, fail, undo, check, save, reload."""
import os

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui
from session import (
    OUT,
    button,
    called_topological,
    close_panel,
    find,
    gmsh_runs,
    held_at,
    is_idle,
    mesh,
    open_panel,
    picture,
    run,
    say,
    see_all,
    select,
    settle,
    start_macro,
    stop_macro,
    wait,
    words,
)

state = {}


def meshes():
    return [o for o in state["doc"].Objects
            if o.isDerivedFrom("Fem::FemMeshObject") and o.FemMesh.VolumeCount]


# ------------------------------------------------------------------------------------------ steps

def workbench_has_its_commands():
    FreeCADGui.activateWorkbench("HexConWorkbench")
    assert FreeCADGui.activeWorkbench().name() == "HexConWorkbench"
    bars = FreeCADGui.getMainWindow().findChildren(QtGui.QToolBar, "HexCon")
    assert len(bars) == 1 and len(bars[0].actions()) == 13
    assert all(not action.icon().isNull() for action in bars[0].actions())
    assert not FreeCADGui.getMainWindow().findChild(QtGui.QMessageBox, "HexConMissingCore")
    workbench = FreeCADGui.listWorkbenches()["HexConWorkbench"]
    assert os.path.isfile(workbench.Icon) and workbench.ToolTip


def commands_know_the_selection():
    doc = state["doc"] = FreeCAD.newDocument("Session")
    box, cylinder = doc.addObject("Part::Box", "Box"), doc.addObject("Part::Cylinder", "Cylinder")
    cylinder.Radius, cylinder.Height, cylinder.Placement.Base.x = 5, 20, 30
    doc.recompute()
    see_all()

    def active(name="HexCon_MeshSolid"):
        return FreeCADGui.Command.get(name).isActive()

    FreeCADGui.Selection.clearSelection()
    assert not active() and not active("HexCon_Check")
    for part, expected in (("", True), ("Face1", True), ("Edge1", False)):
        select(box, part)
        assert active() is expected, part
    select(box)
    FreeCADGui.Selection.addSelection(doc.Name, "Cylinder")
    assert not active()
    assert not active("HexCon_Check")


def box_becomes_a_mesh():
    doc = state["doc"]
    select(doc.Box)
    start_macro()
    open_panel("HexCon_MeshSolid")
    assert abs(find(QtGui.QAbstractSpinBox, "size").property("rawValue") - 1.5) < 1e-9
    assert not FreeCADGui.Command.get("HexCon_MeshSolid").isActive()  # one panel at a time
    picture("panel_open.png")
    undos = doc.UndoCount
    mesh(2.5)
    wait(is_idle, "the box to be meshed")
    picture("panel_done.png")
    stop_macro()
    say(words())
    (made,) = meshes()
    assert made.FemMesh.HexaCount == 64 == made.FemMesh.VolumeCount
    assert len(made.FemMesh.Groups) == 6
    assert not doc.Box.ViewObject.Visibility and made.ViewObject.Visibility
    assert doc.UndoCount == undos + 1
    for expected in ("96 quads", "64, first order (C3D8)", "16 cap quads × 4 rings",
                     "min 1.000, 5 % 1.000, mean 1.000", "certified: every Jacobian"):
        assert expected in words(), expected
    close_panel()


def undo_removes_it():
    doc = state["doc"]
    doc.undo()
    assert not meshes()
    assert doc.Box.ViewObject.Visibility
    doc.redo()
    assert len(meshes()) == 1 and meshes()[0].FemMesh.HexaCount == 64
    doc.undo()


def the_macro_does_it_again():
    with open(os.path.join(OUT, "recorded.FCMacro"), encoding="utf-8") as stream:
        text = stream.read()
    say(text)
    assert text.count("mesh_solid_object(") == 1 and "import hexcon.gui.actions" in text
    exec(compile(text, "recorded.FCMacro", "exec"), {"__name__": "recorded"})
    (made,) = meshes()
    assert made.FemMesh.HexaCount == 64
    state["doc"].undo()
    assert not meshes()


def untouched():
    doc = state["doc"]
    return [o.Name for o in doc.Objects], doc.UndoCount, doc.Cylinder.ViewObject.Visibility


def cancel_stops_gmsh():
    before = untouched()
    select(state["doc"].Cylinder, "Face1")
    open_panel("HexCon_MeshSolid")
    mesh(0.1)  # a million hexes
    wait(gmsh_runs, "gmsh")
    button("cancel").click()
    wait(is_idle, "the work to stop")
    assert "Cancelled" in words(), words()
    assert not gmsh_runs() and before == untouched()
    close_panel()


def cancel_half_way_leaves_the_document_untouched():
    before = untouched()
    select(state["doc"].Cylinder, "Face1")
    open_panel("HexCon_MeshSolid")
    with held_at("placement") as (reached, go_on):
        mesh(0.8)
        wait(reached.is_set, "points to be placed")
        wait(lambda: "placing" in find(QtGui.QProgressBar, "progress").format(), "the stage")
        assert find(QtGui.QProgressBar, "progress").value() > 400
        assert find(QtGui.QLabel, "figures").text().endswith(" hexes")
        picture("panel_working.png")
        button("cancel").click()
        go_on.set()
        wait(is_idle, "the work to stop")
    assert "Cancelled" in words(), words()
    assert before == untouched()
    close_panel()


def a_changed_solid_is_noticed():
    doc = state["doc"]
    select(doc.Cylinder)
    open_panel("HexCon_MeshSolid")
    with held_at("placement") as (reached, go_on):
        mesh(0.8)
        wait(reached.is_set, "points to be placed")
        doc.Cylinder.Height = 21
        doc.recompute()
        go_on.set()
        wait(is_idle, "the cylinder to be meshed")
    assert "changed" in words() and not meshes()
    doc.Cylinder.Height = 20
    doc.recompute()
    close_panel()


def failure_is_told_in_words():
    doc = state["doc"]
    doc.addObject("Part::Sphere", "Ball")
    doc.recompute()
    select(doc.Ball)
    open_panel("HexCon_MeshSolid")
    mesh(2.0, "sweep")
    wait(is_idle, "the ball to be refused")
    picture("panel_refused.png")
    say(words())
    assert "No mesh: no pair of cap faces" in words()
    assert not QtGui.QApplication.activeModalWidget()
    mesh(0.0)
    wait(is_idle, "size 0 to be refused")
    assert "above zero" in words()
    assert not meshes()
    close_panel()
    doc.removeObject("Ball")


def ball():
    """A ball in the document, selected: no sweep."""
    made = state["doc"].addObject("Part::Sphere", "Ball")
    state["doc"].recompute()
    select(made)
    return made


def a_ball_is_filled_with_cells():
    doc, solid = state["doc"], ball()
    start_macro("cells")  # a name of its own: the recorder asks before it overwrites
    open_panel("HexCon_MeshSolid")
    mesh(2.0, layers=2)
    wait(is_idle, "the ball to be meshed")
    stop_macro()
    picture("panel_cells.png")
    say(words())
    for expected in ("Method: cells, ", " layers, ", "hexes a quad", "certified: every Jacobian",
                     "Tried: tetrahedra, thickness"):
        assert expected in words(), expected
    (made,) = meshes()
    assert made.FemMesh.HexaCount > 30 * 60
    with open(os.path.join(OUT, "cells.FCMacro"), encoding="utf-8") as stream:
        assert "method='auto', layers=2, order=1)" in stream.read()
    close_panel()
    doc.undo()
    assert not meshes()
    doc.removeObject(solid.Name)


def the_method_is_chosen():
    solid = ball()
    open_panel("HexCon_MeshSolid")
    layers = find(QtGui.QSpinBox, "layers")
    assert (layers.minimum(), layers.maximum()) == (0, 10)
    mesh(2.0, "subdivided", method="swept", layers=3)
    wait(is_idle, "the ball to be refused")
    assert "No mesh:" in words() and not meshes()  # refused as no sweep, not for its layers
    assert "layers" not in words() and not layers.isEnabled()
    method = find(QtGui.QComboBox, "method")
    method.setCurrentIndex(method.findData("cells"))
    assert layers.isEnabled()
    the_guess_follows_the_tables(solid.Shape, method, layers)
    close_panel()
    state["doc"].removeObject(solid.Name)


def the_guess_follows_the_tables(shape, method, layers):
    """Hexes to expect of a ball with subdivided quads of size 2."""
    from hexcon.gui.filling import guess
    from hexcon.quads import METHOD_TABLE as SURFACE_METHODS
    from hexcon_native import METHOD_TABLE
    quads, natural = shape.Area / 4, shape.Volume / 8
    layers.setValue(0)
    for name, hexes in (("shelling", METHOD_TABLE["shelling"].hexes_a_quad * quads), ("swept", natural),
                        ("diced", SURFACE_METHODS["subdivided"].hexes_a_quad * quads),
                        ("cells", METHOD_TABLE["cells"].hexes_a_quad * quads)):
        method.setCurrentIndex(method.findData(name))
        assert find(QtGui.QLabel, "expected").text() == f"about {guess(hexes)} hexes", name
    layers.setValue(2)
    assert find(QtGui.QLabel, "expected").text() == f"about {guess(hexes + 2 * quads)} hexes"
    tips = [method.itemData(row, QtCore.Qt.ToolTipRole) for row in range(method.count())]
    assert all(tips) and len(set(tips)) == method.count()


def topology_only_needs_a_tick():
    from hexcon_native import METHOD_CHOICES, TOPOLOGICAL_METHODS
    doc, before = state["doc"], untouched()
    select(doc.Box)
    open_panel("HexCon_MeshSolid")
    box, tick = find(QtGui.QComboBox, "method"), find(QtGui.QCheckBox, "allow_topological")
    listed = {box.itemData(row): "(topology only)" in box.itemText(row)
              for row in range(box.count())}
    assert {method for method in listed if listed[method]} == TOPOLOGICAL_METHODS
    assert set(listed) == set(METHOD_CHOICES) and sorted(listed.values()) == list(listed.values())
    assert not tick.isVisible()
    mesh(5.0, method="pyramid")
    assert tick.isVisible() and not find(QtGui.QSpinBox, "layers").isEnabled()
    wait(is_idle, "the method to be refused")
    picture("panel_topology_refused.png")
    say(words())
    for expected in ("No mesh: ", "topology only", "zero or negative", "CalculiX", tick.text()):
        assert expected in words(), expected
    assert before == untouched()
    box.setCurrentIndex(box.findData("cells"))
    assert not tick.isVisible()
    close_panel()


def the_tick_makes_a_marked_object():
    doc = state["doc"]
    select(doc.Box)
    start_macro("topological")
    open_panel("HexCon_MeshSolid")
    box, tick = find(QtGui.QComboBox, "method"), find(QtGui.QCheckBox, "allow_topological")
    box.setCurrentIndex(box.findData("geode"))
    tick.click()
    with called_topological():
        mesh(5.0, method="geode")
        wait(is_idle, "the box to be meshed")
    stop_macro()
    picture("panel_topology.png")
    say(words())
    assert "Topological: topology only" in words() and "Method: geode" in words()
    (made,) = meshes()
    assert made.Topological and made.Label.endswith(" (topological)")
    with open(os.path.join(OUT, "topological.FCMacro"), encoding="utf-8") as stream:
        assert "method='geode', layers=0, order=1, allow_topological=True)" in stream.read()
    box.setCurrentIndex(box.findData("auto"))
    assert not tick.isVisible() and not tick.isChecked()
    close_panel()
    assert "Topological: topology only" in check(made)
    doc.undo()
    assert not meshes()


def cancel_stops_the_tetrahedra():
    solid = ball()
    before = untouched()
    open_panel("HexCon_MeshSolid")
    with held_at("tetrahedra inside") as (reached, go_on):
        mesh(2.0, method="cells")
        wait(reached.is_set, "tetrahedra inside")
        wait(lambda: "tetrahedra" in find(QtGui.QProgressBar, "progress").format(), "the stage")
        button("cancel").click()
        go_on.set()
        wait(is_idle, "the work to stop")
    assert "Cancelled" in words(), words()
    assert not gmsh_runs() and before == untouched()
    close_panel()
    state["doc"].removeObject(solid.Name)


def second_order_mesh_is_checked():
    doc = state["doc"]
    select(doc.Cylinder, "Face2")
    open_panel("HexCon_MeshSolid")
    mesh(2.0, "sweep", 2)
    wait(is_idle, "the cylinder to be meshed")
    assert "second order (C3D20R)" in words() and "certified:" in words()
    picture("panel_cylinder.png")
    close_panel()
    (made,) = meshes()
    assert len(made.FemMesh.getElementNodes(made.FemMesh.Volumes[0])) == 20
    assert "certified:" in check(made)
    state["count"] = made.FemMesh.HexaCount


def check(mesh_object):
    """The words of the check; the panel is open afterwards no more."""
    select(mesh_object)
    assert FreeCADGui.Command.get("HexCon_Check").isActive()
    open_panel("HexCon_Check")
    wait(words, "the check")
    picture(f"check_{mesh_object.Name}.png")
    told = words()
    say(told)
    close_panel()
    return told


def red_pixels():
    """How many pixels of the 3D view are more red than anything FreeCAD draws there itself."""
    path = os.path.join(OUT, "view.png")
    see_all()
    settle()
    FreeCADGui.ActiveDocument.ActiveView.saveImage(path, 400, 300, "White")
    picture = QtGui.QImage(path)
    colours = (QtGui.QColor(picture.pixel(x, y)) for x in range(400) for y in range(300))
    return sum(c.red() > 150 and c.green() < 80 and c.blue() < 80 for c in colours)


def bad_hexes_are_marked():
    import hexcon
    import hexcon.gui.actions as actions
    from hexcon.femmesh import from_femmesh

    doc = state["doc"]
    good = from_femmesh(meshes()[0].FemMesh)
    centre = good.hexes[len(good.hexes) // 2, 0]
    good.points[centre] += 2.5 * (good.points[good.hexes[len(good.hexes) // 2, 1]]
                                  - good.points[centre])
    bad = doc.addObject("Fem::FemMeshObject", "Bad")
    bad.FemMesh = hexcon.to_femmesh(good)  # the middle nodes stayed
    meshes()[0].ViewObject.Visibility = False
    told = check(bad)
    assert "NOT certified" in told and "not positive:" in told and "curved" in told
    report = actions.check_mesh_object(bad)
    assert report.nonpositive and not report.certificate.certified
    assert red_pixels() > 100
    actions.mark_hexes(bad, [])
    assert red_pixels() == 0
    select(bad)
    open_panel("HexCon_Check")
    wait(words, "the check")
    assert red_pixels() > 100
    find(QtGui.QCheckBox, "mark").click()
    assert red_pixels() == 0
    close_panel()
    doc.removeObject("Bad")
    meshes()[0].ViewObject.Visibility = True


def nothing_more_is_claimed_than_proved():
    """A mesh without face groups has no surface to compare its boundary with."""
    from types import SimpleNamespace

    import hexcon
    from hexcon.femmesh import from_femmesh

    doc = state["doc"]
    found = from_femmesh(meshes()[0].FemMesh)
    plain = doc.addObject("Fem::FemMeshObject", "Plain")
    plain.FemMesh = hexcon.to_femmesh(SimpleNamespace(points=found.points, hexes=found.hexes))
    told = check(plain)
    assert "every Jacobian is proved positive, the mesh is proper" in told
    assert "certified" not in told and "boundary exact" not in told
    doc.removeObject("Plain")


def a_body_is_meshed_as_a_whole():
    """Its faces belong to its last feature; the mesh belongs to the body."""
    doc = state["doc"]
    body = doc.addObject("PartDesign::Body", "Body")
    block = body.newObject("PartDesign::AdditiveBox", "Block")
    doc.recompute()
    select(block, "Face1")
    open_panel("HexCon_MeshSolid")
    mesh(5.0)
    wait(is_idle, "the body to be meshed")
    assert "certified:" in words()
    close_panel()
    from hexcon.freecad_compat import solid_of_mesh_object
    made = meshes()[-1]
    assert solid_of_mesh_object(made) == body and made.FemMesh.HexaCount == 8
    doc.undo()


def saved_and_reloaded():
    path = os.path.join(OUT, "session.FCStd")
    state["doc"].saveAs(path)
    FreeCAD.closeDocument("Session")
    state["doc"] = FreeCAD.openDocument(path)
    settle()
    (made,) = meshes()
    assert made.FemMesh.HexaCount == state["count"]
    assert "certified:" in check(made)


def the_panel_ends_with_its_document():
    doc = state["doc"]
    select(doc.Cylinder)
    open_panel("HexCon_MeshSolid")
    from hexcon.gui import panel
    with held_at("placement") as (reached, go_on):
        mesh(0.8)
        wait(reached.is_set, "points to be placed")
        FreeCAD.closeDocument(doc.Name)
        wait(lambda: not FreeCADGui.Control.activeDialog(), "the panel to close")
        assert panel._working
        go_on.set()
    wait(lambda: not panel._working, "the work to stop")


run(workbench_has_its_commands, commands_know_the_selection, box_becomes_a_mesh, undo_removes_it,
    the_macro_does_it_again, cancel_stops_gmsh,
    cancel_half_way_leaves_the_document_untouched, a_changed_solid_is_noticed,
    failure_is_told_in_words, a_ball_is_filled_with_cells, the_method_is_chosen,
    topology_only_needs_a_tick, the_tick_makes_a_marked_object, cancel_stops_the_tetrahedra, second_order_mesh_is_checked, bad_hexes_are_marked,
    nothing_more_is_claimed_than_proved, a_body_is_meshed_as_a_whole,
    saved_and_reloaded, the_panel_ends_with_its_document)

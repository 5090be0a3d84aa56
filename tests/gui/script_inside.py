# SPDX-License-Identifier: LGPL-2.1-or-later
"""Looking into hex meshes and at dual loops: what is drawn, what is said, and that nothing of it stays."""
import os
import sys

import FreeCAD
import FreeCADGui
import numpy as np
from pivy import coin  # noqa: F401  before FreeCAD hands out a node of its scene: 1.1 does not import it itself
from PySide import QtCore, QtGui
from session import (
    OUT,
    close_panel,
    find,
    leave,
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

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from hex_grids import block  # noqa: E402

N = 6  # hexes along each edge of the box
state = {}


def panel_ready():
    return words()


def view():
    return FreeCADGui.ActiveDocument.ActiveView


def image(name):
    """(h, w, 3) int of the 3D view, on white."""
    settle()
    path = os.path.join(OUT, name)
    view().saveImage(path, 400, 300, "White")
    pixels = QtGui.QImage(path)
    return np.array([[QtGui.QColor(pixels.pixel(x, y)).getRgb()[:3] for x in range(400)] for y in range(300)])


def beside_the_bar(pixels):
    """The picture without the legend at its left."""
    rest = pixels.copy()
    rest[60:235, :60] = rest[60:90, :125] = 255
    return rest


def like(pixels, colour):
    """How many pixels have this colour's hue, in whatever light (but not next to black)."""
    length = np.linalg.norm(pixels, axis=2)
    alike = pixels @ np.asarray(colour, float) / np.linalg.norm(colour) / np.maximum(length, 1)
    return int(((alike > 0.998) & (length > 90)).sum())


def scene_of(mesh_object):
    """What must be again as it was: the nodes in the object's view, what its switch shows, its properties."""
    shown = mesh_object.ViewObject
    return ([child.getName().getString() for child in shown.RootNode.getChildren()],
            shown.SwitchNode.whichChild.getValue(), shown.Visibility, shown.DisplayMode,
            [o.Name for o in mesh_object.Document.Objects], mesh_object.Document.UndoCount)


def drawing():
    from hexcon.gui import inside
    return inside.drawings.find(state["box"])


def drawn():
    """(hexes left, faces drawn) of the open panel."""
    return int(drawing().kept.sum()), drawing().faces.count


# ------------------------------------------------------------------------------------------ inside

def a_mesh_of_other_people():
    """A grid with one hex spoilt, and no solid; moved and turned, as somebody may have done."""
    import hexcon
    doc = state["doc"] = FreeCAD.newDocument("Inside")
    mesh = block(N, N, N, (30.0, 30.0, 30.0))
    inner = mesh.hexes[N * N * 3 + N * 2 + 2]
    mesh.points[inner[0]] += 0.6 * (mesh.points[inner[6]] - mesh.points[inner[0]])
    made = state["box"] = doc.addObject("Fem::FemMeshObject", "Grid")
    made.FemMesh = hexcon.to_femmesh(mesh)
    made.Placement = FreeCAD.Placement(FreeCAD.Vector(10, -20, 5), FreeCAD.Rotation(0, 0, 90))
    FreeCADGui.activateWorkbench("HexConWorkbench")
    see_all()
    state["before"], state["picture"] = scene_of(made), image("before.png")


def the_panel_draws_the_mesh():
    from hexcon.pictures.palette import quality_colours
    select(state["box"])
    start_macro("inside")
    open_panel("HexCon_Inspect")
    wait(panel_ready, "the mesh to be shown")
    FreeCADGui.Selection.clearSelection()
    assert drawn() == (N ** 3, 6 * N * N)
    assert "216 of 216 hexes, 216 faces" in words() and "3 from the boundary" in words(), words()
    assert state["box"].ViewObject.Visibility
    assert state["box"].ViewObject.SwitchNode.whichChild.getValue() == -1
    seen = image("whole.png")
    # where the object was, there are its hexes
    body, before = (beside_the_bar(pixels).min(axis=2) < 240 for pixels in (seen, state["picture"]))
    assert body.sum() > 5000 and (body != before).mean() < 0.01
    assert find(QtGui.QListWidget, "stages").isHidden()  # nobody knows how this mesh was made
    assert like(seen, quality_colours([1.0])[0]) > 5000
    picture("inspect_open.png")


def a_bar_in_the_view_tells_the_colours():
    """Whatever the camera does it is there, and it is no part of what "fit all" looks at."""
    from hexcon.pictures.palette import quality_colours
    FreeCADGui.SendMsgToActiveView("ViewFit")
    fitted = view().getCamera()
    for camera in ("Perspective", "Orthographic"):
        view().setCameraType(camera)
        view().viewFront()
        bar = image(f"bar_{camera}.png")[60:235, :60]
        for value in (0.1, 0.5, 0.9):
            near = np.abs(bar - 255 * quality_colours([value])[0]).max(axis=2) < 14
            rows, _ = np.nonzero(near)
            assert len(rows) > 15 and np.ptp(rows) < 25, (camera, value)
    see_all()
    assert view().getCamera().split("height")[1].split()[0] == fitted.split("height")[1].split()[0]


def the_legend_follows_the_theme():
    """Dark paper where FreeCAD's windows are dark."""
    from hexcon.gui import actions, inside
    light = QtGui.QApplication.palette()
    papers = []
    for grey in (240, 40):
        palette = QtGui.QPalette(light)
        palette.setColor(QtGui.QPalette.Window, QtGui.QColor(grey, grey, grey))
        QtGui.QApplication.setPalette(palette)
        actions.hide_inside(state["box"])
        actions.show_inside(state["box"])
        papers.append(image(f"legend_{grey}.png")[150, 45].mean())
    QtGui.QApplication.setPalette(light)
    actions.hide_inside(state["box"])
    actions.show_inside(state["box"])
    assert papers[0] > 230 and papers[1] < 60 and inside.drawings.find(state["box"]), papers


def the_cut_moves():
    axis = find(QtGui.QComboBox, "axis")
    axis.setCurrentIndex(axis.findData("x"))
    assert drawn() == (108, 144)
    slider = find(QtGui.QSlider, "slider")
    slider.setSliderDown(True)
    for step, kept in ((100, 36), (300, 72), (1000, 216)):
        slider.setValue(step)
        assert drawn()[0] == kept
    slider.setValue(300)
    slider.setSliderDown(False)
    assert drawn() == (72, 72 + 48)
    assert "72 of 216 hexes, 120 faces" in words(), words()
    seen = image("cut.png")
    find(QtGui.QCheckBox, "flip").click()
    assert drawn()[0] == 144  # the plane lies between two layers
    assert (image("flipped.png") != seen).any(axis=2).mean() > 0.05


def layers_are_peeled_and_hexes_stand_apart():
    find(QtGui.QCheckBox, "flip").click()
    axis, peel, shrink = (find(kind, name) for kind, name in (
        (QtGui.QComboBox, "axis"), (QtGui.QSpinBox, "peel"), (QtGui.QSpinBox, "shrink")))
    axis.setCurrentIndex(0)
    assert not find(QtGui.QSlider, "slider").isEnabled() and peel.maximum() == 2
    for layers, left in ((1, 64), (2, 8), (0, 216)):
        peel.setValue(layers)
        assert drawn() == (left, 6 * round(left ** (2 / 3)))
    shrink.setValue(20)
    assert drawn() == (216, 6 * (216 - 8))  # but those in the core
    image("apart.png")
    picture("inspect_apart.png")
    shrink.setValue(0)


def the_worst_is_chosen():
    from hexcon.gui.inside import CHOSEN
    from hexcon.pictures.palette import quality_colours
    table = find(QtGui.QTableWidget, "worst")
    mesh = drawing().mesh
    order = np.argsort(mesh.scaled_jacobian, kind="stable")
    assert table.rowCount() == 10
    assert [int(table.item(row, 0).text()) for row in range(10)] == mesh.hex_ids[order[:10]].tolist()
    assert abs(float(table.item(0, 1).text()) - mesh.scaled_jacobian[order[0]]) < 1e-4
    find(QtGui.QSpinBox, "count").setValue(3)
    assert table.rowCount() == 3
    assert like(image("unchosen.png"), CHOSEN) == 0
    QtCore.QCoreApplication.processEvents()
    where = table.visualItemRect(table.item(0, 0)).center()
    for kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonRelease):
        QtGui.QApplication.sendEvent(table.viewport(), QtGui.QMouseEvent(
            kind, where, QtCore.Qt.LeftButton, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier))
    assert drawing().element == mesh.hex_ids[order[0]]
    from hexcon.gui import actions
    for camera in ("Perspective", "Orthographic"):
        view().setCameraType(camera)
        actions.zoom_to_hex(state["box"], drawing().element)
        seen = image(f"chosen_{camera}.png")
        assert like(seen, CHOSEN) > 100
        rows, columns = np.nonzero((np.abs(seen - 255 * np.array(CHOSEN)) < 30).all(axis=2))
        assert abs(rows.mean() - 150) < 30 and abs(columns.mean() - 200) < 30, camera  # it is in the middle
        assert 25 < np.ptp(rows) < 150, camera  # neither a dot nor all
    find(QtGui.QSpinBox, "count").setValue(2)
    assert drawing().element is None and not find(QtGui.QPushButton, "cut_here").isEnabled()
    table.selectRow(0)
    assert drawing().element == mesh.hex_ids[order[0]]
    find(QtGui.QPushButton, "cut_here").click()
    assert drawing().kept[order[0]] and 0 < drawn()[0] < 216
    picture("inspect_chosen.png")
    seen = image("cut_here.png")
    assert like(seen, CHOSEN) > 100
    for row in (1, order.tolist().index(80)):  # its neighbours in their colours
        assert like(seen, quality_colours(mesh.scaled_jacobian[order[[row]]])[0]) > 50, row


def the_histogram_is_the_legend():
    histogram = find(QtGui.QWidget, "histogram")
    assert histogram.counts.sum() == 216 and histogram.counts[-1] > 200
    grabbed = histogram.grab().toImage()
    pixels = np.array([[QtGui.QColor(grabbed.pixel(x, y)).getRgb()[:3] for x in range(grabbed.width())]
                       for y in range(grabbed.height())])
    from hexcon.pictures.palette import quality_colours
    for value in (0.1, 0.5, 0.9):
        near = np.abs(pixels - 255 * quality_colours([value])[0]).max(axis=2) < 12
        assert near.sum() > 10, value


def closed_nothing_is_left():
    close_panel()
    stop_macro()
    assert scene_of(state["box"]) == state["before"]
    see_all()
    assert np.array_equal(image("after.png"), state["picture"])
    with open(os.path.join(OUT, "inside.FCMacro"), encoding="utf-8") as stream:
        text = stream.read()
    say(text)
    for expected in ("import hexcon.gui.actions", "show_inside(FreeCAD.ActiveDocument.getObject('Grid'))",
                     "axis='x', offset=", "peel=1)", "shrink=0.2)", "zoom_to_hex(", "hide_inside("):
        assert expected in text, expected
    assert text.count("axis='x'") < 8  # not every move of the slider


def macros_do_the_same():
    import hexcon
    from hexcon.gui import actions
    box = state["box"]
    actions.show_inside(box, axis=(0, 1, 1), peel=1, element=5)
    assert drawn()[0] == 40 and drawing().element == 5
    for wrong in ({"axis": "w"}, {"axis": (0, 0, 0)}, {"offset": float("nan"), "axis": "x"}, {"peel": -1},
                  {"shrink": 2.0}, {"element": 5000}):
        try:
            actions.show_inside(box, **wrong)
        except hexcon.HexconError:
            assert drawn()[0] == 40, wrong  # what was seen is still seen
        else:
            raise AssertionError(wrong)
    actions.hide_inside(box)
    actions.hide_inside(box)  # nothing to hide is no fault
    assert scene_of(box) == state["before"]


def stages_are_taken_off():
    """Boundary layers, cells and what is inside of them, of a mesh that knows them."""
    import hexcon
    from hexcon.gui import actions, inside
    surface = actions.open_example("octahedron")
    mesh = actions.make_hex_mesh(surface, method="cells", layers=1)
    layers, cells, rest = mesh.HexesOfStages
    assert layers % surface.Quads == 0 and cells == 31 * surface.Quads and layers + cells + rest == mesh.Hexes
    select(mesh)
    open_panel("HexCon_Inspect")
    wait(panel_ready, "the mesh to be shown")
    stages = find(QtGui.QListWidget, "stages")
    assert not stages.isHidden() and stages.count() == 3 and stages.item(0).text() == f"boundary layers: {layers}"
    kept = lambda: int(inside.drawings.find(mesh).kept.sum())  # noqa: E731
    for row, left in ((0, cells + rest), (1, rest)):
        stages.item(row).setCheckState(QtCore.Qt.Unchecked)
        assert kept() == left
    picture("inspect_stages.png")
    for row, left in ((2, 0), (1, cells)):
        stages.item(row).setCheckState(QtCore.Qt.Checked if row == 1 else QtCore.Qt.Unchecked)
        assert kept() == left
    assert f"{cells} of {mesh.Hexes} hexes" in words(), words()
    close_panel()
    actions.show_inside(mesh, hidden=("layers", "cells"))
    assert kept() == rest
    try:
        actions.show_inside(mesh, hidden=("walls",))
    except hexcon.HexconError as fault:
        assert "layers, cells, " in str(fault) and kept() == rest
    else:
        raise AssertionError("no such stage")
    FreeCAD.closeDocument(mesh.Document.Name)
    FreeCAD.setActiveDocument(state["doc"].Name)


def marks_are_where_the_object_is():
    """Those of "Certify hex mesh" hang in the same place of the view."""
    from hexcon.gui import actions, marking
    body = np.argwhere(image("unmarked.png").min(axis=2) < 240)
    actions.mark_hexes(state["box"], [1, N])  # at the ends of an edge
    marks = np.argwhere((np.abs(image("marked.png") - 255 * np.array(marking.RED)) < 20).all(axis=2))
    actions.mark_hexes(state["box"], [])
    assert len(marks) > 100
    assert (marks.min(axis=0) >= body.min(axis=0) - 3).all() and (marks.max(axis=0) <= body.max(axis=0) + 3).all()
    assert (np.ptp(marks, axis=0) > np.ptp(body, axis=0) / 2).any()  # both of them


def a_changed_mesh_is_read_again():
    from types import SimpleNamespace

    import hexcon
    select(state["box"])
    open_panel("HexCon_Inspect")
    wait(panel_ready, "the mesh to be shown")
    small = block(2, 2, 2)
    state["box"].FemMesh = hexcon.to_femmesh(SimpleNamespace(points=small.points, hexes=small.hexes))
    wait(lambda: "8 of 8 hexes" in words(), "the new mesh to be shown")
    assert drawn() == (8, 24)
    FreeCADGui.Control.closeDialog()  # as a macro may: no button is pressed
    wait(lambda: drawing() is None, "the drawing to go")
    assert scene_of(state["box"])[:4] == state["before"][:4]


def other_elements_are_refused():
    import Fem
    doc = state["doc"]
    mixed = doc.addObject("Fem::FemMeshObject", "Mixed")
    femmesh = Fem.FemMesh(state["box"].FemMesh)
    femmesh.addVolume([1, 2, 4, 10])
    mixed.FemMesh = femmesh
    select(mixed)
    open_panel("HexCon_Inspect")
    wait(panel_ready, "words")
    assert "Not shown: 9 volumes of which 8 hexahedra" in words(), words()
    assert not find(QtGui.QComboBox, "axis").isEnabled()
    close_panel()
    doc.removeObject("Mixed")


def a_deleted_mesh_comes_back_as_it_was():
    """Together with a solid that was hidden with it."""
    doc, box = state["doc"], state["box"]
    solid = doc.addObject("Part::Box", "Solid")
    meshed = doc.addObject("Fem::FemMeshObjectPython", "Meshed")
    meshed.ViewObject.Proxy = 0
    meshed.addProperty("App::PropertyLink", "Part")
    meshed.Part, meshed.FemMesh = solid, box.FemMesh
    doc.recompute()
    before = scene_of(meshed)[:4], scene_of(solid)[:4]
    select(meshed)
    open_panel("HexCon_Inspect")
    wait(panel_ready, "the mesh to be shown")
    assert scene_of(solid)[1] == scene_of(meshed)[1] == -1
    doc.openTransaction("delete")
    doc.removeObject("Meshed")
    doc.commitTransaction()
    wait(lambda: not FreeCADGui.Control.activeDialog(), "the panel to close")
    assert scene_of(solid)[:4] == before[1]
    doc.undo()
    assert scene_of(doc.Meshed)[:4] == before[0]
    doc.removeObject("Meshed")
    doc.removeObject("Solid")


# ------------------------------------------------------------------------------------------- loops

def surface_object(name, points, quads):
    """A FEM mesh object of quads alone."""
    import Fem
    femmesh = Fem.FemMesh()
    for node, place in enumerate(points.tolist(), 1):
        femmesh.addNode(*place, node)
    for quad in (quads + 1).tolist():
        femmesh.addFace(quad)
    made = state["doc"].addObject("Fem::FemMeshObject", name)
    made.FemMesh = femmesh
    return made


def curves(thing):
    from hexcon.gui import loop_curves
    return loop_curves.drawings.find(thing)


def loops_are_drawn():
    import hexcon
    from hexcon.pictures.palette import DARK, LOOP_COLOURS
    state["box"].ViewObject.Visibility = False
    surface = hexcon.example("schneiders")
    thing = state["surface"] = surface_object("Pyramid", surface.points, surface.quads)
    see_all()
    state["before"] = scene_of(thing)
    select(thing)
    open_panel("HexCon_Loops")
    wait(panel_ready, "the loops")
    FreeCADGui.Selection.clearSelection()
    say(words())
    assert "16 quads, an even number: hexes can fill it" in words() and "2; crossing themselves: 1" in words(), words()
    table = find(QtGui.QTableWidget, "loops")
    told = [[table.item(row, column).text() for column in (0, 1)] for row in range(table.rowCount())]
    say(told)
    assert told[0][1] == "8 times" and told[1][1] == "–", told
    seen = image("loops.png")
    for colour in LOOP_COLOURS[:2]:
        assert like(seen, 255 * colour) > 100
    state["dark"] = int((np.abs(seen - 255 * DARK) < 12).all(axis=2).sum())
    assert state["dark"] > 100
    picture("loops.png")


def a_loop_is_chosen_and_pairs_are_seen():
    from hexcon.pictures.palette import LOOP_COLOURS, PAIR_COLOURS
    thing, table = state["surface"], find(QtGui.QTableWidget, "loops")
    row = curves(thing).looped.loops.index(max(curves(thing).looped.loops, key=lambda loop: len(loop.crossings)))
    thin = like(image("thin.png"), 255 * LOOP_COLOURS[row])
    table.selectRow(0)
    assert curves(thing).loop == row
    assert like(image("thick.png"), 255 * LOOP_COLOURS[row]) > 1.3 * thin
    find(QtGui.QCheckBox, "pairs").click()
    assert curves(thing).pairs
    seen = image("pairs.png")
    assert sum(like(seen, 255 * colour) > 1000 for colour in PAIR_COLOURS) >= 3
    picture("loops_pairs.png")
    close_panel()
    assert scene_of(thing) == state["before"]


def an_odd_surface_has_no_pairs():
    """A cube with one quad cut in two by a path from corner to corner."""
    cube = block(1, 1, 1)
    (a, b, c, d), rest = cube.quads[0].tolist(), cube.quads[1:].tolist()
    middle = cube.points[[a, c, d]].mean(axis=0) * 1.1 - 0.05
    odd = surface_object("Odd", np.vstack([cube.points, middle]), np.array([(a, b, c, 8), (a, 8, c, d), *rest]))
    select(odd)
    open_panel("HexCon_Loops")
    wait(panel_ready, "the loops")
    assert "7 quads, an odd number" in words(), words()
    find(QtGui.QCheckBox, "pairs").click()
    say(words())
    assert not find(QtGui.QCheckBox, "pairs").isChecked() and not curves(odd).pairs
    assert "Not shown: " in words() and "odd" in words(), words()
    close_panel()
    state["doc"].removeObject("Odd")


def a_hex_mesh_shows_its_boundary():
    box = state["box"]
    box.ViewObject.Visibility = True
    before = scene_of(box)[:2]
    select(box)
    open_panel("HexCon_Loops")
    wait(panel_ready, "the loops")
    assert "24 quads" in words() and "6; crossing themselves: 0" in words(), words()
    # the other panel's drawing would take its place, not lie over it
    from hexcon.gui import actions
    actions.show_inside(box)
    assert curves(box) is None and drawn() == (8, 24)
    actions.hide_inside(box)
    close_panel()
    assert scene_of(box)[:2] == before


def the_panel_ends_with_its_document():
    select(state["box"])
    open_panel("HexCon_Inspect")
    wait(panel_ready, "the mesh to be shown")
    FreeCAD.closeDocument("Inside")
    wait(lambda: not FreeCADGui.Control.activeDialog(), "the panel to close")
    from hexcon.gui import inside
    assert not inside.drawings._open


def freecad_may_close_while_the_panel_is_open():
    a_mesh_of_other_people()
    select(state["box"])
    open_panel("HexCon_Inspect")
    wait(panel_ready, "the mesh to be shown")


run(a_mesh_of_other_people, the_panel_draws_the_mesh, a_bar_in_the_view_tells_the_colours, the_legend_follows_the_theme, the_cut_moves, layers_are_peeled_and_hexes_stand_apart,
    the_worst_is_chosen, the_histogram_is_the_legend, closed_nothing_is_left, macros_do_the_same,
    stages_are_taken_off, marks_are_where_the_object_is, a_changed_mesh_is_read_again, a_deleted_mesh_comes_back_as_it_was, other_elements_are_refused, loops_are_drawn,
    a_loop_is_chosen_and_pairs_are_seen, an_odd_surface_has_no_pairs, a_hex_mesh_shows_its_boundary,
    the_panel_ends_with_its_document, freecad_may_close_while_the_panel_is_open, end=leave)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run inside FreeCAD's window: a mesh without a solid is held and loaded by its groups, and a reversed one repaired."""
import os
import sys

import FreeCAD
import FreeCADGui
from PySide import QtGui

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(1, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from hex_grids import block  # noqa: E402
from session import button, close_panel, find, open_panel, picture, run, see_all, select, wait, words  # noqa: E402

from hexcon.femmesh.document import add_to_document  # noqa: E402

state = {}


def groups_are_offered_and_solved():
    import numpy as np
    FreeCADGui.activateWorkbench("HexConWorkbench")
    box = block(3, 3, 3, (10.0, 20.0, 30.0))
    faces, box.face_of_quad = box.face_of_quad, np.zeros_like(box.face_of_quad)
    box.quad_groups = {"hold it": np.flatnonzero(faces == 5), "pull it": np.flatnonzero(faces == 6)}
    state["doc"] = FreeCAD.newDocument("Groups")
    select(add_to_document(state["doc"], box, None))
    open_panel("HexCon_Solve")
    assert "choose its groups" in words()
    groups = find(QtGui.QComboBox, "groups")
    assert [groups.itemText(k) for k in range(1, groups.count())] == ["hold it", "pull it"]
    groups.activated.emit(1)
    find(QtGui.QPushButton, "loaded").click()
    groups.activated.emit(2)
    said = [find(QtGui.QLabel, f"{kind}_faces").text() for kind in ("held", "loaded")]
    assert said == ["hold it", "pull it"]
    button("run").click()
    wait(lambda: "Solved" in words(), "the results")
    see_all()
    picture("groups_solved.png")
    close_panel()


def a_reversed_mesh_is_repaired():
    from hexcon.judging.report import check_mesh, read_mesh_object
    box = block(2, 2, 2)
    box.hexes, box.quads, box.face_of_quad = box.hexes[:, [0, 3, 2, 1, 4, 7, 6, 5]], None, None
    doc = FreeCAD.newDocument("Reversed")
    select(add_to_document(doc, box, None))
    FreeCADGui.runCommand("HexCon_Repair")
    wait(lambda: len(doc.Objects) == 2, "the repaired mesh")
    assert check_mesh(read_mesh_object(doc.Objects[1])).certified
    assert not check_mesh(read_mesh_object(doc.Objects[0])).certified


run(groups_are_offered_and_solved, a_reversed_mesh_is_repaired)

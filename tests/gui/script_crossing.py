# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window says and draws of surfaces that cross themselves, and of meshes that cover a place twice."""
import os
import pathlib
import sys

import FreeCAD
import FreeCADGui
from PySide import QtGui
from session import OUT, button, close_panel, find, open_panel, picture, run, say, see_all, select, settle, wait, words

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1] / folder) for folder in ("", "python")]
from crossing_meshes import arms, moved, two  # noqa: E402
from hex_grids import block  # noqa: E402


def red(name):
    """Share of red pixels of the 3D view."""
    path = os.path.join(OUT, name)
    settle()
    FreeCADGui.ActiveDocument.ActiveView.saveImage(path, 800, 600, "White")
    image = QtGui.QImage(path)
    pixels = [QtGui.QColor(image.pixel(x, y)) for x in range(0, 800, 4) for y in range(0, 600, 4)]
    return sum(c.red() > 150 and c.green() < 80 and c.blue() < 80 for c in pixels) / len(pixels)


def idle():
    return button("mesh").isEnabled() and words()


def write_obj(path, points, quads):
    lines = ["v %r %r %r" % tuple(p) for p in points.tolist()] + ["f %d %d %d %d" % tuple(q + 1) for q in quads]
    pathlib.Path(path).write_text("\n".join(lines) + "\n", encoding="ascii")


# ------------------------------------------------------------------------------------------ steps

def a_surface_that_crosses_itself_is_imported():
    """A C whose arms end in each other."""
    from types import SimpleNamespace

    from hexcon.femmesh import elements_of
    FreeCADGui.activateWorkbench("HexConWorkbench")
    FreeCAD.newDocument("Crossing")
    points, hexes = arms(-0.6)
    made = elements_of(SimpleNamespace(points=points, hexes=hexes))
    path = os.path.join(OUT, "arms.obj")
    write_obj(path, made.points, made.quads)
    real = QtGui.QFileDialog.getOpenFileName
    QtGui.QFileDialog.getOpenFileName = staticmethod(lambda *_: (path, ""))
    try:
        FreeCADGui.runCommand("HexCon_Import")
    finally:
        QtGui.QFileDialog.getOpenFileName = real
    surface = FreeCAD.ActiveDocument.QuadSurface
    assert surface.Quads == len(made.quads) and surface.Even, surface.Quads
    assert "pairs of quads cross or touch" in surface.Embedded, surface.Embedded
    select(surface)
    see_all()


def its_pairs_are_drawn_in_red():
    doc = FreeCAD.ActiveDocument
    before = red("crossing_before.png")
    open_panel("HexCon_HexMesh")
    button("mesh").click()
    wait(idle, "the refusal")
    picture("crossing.png")
    say(words())
    assert "No mesh: the surface bounds no solid" in words() and "pairs of quads cross or touch" in words()
    assert "Marked in red: pairs of quads " in words()
    share = red("crossing_view.png")
    say("red", before, share)
    assert before == 0 and share > 0.01, (before, share)
    assert [o.Name for o in doc.Objects] == ["QuadSurface"]
    close_panel()
    assert red("crossing_gone.png") == 0


def two_blocks_at_one_place():
    """A FEM mesh of 16 hexes, 8 and 8 that share nothing and stand at the same place."""
    from types import SimpleNamespace

    from hexcon.femmesh import to_femmesh
    points, hexes = two(*[(block(2, 2, 2).points, block(2, 2, 2).hexes)] * 2)
    doc = FreeCAD.newDocument("Twice")
    made = doc.addObject("Fem::FemMeshObject", "Twice")
    made.FemMesh = to_femmesh(SimpleNamespace(points=points, hexes=hexes), 1)
    doc.recompute()
    see_all()
    select(made)
    FreeCADGui.runCommand("HexCon_Quality")
    say(doc.QualityReport.Certificate)
    assert not doc.QualityReport.Certified
    assert "26 points stand twice" in doc.QualityReport.Certificate, doc.QualityReport.Certificate


def certify_says_so_too():
    doc = FreeCAD.ActiveDocument
    select(doc.Twice)
    open_panel("HexCon_Check")
    wait(words, "the check")
    picture("twice.png")
    say(words())
    assert "NOT certified" in words() and "stand twice: not merged" in words(), words()
    assert find(QtGui.QCheckBox, "mark").isVisible() and red("twice_view.png") > 0.01
    close_panel()


def blocks_that_cross_without_common_points():
    """Half a hex into each other: the hexes behind the quads that cross are red."""
    from types import SimpleNamespace

    from hexcon.femmesh import to_femmesh
    one = block(2, 2, 2).points, block(2, 2, 2).hexes
    points, hexes = two(one, moved(one, (0.75, 0.1, 0.1)))
    doc = FreeCAD.ActiveDocument
    doc.Twice.FemMesh = to_femmesh(SimpleNamespace(points=points, hexes=hexes), 1)
    doc.recompute()
    assert "cross or touch" in doc.QualityReport.Certificate, doc.QualityReport.Certificate
    FreeCADGui.SendMsgToActiveView("ViewFit")
    select(doc.Twice)
    open_panel("HexCon_Check")
    wait(words, "the check")
    picture("crossing_blocks.png")
    say(words())
    assert "it overlaps itself" in words() and "overlapping: " in words(), words()
    close_panel()


run(a_surface_that_crosses_itself_is_imported, its_pairs_are_drawn_in_red, two_blocks_at_one_place, certify_says_so_too,
    blocks_that_cross_without_common_points)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parametric objects without a window: recompute, faults, copy, undo, save, reload."""
import os
import sys
import traceback

OUT = os.environ["HEXCON_TEST_OUT"]


def new_document():
    import FreeCAD
    doc = FreeCAD.newDocument("Parametric")
    doc.UndoMode = 1
    doc.addObject("Part::Box", "Box")
    doc.recompute()
    return doc


def parts(doc):
    """(quads, hexes) in the document's first quad surface and hex mesh."""
    return doc.QuadSurface.FemMesh.FaceCount, doc.HexMesh.FemMesh.HexaCount


def follows_its_solid(doc):
    from hexcon.gui import actions
    surface = actions.make_quad_surface(doc.Box, 5.0)
    assert (surface.Quads, surface.Even, surface.Loops, surface.SelfCrossings) == (24, True, 6, 0)
    assert surface.Genus == 0 and surface.Status == "Up to date"
    mesh = actions.make_hex_mesh(surface)
    assert parts(doc) == (24, 8) and mesh.Certified and mesh.MinimumScaledJacobian > 0.999
    report = actions.make_quality_report(mesh, worst=3)
    assert report.Hexes == 8 and len(report.WorstElements) == 3 and "certified" in report.Certificate
    doc.openTransaction("Length")
    doc.Box.Length = 20
    doc.recompute()
    doc.commitTransaction()
    assert parts(doc) == (40, 16) and report.Hexes == 16 and mesh.Hexes == 16
    nodes = mesh.FemMesh.getNodesByFace(doc.Box.Shape.Face2)
    assert len(nodes) == 9, nodes  # where constraints on CAD faces look
    doc.undo()
    assert parts(doc) == (24, 8) and doc.Box.Length.Value == 10
    doc.redo()
    assert parts(doc) == (40, 16)


def nothing_is_meshed_for_nothing(doc):
    from hexcon.objects import quad_surface

    def never(*_, **__):
        raise AssertionError("meshed again")
    real, quad_surface.surface_from_solid = quad_surface.surface_from_solid, never
    try:
        doc.Box.touch()
        doc.recompute()
    finally:
        quad_surface.surface_from_solid = real
    assert doc.QuadSurface.Status == doc.HexMesh.Status == "Up to date"


def only_marked_without_auto_update(doc):
    from hexcon.gui import actions
    doc.QuadSurface.AutoUpdate = False
    doc.Box.Length = 10
    doc.recompute()
    assert parts(doc) == (40, 16)
    assert doc.QuadSurface.Status.startswith("Out of date"), doc.QuadSurface.Status
    assert "not up to date" in doc.HexMesh.Status, doc.HexMesh.Status
    actions.update_quad_surface(doc.QuadSurface)
    assert parts(doc) == (24, 8)
    assert doc.QuadSurface.Status == doc.HexMesh.Status == "Up to date"
    doc.QuadSurface.AutoUpdate = True


def a_fault_keeps_the_old_mesh(doc):
    import FreeCAD

    import hexcon
    from hexcon.gui import actions
    doc.HexMesh.Method = "diced"
    doc.HexMesh.Layers = 99
    doc.recompute()
    assert parts(doc) == (24, 8) and doc.HexMesh.Status.startswith("Failed: "), doc.HexMesh.Status
    doc.HexMesh.Method, doc.HexMesh.Layers = "auto", 0
    doc.recompute()
    assert doc.HexMesh.Status == "Up to date"
    before = len(doc.Objects), doc.UndoCount
    for call in (lambda: actions.make_quad_surface(doc.Box, -1.0),
                 lambda: actions.make_hex_mesh(doc.QuadSurface, method="pyramid"),
                 lambda: actions.update_hex_mesh(doc.HexMesh, layers=-1),
                 lambda: actions.import_quad_surface("/nowhere/at/all.obj")):
        try:
            call()
        except hexcon.HexconError:
            pass
        else:
            raise AssertionError("no fault")
    assert (len(doc.Objects), doc.UndoCount) == before
    assert doc.HexMesh.Layers == 0 and FreeCAD.ActiveDocument == doc


def a_failing_gmsh_is_named(doc):
    from hexcon import preferences
    preferences.set_value("GmshPython", "/nowhere/python")
    environment = os.environ.pop("HEXCON_GMSH_PYTHON", None)
    try:
        doc.Box.Width = 15
        doc.recompute()
        assert "cannot import gmsh" in doc.QuadSurface.Status, doc.QuadSurface.Status
        assert parts(doc) == (24, 8)
    finally:
        preferences.set_value("GmshPython", "")
        if environment:
            os.environ["HEXCON_GMSH_PYTHON"] = environment
    doc.QuadSurface.touch()
    doc.recompute()
    assert parts(doc) == (32, 12) and doc.HexMesh.Status == "Up to date"


def an_odd_surface_is_told(doc):
    """A given surface may be odd: the object says so, and the hex mesh names the cause."""
    import hexcon
    from hexcon.gui import actions
    path = os.path.join(OUT, "odd.obj")
    with open(path, "w", encoding="utf-8") as stream:  # a cube whose corner is cut: 9 quads
        stream.write(ODD)
    surface = actions.import_quad_surface(path)
    assert surface.Quads % 2 == 1 and not surface.Even
    try:
        actions.make_hex_mesh(surface)
    except hexcon.HexconError as fault:
        assert "odd" in str(fault), fault
    else:
        raise AssertionError("an odd surface was filled")
    doc.removeObject(surface.Name)


# A torus-like ring of 3 x 3 quads: closed, and an odd number.
ODD = "".join(f"v {x} {y} {z}\n" for x, y, z in (
    (3, 0, 0), (2, 0, 1), (2, 0, -1), (-1.5, 2.6, 0), (-1, 1.7, 1), (-1, 1.7, -1),
    (-1.5, -2.6, 0), (-1, -1.7, 1), (-1, -1.7, -1))) + "".join(
    f"f {3 * i + j + 1} {3 * ((i + 1) % 3) + j + 1} {3 * ((i + 1) % 3) + (j + 1) % 3 + 1} {3 * i + (j + 1) % 3 + 1}\n"
    for i in range(3) for j in range(3))


def copies_work_on_their_own(doc):
    copy = doc.copyObject(doc.HexMesh, False)
    copy.Order = "2"
    doc.recompute()
    assert copy.FemMesh.HexaCount == 12 and len(copy.FemMesh.getElementNodes(1)) == 20
    assert len(doc.HexMesh.FemMesh.getElementNodes(1)) == 8
    doc.removeObject(copy.Name)


def survives_save_and_load(doc):
    import FreeCAD
    path = os.path.join(OUT, "parametric.FCStd")
    doc.saveAs(path)
    FreeCAD.closeDocument(doc.Name)
    doc = FreeCAD.openDocument(path)
    assert parts(doc) == (32, 12) and doc.QuadSurface.Notes is not None
    assert doc.HexMesh.Stages == []
    doc.HexMesh.Method = "cells"
    doc.recompute()
    assert doc.HexMesh.Stages[-2:] == ["cells", "tetrahedra"] or doc.HexMesh.Stages[-2:] == ["cells", "star"]
    assert sum(doc.HexMesh.HexesOfStages) == doc.HexMesh.Hexes > 31 * 32
    doc.HexMesh.Method = "auto"
    doc.recompute()
    assert doc.HexMesh.Stages == [] and parts(doc) == (32, 12)
    nothing_is_meshed_for_nothing(doc)
    doc.Box.Width = 10
    doc.recompute()
    assert parts(doc) == (24, 8) and doc.QualityReport.Hexes == 8
    return doc


def outlives_its_solid(doc):
    doc.removeObject("Box")
    doc.recompute()
    assert parts(doc) == (24, 8) and "gone" in doc.QuadSurface.Status, doc.QuadSurface.Status


def an_analysis_is_made_once(doc):
    from hexcon.gui import actions
    analysis = actions.into_analysis(doc.HexMesh)
    kinds = {member.TypeId.split("::")[1] for member in analysis.Group}
    assert {"ConstraintFixed", "ConstraintForce", "FemMeshObjectPython"} <= kinds, kinds
    assert actions.into_analysis(doc.HexMesh) == analysis
    assert sum(o.isDerivedFrom("Fem::FemAnalysis") for o in doc.Objects) == 1


def a_missing_ccx_is_named(doc):
    import hexcon
    from hexcon.gui import actions
    os.environ["HEXCON_CCX"] = "/nowhere/ccx"
    before = len(doc.Objects)
    try:
        actions.load_and_solve(doc.HexMesh, ["Face1"], {"Face2": (0, 0, -100.0)})
    except hexcon.HexconError as fault:
        assert "/nowhere/ccx" in str(fault), fault
    else:
        raise AssertionError("solved without a solver")
    finally:
        del os.environ["HEXCON_CCX"]
    assert len(doc.Objects) == before
    result = actions.load_and_solve(doc.HexMesh, ["Face1"], {"Face2": (0, 0, -100.0)})
    assert result.max_displacement > 0
    return result.document_object


def results_of_an_older_mesh_say_so(doc, solved):
    """The length changes, comes back, and changes again in a step that is undone; then it is solved anew."""
    from hexcon.gui import actions
    from hexcon.objects.old_results import SUFFIX
    shown, doc.UndoMode = solved.Mesh, 1  # off in a document that was opened without a window

    def lengthen(length):
        doc.openTransaction("Length")
        doc.Box.Length = length
        doc.recompute()
        doc.commitTransaction()
        return [thing.Label.count(SUFFIX) for thing in (solved, shown)]
    labels, hexes = [solved.Label, shown.Label], doc.HexMesh.Hexes
    assert lengthen(30) == [1, 1] and doc.HexMesh.Hexes > hexes and solved.OfHexMesh
    assert lengthen(40) == [1, 1]
    assert lengthen(10) == [0, 0] and [solved.Label, shown.Label] == labels and doc.HexMesh.Hexes == hexes
    assert lengthen(20) == [1, 1]
    doc.undo()
    assert [solved.Label, shown.Label] == labels and doc.HexMesh.Hexes == hexes
    assert lengthen(20) == [1, 1]
    again = actions.load_and_solve(doc.HexMesh, ["Face1"], {"Face2": (0, 0, -100.0)}).document_object
    assert SUFFIX not in again.Label and SUFFIX in solved.Label
    assert lengthen(10) and SUFFIX in again.Label


def examples_open():
    from hexcon.gui import actions
    for name in actions.EXAMPLES:
        made = actions.open_example(name)
        assert made.Shape.Solids if name in ("box", "wedge", "bracket", "shaft_segment") else made.Even


def main():
    doc = new_document()
    for step in (follows_its_solid, nothing_is_meshed_for_nothing, only_marked_without_auto_update,
                 a_fault_keeps_the_old_mesh, a_failing_gmsh_is_named, an_odd_surface_is_told,
                 copies_work_on_their_own):
        print("step", step.__name__, flush=True)
        step(doc)
    doc = survives_save_and_load(doc)
    an_analysis_is_made_once(doc)
    results_of_an_older_mesh_say_so(doc, a_missing_ccx_is_named(doc))
    outlives_its_solid(doc)
    examples_open()


status = 1
try:
    main()
    status = 0
except BaseException:
    traceback.print_exc()
sys.stdout.flush()
sys.stderr.flush()
os._exit(status)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh of topology only in FreeCAD: no FEM object without the override, and none without the word.

The meshes are blocks that are called topological: what is tested is the word alone.
"""
import pytest
from hex_grids import block

import hexcon
from hexcon import femmesh, freecad_compat
from hexcon.errors import FaultCode
from hexcon.quads.surface import given
from hexcon.topological import is_topological

pytestmark = pytest.mark.usefixtures("freecad")
SIZE = (8.0, 1.0, 1.0)


@pytest.fixture
def mesh():
    """A mesh of the box of SIZE that is called topological."""
    made = block(8, 2, 2, SIZE)
    made.method, made.topological = "pyramid", True
    made.quality = made.certificate = None
    made.report = {"log": []}
    made.surface = given(made.points, femmesh.elements_of(made).quads, [])
    return made


def refused(call, *arguments, **options):
    """The words of the refusal."""
    with pytest.raises(hexcon.ToolError) as caught:
        call(*arguments, **options)
    assert caught.value.code is FaultCode.TOPOLOGICAL_MESH
    assert "topology only" in str(caught.value) and "allow_topological" in str(caught.value)
    return str(caught.value)


def test_no_femmesh_without_the_override(mesh):
    for call in (hexcon.to_femmesh, femmesh.to_femmesh):
        refused(call, mesh)
        refused(call, mesh, 2)
        assert call(mesh, 2, allow_topological=True).HexaCount == 32
    mesh.topological = False
    assert hexcon.to_femmesh(mesh).HexaCount == 32


@pytest.mark.parametrize("undo", [0, 1])
def test_the_document_is_untouched(doc, box_in, mesh, undo):
    solid = box_in(SIZE)
    doc.UndoMode = undo
    before = doc.UndoCount
    refused(femmesh.add_to_document, doc, mesh, solid)
    refused(hexcon.solve, doc, mesh, solid)
    assert [o.Name for o in doc.Objects] == ["Box"] and doc.UndoCount == before


def test_the_object_says_so_after_save_and_reload(freecad, doc, box_in, mesh, tmp_path):
    solid = box_in(SIZE)
    made = femmesh.add_to_document(doc, mesh, solid, allow_topological=True)
    mesh.topological = False
    plain = femmesh.add_to_document(doc, mesh, solid)
    names = made.Name, plain.Name
    doc.saveAs(str(tmp_path / "saved.FCStd"))
    freecad.closeDocument(doc.Name)
    again = freecad.openDocument(str(tmp_path / "saved.FCStd"))
    try:
        made, plain = map(again.getObject, names)
        assert made.Label == f"{names[0]} (topological)" and plain.Label == names[1]
        assert is_topological(made) and made.Topological is True
        assert not is_topological(plain) and "Topological" not in plain.PropertiesList
        assert made.Proxy.Type == "HexCon::HexMesh" and made.FemMesh.HexaCount == 32
        words = refused(hexcon.solve, again, made, again.Box)
        assert made.Label in words
    finally:
        freecad.closeDocument(again.Name)


def test_undo_takes_it_away_in_one_step(doc, box_in, mesh):
    solid = box_in(SIZE)
    doc.UndoMode = 1
    femmesh.add_to_document(doc, mesh, solid, allow_topological=True)
    doc.undo()
    assert [o.Name for o in doc.Objects] == ["Box"]


def test_a_document_file(freecad, mesh, tmp_path):
    refused(hexcon.write, mesh, tmp_path / "x.FCStd")
    assert not list(tmp_path.iterdir())
    hexcon.write(mesh, tmp_path / "x.FCStd", allow_topological=True)
    document = freecad.openDocument(str(tmp_path / "x.FCStd"))
    try:
        made, = [o for o in document.Objects if o.isDerivedFrom("Fem::FemMeshObject")]
        assert is_topological(made) and made.Label.endswith("(topological)")
    finally:
        freecad.closeDocument(document.Name)


def test_solving_by_override(doc, box_in, mesh):
    """From arrays and from an object; the object that is made is marked."""
    solid = box_in(SIZE)
    options = {"fixed": ["Face1"], "force": {"Face2": (0, 0, -1)}, "order": 2}
    result = hexcon.solve(doc, mesh, solid, allow_topological=True, **options)
    assert result.max_displacement > 0
    made, = [o for o in doc.Objects if getattr(o, "Topological", False)]
    refused(hexcon.solve, doc, made, solid, **options)
    again = hexcon.solve(doc, made, solid, allow_topological=True, **options)
    assert again.max_displacement == pytest.approx(result.max_displacement)


# --------------------------------------------------------------------- what the window's calls say

def test_actions_refuse_before_the_work(doc, box_in, monkeypatch):
    from hexcon.document import making_hexes
    from hexcon.gui import actions
    solid = box_in(SIZE)
    monkeypatch.setattr(making_hexes, "mesh_solid", lambda *_, **__: pytest.fail("work was done"))
    refused(actions.mesh_solid_object, solid, 1.0, method="geode")
    assert [o.Name for o in doc.Objects] == ["Box"]


def test_actions_by_override(doc, box_in, mesh, monkeypatch):
    from hexcon.document import making_hexes
    from hexcon.gui import actions
    solid = box_in(SIZE)
    monkeypatch.setattr(making_hexes, "mesh_solid", lambda *_, **__: mesh)
    made = actions.mesh_solid_object(solid, 1.0, method="geode", allow_topological=True)
    assert made.Label.endswith("(topological)")
    assert freecad_compat.solid_of_mesh_object(made) == solid
    report = actions.check_mesh_object(made)
    assert report.topological and "Topological: topology only" in str(report)
    mesh.topological = False
    plain = actions.mesh_solid_object(solid, 1.0)
    assert "Topological" not in str(actions.check_mesh_object(plain))


def test_a_mesh_that_is_topological_whatever_the_method_said(doc, box_in, mesh, monkeypatch):
    from hexcon.document import making_hexes
    from hexcon.gui import actions
    solid = box_in(SIZE)
    monkeypatch.setattr(making_hexes, "mesh_solid", lambda *_, **__: mesh)
    refused(actions.mesh_solid_object, solid, 1.0)
    assert [o.Name for o in doc.Objects] == ["Box"]


def test_words_of_what_was_not_checked(mesh):
    from hexcon.judging import words
    mesh.certificate = mesh.quality = None
    mesh.report = {"log": []}
    said = words.as_text(words.of_mesh(mesh))
    for line in ("Method: pyramid; 0.4 hexes a quad", "Topological: topology only",
                 "Scaled Jacobian: not checked", "Certificate: not checked"):
        assert line in said

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces in .med files, as Salome and FreeCAD write them: quads with groups, in a file that is called otherwise."""
import pathlib
import shutil
import sys

import numpy as np
import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))
from deck_texts import GRID, OUTER  # noqa: E402
from hex_grids import block  # noqa: E402
from quad_figures import volume_of  # noqa: E402

from hexcon.errors import FaultCode, ToolError  # noqa: E402
from hexcon.quads import surface_from_file  # noqa: E402


def fail(_):
    raise ToolError("no results, says the test", FaultCode.TOOL_FAILED)


@pytest.mark.parametrize("name", ("Mesh_1.med", "another name.med"))
def test_quads_with_groups(freecad, tmp_path, name):
    from hexcon.freecad_compat import fem_module
    mesh = fem_module("Fem").FemMesh()
    for k, place in enumerate(GRID.tolist(), 1):
        mesh.addNode(*place, k)
    for k, quad in enumerate((OUTER + 1).tolist(), 1):
        mesh.addFace(quad, k)
    mesh.addGroupElements(mesh.addGroup("in let", "Face"), [1, 2, 3])
    mesh.addGroupElements(mesh.addGroup("corner", "Node"), [1])
    mesh.write(str(tmp_path / "Mesh_1.med"))
    if name != "Mesh_1.med":
        shutil.move(tmp_path / "Mesh_1.med", tmp_path / name)
    surface = surface_from_file(tmp_path / name)
    assert len(surface.quads) == 24 and np.isclose(volume_of(surface.points, surface.quads), 6000)
    assert {key: len(rows) for key, rows in surface.quad_groups.items()} == {"in let": 3}
    assert surface.points[surface.node_groups["corner"]].tolist() == [[0, 0, 0]]


def test_check_and_solve_take_documents(freecad, tmp_path, capsys):
    """A .FCStd that HexCon wrote: its mesh object, with the CAD faces."""
    import Part

    from hexcon import files
    from hexcon.cli import main
    box = block(2, 2, 2, (10.0, 20.0, 30.0))
    files.write(box, tmp_path / "m.FCStd", solid=Part.makeBox(10, 20, 30))
    assert main(["check", str(tmp_path / "m.FCStd")]) == 0
    assert main(["solve", str(tmp_path / "m.FCStd"), "--fixed", "Face5", "--force", "Face6=0,0,100"]) == 0
    assert "deflection" in capsys.readouterr().out


def test_a_scale_for_the_file_of_a_quad_surface(freecad, tmp_path):
    """A property of the object: with another one the quads are made anew."""
    from deck_texts import SHELL

    from hexcon.document.making_quads import import_quad_surface
    (tmp_path / "m.inp").write_text(SHELL, encoding="ascii")
    made = import_quad_surface(tmp_path / "m.inp", scale=25.4)
    try:
        assert made.FemMesh.BoundBox.ZMax == pytest.approx(762) and made.Scale == 25.4
        made.Scale = 2.0
        made.Document.recompute()
        assert made.FemMesh.BoundBox.ZMax == pytest.approx(60)
    finally:
        freecad.closeDocument(made.Document.Name)


def test_a_mesh_without_a_solid_is_solved_by_its_groups(freecad, tmp_path):
    """As the window's panel does: groups held and loaded by name; the same displacements as on the command line."""
    from hexcon.calculix import solve_inp, static_deck
    from hexcon.document.analyses import load_and_solve
    from hexcon.femmesh.document import add_to_document
    box = block(2, 2, 2, (10.0, 20.0, 30.0))
    box.face_of_quad, faces = np.zeros_like(box.face_of_quad), box.face_of_quad
    box.quad_groups = {"hold it": np.flatnonzero(faces == 5), "pull it": np.flatnonzero(faces == 6)}
    doc = freecad.newDocument("Named", hidden=True)
    try:
        result = load_and_solve(add_to_document(doc, box, None), ["hold it"], {"pull it": (0.0, 0.0, 100.0)})
        right = solve_inp(static_deck(box, fixed=["hold it"], force={"pull it": (0.0, 0.0, 100.0)}))
        assert result.max_displacement == pytest.approx(right.max_displacement) and result.max_displacement > 0
        assert len(result.document_object.DisplacementVectors) == 27
        assert "*ELEMENT, TYPE=C3D8," in pathlib.Path(result.inp_path).read_text(encoding="utf-8")
    finally:
        freecad.closeDocument(doc.Name)


def test_groups_are_solved_with_the_elements_chosen(freecad):
    """ElementType counts for groups as for faces; a run that fails leaves the mesh in its analysis, and rows."""
    from hexcon.calculix import by_names
    from hexcon.femmesh.document import add_to_document
    from hexcon.femmesh.element_types import CHOICES, PROPERTY
    box = block(2, 2, 2, (10.0, 20.0, 30.0))
    doc = freecad.newDocument("Chosen", hidden=True)
    try:
        made = add_to_document(doc, box, None)
        made.addProperty("App::PropertyEnumeration", PROPERTY, "HexCon", "")
        setattr(made, PROPERTY, list(CHOICES))
        setattr(made, PROPERTY, "C3D8R")
        assert by_names.names_of(made) == [f"Face{k}" for k in range(1, 7)]
        loads = {"fixed": ["Face5"], "force": {"Face6": (0.0, 0.0, 100.0)}}
        result = by_names.solve_by_names(doc, made, **loads)
        assert "*ELEMENT, TYPE=C3D8R," in pathlib.Path(result.inp_path).read_text(encoding="utf-8")
        analysis, objects = made.getParentGroup(), [o.Name for o in doc.Objects]
        with pytest.MonkeyPatch.context() as patch, pytest.raises(ToolError) as fault:
            patch.setattr(by_names, "result_object_of", fail)
            by_names.solve_by_names(doc, made, **loads)
        assert "no results" in str(fault.value)
        assert made.getParentGroup() == analysis and [o.Name for o in doc.Objects] == objects
        setattr(made, PROPERTY, "C3D20")
        with pytest.raises(ToolError, match="order 1"):
            by_names.solve_by_names(doc, made, **loads)
    finally:
        freecad.closeDocument(doc.Name)

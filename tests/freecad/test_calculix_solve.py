# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solving through FreeCAD's FEM workbench."""
import os
import pathlib
import tempfile

import numpy as np
import pytest
from hex_grids import block, cylinder, distorted

from hexcon import calculix, femmesh, keeper
from hexcon.calculix.freecad_deck import nodal_loads
from hexcon.errors import FaultCode, ToolError

pytestmark = pytest.mark.usefixtures("freecad")

PULL = {"Face2": (1.0, 0.0, 0.0)}
NO_POISSON = {"name": "Bar", "young": 210000.0, "poisson": 0.0}


@pytest.fixture(autouse=True)
def folders_of_runs(tmp_path, monkeypatch):
    """solve() keeps its working folder; keep the tests' ones together."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))


def force_in_deck(result):
    text = pathlib.Path(result.inp_path).read_text()
    return nodal_loads(text, np.arange(1, len(result.displacements) + 1))


@pytest.mark.parametrize("order", [1, 2])
def test_one_hex(doc, box_in, order):
    """The first test of the node order: in VTK's, ccx ends with a nonpositive jacobian."""
    solid = box_in((2.0, 1.0, 1.0))
    result = calculix.solve(doc, block(1, 1, 1, (2.0, 1.0, 1.0)), solid, order=order,
                            material=NO_POISSON, fixed=["Face1"],
                            force={"Face2": (21.0, 0.0, 0.0)})
    points = femmesh.elements_of(block(1, 1, 1, (2.0, 1.0, 1.0)), order).points
    right = points * [1e-4, 0, 0]
    assert np.allclose(result.displacements, right, atol=1e-9)
    assert np.allclose(result.von_mises, 21.0, rtol=1e-4)
    assert ("C3D20" if order == 2 else "C3D8,") in pathlib.Path(result.inp_path).read_text()


def test_the_folder_of_a_run_outlives_the_process(doc, box_in):
    """It holds the deck and what CalculiX said: the keeper, which removes temporary folders, has let go of it."""
    result = calculix.solve(doc, block(1, 1, 1, (2.0, 1.0, 1.0)), box_in((2.0, 1.0, 1.0)), force={"Face2": (0, 0, 1.0)})
    folder = os.path.dirname(result.inp_path)
    assert os.path.basename(folder).startswith("hexcon-fem-")
    assert not any(os.fsencode(folder) in record for record in keeper._keeper._held)


def test_nothing_loaded_is_refused(doc, box_in):
    before = len(doc.Objects)
    with pytest.raises(ToolError, match="no load is given") as raised:
        calculix.solve(doc, block(1, 1, 1), box_in((1.0, 1.0, 1.0)))
    assert raised.value.code is FaultCode.BAD_OPTION and len(doc.Objects) == before + 1


def test_results_are_in_the_document(freecad, doc, box_in, tmp_path):
    solid = box_in((4.0, 1.0, 1.0))
    result = calculix.solve(doc, block(4, 2, 2, (4.0, 1.0, 1.0)), solid,
                            force={"Face2": (0, 0, -10.0)}, workdir=str(tmp_path))
    kinds = {o.TypeId for o in result.document_objects}
    assert {"Fem::FemAnalysis", "Fem::FemSolverObjectPython", "Fem::ConstraintFixed",
            "Fem::ConstraintForce", "Fem::FemMeshObjectPython",
            "Fem::FemResultObjectPython"} <= kinds
    found = np.array([tuple(v) for v in result.document_object.DisplacementVectors])
    assert np.allclose(found, result.displacements, atol=1e-12)
    assert np.allclose(result.document_object.vonMises, result.von_mises, rtol=1e-5)
    assert result.max_displacement == pytest.approx(max(
        result.document_object.DisplacementLengths))
    assert pathlib.Path(result.inp_path).parent == tmp_path
    assert "Job finished" in result.ccx_log
    name = result.document_object.Name
    doc.saveAs(str(tmp_path / "solved.FCStd"))
    freecad.closeDocument(doc.Name)
    again = freecad.openDocument(str(tmp_path / "solved.FCStd"))
    try:
        loaded = again.getObject(name)
        assert len(loaded.DisplacementVectors) == len(found)
        assert loaded.getParentGroup().isDerivedFrom("Fem::FemAnalysis")
    finally:
        freecad.closeDocument(again.Name)


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("force", [(0, 0, -10.0), (7.0, 0, 0), (1.0, -2.0, 3.0)])
def test_force_is_right_in_size_and_direction(doc, box_in, order, force):
    """Along an edge of the solid, along a normal, and along nothing the solid has."""
    solid = box_in((3.0, 2.0, 2.0))
    result = calculix.solve(doc, block(3, 2, 3, (3.0, 2.0, 2.0)), solid, order=order,
                            force={"Face2": force})
    loads = force_in_deck(result)
    assert np.allclose(loads.sum(axis=0), force, atol=1e-9)
    assert np.allclose(result.report["force_sum"], force, atol=1e-9)
    assert result.report["notes"] == []  # FreeCAD's own loads were right
    loaded = np.flatnonzero(np.abs(loads).max(axis=1) > 0)
    on_face = femmesh.face_nodes(block(3, 2, 3, (3.0, 2.0, 2.0)), 2, order)
    assert set(loaded) == set(on_face)


def test_two_forces_that_cancel(doc, box_in):
    solid = box_in((3.0, 2.0, 2.0))
    result = calculix.solve(doc, block(3, 2, 3, (3.0, 2.0, 2.0)), solid, material=NO_POISSON,
                            force={"Face6": (0, 0, 40.0), "Face5": (0, 0, -40.0)})
    assert np.allclose(force_in_deck(result).sum(axis=0), 0, atol=1e-9)
    assert result.max_displacement > 1e-6


@pytest.mark.parametrize("order", [1, 2])
def test_force_on_a_round_face_is_put_right(doc, cylinder_in, order):
    """FreeCAD divides by the area of the circle, not of the polygon: here 3 % too little."""
    solid = cylinder_in(5.0, 8.0)
    result = calculix.solve(doc, cylinder(4, 3, 5.0, 8.0), solid, order=order,
                            fixed=["Face2"], force={"Face3": (0, 0, -100.0)})
    assert np.allclose(force_in_deck(result).sum(axis=0), (0, 0, -100.0), atol=1e-6)
    assert len(result.report["notes"]) == 1 and "replaced" in result.report["notes"][0]
    assert ("straight edges" in result.report) == (order == 2)    # the mesh has order 1


def test_curved_faces_at_second_order(doc, cylinder_in):
    """Middle nodes of straight edges lie off the cylinder: FreeCAD alone would hold the
    corners only, and write neither pressure nor force there."""
    solid = cylinder_in(5.0, 8.0)
    mesh = cylinder(4, 3, 5.0, 8.0)
    result = calculix.solve(doc, mesh, solid, order=2, fixed=["Face1"],
                            pressure={"Face3": 2.0})
    side = femmesh.face_nodes(mesh, 1, 2)
    assert (result.displacements[side] == 0).all()
    assert any("ConstraintFixed" in note for note in result.report["notes"])

    squeezed = calculix.solve(doc, mesh, solid, order=2, fixed=["Face2"],
                              pressure={"Face1": 10.0})
    alone = calculix.solve_inp(calculix.static_deck(
        mesh, fixed=["Face2"], pressure={"Face1": 10.0}, order=2))
    assert np.allclose(squeezed.displacements, alone.displacements,
                       atol=1e-6 * alone.max_displacement)
    assert squeezed.max_displacement > 1e-5

    pulled = calculix.solve(doc, mesh, solid, order=2, fixed=["Face2"],
                            force={"Face1": (0, 50.0, 0)})
    assert np.allclose(force_in_deck(pulled).sum(axis=0), (0, 50.0, 0), atol=1e-6)


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("value", [5.0, -5.0])
def test_pressure_pushes_onto_the_face(doc, box_in, order, value):
    solid = box_in((2.0, 1.0, 1.0))
    mesh = distorted(block(4, 2, 2, (2.0, 1.0, 1.0)), 0.08, keep=("x", "y", "z"))
    result = calculix.solve(doc, mesh, solid, material=NO_POISSON, order=order,
                            pressure={"Face2": value})
    right = -value / 210000.0 * femmesh.elements_of(mesh, order).points[:, 0]
    assert np.allclose(result.displacements[:, 0], right, atol=1e-6 * abs(right).max())
    assert result.report["notes"] == []


@pytest.mark.parametrize("order", [1, 2])
def test_same_as_the_bare_deck(doc, box_in, order):
    """FreeCAD's road and the one without it agree, loads of three kinds at once."""
    solid = box_in((3.0, 2.0, 2.0))
    mesh = block(5, 3, 3, (3.0, 2.0, 2.0))
    loads = dict(fixed=["Face1", "Face3"], force={"Face2": (3.0, 1.0, -2.0)},
                 pressure={"Face6": 4.0})
    through = calculix.solve(doc, mesh, solid, order=order, **loads)
    bare = calculix.solve_inp(calculix.static_deck(mesh, order=order, **loads))
    assert np.allclose(through.displacements, bare.displacements,
                       atol=1e-5 * bare.max_displacement)


@pytest.mark.parametrize("order", [1, 2])
def test_freecad_finds_the_element_faces_of_every_box_face(doc, box_in, order):
    solid = box_in((1.0, 1.0, 1.0))
    for number in range(2, 7):
        result = calculix.solve(doc, block(2, 2, 2), solid, order=order,
                                pressure={f"Face{number}": 1.0})
        assert result.report["notes"] == []


def test_a_mesh_object_of_the_document(doc, box_in):
    solid = box_in((3.0, 1.0, 1.0))
    mesh = block(3, 1, 1, (3.0, 1.0, 1.0))
    mesh_object = femmesh.add_to_document(doc, mesh, solid, order=2)
    result = calculix.solve(doc, mesh_object, solid, force={"Face2": (0, 0, -1.0)})
    assert len(result.displacements) == len(femmesh.elements_of(mesh, 2).points)
    assert mesh_object not in result.document_objects
    assert mesh_object.getParentGroup().isDerivedFrom("Fem::FemAnalysis")


def test_a_mesh_without_face_groups(doc, box_in):
    solid = box_in((3.0, 1.0, 1.0))
    mesh = block(3, 2, 2, (3.0, 1.0, 1.0))
    mesh.face_of_quad = None
    result = calculix.solve(doc, mesh, solid, force={"Face2": (0, 0, -1.0)},
                            pressure={"Face6": 1.0})
    assert result.max_displacement > 0 and result.report["notes"] == []


@pytest.mark.parametrize("undo", [0, 1])
@pytest.mark.parametrize("given", ["mesh", "object"])
def test_failure_with_ccx_words_leaves_the_document(doc, box_in, undo, given):
    solid = box_in((2.0, 1.0, 1.0))
    mesh = block(2, 1, 1, (2.0, 1.0, 1.0))
    mesh.hexes[1] = mesh.hexes[1, [4, 5, 6, 7, 0, 1, 2, 3]]  # inside out
    if given == "object":
        mesh = femmesh.add_to_document(doc, mesh, solid)
        group = doc.addObject("App::DocumentObjectGroup", "Mine")
        group.addObject(mesh)
    doc.UndoMode = undo
    before = [o.Name for o in doc.Objects]
    with pytest.raises(ToolError) as raised:
        calculix.solve(doc, mesh, solid, force={"Face2": (0, 0, -1.0)})
    assert raised.value.code is FaultCode.TOOL_FAILED
    assert "nonpositive jacobian" in str(raised.value)
    assert raised.value.elements == [1]
    assert [o.Name for o in doc.Objects] == before
    assert doc.UndoCount == 0
    if given == "object":
        assert mesh.getParentGroup() is group
        assert mesh.FemMesh.HexaCount == 2 and mesh.FemMesh.GroupCount == 6


def test_options_that_make_no_sense(doc, box_in, monkeypatch, tmp_path):
    solid = box_in((1.0, 1.0, 1.0))
    mesh = block(1, 1, 1)
    cases = [(dict(fixed=["Face9"]), FaultCode.BAD_OPTION, "Face6"),
             (dict(fixed=[]), FaultCode.BAD_OPTION, "fixed"),
             (dict(fixed=["top"]), FaultCode.BAD_OPTION, "top"),
             (dict(force={"Face2": (1, 2)}), FaultCode.BAD_OPTION, "three"),
             (dict(material={"young": 1.0}), FaultCode.BAD_OPTION, "Poisson"),
             (dict(material={"young": "5 bananas", "poisson": 0}), FaultCode.BAD_OPTION,
              "bananas"),
             (dict(workdir=str(tmp_path / "none"), force=PULL), FaultCode.FILE_IO, "none")]
    for options, code, word in cases:
        with pytest.raises(ToolError, match=word) as raised:
            calculix.solve(doc, mesh, solid, **options)
        assert raised.value.code is code
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(ToolError, match="apt install calculix-ccx") as raised:
        calculix.solve(doc, mesh, solid, force=PULL)
    assert raised.value.code is FaultCode.TOOL_MISSING
    assert [o.Name for o in doc.Objects] == ["Box"]


LENGTH, SIDE, FORCE, YOUNG, POISSON = 100.0, 10.0, 100.0, 210000.0, 0.3


def timoshenko():
    """Deflection of the end of a cantilever with a square section, mm."""
    shear = YOUNG / (2 * (1 + POISSON))
    factor = 10 * (1 + POISSON) / (12 + 11 * POISSON)
    return (FORCE * LENGTH ** 3 / (3 * YOUNG * SIDE ** 4 / 12)
            + FORCE * LENGTH / (factor * shear * SIDE ** 2))


@pytest.mark.parametrize("order, cells, within", [
    (1, (40, 4, 4), 0.05), (1, (60, 6, 6), 0.03),
    (2, (10, 1, 1), 0.025), (2, (20, 2, 2), 0.015), (2, (30, 3, 3), 0.015)])
def test_cantilever(doc, box_in, order, cells, within):
    size = (LENGTH, SIDE, SIDE)
    solid, mesh = box_in(size), block(*cells, size)
    result = calculix.solve(doc, mesh, solid, order=order, fixed=["Face1"],
                            force={"Face2": (0, 0, -FORCE)})
    end = femmesh.face_nodes(mesh, 2, order)
    ratio = -result.displacements[end, 2].mean() / timoshenko()
    print(f"C3D{8 if order == 1 else 20} {cells}: {ratio:.4f} of Timoshenko")
    assert abs(ratio - 1) < within

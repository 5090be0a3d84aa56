# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hex mesh to FemMesh and document."""
import numpy as np
import pytest
from hex_grids import block, cylinder, distorted

from hexcon import femmesh
from hexcon.errors import FaultCode, ToolError

pytestmark = pytest.mark.usefixtures("freecad")


@pytest.mark.parametrize("order, kind", [(1, 8), (2, 20)])
def test_counts_groups_and_numbers(order, kind):
    made = femmesh.to_femmesh(block(3, 2, 2), order)
    assert made.HexaCount == made.VolumeCount == 12
    assert made.FaceCount == made.QuadrangleCount == 32
    assert {len(made.getElementNodes(v)) for v in made.Volumes} == {kind}
    assert made.Volumes == tuple(range(1, 13))
    names = {made.getGroupName(g): len(made.getGroupElements(g)) for g in made.Groups}
    assert names == {"Face1": 4, "Face2": 4, "Face3": 6, "Face4": 6, "Face5": 6, "Face6": 6}
    assert {made.getGroupElementType(g) for g in made.Groups} == {"Face"}


@pytest.mark.parametrize("order", [1, 2])
def test_back_from_femmesh(order):
    mesh = distorted(block(2, 3, 2), 0.05)
    elements = femmesh.elements_of(mesh, order)
    back = femmesh.from_femmesh(femmesh.to_femmesh(mesh, order))
    assert np.array_equal(back.points, elements.points)
    assert np.array_equal(back.hexes, elements.hexes)
    again = femmesh.elements_of(back)
    for number in range(1, 7):
        assert (sorted(map(tuple, again.quads[again.quads_of_face(number)]))
                == sorted(map(tuple, elements.quads[elements.quads_of_face(number)])))


def test_second_order_keeps_points_and_halves_edges():
    mesh = distorted(block(2, 2, 2), 0.1)
    elements = femmesh.elements_of(mesh, 2)
    assert np.array_equal(elements.points[:27], mesh.points)
    assert len(elements.points) == 27 + 54  # a grid of 2 x 2 x 2 has 54 edges
    for middle, (a, b) in {8: (0, 1), 13: (5, 6), 19: (3, 7)}.items():
        half = elements.points[elements.hexes[:, [a, b]]].mean(axis=1)
        assert np.allclose(elements.points[elements.hexes[:, middle]], half, atol=1e-15)
    lowered = femmesh.elements_of(elements, 1)
    assert np.array_equal(lowered.points, mesh.points)
    assert np.array_equal(lowered.hexes, mesh.hexes)


def test_boundary_is_found_where_no_quads_are_given():
    mesh = block(3, 3, 2)
    given = femmesh.elements_of(mesh)
    mesh.quads = mesh.face_of_quad = None
    found = femmesh.elements_of(mesh)
    assert ({frozenset(q) for q in found.quads.tolist()}
            == {frozenset(q) for q in given.quads.tolist()})
    corners = found.points[found.quads]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 3] - corners[:, 0])
    outward = corners.mean(axis=1) - found.points.mean(axis=0)
    assert (np.einsum("ij,ij->i", normals, outward) > 0).all()


@pytest.mark.parametrize("order", [1, 2])
def test_constraints_find_the_nodes_of_every_box_face(box_in, order):
    solid = box_in((10.0, 4.0, 3.0))
    mesh = block(5, 3, 2, (10.0, 4.0, 3.0))
    made = femmesh.to_femmesh(mesh, order)
    for number, face in enumerate(solid.Shape.Faces, 1):
        found = np.array(sorted(made.getNodesByFace(face))) - 1
        assert np.array_equal(found, femmesh.face_nodes(mesh, number, order))
        assert len(made.getFacesByFace(face)) == (mesh.face_of_quad == number).sum()


def test_constraints_find_the_nodes_of_every_cylinder_face(cylinder_in):
    solid = cylinder_in(5.0, 8.0)
    mesh = cylinder(6, 3, 5.0, 8.0)
    made = femmesh.to_femmesh(mesh)
    for number, face in enumerate(solid.Shape.Faces, 1):
        found = np.array(sorted(made.getNodesByFace(face))) - 1
        assert np.array_equal(found, femmesh.face_nodes(mesh, number))
        assert len(made.getFacesByFace(face)) == (mesh.face_of_quad == number).sum()


@pytest.mark.parametrize("order", [1, 2])
def test_mesh_object_survives_save_and_reload(freecad, doc, box_in, order, tmp_path):
    mesh = block(2, 2, 2, (2.0, 2.0, 2.0))
    mesh_object = femmesh.add_to_document(doc, mesh, box_in((2.0, 2.0, 2.0)), order=order)
    name, before = mesh_object.Name, femmesh.from_femmesh(mesh_object.FemMesh)
    doc.saveAs(str(tmp_path / "saved.FCStd"))
    freecad.closeDocument(doc.Name)
    again = freecad.openDocument(str(tmp_path / "saved.FCStd"))
    try:
        loaded = again.getObject(name)
        from hexcon.freecad_compat import solid_of_mesh_object
        assert solid_of_mesh_object(loaded).Name == "Box"
        assert loaded.Proxy.Type == "HexCon::HexMesh"
        after = femmesh.from_femmesh(loaded.FemMesh)
        assert np.array_equal(after.hexes, before.hexes)
        assert np.allclose(after.points, before.points, atol=1e-12)
        assert np.array_equal(np.sort(after.face_of_quad), np.sort(before.face_of_quad))
    finally:
        freecad.closeDocument(again.Name)


def test_one_undo_step(doc, box_in):
    solid = box_in((1.0, 1.0, 1.0))
    doc.UndoMode = 1
    femmesh.add_to_document(doc, block(1, 1, 1), solid)
    assert doc.UndoNames[0] == "Hex mesh"
    doc.undo()
    assert [o.Name for o in doc.Objects] == ["Box"]


@pytest.mark.parametrize("undo", [0, 1])
def test_document_is_untouched_on_failure(doc, box_in, undo, monkeypatch):
    solid = box_in((1.0, 1.0, 1.0))
    doc.UndoMode = undo
    bad = block(2, 1, 1)
    bad.hexes[1, 3] = 99
    with pytest.raises(ToolError) as raised:
        femmesh.add_to_document(doc, bad, solid)
    assert raised.value.code is FaultCode.BAD_MESH and raised.value.elements == [1]
    from hexcon.femmesh import document
    monkeypatch.setattr(document.HexMesh, "__init__", lambda self, obj: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        femmesh.add_to_document(doc, block(1, 1, 1), solid)
    assert [o.Name for o in doc.Objects] == ["Box"]


def test_faults_have_names():
    mesh = block(1, 1, 1)
    with pytest.raises(ToolError) as raised:
        femmesh.to_femmesh(mesh, order=3)
    assert raised.value.code is FaultCode.BAD_OPTION
    with pytest.raises(ToolError) as raised:
        femmesh.face_nodes(mesh, 7)
    assert raised.value.code is FaultCode.BAD_OPTION and "Face6" in str(raised.value)
    mesh.quads = np.array([[0, 1, 2, 7]])
    mesh.face_of_quad = None
    with pytest.raises(ToolError) as raised:
        femmesh.to_femmesh(mesh)
    assert raised.value.code is FaultCode.BAD_MESH and raised.value.elements == [0]
    mesh = block(1, 1, 1)
    mesh.points[3, 1] = np.nan
    with pytest.raises(ToolError) as raised:
        femmesh.to_femmesh(mesh)
    assert raised.value.elements == [3]


def test_a_mesh_object_is_exported_with_its_whole_boundary(tmp_path, freecad):
    """Groups of some faces only: the others are on the boundary all the same."""
    from hexcon import files
    from hexcon.gui.actions import export_hex_mesh
    mesh = block(2, 2, 2)
    mesh.face_of_quad = np.where(mesh.face_of_quad > 2, 0, mesh.face_of_quad)
    document = freecad.newDocument("Export", hidden=True, temp=True)
    try:
        thing = document.addObject("Fem::FemMeshObject", "Mesh")
        thing.FemMesh = femmesh.to_femmesh(mesh)
        export_hex_mesh(thing, str(tmp_path / "m.inp"))
        export_hex_mesh(thing, str(tmp_path / "m.re2"))
    finally:
        freecad.closeDocument(document.Name)
    back = files.read_mesh(tmp_path / "m.inp")
    assert len(back.quads) == 24 and np.bincount(back.face_of_quad).tolist() == [16, 4, 4]
    assert (tmp_path / "m.re2").stat().st_size == 84 + 8 * 200 + 8 + 8 + 24 * 64     # all 24 faces

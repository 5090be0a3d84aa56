# SPDX-License-Identifier: LGPL-2.1-or-later
"""The textbook's cantilever, 100 x 10 x 10 mm of steel, by the whole road a user goes: a Part box
in a document, mesh_solid, the mesh object, FreeCAD's analysis, CalculiX, the results."""
import tempfile

import numpy as np
import pytest
from test_calculix_solve import FORCE, LENGTH, SIDE, timoshenko

import hexcon
from hexcon import femmesh, freecad_compat

HELD, LOADED = "Face1", "Face2"  # x = 0 and x = 100
GRIDS = [(1, 2.5, 0.05), (1, 1.5, 0.05), (1, 1.25, 0.02),
         (2, 10.0, 0.025), (2, 5.0, 0.015), (2, 2.5, 0.015)]  # order, size, allowed error


@pytest.fixture(autouse=True)
def folders_of_runs(tmp_path, monkeypatch):
    """solve() keeps its working folder; keep the tests' ones together."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))


def solved(doc, solid, size, order):
    """(mesh, mesh object, result) of the box, FORCE N downwards on its end."""
    mesh = hexcon.mesh_solid(solid.Shape, size, order=order)
    mesh_object = femmesh.add_to_document(doc, mesh, solid)
    result = hexcon.solve(doc, mesh_object, solid, fixed=(HELD,),
                          force={LOADED: (0.0, 0.0, -FORCE)})
    return mesh, mesh_object, result


@pytest.mark.parametrize("order,size,within", GRIDS)
def test_deflection(doc, box_in, order, size, within):
    mesh, _, result = solved(doc, box_in((LENGTH, SIDE, SIDE)), size, order)
    assert mesh.certificate.certified and mesh.order == order
    end = femmesh.face_nodes(mesh, int(LOADED[4:]))
    deflection = -result.displacements[end, 2].mean()
    print(f"order {order}, size {size}: {len(mesh.hexes)} hexes, {len(mesh.points)} nodes, end "
          f"deflection {deflection:.6f} mm, {deflection / timoshenko():.4f} of Timoshenko")
    assert abs(deflection / timoshenko() - 1) < within
    assert np.allclose(result.report["force_sum"], (0, 0, -FORCE), atol=1e-9 * FORCE)


def nodes_by_freecad(femmesh_, constraint):
    """Node numbers FreeCAD's FEM workbench gives to a constraint when it writes a deck."""
    tools = freecad_compat.fem_module("femmesh.meshtools")
    return sorted(tools.get_femnodes_by_femobj_with_references(femmesh_, {"Object": constraint}))


@pytest.mark.parametrize("order", [1, 2])
def test_saved_and_reloaded(freecad, doc, box_in, order, tmp_path):
    mesh, mesh_object, result = solved(doc, box_in((LENGTH, SIDE, SIDE)), 5.0, order)
    names = mesh_object.Name, result.document_object.Name
    doc.saveAs(str(tmp_path / "cantilever.FCStd"))
    freecad.closeDocument(doc.Name)
    again = freecad.openDocument(str(tmp_path / "cantilever.FCStd"))
    try:
        loaded, results = map(again.getObject, names)
        assert loaded.getParentGroup() is results.getParentGroup() is not None
        found = np.array([tuple(v) for v in results.DisplacementVectors])
        assert np.allclose(found, result.displacements, atol=1e-12)
        assert np.allclose(results.vonMises, result.von_mises, rtol=1e-5)
        held, = [o for o in again.Objects if o.isDerivedFrom("Fem::ConstraintFixed")]
        right = (femmesh.face_nodes(mesh, 1) + 1).tolist()
        assert nodes_by_freecad(loaded.FemMesh, held) == right
        assert np.abs(found[np.array(right) - 1]).max() == 0.0
    finally:
        freecad.closeDocument(again.Name)


def on_face(mesh, number, face):
    """Nodes of the mesh's CAD face that are on it to FreeCAD's 1e-7: corners all, and middles of
    straight edges where the face does not curve."""
    part = freecad_compat.freecad_module("Part")
    nodes = femmesh.face_nodes(mesh, number).tolist()
    on = [n for n in nodes if part.Vertex(*mesh.points[n]).distToShape(face)[0] < 1e-7]
    assert {n for n in nodes if n < len(mesh.surface.points)} <= set(on)
    return [n + 1 for n in on]


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("maker,size", [("box_in", [(10, 7, 5)]), ("cylinder_in", (5, 12))])
def test_constraints_find_their_nodes_on_every_face(request, doc, maker, size, order):
    solid = request.getfixturevalue(maker)(*size)
    mesh = hexcon.mesh_solid(solid.Shape, 2.0, order=order)
    mesh_object = femmesh.add_to_document(doc, mesh, solid)
    objects = freecad_compat.fem_module("ObjectsFem")
    for number, face in enumerate(solid.Shape.Faces, 1):
        held = objects.makeConstraintFixed(doc, f"Held{number}")
        held.References = [(solid, f"Face{number}")]
        right = on_face(mesh, number, face)
        assert order == 2 or len(right) == len(femmesh.face_nodes(mesh, number))
        assert sorted(mesh_object.FemMesh.getNodesByFace(face)) == right
        assert nodes_by_freecad(mesh_object.FemMesh, held) == right


def test_a_curved_face_is_held_with_its_middle_nodes(doc, cylinder_in):
    """They are on the face, so that FreeCAD's own distance test finds all of them."""
    solid = cylinder_in(5, 12)
    mesh = hexcon.mesh_solid(solid.Shape, 2.0, order=2)
    result = hexcon.solve(doc, mesh, solid, fixed=("Face1",), force={"Face3": (0, 0, -100.0)})
    assert len(on_face(mesh, 1, solid.Shape.Faces[0])) == len(femmesh.face_nodes(mesh, 1)) > 0
    assert np.abs(result.displacements[femmesh.face_nodes(mesh, 1)]).max() == 0.0
    assert result.max_displacement > 0.0

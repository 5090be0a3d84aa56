# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh files, there and back."""
import os
import pathlib
import re
import subprocess
import sys

import numpy as np
import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from hex_grids import block, distorted  # noqa: E402

from hexcon import calculix, files  # noqa: E402
from hexcon.errors import FaultCode, ToolError  # noqa: E402
from hexcon.femmesh import elements_of  # noqa: E402

ENDINGS = ["inp", "msh", "vtu", "vtk", "unv", "med"]


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("ending", ENDINGS)
def test_there_and_back(tmp_path, ending, order):
    mesh = distorted(block(3, 2, 2, (3.0, 2.0, 2.0)), 0.1)
    mesh.points -= [1.0, 0.3, 100 / 7]  # negative, and no short decimal numbers
    path = tmp_path / f"mesh.{ending}"
    files.write(mesh, path, order=order)
    points, hexes = files.read_hexes(path)
    right = elements_of(mesh, order)
    assert np.array_equal(hexes, right.hexes)
    # ccx reads 20 characters of a number: .inp keeps 14 digits, the others every bit
    assert np.abs(points - right.points).max() <= (1e-12 if ending == "inp" else 0)
    assert [p.name for p in tmp_path.iterdir()] == [path.name]


@pytest.mark.parametrize("order", [1, 2])
def test_one_hex_in_every_format(tmp_path, order):
    mesh = distorted(block(1, 1, 1), 0.2)
    for ending in ENDINGS:
        files.write(mesh, tmp_path / f"one.{ending}", order=order)
        points, hexes = files.read_hexes(tmp_path / f"one.{ending}")
        corners = points[hexes[0]]
        assert np.abs(corners - elements_of(mesh, order).points[
            elements_of(mesh, order).hexes[0]]).max() < 1e-12
        a, b, c = corners[[1, 3, 4]] - corners[0]
        assert np.dot(np.cross(a, b), c) > 0


@pytest.mark.parametrize("order", [1, 2])
def test_sets_of_the_inp_carry_loads(tmp_path, order):
    """The file's own sets, used by name: the end face moves as a bar in tension does."""
    mesh = block(4, 2, 2, (8.0, 1.0, 1.0))
    files.write(mesh, tmp_path / "bar.inp", order=order)
    deck = """*INCLUDE, INPUT=bar.inp
*BOUNDARY
FACE1_NODES, 1, 1, 0
FACE3_NODES, 2, 2, 0
FACE5_NODES, 3, 3, 0
*STEP
*STATIC
*DSLOAD
FACE2, P, -21.0
*NODE FILE
U
*EL FILE
S
*END STEP
"""
    (tmp_path / "run.inp").write_text(deck)
    result = calculix.solve_inp(tmp_path / "run.inp")
    points = elements_of(mesh, order).points
    assert np.allclose(result.displacements[:, 0], points[:, 0] * 1e-4, atol=1e-9)
    assert np.allclose(result.displacements[:, 1], points[:, 1] * -0.3e-4, atol=1e-9)
    assert np.allclose(result.stress[:, 0], 21.0, rtol=1e-4)


@pytest.mark.parametrize("face, axis", [(1, 0), (2, 0), (3, 1), (4, 1), (5, 2), (6, 2)])
def test_each_surface_is_the_right_side(tmp_path, face, axis):
    """Pressure on one named surface squeezes the cube along that axis alone."""
    mesh = block(2, 2, 2)
    files.write(mesh, tmp_path / "cube.inp")
    opposite = face + 1 if face % 2 else face - 1
    others = [f for f in (1, 3, 5) if (f - 1) // 2 != axis]
    held = [(f, (f - 1) // 2 + 1) for f in [opposite] + others]
    deck = (tmp_path / "cube.inp").read_text() + "*BOUNDARY\n" + "".join(
        f"FACE{f}_NODES, {dof}, {dof}, 0\n" for f, dof in held
    ) + f"*STEP\n*STATIC\n*DSLOAD\nFACE{face}, P, 5.0\n*NODE FILE\nU\n*EL FILE\nS\n*END STEP\n"
    stress = calculix.solve_inp(deck).stress
    right = np.zeros(6)
    right[axis] = -5.0
    assert np.allclose(stress, right, atol=1e-3)


@pytest.mark.parametrize("order", [1, 2])
def test_gmsh_reads_the_groups(tmp_path, order):
    mesh = block(2, 2, 1)
    files.write(mesh, tmp_path / "m.msh", order=order)
    done = subprocess.run(
        ["gmsh", str(tmp_path / "m.msh"), "-0", "-format", "msh41", "-o",
         str(tmp_path / "again.msh")], capture_output=True, text=True, timeout=60, check=True)
    assert "Error" not in done.stdout + done.stderr
    text = (tmp_path / "again.msh").read_text()
    names = set(re.findall(r'^(\d \d+ "\w+")$', text, re.M))
    assert names == {'3 1 "Solid"'} | {f'2 {k} "Face{k}"' for k in range(1, 7)}
    points, hexes = files.read_hexes(tmp_path / "again.msh")
    right = elements_of(mesh, order)
    assert (np.sort(points[hexes].reshape(len(hexes), -1), axis=0).round(9).tolist()
            == np.sort(right.points[right.hexes].reshape(len(hexes), -1), axis=0)
            .round(9).tolist())


def test_gmsh_finds_positive_jacobians_at_second_order(tmp_path):
    """A wrong place of a middle node would fold the element."""
    files.write(distorted(block(2, 2, 2), 0.1), tmp_path / "m.msh", order=2)
    script = tmp_path / "check.geo"
    script.write_text(f'Merge "{tmp_path}/m.msh";\nPlugin(AnalyseMeshQuality).JacobianDeterminant'
                      " = 1;\nPlugin(AnalyseMeshQuality).Run;\n")
    done = subprocess.run(["gmsh", str(script), "-0", "-o", str(tmp_path / "x.msh")],
                          capture_output=True, text=True, timeout=60, check=True)
    text = done.stdout + done.stderr
    worst, _, best = map(float, re.search(r"minJ +=([^(]*)", text).group(1).split(","))
    assert 0 < worst <= best < 0.125  # hexahedra of 1/8


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("ending", ["vtu", "vtk"])
def test_vtk_reads_cells_and_data(tmp_path, ending, order):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    mesh = distorted(block(2, 2, 2), 0.1)
    right = elements_of(mesh, order)
    shift = np.arange(3.0 * len(right.points)).reshape(-1, 3)
    files.write(mesh, tmp_path / f"m.{ending}", order=order,
                point_data={"displacement": shift}, cell_data={"number": np.arange(8)})
    reader = vtkXMLUnstructuredGridReader() if ending == "vtu" else vtkUnstructuredGridReader()
    reader.SetFileName(str(tmp_path / f"m.{ending}"))
    if ending == "vtk":
        reader.ReadAllFieldsOn()
    reader.Update()
    grid = reader.GetOutput()
    assert grid.GetNumberOfCells() == 8
    assert {grid.GetCellType(k) for k in range(8)} == {12 if order == 1 else 25}
    assert np.array_equal(vtk_to_numpy(grid.GetPoints().GetData()), right.points)
    cells, fields = grid.GetCellData(), grid.GetFieldData()
    assert np.array_equal(vtk_to_numpy(cells.GetArray("number")), np.arange(8))
    quality = vtk_to_numpy(cells.GetArray("scaled_jacobian"))
    assert 0 < quality.min() <= quality.max() <= 1
    assert np.array_equal(vtk_to_numpy(grid.GetPointData().GetArray("displacement")), shift)
    sides = vtk_to_numpy(cells.GetArray("face_of_side"))
    assert np.array_equal(sides[right.hex_of_quad, right.side_of_quad], right.face_of_quad)
    assert np.count_nonzero(sides) == len(right.quads)
    if ending == "vtu":
        assert np.array_equal(vtk_to_numpy(fields.GetArray("face_of_quad")), right.face_of_quad)
        assert np.array_equal(vtk_to_numpy(fields.GetArray("boundary_quads")), right.quads[:, :4])
    else:   # they would stand before the points, where gmsh wants none
        assert b"boundary_quads" not in (tmp_path / "m.vtk").read_bytes()


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("ending", ["unv", "med"])
def test_freecad_reads_hexes_and_groups(tmp_path, ending, order):
    from hexcon import freecad_compat
    from hexcon.femmesh import from_femmesh
    mesh = block(2, 1, 1)
    files.write(mesh, tmp_path / f"m.{ending}", order=order)
    read = freecad_compat.fem_module("Fem").read(str(tmp_path / f"m.{ending}"))
    assert {read.getGroupName(g) for g in read.Groups} == {f"Face{k}" for k in range(1, 7)}
    back, right = from_femmesh(read), elements_of(mesh, order)
    assert np.array_equal(back.hexes, right.hexes)
    assert read.FaceCount == 10


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("ending", ["inp", "msh", "vtu", "unv", "med"])
def test_cad_faces_come_back(tmp_path, ending, order):
    """So that a file can be loaded by face, also where some quads have no CAD face."""
    mesh = block(3, 2, 2)
    mesh.face_of_quad = np.where(mesh.face_of_quad == 4, 0, mesh.face_of_quad)
    files.write(mesh, tmp_path / f"m.{ending}", order=order)
    back = files.read_mesh(tmp_path / f"m.{ending}")
    right = elements_of(mesh, order)

    def faces(m):
        return {frozenset(q): f for q, f in zip(m.quads[:, :4].tolist(),
                                                m.face_of_quad.tolist())}
    assert back.order == order and faces(back) == faces(right)
    deck = calculix.static_deck(back, fixed=["Face1"], force={"Face2": (0, 0, -1.0)})
    assert calculix.solve_inp(deck).max_displacement > 0


def test_an_option_that_a_format_cannot_hold(tmp_path):
    with pytest.raises(ToolError, match="point_data") as raised:
        files.write(block(1, 1, 1), tmp_path / "m.inp", point_data={})
    assert raised.value.code is FaultCode.BAD_OPTION


def test_fcstd_holds_the_mesh_and_leaves_documents_alone(tmp_path):
    from hexcon import freecad_compat
    app = freecad_compat.freecad()
    before = list(app.listDocuments())
    files.write(block(2, 1, 1), tmp_path / "m.FCStd")
    assert list(app.listDocuments()) == before
    doc = app.openDocument(str(tmp_path / "m.FCStd"))
    try:
        assert [o.Name for o in doc.Objects] == ["HexMesh"]
        assert doc.HexMesh.FemMesh.HexaCount == 2
    finally:
        app.closeDocument(doc.Name)
    assert [p.name for p in tmp_path.iterdir()] == ["m.FCStd"]


def test_no_freecad_is_needed_for_plain_formats(tmp_path):
    """A process in which FreeCAD cannot be imported writes and reads, and says what .med
    needs."""
    program = f"""
import sys
sys.modules["FreeCAD"] = None
sys.path[:0] = {[str(pathlib.Path(__file__).parents[1])]!r}
from hex_grids import block
from hexcon import files
from hexcon.errors import FaultCode, ToolError
for ending in ("inp", "msh", "vtu", "vtk", "unv"):
    path = {str(tmp_path)!r} + "/m." + ending
    files.write(block(2, 2, 2), path, order=2)
    assert len(files.read_hexes(path)[1]) == 8
for ending in ("med", "FCStd"):
    try:
        files.write(block(1, 1, 1), {str(tmp_path)!r} + "/n." + ending)
    except ToolError as error:
        assert error.code is FaultCode.FREECAD_MISSING, error
    else:
        raise SystemExit("no error")
"""
    subprocess.run([sys.executable, "-c", program], check=True, timeout=60)
    assert not list(tmp_path.glob("n.*"))


@pytest.mark.parametrize("path, code", [
    ("mesh.xyz", FaultCode.FILE_FORMAT), ("mesh", FaultCode.FILE_FORMAT),
    ("no/such/folder/mesh.inp", FaultCode.FILE_IO)])
def test_what_cannot_be_written(tmp_path, path, code):
    with pytest.raises(ToolError) as raised:
        files.write(block(1, 1, 1), tmp_path / path)
    assert raised.value.code is code
    assert path.split("/")[-1] in str(raised.value)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("ending", ["inp", "vtk", "FCStd"])
def test_a_failed_write_leaves_the_old_file(tmp_path, ending, monkeypatch):
    path = tmp_path / f"mesh.{ending}"
    path.write_text("old")

    def fails(name, *_, **__):
        pathlib.Path(name).write_text("half a me")
        raise OSError(28, "No space left on device")
    monkeypatch.setitem(files.WRITERS, "." + ending.lower(), fails)
    with pytest.raises(ToolError, match="no space left on the disk"):
        files.write(block(1, 1, 1), path)
    assert path.read_text() == "old"
    assert os.listdir(tmp_path) == [path.name]


def test_what_cannot_be_read(tmp_path):
    cases = {"missing.inp": (None, FaultCode.FILE_IO),
             "empty.inp": ("", FaultCode.FILE_FORMAT),
             "mesh.doc": ("", FaultCode.FILE_FORMAT),
             "tets.inp": ("*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n"
                          "*ELEMENT,TYPE=C3D4\n1,1,2,3,4\n", FaultCode.FILE_FORMAT),
             "lost.inp": ("*NODE\n1,0,0,0\n*ELEMENT,TYPE=C3D8\n1,1,2,3,4,5,6,7,8\n",
                          FaultCode.FILE_FORMAT),
             "broken.msh": ("$MeshFormat\n", FaultCode.FILE_FORMAT),
             "broken.vtu": ("<VTK", FaultCode.FILE_FORMAT),
             "broken.vtk": ("x\n", FaultCode.FILE_FORMAT),
             "broken.unv": ("    -1\n  2411\n  what\n    -1\n", FaultCode.FILE_FORMAT)}
    for name, (text, code) in cases.items():
        if text is not None:
            (tmp_path / name).write_text(text)
        with pytest.raises(ToolError) as raised:
            files.read_hexes(tmp_path / name)
        assert raised.value.code is code, name
        assert name in str(raised.value)


def test_inp_of_other_programs(tmp_path):
    """Numbers with gaps, wrapped lines, D exponents, lower case, shells beside."""
    (tmp_path / "other.inp").write_text("""*Heading
 something
*Node, nset=all
 10, 0., 0., 0.
 20, 1.D0, 0, 0
 30, 1, 1, 0
 40, 0, 1,
** a comment
 50, 0, 0, 1
 60, 1, 0, 1
 70, 1, 1, 1
 80, 0, 1, 1
*Element, type=S4, elset=skin
 7, 10, 20, 30, 40
*ELEMENT, elset=e,
 type=c3d8r
 9, 10, 20, 30, 40,
 50, 60, 70, 80
*Step
""")
    points, hexes = files.read_hexes(tmp_path / "other.inp")
    assert hexes.tolist() == [list(range(8))]
    assert points[1].tolist() == [1, 0, 0] and points[3].tolist() == [0, 1, 0]

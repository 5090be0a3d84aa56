# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files for solvers that take hexes only: Nek5000's .re2, Exodus II, SPECFEM3D's folder.

The readers here follow the formats' own pages and share no code with the writers. What they hand back is compared by
coordinates: hexes as their corners in order, boundary faces as sets of four corners.
"""
import os
import pathlib
import re
import struct
import sys
from types import SimpleNamespace

import numpy as np
import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from hex_grids import block, distorted  # noqa: E402

import hexcon_native as hn  # noqa: E402
from hexcon import files  # noqa: E402
from hexcon.errors import FaultCode, ToolError  # noqa: E402
from hexcon.femmesh import elements_of  # noqa: E402

SIGNS = np.array([(x, y, z) for z in (-1, 1) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))])
"""Reference corners 1 to 8, the same in all three formats."""


def corners_where(axis, sign):
    return [k for k in range(8) if SIGNS[k, axis] == sign]


def read_re2(path):
    """Nek5000's, double precision: core/reader_re2.f of that project."""
    data = pathlib.Path(path).read_bytes()
    version, count, dimension, fluid = data[:5], int(data[5:14]), int(data[14:17]), int(data[17:26])
    assert (version, dimension, fluid) == (b"#v003", 3, count)
    assert abs(struct.unpack("<f", data[80:84])[0] - 6.54321) < 1e-6
    at, hexes = 84, []
    for _ in range(count):
        numbers = struct.unpack("<25d", data[at:at + 200])
        hexes.append(np.array(numbers[1:]).reshape(3, 8).T)
        at += 200
    sections = []
    for _ in range(2):
        number, at = int(struct.unpack("<d", data[at:at + 8])[0]), at + 8
        sections.append([struct.unpack("<7d8s", data[at + 64 * k:at + 64 * k + 64]) for k in range(number)])
        at += 64 * number
    assert at == len(data)
    faces = {1: (1, -1), 2: (0, 1), 3: (1, 1), 4: (0, -1), 5: (2, -1), 6: (2, 1)}
    edges = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
    boundary, middles = {}, {}
    for element, face, *_, number, kind in sections[1]:
        assert kind == b"EXO     "
        corners = hexes[int(element) - 1][corners_where(*faces[int(face)])]
        boundary.setdefault(key(corners), []).append(int(number))
    for element, edge, x, y, z, *rest, kind in sections[0]:
        assert kind == b"m       " and rest == [0, 0]
        middles[int(element) - 1, key(hexes[int(element) - 1][list(edges[int(edge) - 1])])] = (x, y, z)
    return SimpleNamespace(hexes=np.array(hexes), boundary=boundary, middles=middles)


def key(corners):
    return frozenset(map(tuple, np.asarray(corners).tolist()))


def read_exodus(path):
    """Through VTK: hexes with all their nodes, in VTK's order; boundary faces; names of the side sets by number."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOExodus import vtkExodusIIReader
    reader = vtkExodusIIReader()
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    for k in range(reader.GetNumberOfSideSetArrays()):
        reader.SetSideSetArrayStatus(reader.GetSideSetArrayName(k), 1)
    reader.Update()
    blocks = reader.GetOutput()

    def cells(grid):
        points = vtk_to_numpy(grid.GetPoints().GetData())
        return [points[[grid.GetCell(k).GetPointId(j) for j in range(grid.GetCell(k).GetNumberOfPoints())]]
                for k in range(grid.GetNumberOfCells())]
    groups, boundary, names = blocks.GetNumberOfBlocks(), {}, []
    solid = np.array(cells(blocks.GetBlock(0).GetBlock(0)))
    for k in range(groups):
        part, words = blocks.GetBlock(k), blocks.GetMetaData(k)
        if part is None or words is None or words.Get(words_name()) != "Side Sets":
            continue
        for j in range(part.GetNumberOfBlocks()):
            name = part.GetMetaData(j).Get(words_name())
            names.append(re.match(r"\w+", name)[0])
            for face in cells(part.GetBlock(j)):
                boundary.setdefault(key(face[:4]), []).append(names[-1])
    return SimpleNamespace(hexes=solid, boundary=boundary, names=names)


def words_name():
    from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
    return vtkCompositeDataSet.NAME()


def read_specfem(folder):
    """SPECFEM3D's, as src/decompose_mesh/read_mesh_files.F90 of that project reads them."""
    def rows(name):
        head, *lines = (pathlib.Path(folder) / name).read_text(encoding="ascii").splitlines()
        assert int(head) == len(lines)
        return [line.split() for line in lines]
    points = {int(number): tuple(map(float, place)) for number, *place in rows("nodes_coords_file")}
    assert sorted(points) == list(range(1, len(points) + 1))
    hexes = {int(number): [points[int(node)] for node in nodes] for number, *nodes in rows("mesh_file")}
    materials = [line.split() for line in (pathlib.Path(folder) / "materials_file").read_text().splitlines()]
    assert materials == [[str(k), "1"] for k in range(1, len(hexes) + 1)]
    material = (pathlib.Path(folder) / "nummaterial_velocity_file").read_text(encoding="ascii")
    domain, number, density, fast, slow, *rest = material.split()
    assert (domain, number, rest) == ("2", "1", ["9999", "9999", "0"]) and float(density) > 0
    assert float(fast) > float(slow) > 0
    found = {}
    for name in os.listdir(folder):
        if "surface_file" in name:
            found[name] = [(hexes[int(element)], [points[int(node)] for node in nodes])
                           for element, *nodes in rows(name)]
    return SimpleNamespace(hexes=np.array([hexes[k] for k in sorted(hexes)]), surfaces=found)


@pytest.fixture
def mesh():
    """A box whose top is crooked; its side y = 2 is on no CAD face."""
    made = distorted(block(3, 2, 2, (3.0, 2.0, 2.0)), 0.1)
    made.points -= [1.0, 0.3, 100 / 7]
    made.face_of_quad = np.where(made.face_of_quad == 4, 0, made.face_of_quad)
    return made


@pytest.fixture
def curved(mesh):
    """Of order 2, with middles off the middles of some edges."""
    points, hexes = hn.raise_order(mesh.points, mesh.hexes)
    moved = np.arange(len(mesh.points), len(points), 3)
    points = points.copy()
    points[moved] += np.random.default_rng(2).uniform(-0.05, 0.05, (len(moved), 3))
    return SimpleNamespace(points=points, hexes=hexes, order=2, quads=mesh.quads, face_of_quad=mesh.face_of_quad)


def groups_of(mesh, unnamed):
    """{corners of a boundary face: [number or name]} of what the writers were given."""
    return {key(mesh.points[quad]): [unnamed if number == 0 else number]
            for quad, number in zip(mesh.quads, mesh.face_of_quad.tolist())}


@pytest.mark.parametrize("order", [1, 2])
def test_nek5000(tmp_path, mesh, order):
    files.write(mesh, tmp_path / "m.re2", order=order)
    read = read_re2(tmp_path / "m.re2")
    assert np.array_equal(read.hexes, mesh.points[mesh.hexes])
    assert read.boundary == groups_of(mesh, 7)
    assert not read.middles     # straight edges need none


def test_curved_edges_reach_nek5000(tmp_path, curved):
    files.write(curved, tmp_path / "m.re2")
    middles, ends = read_re2(tmp_path / "m.re2").middles, [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7),
                                                           (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
    count = 0
    for row, nodes in enumerate(curved.points[curved.hexes]):
        for (a, b), middle in zip(ends, nodes[8:]):
            straight = np.allclose(middle, (nodes[a] + nodes[b]) / 2, rtol=0, atol=1e-12)
            assert middles.get((row, key(nodes[[a, b]]))) == (None if straight else tuple(middle.tolist()))
            count += not straight
    assert count == len(middles) > 20


@pytest.mark.parametrize("order", [1, 2])
def test_exodus(tmp_path, mesh, order):
    mesh.points = mesh.points.astype(np.float32).astype(float)      # VTK keeps no more of them
    files.write(mesh, tmp_path / "m.exo", order=order)
    read, right = read_exodus(tmp_path / "m.exo"), elements_of(mesh, order)
    assert np.array_equal(read.hexes, right.points[right.hexes].astype(np.float32))
    assert read.names == ["Face1", "Face2", "Face3", "Face5", "Face6", "Boundary"]
    assert read.boundary == {corners: ["Boundary" if number == 7 else f"Face{number}"]
                             for corners, (number,) in groups_of(mesh, 7).items()}


def test_exodus_follows_its_manual(tmp_path, mesh):
    """What VTK does not ask for, other programs do."""
    from scipy.io import netcdf_file
    files.write(mesh, tmp_path / "m.exo")
    with netcdf_file(tmp_path / "m.exo", mmap=False) as data:
        assert (tmp_path / "m.exo").read_bytes()[:4] == b"CDF\x02"
        assert data.dimensions["len_string"] == 33 and data.dimensions["num_dim"] == 3
        assert data.dimensions["time_step"] is None and data.floating_point_word_size == 8
        assert data.variables["connect1"].elem_type == b"HEX8" and data.variables["connect1"][:].min() == 1
        assert data.variables["ss_prop1"][:].tolist() == [1, 2, 3, 5, 6, 7] and data.variables["ss_prop1"].name == b"ID"
        assert [data.variables[f"coord{axis}"][:].tolist() for axis in "xyz"] == mesh.points.T.tolist()
        assert data.variables["side_ss1"][:].tolist() == [4] * 4     # x = 0: nodes 1, 5, 8, 4


SPECFEM_27 = np.array([*SIGNS, (0, -1, -1), (1, 0, -1), (0, 1, -1), (-1, 0, -1), (-1, -1, 0), (1, -1, 0), (1, 1, 0),
                       (-1, 1, 0), (0, -1, 1), (1, 0, 1), (0, 1, 1), (-1, 0, 1), (0, 0, -1), (0, -1, 0), (1, 0, 0),
                       (0, 1, 0), (-1, 0, 0), (0, 0, 1), (0, 0, 0)], float)
"""Its src/shared/hex_nodes.f90, in -1, 0, 1."""


def serendipity(nodes, at):
    """Place of the 20-node hex's map: corners (1 + x xi)(1 + y yi)(1 + z zi)(x xi + y yi + z zi - 2) / 8, middles
    (1 - x x)(1 + y yi)(1 + z zi) / 4 (Zienkiewicz and Taylor)."""
    middles = [(SIGNS[a] + SIGNS[b]) / 2 for a, b in ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4),
                                                     (0, 4), (1, 5), (2, 6), (3, 7))]
    weights = [np.prod(1 + at * sign) * (at @ sign - 2) / 8 for sign in SIGNS]
    weights += [np.prod(np.where(sign == 0, 1 - at ** 2, 1 + at * sign)) / 4 for sign in middles]
    return np.array(weights) @ nodes


def test_specfem(tmp_path, mesh):
    files.write(mesh, tmp_path / "m.specfem3d")
    read = read_specfem(tmp_path / "m.specfem3d")
    assert np.array_equal(read.hexes, mesh.points[mesh.hexes])
    check_surfaces(read, mesh)


def test_specfem_of_order_2_has_27_nodes(tmp_path, curved):
    files.write(curved, tmp_path / "m.specfem3d/")
    read = read_specfem(tmp_path / "m.specfem3d")
    assert read.hexes.shape[1] == 27
    for nodes, right in zip(read.hexes, curved.points[curved.hexes]):
        assert np.allclose(nodes, [serendipity(right, at) for at in SPECFEM_27], rtol=0, atol=1e-12)
    check_surfaces(read, curved)
    lines = (tmp_path / "m.specfem3d" / "nodes_coords_file").read_text().splitlines()[1:]
    assert len({line.split(None, 1)[1] for line in lines}) == len(lines)     # shared middles are one node


def check_surfaces(read, mesh):
    sides = {"absorbing_surface_file_xmin": 1, "absorbing_surface_file_xmax": 2, "absorbing_surface_file_ymin": 3,
             "absorbing_surface_file_ymax": 0, "absorbing_surface_file_bottom": 5,
             "free_or_absorbing_surface_file_zmax": 6}
    groups = {"Boundary_surface_file": 0, **{f"Face{k}_surface_file": k for k in (1, 2, 3, 5, 6)}}
    assert set(read.surfaces) == {*sides, *groups}
    for name, number in (*sides.items(), *groups.items()):
        faces = read.surfaces[name]
        assert [key(nodes[:4]) for _, nodes in faces] == [key(mesh.points[quad]) for quad in
                                                         mesh.quads[mesh.face_of_quad == number]]
        for element, nodes in faces:
            nodes, element = np.array(nodes), np.array(element)
            normal = np.cross(nodes[2] - nodes[0], nodes[3] - nodes[1])
            assert normal @ (nodes[:4].mean(axis=0) - element[:8].mean(axis=0)) > 0
            if len(nodes) == 9:     # corners, middles, centre, each a node of its hex
                assert key(nodes) <= key(element)
                where = np.array([SPECFEM_27[np.flatnonzero((element == node).all(axis=1))[0]] for node in nodes])
                assert np.array_equal(where[4:8], (where[:4] + where[[1, 2, 3, 0]]) / 2)
                assert np.array_equal(where[8], where[:4].mean(axis=0))


def test_a_folder_is_replaced_whole_or_not_at_all(tmp_path, mesh, monkeypatch):
    path = tmp_path / "m.specfem3d"
    files.write(mesh, path)
    before = {file.name: file.read_bytes() for file in path.iterdir()}
    files.write(block(1, 1, 1), path)
    assert (path / "mesh_file").read_text().startswith("1\n") and os.listdir(tmp_path) == [path.name]
    files.write(mesh, path)

    def fails(folder, *_):
        os.mkdir(folder)
        (pathlib.Path(folder) / "mesh_file").write_text("half a me")
        raise OSError(28, "No space left on device")
    monkeypatch.setitem(files.WRITERS, ".specfem3d", fails)
    with pytest.raises(ToolError, match="no space left on the disk"):
        files.write(block(1, 1, 1), path)
    assert {file.name: file.read_bytes() for file in path.iterdir()} == before
    assert os.listdir(tmp_path) == [path.name]


@pytest.mark.parametrize("what", ["a file of somebody's", "a folder in it", "a file"])
def test_what_is_not_ours_is_not_replaced(tmp_path, mesh, what):
    path = tmp_path / "m.specfem3d"
    if what == "a file":
        path.write_text("precious")
    else:
        path.mkdir()
        (path / "precious").mkdir() if what == "a folder in it" else (path / "precious").write_text("data")
    with pytest.raises(ToolError) as raised:
        files.write(mesh, path)
    assert raised.value.code is FaultCode.FILE_IO
    assert os.listdir(tmp_path) == [path.name] and (path.is_file() or os.listdir(path) == ["precious"])


def test_topological_meshes_are_not_for_these_solvers(tmp_path):
    surface = block(2, 1, 1)
    made = hn.mesh(surface.points, surface.quads, "pyramid")
    for ending in (".re2", ".exo", ".specfem3d"):
        with pytest.raises(ToolError) as raised:
            files.write(made, tmp_path / f"m{ending}")
        assert raised.value.code is FaultCode.TOPOLOGICAL_MESH
        files.write(made, tmp_path / f"m{ending}", allow_topological=True)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""hexcon.quads.surface_from_file: every format, and what it refuses. No FreeCAD, no gmsh."""
import meshio
import numpy as np
import pytest
from mesh_checker import enclosed

import hexcon_native
from hexcon.errors import FaultCode, HexconError, ToolError
from hexcon.quads import surface_from_file
from hexcon_native import ErrorCode

# A box of 1 x 1 x 2 unit cubes: 10 quads, outward.
POINTS = np.array([(x, y, z) for z in (0, 1, 2) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], float)
SIDES = [(4 * z + i, 4 * z + (i + 1) % 4, 4 * z + 4 + (i + 1) % 4, 4 * z + 4 + i) for z in (0, 1) for i in range(4)]
QUADS = np.array([(3, 2, 1, 0), (8, 9, 10, 11)] + SIDES)
HEXES = np.array([list(range(8)), list(range(4, 12))])
ENDINGS = ("msh", "inp", "vtk", "vtu", "obj", "mesh")


def _write(path, points, cells):
    meshio.Mesh(points, cells).write(str(path))
    return str(path)


@pytest.mark.parametrize("ending", ENDINGS)
def test_round_trip(tmp_path, ending):
    surface = surface_from_file(_write(tmp_path / f"s.{ending}", POINTS, [("quad", QUADS)]))
    assert np.array_equal(surface.points, POINTS)
    assert np.array_equal(surface.quads, QUADS)
    assert surface.method == "given" and not surface.notes and not surface.face_of_quad.any()


@pytest.mark.parametrize("ending", ("msh", "vtk", "vtu", "mesh"))
def test_turned_quads_are_turned_back(tmp_path, ending):
    mixed = QUADS.copy()
    mixed[::3] = mixed[::3, ::-1]
    surface = surface_from_file(_write(tmp_path / f"s.{ending}", POINTS, [("quad", mixed)]))
    assert enclosed(surface) == pytest.approx(2.0)


@pytest.mark.parametrize("ending", ("msh", "inp", "vtk", "vtu", "mesh"))
def test_hexes_alone_give_their_outer_faces(tmp_path, ending):
    surface = surface_from_file(_write(tmp_path / f"s.{ending}", POINTS, [("hexahedron", HEXES)]))
    assert len(surface.quads) == 10 and len(surface.points) == 12
    assert any("outer faces" in note for note in surface.notes)


def test_hexes_with_their_quads_keep_the_quads(tmp_path):
    surface = surface_from_file(_write(tmp_path / "s.msh", POINTS, [("hexahedron", HEXES), ("quad", QUADS)]))
    assert np.array_equal(surface.quads, QUADS) and not surface.notes


def test_hexes_with_some_quads_give_outer_faces(tmp_path):
    surface = surface_from_file(_write(tmp_path / "s.vtu", POINTS, [("hexahedron", HEXES), ("quad", QUADS[:3])]))
    assert len(surface.quads) == 10 and surface.notes


def test_second_order_hexes_give_corners(tmp_path):
    edges = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
    points = np.concatenate([POINTS[:8], [POINTS[[a, b]].mean(axis=0) for a, b in edges]])
    surface = surface_from_file(_write(tmp_path / "s.vtu", points, [("hexahedron20", np.arange(20)[None])]))
    assert len(surface.quads) == 6 and len(surface.points) == 8
    assert any("second-order" in note for note in surface.notes)


@pytest.mark.parametrize("ending", ENDINGS)
def test_unused_points_go(tmp_path, ending):
    points = np.concatenate([[[9.0, 9, 9]], POINTS])
    surface = surface_from_file(_write(tmp_path / f"s.{ending}", points, [("quad", QUADS + 1)]))
    assert np.array_equal(surface.points, POINTS)


def test_seams_are_merged_only_where_needed(tmp_path):
    loose = POINTS[QUADS].reshape(-1, 3)
    surface = surface_from_file(_write(tmp_path / "s.obj", loose, [("quad", np.arange(40).reshape(-1, 4))]))
    assert len(surface.points) == 12 and any("merged" in note for note in surface.notes)


@pytest.mark.parametrize("ending", ("msh", "inp", "vtk", "vtu", "mesh"))
def test_triangles_are_counted(tmp_path, ending):
    halves = np.array([(3, 2, 1), (3, 1, 0)])
    path = _write(tmp_path / f"s.{ending}", POINTS, [("triangle", halves), ("quad", QUADS[1:])])
    with pytest.raises(ToolError) as caught:
        surface_from_file(path)
    assert caught.value.code is FaultCode.NOT_ALL_QUAD and "2 triangles" in str(caught.value)


def test_tetrahedra_are_refused(tmp_path):
    path = _write(tmp_path / "s.msh", POINTS, [("tetra", np.array([(0, 1, 2, 4)]))])
    with pytest.raises(ToolError) as caught:
        surface_from_file(path)
    assert caught.value.code is FaultCode.NOT_ALL_QUAD and "4 triangles" in str(caught.value)


def _code(path):
    with pytest.raises(HexconError) as caught:
        surface_from_file(path)
    return caught.value.code


def _code_of_meshing(path):
    """Read, which must go well, then fill, which must not: the core judges given surfaces."""
    surface = surface_from_file(path)
    with pytest.raises(HexconError) as caught:
        hexcon_native.mesh(surface.points, surface.quads)
    return caught.value.code


def test_open_surface(tmp_path):
    """One name for it, from a file and from the core."""
    path = _write(tmp_path / "s.vtk", POINTS, [("quad", QUADS[1:])])
    with pytest.raises(HexconError) as caught:
        surface_from_file(path)
    with pytest.raises(HexconError) as core:
        hexcon_native.mesh(POINTS, QUADS[1:])
    assert caught.value.code is core.value.code is ErrorCode.NOT_CLOSED and "4 edges" in str(caught.value)
    assert str(path) in str(caught.value) and caught.value.elements == core.value.elements


def test_two_bodies(tmp_path):
    quads = np.concatenate([QUADS, QUADS + 12])
    path = _write(tmp_path / "s.vtk", np.concatenate([POINTS, POINTS + 5]), [("quad", quads)])
    assert _code_of_meshing(path) is ErrorCode.SEVERAL_COMPONENTS


def test_odd_surface(tmp_path):
    """A torus of 3 x 5 quads."""
    i, j = np.meshgrid(np.arange(3), np.arange(5), indexing="ij")
    a, b = 2 * np.pi * i / 3, 2 * np.pi * j / 5
    points = np.stack([(3 + np.cos(a)) * np.cos(b), (3 + np.cos(a)) * np.sin(b), np.sin(a)], -1).reshape(-1, 3)
    ids = np.arange(15).reshape(3, 5)
    up, right = np.roll(ids, -1, axis=0), np.roll(ids, -1, axis=1)
    quads = np.stack([ids, up, np.roll(up, -1, axis=1), right], -1).reshape(-1, 4)
    assert _code_of_meshing(_write(tmp_path / "s.vtk", points, [("quad", quads)])) is ErrorCode.ODD


def test_turned_quads_are_told(tmp_path):
    inward = surface_from_file(_write(tmp_path / "a.vtk", POINTS, [("quad", QUADS[:, ::-1])]))
    assert any("all quads faced inward" in note for note in inward.notes)
    mixed = QUADS.copy()
    mixed[1] = mixed[1, ::-1]
    mended = surface_from_file(_write(tmp_path / "b.vtk", POINTS, [("quad", mixed)]))
    assert any(note.startswith("1 quads were oriented against") for note in mended.notes)
    assert np.array_equal(np.sort(mended.quads, axis=1), np.sort(QUADS, axis=1))


@pytest.mark.parametrize("damage", ("POLYGONS 10 50\n4 0 1 2 99", "POLYGONS 10 50\n4 0 1 2 -7",
                                    "POLYGONS 1 2\n1 0"))
def test_damaged_polydata_is_told(tmp_path, damage):
    """VTK's own access by cell would read beyond its arrays."""
    lines = ["# vtk DataFile Version 3.0", "quads", "ASCII", "DATASET POLYDATA", f"POINTS {len(POINTS)} double"]
    lines += [" ".join(map(str, p)) for p in POINTS] + [damage]
    lines += ["4 " + " ".join(map(str, q)) for q in QUADS[1:]]
    path = tmp_path / "s.vtk"
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
    assert _code(path) in (FaultCode.FILE_FORMAT, FaultCode.BAD_SHAPE, ErrorCode.EMPTY)


def test_repeated_vertex_and_nan(tmp_path):
    bad = QUADS.copy()
    bad[0, 1] = bad[0, 0]
    assert _code(_write(tmp_path / "a.vtk", POINTS, [("quad", bad)])) is ErrorCode.REPEATED_VERTEX
    points = POINTS.copy()
    points[3, 0] = np.nan
    with pytest.raises(HexconError) as caught:
        surface_from_file(_write(tmp_path / "b.vtk", points, [("quad", QUADS)]))
    assert caught.value.code is ErrorCode.NOT_FINITE and caught.value.elements == [3]


@pytest.mark.parametrize("ending", ENDINGS + ("unv",))
def test_nonsense(tmp_path, ending):
    path = tmp_path / f"s.{ending}"
    path.write_text("this is no mesh\n", encoding="ascii")
    assert _code(path) in (FaultCode.FILE_FORMAT, FaultCode.BAD_SHAPE, ErrorCode.EMPTY)
    path.write_bytes(b"")
    assert _code(path) in (FaultCode.FILE_FORMAT, FaultCode.BAD_SHAPE, ErrorCode.EMPTY)


def test_missing_and_unknown(tmp_path):
    assert _code(tmp_path / "none.msh") is FaultCode.FILE_IO
    (tmp_path / "s.xyz").write_text("solid", encoding="ascii")
    assert _code(tmp_path / "s.xyz") is FaultCode.FILE_FORMAT


def test_legacy_vtk_polydata(tmp_path):
    """What meshio does not read, VTK does."""
    lines = ["# vtk DataFile Version 3.0", "quads", "ASCII", "DATASET POLYDATA", f"POINTS {len(POINTS)} double"]
    lines += [" ".join(map(str, p)) for p in POINTS]
    lines += [f"POLYGONS {len(QUADS)} {5 * len(QUADS)}"] + ["4 " + " ".join(map(str, q)) for q in QUADS]
    path = tmp_path / "s.vtk"
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
    assert np.array_equal(surface_from_file(path).quads, QUADS)


def _unv(points, elements):
    """elements: list of (descriptor, labels)."""
    lines = ["    -1", "  2411"]
    for k, p in enumerate(points):
        lines += [f"{k + 1:10d}{1:10d}{1:10d}{11:10d}", "".join(f"{x:25.16E}" for x in p).replace("E", "D")]
    lines += ["    -1", "    -1", "  2412"]
    for k, (descriptor, labels) in enumerate(elements):
        lines.append("".join(f"{x:10d}" for x in (k + 1, descriptor, 2, 1, 7, len(labels))))
        if descriptor < 30:
            lines.append("         0         1         1")
        lines += ["".join(f"{x:10d}" for x in labels[i:i + 8]) for i in range(0, len(labels), 8)]
    return "\n".join(lines + ["    -1", ""])


@pytest.mark.parametrize("descriptor", (44, 94))
def test_unv_quads(tmp_path, descriptor):
    path = tmp_path / "s.unv"
    path.write_text(_unv(POINTS, [(11, [1, 2])] + [(descriptor, [int(i) + 1 for i in q]) for q in QUADS]),
                    encoding="ascii")
    surface = surface_from_file(path)
    assert np.array_equal(surface.points, POINTS) and np.array_equal(surface.quads, QUADS)


def test_unv_hexes(tmp_path):
    path = tmp_path / "s.unv"
    path.write_text(_unv(POINTS, [(115, [int(i) + 1 for i in h]) for h in HEXES]), encoding="ascii")
    assert len(surface_from_file(path).quads) == 10

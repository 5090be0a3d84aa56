# SPDX-License-Identifier: LGPL-2.1-or-later
"""meshing.Strategy: what is tried, in which order, and what is told of it. The core's answers are stubs."""
import json
import pathlib
import subprocess
import sys
from types import SimpleNamespace

import numpy as np
import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from hex_grids import block  # noqa: E402

from hexcon.errors import FaultCode, ToolError  # noqa: E402
from hexcon.meshing import Strategy, filling, mesh_quad_surface, mesh_solid, strategy  # noqa: E402
from hexcon.quads import QuadSurface  # noqa: E402
from hexcon.quads.surface import finished  # noqa: E402
from hexcon_native import ErrorCode, HexconError  # noqa: E402

PROPOSAL = np.array([[0, 1, 2, 3, 4, 5, 6, 7]])


def surface_of(count=24, method="given", hexes=None):
    quads, faces = np.zeros((count, 4), np.int64), np.zeros(count, np.int64)
    return QuadSurface(np.zeros((8, 3)), quads, faces, method, [], hexes=hexes)


class Core:
    """Stands for hexcon_native.mesh: refuses with the given faults in turn, then makes a mesh; remembers its calls."""

    def __init__(self, monkeypatch, *faults):
        self.calls, self._faults = [], list(faults)
        monkeypatch.setattr(filling.hexcon_native, "mesh", self)

    def __call__(self, points, quads, method, *, progress, tetrahedralise, **options):
        self.calls.append((method, len(quads), options))
        fault = self._faults.pop(0) if self._faults else None
        if fault is not None:
            raise HexconError(f"no {method}", fault, [1])
        return SimpleNamespace(method=method, report={"log": ["from the core"]}, topological=False)

    @property
    def methods(self):
        return [method for method, _, _ in self.calls]


@pytest.fixture
def surfaces(monkeypatch):
    """Surfaces of solids as stubs: (size, care) asked for; one that is a fault is raised."""
    asked, made = [], {}

    def make(solid, size, method, *, care, timeout, progress):
        asked.append((round(size, 9), care))
        found = made.get(care, surface_of())
        if isinstance(found, Exception):
            raise found
        return found
    monkeypatch.setattr(strategy, "surface_from_solid", make)
    return SimpleNamespace(asked=asked, made=made)


def test_the_surfaces_that_are_tried(monkeypatch, surfaces):
    core = Core(monkeypatch, ErrorCode.NOT_CERTIFIED, ErrorCode.NO_HEX_MESH, ErrorCode.SELF_INTERSECTING)
    mesh = mesh_solid("part.step", 10.0)
    assert surfaces.asked == [(10.0, 0), (9.4, 1), (8.8, 2), (8.0, 3)] and core.methods == ["auto"] * 4
    assert mesh.surface.tried == 3 and mesh.solid == "part.step"
    assert [line.split(":")[0] for line in mesh.report["surface tries"]] == [
        "1 times the size", "0.94 times the size", "0.88 times the size"]


def test_the_last_fault_comes_out(monkeypatch, surfaces):
    Core(monkeypatch, *[ErrorCode.NOT_CERTIFIED] * 3, ErrorCode.NO_SHEETS)
    with pytest.raises(HexconError) as caught:
        mesh_solid("part.step", 10.0)
    assert caught.value.code is ErrorCode.NO_SHEETS and len(surfaces.asked) == 4


@pytest.mark.parametrize("options", [{"method": "cells"}, {"surface_method": "sweep"}, {"budget": 60.0}])
def test_who_asks_for_a_method_or_a_time_gets_no_other_surface(monkeypatch, surfaces, options):
    Core(monkeypatch, ErrorCode.NOT_CERTIFIED)
    with pytest.raises(HexconError):
        mesh_solid("part.step", 10.0, **options)
    assert surfaces.asked == [(10.0, 0)]


@pytest.mark.parametrize("code,elements,tried", [
    (FaultCode.OFF_CAD, [], 1), (FaultCode.BAD_SHAPE, [3], 1), (FaultCode.BAD_SHAPE, [], 0),
    (FaultCode.TOOL_MISSING, [], 0)])
def test_surfaces_that_cannot_be_made(monkeypatch, surfaces, code, elements, tried):
    Core(monkeypatch)
    surfaces.made[0] = ToolError("no surface", code, elements)
    if tried:
        assert mesh_solid("part.step", 10.0).surface.tried == 1
    else:
        with pytest.raises(ToolError):
            mesh_solid("part.step", 10.0)
    assert len(surfaces.asked) == 1 + tried


def test_half_the_size_where_quads_cross(monkeypatch, surfaces):
    """The last rung of the ladder is for those alone."""
    core = Core(monkeypatch, *[ErrorCode.SELF_INTERSECTING] * 4)
    assert mesh_solid("part.step", 10.0).surface.tried == 4
    assert surfaces.asked == [(10.0, 0), (9.4, 1), (8.8, 2), (8.0, 3), (5.0, 3)] and len(core.calls) == 5
    surfaces.asked.clear()
    Core(monkeypatch, *[ErrorCode.SELF_INTERSECTING] * 3, ErrorCode.NOT_CERTIFIED)
    with pytest.raises(HexconError):
        mesh_solid("part.step", 10.0)
    assert len(surfaces.asked) == 4


def test_a_first_surface_that_is_there_is_taken(monkeypatch, surfaces):
    core = Core(monkeypatch, ErrorCode.NOT_CERTIFIED)
    mesh = Strategy().of_solid("part.step", 10.0, first=surface_of(16))
    assert surfaces.asked == [(9.4, 1)] and mesh.surface.tried == 1
    assert [count for _, count, _ in core.calls] == [16, 24]


@pytest.mark.parametrize("count,method,options,methods", [
    (601, "subdivided-triangles", {}, ["diced"]), (600, "subdivided-triangles", {}, ["auto"]),
    (601, "subdivided", {}, ["auto"]), (601, "given", {}, ["auto"]),
    (601, "subdivided-triangles", {"layers": 1}, ["auto"]),
    (601, "subdivided-triangles", {"method": "cells"}, ["cells"])])
def test_what_is_diced_first(monkeypatch, count, method, options, methods):
    core = Core(monkeypatch)
    mesh_quad_surface(surface_of(count, method), **options)
    assert core.methods == methods


def test_dicing_that_fails(monkeypatch, surfaces):
    """Another surface first; where there is none, the other methods; a fault of another kind at once."""
    surfaces.made[0] = surface_of(601, "subdivided-triangles")
    core = Core(monkeypatch, ErrorCode.NOT_CERTIFIED)
    assert mesh_solid("part.step", 10.0).surface.tried == 1 and core.methods == ["diced", "auto"]
    core = Core(monkeypatch, ErrorCode.NOT_CERTIFIED)
    mesh = mesh_quad_surface(surfaces.made[0], allow_uncertified=True)
    assert core.methods == ["diced", "auto"]
    assert mesh.report["log"] == ["diced: NOT_CERTIFIED: no diced", "from the core"]
    assert [options["allow_uncertified"] for _, _, options in core.calls] == [False, True]
    Core(monkeypatch, ErrorCode.OUT_OF_MEMORY)
    with pytest.raises(HexconError, match="no diced"):
        mesh_quad_surface(surfaces.made[0])


def test_a_proposal_comes_first(monkeypatch, surfaces):
    core = Core(monkeypatch)
    surfaces.made[0] = surface_of(hexes=PROPOSAL)
    mesh = mesh_solid("part.step", 10.0)
    (method, _, options), = core.calls
    assert method == mesh.method == "proposal" and options["hexes"] is PROPOSAL
    assert mesh.report["log"] == ["from the core"]


def test_a_proposal_that_is_refused(monkeypatch):
    """The methods follow, without the hexes, and the log tells why."""
    core = Core(monkeypatch, ErrorCode.NOT_CERTIFIED, ErrorCode.NOT_DICED)
    mesh = mesh_quad_surface(surface_of(601, "subdivided-triangles", PROPOSAL))
    assert core.methods == ["proposal", "diced", "auto"]
    assert ["hexes" in options for _, _, options in core.calls] == [True, False, False]
    assert mesh.report["log"] == ["proposal: NOT_CERTIFIED: no proposal", "diced: NOT_DICED: no diced", "from the core"]


@pytest.mark.parametrize("code", [ErrorCode.CANCELLED, ErrorCode.OUT_OF_TIME, ErrorCode.OUT_OF_MEMORY])
def test_nothing_follows_a_proposal_that_was_stopped(monkeypatch, code):
    core = Core(monkeypatch, code)
    with pytest.raises(HexconError) as caught:
        mesh_quad_surface(surface_of(hexes=PROPOSAL))
    assert caught.value.code is code and core.methods == ["proposal"]


@pytest.mark.parametrize("options", [{"method": "cells"}, {"layers": 2}])
def test_who_asks_for_a_method_or_layers_gets_no_proposal(monkeypatch, options):
    core = Core(monkeypatch)
    mesh_quad_surface(surface_of(hexes=PROPOSAL), **options)
    assert core.methods == [options.get("method", "auto")] and "hexes" not in core.calls[0][2]


def test_a_proposal_is_numbered_as_the_packed_points():
    """Points that no quad has are inside, whatever coordinates they have, and keep their sequence."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], float)
    points = np.vstack([[[9, 9, 9]], corners[:4], [[.5, .5, .5]], corners[4:]])     # rows 0 and 5 are in no quad
    quads = np.array([[1, 4, 3, 2], [6, 7, 8, 9], [1, 2, 7, 6], [2, 3, 8, 7], [3, 4, 9, 8], [4, 1, 6, 9]])
    hexes = [[1, 2, 3, 4, 6, 7, 8, 9], [1, 2, 3, 4, 5, 20, 11, 0]]
    made = finished(points, quads, np.ones(6), "test", [], hexes)
    assert np.array_equal(made.points, corners)
    assert made.hexes.tolist() == [[0, 1, 2, 3, 4, 5, 6, 7], [0, 1, 2, 3, 9, 11, 10, 8]]
    assert finished(points, quads, np.ones(6), "test", []).hexes is None
    inner, hexes = finished(points, quads, np.ones(6), "test", [], [[1, 2, 3, 4, 5, 7, 8, 0]]).hexes
    assert inner.tolist() == [[9, 9, 9], [.5, .5, .5]] and hexes.tolist() == [[0, 1, 2, 3, 9, 5, 6, 8]]


@pytest.mark.parametrize("placed", [False, True])
def test_a_proposal_of_a_block(placed):
    """By the core itself: 3 x 2 x 2 hexes, handed over with the quads of the block."""
    grid = block(3, 2, 2)
    unplaced = np.where(np.isin(grid.hexes, grid.quads), grid.hexes, grid.hexes + len(grid.points))
    hexes = grid.hexes if placed else unplaced
    surface = finished(grid.points, grid.quads, np.ones(len(grid.quads)), "test", [], hexes)
    assert isinstance(surface.hexes, tuple) == placed
    mesh = mesh_quad_surface(surface)
    assert mesh.method == "proposal" and len(mesh.hexes) == 12 and mesh.certificate.certified


def test_the_worker_hands_hexes_over(tmp_path):
    """A result of the subprocess may hold hexes; of other shapes it is damaged."""
    from hexcon import answers
    arrays = {"points": np.zeros((8, 3)), "quads": np.zeros((6, 4), int), "faces": np.ones(6, int),
              "off_cad": np.zeros(8), "cad_gap": np.zeros(8), "tolerance": 0.0, "method": "sweep",
              "notes": np.array([], dtype=str)}
    path = str(tmp_path / "result.npz")
    np.savez(path, **arrays)
    assert "hexes" not in answers.read_arrays(path, "gmsh", answers.RESULTS["gmsh_worker"])
    np.savez(path, **arrays, hexes=PROPOSAL)
    assert np.array_equal(answers.read_arrays(path, "gmsh", answers.RESULTS["gmsh_worker"])["hexes"], PROPOSAL)
    np.savez(path, **arrays, hexes=PROPOSAL[:, :7])
    with pytest.raises(ToolError, match="hexes"):
        answers.read_arrays(path, "gmsh", answers.RESULTS["gmsh_worker"])


def test_the_command_line_goes_the_same_road(tmp_path):
    """One solid, one mesh: of the API and of the program."""
    from hexcon.examples import FOLDER
    from hexcon.files import read_hexes
    wedge = f"{FOLDER}/../wedge.step"
    made, path = mesh_solid(wedge, 8.0), str(tmp_path / "wedge.vtu")
    said = subprocess.run([sys.executable, "-m", "hexcon", "mesh", wedge, "--size", "8", "-o", path, "--json"],
                          capture_output=True, check=True, encoding="utf-8").stdout
    points, hexes = read_hexes(path)
    assert np.array_equal(points, made.points) and np.array_equal(hexes, made.hexes)
    assert json.loads(said)["method"] == made.method

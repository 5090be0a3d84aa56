# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corners, curves and patches of a model on the boundary of hexes; solids of cubes, whose features are known."""
from types import SimpleNamespace

import numpy as np
import pytest
from grid_voxels import VoxelModel, captured_faults, hexes_of, random_cubes
from mesh_checker import conformity_faults

from hexcon.quads.gmsh_worker.grid.capture import capture
from hexcon.quads.gmsh_worker.grid.captured import NotCaptured
from hexcon.quads.gmsh_worker.grid.corner_places import embedded, ends_of_corners
from hexcon.quads.gmsh_worker.grid.skin import Skin
from hexcon.quads.gmsh_worker.grid.valence import with_valence

CUBE = {(0, 0, 0)}
ELL = {(0, 0, 0), (1, 0, 0), (0, 1, 0)}
FRAME = {(i, j, 0) for i in range(3) for j in range(3)} - {(1, 1, 0)}


@pytest.mark.parametrize("cubes, patches, curves, corners", [(CUBE, 6, 12, 8), (ELL, 8, 18, 12), (FRAME, 10, 24, 16)])
@pytest.mark.parametrize("parts", [1, 2, 3])
def test_bodies_of_cubes_are_captured_on_their_own_edges(cubes, patches, curves, corners, parts):
    model = VoxelModel(cubes)
    assert (len(model.patches), len(model.curves), len(model.corners)) == (patches, curves, corners)
    mesh = capture(model, *hexes_of(cubes, parts))
    assert captured_faults(mesh, model) == []
    assert len(mesh.hexes) == len(cubes) * parts ** 3
    assert np.allclose(mesh.points[mesh.corner_vertex], model.corners)
    assert np.bincount(mesh.curve).tolist() == [round(c.length * parts) for c in model.curves]
    assert np.bincount(mesh.patch).tolist() == [round(p.area * parts ** 2) for p in model.patches]


def test_random_bodies_on_shaken_and_shifted_hexes():
    rng = np.random.default_rng(5)
    for _ in range(12):
        cubes = random_cubes(rng)
        model = VoxelModel(cubes)
        points, hexes = hexes_of(cubes, 2, rng, 0.25)
        order = rng.permutation(len(hexes))
        mesh = capture(model, points + rng.uniform(-0.1, 0.1, 3), hexes[order])
        assert captured_faults(mesh, model) == []


def test_every_chain_starts_at_its_corner_with_its_left_patch_on_the_left():
    model = VoxelModel(FRAME)
    mesh = capture(model, *hexes_of(FRAME, 2))
    for c, curve in enumerate(model.curves):
        chain = mesh.chain(model, c)
        assert (chain[0], chain[-1]) == (mesh.corner_vertex[curve.start], mesh.corner_vertex[curve.end])
        assert (mesh.patch[mesh.half_edges.find(chain[:-1], chain[1:]) // 4] == curve.left).all()


@pytest.mark.parametrize("vertex", [(0, 0, 0), (0.5, 0, 0), (0.5, 0.5, 0)])
@pytest.mark.parametrize("degree", [4, 7, 24])
def test_a_vertex_gets_as_many_edges_as_its_corner_has_curves(vertex, degree):
    """At a corner, on an edge and on a face of a cube of hexes."""
    points, hexes = hexes_of(CUBE, 2)
    angle = np.linspace(0, np.pi / 2, degree)
    spread = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    order = tuple(range(degree))[::-1]          # counter-clockwise from below
    ends = SimpleNamespace(ends=list(range(degree)), orders=[order], directions=lambda step: spread)
    v = int(np.flatnonzero((points == vertex).all(axis=1))[0])
    more, new = with_valence(points, hexes, [(v, ends)])
    assert Skin(more, new).valence.max() >= degree and np.array_equal(more[:len(points)], points)
    assert conformity_faults(new) == [] and len(new) <= 8 + 5 * degree


def test_ends_take_ports_in_their_cyclic_order():
    model = VoxelModel(CUBE)
    ends = ends_of_corners(model)[0]
    ports = ends.directions(0.5)[list(ends.orders[0])]
    cost, found = embedded(ends, ends.directions(0.5), ports)
    assert cost == pytest.approx(0) and [ports[found[e]].tolist() for e in range(3)] == ends.directions(0.5).tolist()
    crossed = ports[[1, 0, 2]]                      # clockwise: no order fits without a turn
    cost, found = embedded(ends, ends.directions(0.5), crossed)
    assert cost > 0.5 and sorted(found) == [0, 1, 2]
    assert embedded(ends, ends.directions(0.5), ports[:2]) == (np.inf, None)


def test_what_is_too_small_is_named_with_its_place():
    """A body with a hole of one cube, on hexes without a hole; a frame on one hex."""
    with pytest.raises(NotCaptured) as fault:
        capture(VoxelModel(FRAME), *hexes_of({(i, j, 0) for i in range(3) for j in range(3)}, 2))
    assert fault.value.place is not None and (fault.value.curves or fault.value.patches or fault.value.corners)
    points, hexes = hexes_of(CUBE, 1)
    with pytest.raises(NotCaptured) as fault:
        capture(VoxelModel(FRAME), 3 * points, hexes)
    assert fault.value.kind == "corner" and fault.value.corners

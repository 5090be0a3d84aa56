# SPDX-License-Identifier: LGPL-2.1-or-later
"""Grids refined locally: conforming, proper and positive whatever is split; planes stay where they are."""
import numpy as np
import pytest
from grid_bodies import ball, box, tensor_grid
from mesh_checker import conformity_faults, euler, improper_pairs, nonpositive, scaled_jacobians

import hexcon_native as hn
from hexcon.quads.gmsh_worker.grid.cells import cells
from hexcon.quads.gmsh_worker.grid.cells_to_split import for_field, for_gaps
from hexcon.quads.gmsh_worker.grid.fullness import fullness
from hexcon.quads.gmsh_worker.grid.gaps import KINDS, Gaps
from hexcon.quads.gmsh_worker.grid.grid_levels import balanced_levels
from hexcon.quads.gmsh_worker.grid.hex_neighbours import HexNeighbours
from hexcon.quads.gmsh_worker.grid.pillow_groups import pillow_groups
from hexcon.quads.gmsh_worker.grid.refined_grid import refined_grid
from hexcon.quads.gmsh_worker.grid.solid_rays import SolidRays
from hexcon.quads.gmsh_worker.grid.tensor_grid import indices, places
from hexcon.quads.gmsh_worker.size_field import SizeField

LEAST = 0.25      # scaled Jacobian that is promised on even planes


def even(count):
    return [np.arange(count + 1.0)] * 3


def refined(planes, wanted, most=10 ** 6):
    wanted = [np.asarray(w).reshape(-1, 3) for w in wanted]
    levels, dropped = balanced_levels([len(p) - 1 for p in planes], wanted, most)
    assert dropped == 0
    return refined_grid(planes, levels)


def faults(planes, points, hexes):
    """What the independent checker says; and the mesh must fill the grid's box."""
    found = conformity_faults(hexes) + improper_pairs(hexes)[:3] + nonpositive(points, hexes).tolist()[:3]
    if euler(hexes) != 1 or len(np.unique(hexes)) != len(points):
        found.append("no ball, or a point without a hex")
    low, high = [p[0] for p in planes], [p[-1] for p in planes]
    if not (points.min(axis=0) == low).all() or not (points.max(axis=0) == high).all():
        found.append("the box has moved")
    outer = HexNeighbours(hexes)
    border = points[outer.sides[outer.mate < 0]]
    on = (border == low) | (border == high)
    if not on.all(axis=1).any(axis=1).all():
        found.append("the box is not flat")
    return found


@pytest.mark.parametrize("counts,depth", [((4, 4, 4), 1), ((5, 5, 5), 1), ((2, 3, 3), 2)])
def test_all_split_is_a_finer_grid(counts, depth):
    planes = [np.arange(n + 1.0) for n in counts]
    everything = [np.argwhere(np.ones([n * 2 ** k for n in counts])) for k in range(depth)]
    points, hexes = refined(planes, everything)
    wanted = {tuple(p) for p in tensor_grid(*[np.linspace(0, n, n * 2 ** depth + 1) for n in counts])[0].tolist()}
    assert len(hexes) == np.prod(counts) * 8 ** depth and {tuple(p) for p in points.tolist()} == wanted
    assert scaled_jacobians(points, hexes).min() > 0.999999 and faults(planes, points, hexes) == []


@pytest.mark.parametrize("where,depth,count", [((4, 4, 4), 1, 1272), ((0, 0, 0), 1, 1146), ((4, 4, 4), 3, 3608)])
def test_one_cell(where, depth, count):
    """A block of eight becomes 64; the ring of cells round it takes the rest."""
    planes = even(10)
    points, hexes = refined(planes, [[]] * (depth - 1) + [[np.array(where) * 2 ** (depth - 1)]])
    assert faults(planes, points, hexes) == []
    assert len(hexes) == count
    assert scaled_jacobians(points, hexes).min() > LEAST
    least = np.ptp(points[hexes], axis=1).max(axis=1).min()
    assert least == 0.5 ** depth


@pytest.mark.parametrize("seed", range(4))
def test_any_set_of_cells(seed):
    """Random cells on three levels, on the border too, dense and sparse."""
    rng = np.random.default_rng(seed)
    planes = even(6 + seed % 3)
    n = len(planes[0]) - 1
    wanted = [rng.integers(0, n * 2 ** k, (2 + 3 * seed // (k + 1), 3)) for k in range(3)]
    points, hexes = refined(planes, wanted[:2 + seed % 2])
    assert faults(planes, points, hexes) == []
    assert scaled_jacobians(points, hexes).min() > LEAST


@pytest.mark.parametrize("seed", range(2))
def test_every_pattern_of_blocks(seed):
    """All neighbourhoods of 2 x 2 x 2 blocks round a point occur: every other block at random."""
    rng = np.random.default_rng(seed)
    blocks = rng.random((4, 4, 4)) < 0.5
    planes = even(8)
    points, hexes = refined(planes, [2 * np.argwhere(blocks)])
    assert faults(planes, points, hexes) == [] and scaled_jacobians(points, hexes).min() > LEAST


@pytest.mark.parametrize("seed", range(2))
def test_uneven_planes_stay(seed):
    """The grid's planes are at the same places, and split cells lie between them."""
    rng = np.random.default_rng(seed)
    planes = [np.cumsum(rng.uniform(0.2, 1, 9)) for _ in range(3)]
    points, hexes = refined(planes, [rng.integers(0, 8, (5, 3)), rng.integers(0, 16, (2, 3))])
    assert faults(planes, points, hexes) == []
    assert (points[:9 ** 3] == tensor_grid(*planes)[0]).all()


def test_neighbours_differ_by_one_level():
    levels, _ = balanced_levels([12, 12, 12], [np.zeros((0, 3), int)] * 2 + [np.array([[20, 21, 22]])], 10 ** 6)
    coarse, middle, fine = (set(map(tuple, one.tolist())) for one in levels)
    around = {(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)}
    for blocks, above in ((fine, middle), (middle, coarse)):
        for b in blocks:
            for d in around:
                cell = tuple(x + y for x, y in zip(b, d))
                assert all(x < 0 for x in cell) or tuple(x // 2 for x in cell) in above


def test_the_cap_leaves_out_the_finest_levels():
    wanted = [np.argwhere(np.ones((6, 6, 6))), np.argwhere(np.ones((12, 12, 12)))]
    assert [balanced_levels([6] * 3, wanted, most)[1] for most in (216, 3000, 30000)] == [2, 1, 0]


def test_pillows_round_groups_that_touch():
    """Two groups with a face in common, one of them in two parts that touch in an edge."""
    points, hexes = tensor_grid(*[np.arange(6.0)] * 3)
    group = np.full((5, 5, 5), -1)
    group[1:3, 1:3, 1:3], group[3, 1:3, 1:3], group[1:3, 3, 3] = 0, 1, 0
    made, new, parent = pillow_groups(points, hexes, group.ravel(), 0.4)
    assert conformity_faults(new) == [] and improper_pairs(new) == [] and euler(new) == 1
    # eight and four and two hexes with 24, 16 and 10 faces
    assert len(new) == 125 + 24 + 16 + 10
    assert (made[:len(points)] == points).all() and (parent[:125] == np.arange(125)).all()


def test_taken_cells_of_a_refined_grid():
    """Fullness and repair know no grid: a ball in a grid refined on one side."""
    planes = [np.linspace(-1.5, 1.5, 13)] * 3
    points, hexes = refined(planes, [np.argwhere(np.indices((12, 12, 12))[0] > 6)])
    body = ball((0, 0, 0), 1.1)
    full = fullness(points, hexes, SolidRays(*body))
    mesh = HexNeighbours(hexes)
    one = next(cells(mesh, full))
    assert (one.shells, one.euler) == (1, 2)
    taken = np.unique(hexes[one.inside], return_inverse=True)[1].reshape(-1, 8)
    assert conformity_faults(taken) == []
    volume = hn.quality(points, hexes[one.inside])
    assert volume.min > LEAST
    radius = np.linalg.norm(points[mesh.sides[mesh.boundary(one.inside)]].mean(axis=1), axis=1)
    assert 0.85 < radius.min() and radius.max() < 1.35


def test_a_field_is_followed():
    """No hex is longer than the field allows where it stands, on whatever level."""
    planes = [np.linspace(0, 8, 9)] * 3
    field = SizeField(1.0, [[4.1, 4.2, 3.9]], [0.2])
    points, hexes = refined(planes, for_field(planes, field))
    corners = points[hexes]
    longest = np.ptp(corners, axis=1).max(axis=1)
    assert faults(planes, points, hexes) == []
    assert (longest <= 2.01 * field(corners.mean(axis=1))).all() and longest.min() <= 0.25
    assert [len(one) for one in for_field(planes, SizeField(1.0))] == [0, 0, 0]


def apart(a, b, kind="wall", levels=3):
    planes = [np.arange(9.0)] * 3
    gaps = Gaps(np.array([a], float), np.array([b], float), np.array([KINDS.index(kind)]))
    wanted, left = for_gaps(planes, gaps, 1.0, levels)
    return [len(one) for one in wanted], len(left)


def test_places_that_planes_tell_apart_need_no_cells():
    assert apart((3, 4.3, 4.3), (4, 4.3, 4.3)) == ([0, 0, 0], 0)
    assert apart((3.2, 4.3, 4.3), (4.9, 4.3, 4.3)) == ([0, 0, 0], 0)


def test_narrow_places_are_split_until_they_are_wide():
    split, left = apart((3.2, 4.3, 4.3), (3.8, 4.3, 4.3))
    assert [n > 0 for n in split] == [True, True, False] and left == 0 and split[0] == 27     # and those round it
    split, left = apart((3.2, 4.3, 4.3), (3.4, 4.3, 4.3))
    assert [n > 0 for n in split] == [True, True, True] and left == 0
    assert apart((3.2, 4.3, 4.3), (3.3, 4.3, 4.3))[1] == 1
    assert apart((3.2, 4.3, 4.3), (3.21, 4.3, 4.3)) == ([0, 0, 0], 0)        # a sliver is left alone


def test_indices_are_of_the_snapped_grid():
    planes = [np.array([0.0, 1, 3, 4]), np.array([0.0, 2]), np.array([5.0, 6])]
    assert indices(planes, np.array([[2.0, 1, 5], [3.5, 2, 6]])).tolist() == [[1.5, 0.5, 0], [2.5, 1, 1]]
    assert places(planes, np.array([[1.5, 0.5, 0], [2.5, 1, 1]])).tolist() == [[2.0, 1, 5], [3.5, 2, 6]]
    assert len(box((0, 0, 0), (1, 1, 1))[1]) == 12

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proofs that a boundary allows no valid mesh are not given lightly."""
import numpy as np
from impossible import impossible_reason
from mesh_checker import nonpositive
from scrambled import extruded, swept_meshes
from surfaces import grid, upright


def test_valid_meshes_are_possible():
    """However they are deformed, and whatever is free."""
    rng = np.random.default_rng(1)
    for _, (points, hexes, boundary) in swept_meshes(60):
        for share in (0, 0.1, 0.5, 1):
            fixed = boundary | (rng.random(len(points)) < share)
            moved = points @ rng.uniform(-1, 1, (3, 3))
            if np.linalg.det(moved[hexes[0, [1, 3, 4]]] - moved[hexes[0, 0]]) < 0:
                moved = -moved
            assert not len(nonpositive(moved, hexes))
            assert impossible_reason(moved, hexes, fixed) is None


def test_one_free_point():
    """2 * 2 * 2 hexes, the middle free: the corners of the eight boxes around it decide, and the
    proof is exact: a billionth more or less makes the difference."""
    points, hexes, fixed = extruded(grid(2, 2), 2, lambda t, xy: upright(2 * t, xy))
    low, high = (int(np.flatnonzero((points == [1, 1, z]).all(axis=1))[0]) for z in (0, 2))
    for gap, possible in ((1, True), (2e-9, True), (-2e-9, False), (-1, False), (0, False)):
        goal = points.copy()
        goal[low, 2], goal[high, 2] = 1, 1 + gap    # the middle must lie between these two
        reason = impossible_reason(goal, hexes, fixed)
        assert (reason is None) == possible, gap

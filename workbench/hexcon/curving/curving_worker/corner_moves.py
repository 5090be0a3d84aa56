# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inner corners moved where curved edges fold hexes: each to the best of some places round it, one after the other.

Freitag and Ollivier-Gooch, Tetrahedral mesh improvement using swapping and smoothing (1997), section 3.2, raise the
worst element at a point in the same sense; here it is a direct search, as the bound of a curved hex has no gradient.
"""
import numpy as np

import hexcon_native as hn

from .boundary_edges import EDGES

STEPS = (0.3, 0.15, 0.07, 0.03)     # of the shortest edge at a corner, one round each, and again
ROUNDS = 3
MOST = 2000                         # corners that are tried, those of the first folded hexes
DIRECTIONS = np.array([(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1) if x or y or z], float)
DIRECTIONS /= np.linalg.norm(DIRECTIONS, axis=1)[:, None]


def with_moved_corners(points, hexes, quads, bend, folded, least):
    """(points (P,3), how many corners have moved): middle nodes follow by half, so that straight edges stay straight.

    points with straight edges, hexes (H,20), quads (n,4) the boundary, whose corners stay;  bend (P,3) of middle nodes
    folded: rows of hexes;  least (H,): below it a hex counts as folded. Where no place is better a corner stays.
    """
    points, start = points.copy(), points
    held = np.zeros(len(points), bool)
    held[quads] = True
    free = np.unique(hexes[folded, :8])
    free = free[~held[free]][:MOST]
    around = _hexes_at(hexes, free, len(points)) if len(free) else []
    for _ in range(ROUNDS):
        for step in STEPS:
            for corner, rows in zip(free, around):
                _move(points, hexes[rows], bend, corner, step, least[rows])
        if all(_worst(points + bend, hexes[rows], least[rows]) >= 0.0 for rows in around):
            break
    return points, int((points[free] != start[free]).any(axis=1).sum())


def _hexes_at(hexes, corners, count):
    """Rows of the hexes at each of some corners."""
    place = np.full(count, -1)
    place[corners] = np.arange(len(corners))
    rows, at = np.nonzero(place[hexes[:, :8]] >= 0)
    which = place[hexes[rows, at]]
    order = np.argsort(which, kind="stable")
    return np.split(rows[order], np.searchsorted(which[order], np.arange(1, len(corners))))


def _worst(points, hexes, least):
    """How far the worst of some hexes is above what counts as folded."""
    return (hn.quality(points, hexes).scaled_jacobian - least).min(initial=1.0)


def _move(points, hexes, bend, corner, step, least):
    """Move one corner, in place, if some place nearby is better for the worst hex at it."""
    ends = hexes[:, EDGES]
    at, edge = np.nonzero((ends == corner).any(axis=2))
    pairs = ends[at, edge]
    middles, first = np.unique(hexes[at, 8 + edge], return_index=True)
    others = np.where(pairs[first, 0] == corner, pairs[first, 1], pairs[first, 0])
    reach = step * np.linalg.norm(points[others] - points[corner], axis=1).min()
    used, place = np.unique(hexes, return_inverse=True)
    tried = np.repeat((points[used] + bend[used])[None],
                      len(DIRECTIONS) + 1, axis=0)
    shift = np.vstack([np.zeros(3), reach * DIRECTIONS])
    tried[:, np.searchsorted(used, corner)] += shift
    tried[:, np.searchsorted(used, middles)] += shift[:, None] / 2
    cells = place.reshape(1, -1, 20) + len(used) * np.arange(len(tried))[:, None, None]
    found = hn.quality(tried.reshape(-1, 3), cells.reshape(-1, 20)).scaled_jacobian.reshape(len(tried), -1)
    worst = (found - least).min(axis=1)
    best = int(worst.argmax())
    if worst[best] > worst[0]:
        points[corner] += shift[best]
        points[middles] += shift[best] / 2

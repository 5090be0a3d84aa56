# SPDX-License-Identifier: LGPL-2.1-or-later
"""Move inner points to where the worst hex around them is better; the topology stays."""
import numpy as np

from .quality import diced_quality

GOOD = 0.3      # scaled Jacobian; points with nothing worse around them stay
STEPS = 0.7 ** np.arange(8)     # of each round: a move towards the middle of the neighbours, then a trial move


def relax(points, tetrahedra, fixed, goes_on=lambda: True):
    """Points (Q,3) of which the first `fixed` stay; no point's worst tetrahedron gets worse.

    goes_on is asked now and then; once it is False, the points are what they had come to.
    tetrahedra (M,4), positive. Deterministic as long as it goes on. O(M) a round, about 0.2 ms a tetrahedron in all.
    """
    points = points.copy()
    if len(points) == fixed:
        return points
    quality = diced_quality(points, tetrahedra)
    rng = np.random.default_rng(1)
    movable = np.zeros(len(points), bool)
    movable[tetrahedra[quality < GOOD]] = True
    movable[:fixed] = False
    stars = [_stars(tetrahedra, group, len(points)) for group in _groups(tetrahedra, movable, rng)]
    for step in STEPS:
        for star in stars:
            if not goes_on():
                return points
            _to_middle(points, tetrahedra, quality, star, step)
            _trial(points, tetrahedra, quality, star, 0.3 * step, rng)
    return points


def _groups(tetrahedra, movable, rng):
    """Arrays of movable points, in each no two of one tetrahedron."""
    left, count = movable.copy(), len(movable)
    while left.any():
        rank = np.where(left, rng.permutation(count), count)
        best = rank[tetrahedra].min(axis=1, keepdims=True)
        first = left.copy()
        first[tetrahedra[(rank[tetrahedra] > best)]] = False
        left &= ~first
        yield np.flatnonzero(first)


def _stars(tetrahedra, group, count):
    """(points, rows of tetrahedra around them, position in `points` of each row's own)."""
    place = np.full(count, -1)
    place[group] = np.arange(len(group))
    owner = place[tetrahedra].max(axis=1)
    rows = np.flatnonzero(owner >= 0)
    return group, rows, owner[rows]


def _to_middle(points, tetrahedra, quality, star, step):
    group, rows, owner = star
    centres = points[tetrahedra[rows]].mean(axis=1)
    number = np.maximum(np.bincount(owner, minlength=len(group)), 1)
    middle = np.stack([np.bincount(owner, c, len(group)) / number for c in centres.T], axis=1)
    _keep_better(points, tetrahedra, quality, star, (1 - step) * points[group] + step * middle)


def _trial(points, tetrahedra, quality, star, step, rng):
    """A random move by up to `step` times the size of the star."""
    group, rows, owner = star
    size = np.zeros(len(group))
    np.maximum.at(size, owner, np.ptp(points[tetrahedra[rows]], axis=1).max(axis=1))
    _keep_better(points, tetrahedra, quality, star,
                 points[group] + step * size[:, None] * rng.uniform(-1, 1, (len(group), 3)))


def _keep_better(points, tetrahedra, quality, star, wanted):
    group, rows, owner = star
    before, old = points[group], quality[rows]
    points[group] = wanted
    new = diced_quality(points, tetrahedra[rows])
    worst = np.full((2, len(group)), np.inf)
    np.minimum.at(worst[0], owner, old)
    np.minimum.at(worst[1], owner, new)
    better = worst[1] > worst[0]
    points[group[~better]] = before[~better]
    quality[rows] = np.where(better[owner], new, old)

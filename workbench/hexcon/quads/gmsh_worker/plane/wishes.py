# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a region asks of the divisions of its boundary, as rows for an integer program."""
from dataclasses import dataclass

import numpy as np

from ..outline import CORNER

LIKE = 3.0      # sides up to so many times as long as each other are to be divided alike
ALONG = 0.02    # of a right angle: edges that are turned by less are parallel, or across
RINGS = 6.0     # and so the loops of a ring
SMOOTH_IN_FOUR = 1.7    # a smooth hole in four sides; else a square hole in the lattice serves it better


@dataclass(frozen=True)
class Row:
    """The sum of coefficient * count over `terms` is a multiple of `multiple`, or 0 if that is 0.

    terms   {(loop, edge): coefficient};  hard: there is no mesh without;  weight: what a difference of one costs, where
            it costs 1 / sqrt(n) to give an edge of n intervals one more
    """

    terms: dict
    multiple: int
    hard: bool
    weight: float = 0.0


def wishes(turns, desired, ways=None):
    """list of Row for one region.

    turns    list per loop (outer first, counter-clockwise) of (k,) radians by which it turns left at each edge's start
    desired  list per loop of (k,) intervals that each edge would have
    ways     list per loop of (k,) radians of straight edges' directions, NaN of curved ones; None: not known
    """
    rows = [Row(_all(loop, len(d)), 2, True) for loop, d in enumerate(desired)]
    corners = [np.flatnonzero(np.abs(t) > CORNER) for t in turns]
    if len(turns) == 1 and not len(corners[0]):
        rows.append(Row(_all(0, len(desired[0])), 4, False, 0.6))
    headings = _headings(turns, corners)
    lattice = _of_lattice(ways) if ways is not None and len(turns) > 1 else None
    if lattice is not None:
        rows += [row for loop, h in enumerate(lattice) for row in _opposite(h, desired, loop)]
    elif headings is not None:
        rows += _opposite(headings, desired)
    elif len(turns) == 2:
        rows += _ring(corners, desired)
    return rows


def _all(loop, count, coefficient=1):
    return {(loop, k): coefficient for k in range(count)}


def _headings(turns, corners):
    """(k,) lattice direction 0..3 of the edges of a single loop, None where it is no lattice polygon."""
    if len(turns) > 1:
        return None
    turn = turns[0]
    kinds = np.zeros(len(turn), int)
    if len(corners[0]) == 4 and (turn[corners[0]] > 0).all():
        kinds[corners[0]] = 1
    else:
        kinds = np.rint(turn / (np.pi / 2)).astype(int)
    return np.cumsum(kinds) % 4 if kinds.sum() == 4 and np.abs(kinds).max(initial=0) <= 1 else None


def _of_lattice(ways):
    """Per loop (k,) lattice directions 0..3, None where the edges of all loops do not run along two directions."""
    steps = [(way - ways[0][0]) / (np.pi / 2) for way in ways]
    if not all(np.abs(s - np.rint(s)).max() < ALONG for s in steps):
        return None
    return [np.rint(s).astype(int) % 4 for s in steps]


def _opposite(headings, desired, loop=0):
    """Both sums of a direction and its opposite alike."""
    rows = []
    for d in (0, 1):
        terms = {(loop, k): 1 if h == d else -1 for k, h in enumerate(headings) if h % 2 == d}
        sums = [sum(desired[loop][k] for k, h in enumerate(headings) if h == side) for side in (d, d + 2)]
        if max(sums) <= LIKE * min(sums) + 2:
            rows.append(Row(terms, 0, False, 1.5))
    return rows


def _ring(corners, desired):
    """Both loops alike: edge by edge is the caller's choice."""
    sums = [d.sum() for d in desired]
    alike = len(corners[0]) == len(corners[1])
    smooth = not len(corners[1])
    most = RINGS if alike and smooth else LIKE if alike else SMOOTH_IN_FOUR if smooth and len(corners[0]) == 4 else 0.0
    if max(sums) > most * min(sums) + 2 * (most > 0):
        return []
    return [Row({**_all(0, len(desired[0])), **_all(1, len(desired[1]), -1)}, 0, False, 1.5)]

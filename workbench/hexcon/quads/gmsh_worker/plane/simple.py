# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether polygons cross or touch themselves and each other, as chords do that are long beside a narrow wall."""
import numpy as np
from scipy.spatial import cKDTree

from ..segments import on_segments

TOUCH = 1e-9        # of a polygon's extent


def touching(loops):
    """(k,2) pairs of segments, numbered loop after loop, that have a place in common and no end.

    loops: list of (N,2) points, the first one not repeated
    Cost: n log n and, for each segment, the shorter ones as near as it is long.
    """
    start, end = np.concatenate(loops), np.concatenate([np.roll(loop, -1, axis=0) for loop in loops])
    rows = np.arange(len(start))
    after = np.concatenate([np.roll(own, -1) for own in np.split(rows, np.cumsum([len(p) for p in loops])[:-1])])
    length = np.linalg.norm(end - start, axis=1)
    middle = (start + end) / 2
    near = cKDTree(middle).query_ball_point(middle, length * (1.0 + 1e-6) + TOUCH)
    i = np.repeat(rows, [len(ones) for ones in near])
    j = np.concatenate([np.asarray(ones, int) for ones in near])
    first = (length[j] < length[i]) | ((length[j] == length[i]) & (j < i))
    apart = (j != i) & (j != after[i]) & (i != after[j])
    i, j = i[first & apart], j[first & apart]
    tiny = TOUCH * float(np.ptp(start, axis=0).max())
    hit = _meet(start[i], end[i], start[j], end[j], tiny)
    return np.stack([i[hit], j[hit]], axis=1)


def _meet(a, b, c, d, tiny):
    """(n,) bool: segments ab and cd come nearer than tiny."""
    sides = [_side(a, b, c), _side(a, b, d), _side(c, d, a), _side(c, d, b)]
    crossed = (sides[0] * sides[1] < 0) & (sides[2] * sides[3] < 0)
    ends = [_distance(a, b, c), _distance(a, b, d), _distance(c, d, a), _distance(c, d, b)]
    return crossed | (np.min(ends, axis=0) <= tiny) if len(a) else np.zeros(0, bool)


def _side(a, b, p):
    return (b[:, 0] - a[:, 0]) * (p[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (p[:, 0] - a[:, 0])


def _distance(a, b, p):
    return np.linalg.norm(on_segments(p, a, b)[0] - p, axis=1)

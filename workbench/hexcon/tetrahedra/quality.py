# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shape of the four hexes that a tetrahedron is diced into."""
import numpy as np

# Corner and its three neighbours, right-handed, of the hex at corner 0: 0 that corner, 1 2 3 the middles of its edges,
# 4 5 6 the centres of its faces between the edges 12, 23, 31, 7 the body's centre.
_CORNERS = ((0, 1, 2, 3), (1, 0, 6, 4), (2, 0, 4, 5), (3, 0, 5, 6),
            (4, 1, 7, 2), (5, 2, 7, 3), (6, 3, 7, 1), (7, 4, 6, 5))
_TURNS = ((0, 1, 2, 3), (1, 0, 3, 2), (2, 3, 0, 1), (3, 2, 1, 0))       # even: each corner in turn comes first


def diced_quality(points, tetrahedra):
    """(M,): smallest scaled Jacobian at the 32 corners of the four hexes of each of (M,4) tetrahedra.

    1 cannot be reached: 0.707 is that of the regular tetrahedron. About 5 us a tetrahedron.
    """
    corners = np.ascontiguousarray(points.T[:, tetrahedra.T].transpose(1, 0, 2))      # (4,3,M)
    worst = np.full(len(tetrahedra), np.inf)
    for turn in _TURNS:
        hexes = _hex_points(corners[list(turn)])
        for at, *near in _CORNERS:
            np.minimum(worst, _scaled_jacobian(*(hexes[k] - hexes[at] for k in near)), out=worst)
    return worst


def _scaled_jacobian(a, b, c):
    """(M,) of three edges, each (3,M)."""
    jacobian = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) \
        + a[2] * (b[0] * c[1] - b[1] * c[0])
    lengths = np.sqrt(np.prod([e[0] * e[0] + e[1] * e[1] + e[2] * e[2] for e in (a, b, c)], axis=0))
    return jacobian / np.where(lengths > 0.0, lengths, np.inf)


def _hex_points(corners):
    """The eight points, each (3,M), of the hex at the first of (4,3,M) corners."""
    first, *others = corners
    middles = [(first + other) / 2 for other in others]
    faces = [(first + others[i] + others[(i + 1) % 3]) / 3 for i in range(3)]
    return [first, *middles, *faces, corners.mean(axis=0)]

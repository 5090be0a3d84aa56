# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which hexes of order 2 have straight edges, so that what is proved of their corners holds for them."""
import numpy as np

from hexcon.femmesh.hexahedron import EDGES

# How far a middle node may be from the middle of its edge, in parts of the edge: what files in single precision, or
# with six figures, leave of an edge that is straight.
STRAIGHT = 1e-6


def curved_hexes(points, hexes):
    """Rows of the hexes (H,8|20) with an edge that is not straight, to STRAIGHT; none of order 1."""
    if hexes.shape[1] == 8:
        return np.zeros(0, np.int64)
    start, end = (points[hexes[:, EDGES[:, k]]] for k in (0, 1))
    off = np.linalg.norm(points[hexes[:, 8:]] - (start + end) / 2, axis=2)
    return np.flatnonzero(~(off <= STRAIGHT * np.linalg.norm(end - start, axis=2)).all(axis=1))

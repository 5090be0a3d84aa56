# SPDX-License-Identifier: LGPL-2.1-or-later
"""Change of order: 8-node to 20-node hexahedra with straight edges, and back."""
import numpy as np

from .hexahedron import EDGES


def raise_order(points, hexes):
    """Put a node in the middle of every edge.

    points  (P,3) float64;  hexes (H,8) int, 0-based, VTK order
    Returns (points (P+E,3), hexes (H,20)): rows 0..P-1 are kept bit for bit, the E new
    rows are the edge middles, sorted by the edge's end nodes. Cost: one sort of 12 H keys.
    """
    ends = hexes[:, EDGES].astype(np.int64)
    keys = ends.min(axis=2) * len(points) + ends.max(axis=2)
    edges, middle = np.unique(keys, return_inverse=True)
    low, high = np.divmod(edges, len(points))
    middles = 0.5 * (points[low] + points[high])
    middle = middle.reshape(keys.shape) + len(points)
    return np.vstack([points, middles]), np.hstack([hexes, middle]).astype(np.int64)


def lower_order(points, hexes):
    """Drop the middle nodes of (H,20) hexes.

    Returns (points, hexes (H,8), kept), kept (P',) being the old index of each new point:
    the middle nodes alone leave, the others keep their sequence.
    """
    middle = np.zeros(len(points), bool)
    middle[hexes[:, 8:]] = True
    middle[hexes[:, :8]] = False
    kept = np.flatnonzero(~middle)
    new = np.full(len(points), -1, np.int64)
    new[kept] = np.arange(len(kept))
    return points[kept], new[hexes[:, :8]], kept

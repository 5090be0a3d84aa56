# SPDX-License-Identifier: LGPL-2.1-or-later
"""Back from 20-node to 8-node hexahedra; hexcon_native.raise_order goes the other way."""
import numpy as np


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

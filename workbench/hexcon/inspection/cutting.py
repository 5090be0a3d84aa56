# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts by a plane that leave hexes whole: each stays or goes with its centre."""
import numpy as np

AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
_NEAR = 1e-9  # of the size of the mesh: centres so near to the plane lie on it


def centres_of(points, cells):
    """(k,3) the mean of the corners of each cell (k,8) or (k,4)."""
    # corner by corner: twice as fast as the mean of (k,8,3)
    return sum(points[cells[:, corner]] for corner in range(cells.shape[1])) / cells.shape[1]


def behind_plane(centres, point, normal):
    """(k,) bool: centres (k,3) on the plane, or on the side its normal points away from."""
    reach = _NEAR * (np.ptp(centres, axis=0).max() if len(centres) else 0.0)
    return (centres - np.asarray(point, float)) @ np.asarray(normal, float) <= reach

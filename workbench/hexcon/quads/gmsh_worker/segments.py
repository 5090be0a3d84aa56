# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nearest points of segments."""
import numpy as np
from scipy.spatial import cKDTree

NEAR = 8            # segments looked at for each point


def on_segments(p, a, b):
    """((n,d) nearest points of segments a b, each to its own point of p, (n,) which part of the segment that is)."""
    d = b - a
    t = (((p - a) * d).sum(1) / np.maximum((d * d).sum(1), 1e-300)).clip(0.0, 1.0)
    return a + t[:, None] * d, t


def distances(points, a, b):
    """(n,) distances of points from segments a b (m,d): those whose middles are nearest are measured."""
    near = cKDTree((a + b) / 2.0).query(points, min(NEAR, len(a)))[1].reshape(len(points), -1)
    return np.min([np.linalg.norm(on_segments(points, a[k], b[k])[0] - points, axis=1) for k in near.T], axis=0)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scaled Jacobian of hexahedra, for files and pictures."""
import numpy as np

from .hexahedron import CORNERS


def scaled_jacobian(points, hexes):
    """(H,) float64: minimum over the 8 corners of det(a,b,c) / (|a| |b| |c|).

    points (P,3), hexes (H,8|20) 0-based; the corners alone count. The core's own quality
    is used where it is built; the formula here is the same, so files do not depend on it.
    """
    try:
        from hexcon_native import quality
        return np.asarray(quality(points, hexes[:, :8]).scaled_jacobian, float)
    except ImportError:
        return _by_numpy(points, hexes)


def _by_numpy(points, hexes):
    worst = np.full(len(hexes), np.inf)
    for corner, neighbours in enumerate(CORNERS):
        a, b, c = (points[hexes[:, n]] - points[hexes[:, corner]] for n in neighbours)
        lengths = (np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1)
                   * np.linalg.norm(c, axis=1))
        det = np.einsum("ij,ij->i", a, np.cross(b, c))
        scaled = np.divide(det, lengths, out=np.zeros_like(det), where=lengths > 0)
        np.minimum(worst, scaled, out=worst)
    return worst

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nearest points on a CAD edge of any kind: from samples, by Gauss and Newton's steps in its parameter."""
import gmsh
import numpy as np
from scipy.spatial import cKDTree

SAMPLES = 400
STEPS = 12


class CurvePoints:
    """Of one CAD edge without a closed form."""

    def __init__(self, edge):
        self._edge = edge
        low, high = gmsh.model.getParametrizationBounds(1, edge)
        self._low, self._high = float(low[0]), float(high[0])
        self._at = np.linspace(self._low, self._high, SAMPLES)
        self._tree = cKDTree(self._value(self._at))

    def _value(self, t):
        return np.array(gmsh.model.getValue(1, self._edge, t)).reshape(-1, 3)

    def project(self, points):
        """(n,3) nearest places between the edge's ends; points (n,3)."""
        points = np.asarray(points, float).reshape(-1, 3)
        if not len(points):
            return points.copy()
        t = self._at[self._tree.query(points)[1]]
        reach = (self._high - self._low) / SAMPLES
        for _ in range(STEPS):
            ahead = np.array(gmsh.model.getDerivative(1, self._edge, t)).reshape(-1, 3)
            step = ((points - self._value(t)) * ahead).sum(1) / np.maximum((ahead * ahead).sum(1), 1e-300)
            t = (t + step.clip(-reach, reach)).clip(self._low, self._high)
            if (np.abs(step) <= 1e-14 * (self._high - self._low)).all():
                break
        return self._value(t)

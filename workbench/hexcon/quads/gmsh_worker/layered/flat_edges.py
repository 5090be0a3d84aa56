# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAD edges seen along a direction: curves of a plane."""
import numpy as np
from scipy.interpolate import make_interp_spline
from scipy.spatial import cKDTree

SAMPLES = 129       # of a curved edge


class FlatEdge:
    """fractions (n,), xy (n,2): samples along an edge, of its arc length in space."""

    def __init__(self, solid, upright, edge):
        """upright: upright.Upright, which says where places are seen."""
        self.edge, self._solid, self._upright = edge, solid, upright
        self.fractions = np.linspace(0.0, 1.0, 2 if solid.is_line(edge) and upright.is_straight(edge) else SAMPLES)
        self.xy = upright.flat(edge, self.fractions, self.places(self.fractions))
        self.low, self.high = self.xy.min(0), self.xy.max(0)
        self._line = make_interp_spline(self.fractions, self.xy, 1 if len(self.fractions) == 2 else 3)
        self._slopes = self._line.derivative(), None if len(self.fractions) == 2 else self._line.derivative(2)
        self._seen = len(self.fractions) == 2 or upright.moves(edge)

    def at(self, fractions):
        """(n,2) places at fractions."""
        fractions = np.clip(fractions, 0.0, 1.0)
        if self._seen:
            return self._line(fractions)
        return self._upright.flat(self.edge, fractions, self.places(fractions))

    def about(self, fractions):
        """(n,2) the same by a spline through the samples: some 1e-8 of the edge's length off, and a hundredth of the
        time."""
        return self._line(fractions)

    def slope(self, fractions):
        """(n,2) what the place moves by for each unit of the fraction."""
        return self._slopes[0](fractions)

    def places(self, fractions):
        """(n,3) points of the CAD edge."""
        return self._solid.edge_points(self.edge, np.clip(fractions, 0.0, 1.0))

    def locate(self, points, low=0.0, high=1.0):
        """((n,) fractions between low and high of the nearest places, (n,) how far they are in the plane).

        From the nearest sample by Newton's steps; linear.
        """
        points = np.asarray(points, float).reshape(-1, 2)
        dense = np.linspace(low, high, 2 * SAMPLES)
        if len(self.fractions) == 2:
            a, d = self.xy[0], self.xy[1] - self.xy[0]
            f = ((points - a) @ d / max(d @ d, 1e-300)).clip(low, high)
            return f, np.linalg.norm(a + f[:, None] * d - points, axis=1)
        f = dense[cKDTree(self.about(dense)).query(points)[1]]
        for _ in range(6):
            one, two, off = self.slope(f), self._slopes[1](f), self.about(f) - points
            slope = (one * one).sum(1) + (two * off).sum(1)
            slope = np.where(slope > 0.1 * (one * one).sum(1), slope, (one * one).sum(1))
            f = (f - (one * off).sum(1) / np.maximum(slope, 1e-300)).clip(low, high)
        return f, np.linalg.norm(self.at(f) - points, axis=1)


def crossings(a, b):
    """(n,2) fractions of two FlatEdges at which they cross, and (n,2) places."""
    rows, columns = _beside(a, b), _beside(b, a)
    p, r = a.xy[rows, None], (a.xy[rows + 1] - a.xy[rows])[:, None]
    q, s = b.xy[None, columns], (b.xy[columns + 1] - b.xy[columns])[None]
    det = r[..., 0] * s[..., 1] - r[..., 1] * s[..., 0]
    flat = np.abs(det) <= 1e-12 * np.linalg.norm(r, axis=-1) * np.linalg.norm(s, axis=-1)
    det = np.where(flat, 1.0, det)
    d = q - p
    t = (d[..., 0] * s[..., 1] - d[..., 1] * s[..., 0]) / det
    u = (d[..., 0] * r[..., 1] - d[..., 1] * r[..., 0]) / det
    i, j = np.nonzero(~flat & (t >= 0) & (t <= 1) & (u >= 0) & (u <= 1))
    ka, kb = rows[i], columns[j]
    f = np.stack([a.fractions[ka] + t[i, j] * (a.fractions[ka + 1] - a.fractions[ka]),
                  b.fractions[kb] + u[i, j] * (b.fractions[kb + 1] - b.fractions[kb])], 1)
    return _refined(a, b, f)


def _beside(a, b):
    """(n,) segments of a in the box of b."""
    low, high = np.minimum(a.xy[:-1], a.xy[1:]), np.maximum(a.xy[:-1], a.xy[1:])
    return np.flatnonzero((low <= b.high).all(1) & (high >= b.low).all(1))


def _refined(a, b, f):
    """The crossing fractions put right by Newton's method, and their places."""
    for _ in range(5):
        if not len(f):
            return f, np.empty((0, 2))
        gap = a.about(f[:, 0]) - b.about(f[:, 1])
        da, db = a.slope(f[:, 0]), b.slope(f[:, 1])
        det = -da[:, 0] * db[:, 1] + da[:, 1] * db[:, 0]
        det = np.where(np.abs(det) < 1e-9 * np.linalg.norm(da, axis=1) * np.linalg.norm(db, axis=1), np.inf, det)
        move = np.stack([-gap[:, 0] * -db[:, 1] + gap[:, 1] * -db[:, 0],
                         -da[:, 0] * gap[:, 1] + da[:, 1] * gap[:, 0]], 1) / det[:, None]
        f = (f + np.clip(move, -0.02, 0.02)).clip(0.0, 1.0)
    return f, a.at(f[:, 0])

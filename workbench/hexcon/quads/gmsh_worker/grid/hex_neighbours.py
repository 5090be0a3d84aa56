# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which hexes of a conforming mesh share faces, and where round each point."""
from functools import cached_property

import numpy as np

FACES = np.array([[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]])
"""Corners of the sides of a hex, outward; side s is across from side s ^ 1."""


class HexNeighbours:
    """Of hexes (H, 8), 0-based ids in VTK order, each face in one or two of them.

    sides   (6 H, 4) ids of side s of hex h in row 6 h + s, outward
    mate    (6 H,) the row of the same face in the other hex, -1 on the border of the mesh
    across  (H, 6) the hexes there, -1 for none
    """

    def __init__(self, hexes):
        self.hexes = np.asarray(hexes)
        self.sides = self.hexes[:, FACES].reshape(-1, 4)
        keys = np.sort(self.sides, axis=1)
        order = np.lexsort(keys.T)
        same = np.flatnonzero((keys[order[1:]] == keys[order[:-1]]).all(axis=1))
        self.mate = np.full(len(self.sides), -1)
        self.mate[order[same]], self.mate[order[same + 1]] = order[same + 1], order[same]
        self.across = np.where(self.mate < 0, -1, self.mate // 6).reshape(-1, 6)
        self.points = int(self.hexes.max(initial=-1)) + 1

    @cached_property
    def on_border(self):
        """(P,) bool of points on the border of the mesh."""
        out = np.zeros(self.points, bool)
        out[self.sides[self.mate < 0]] = True
        return out

    @cached_property
    def corner_mates(self):
        """(8 H, 3) for corner k of hex h (row 8 h + k) the corners at the same point across its three faces, or -1."""
        out = np.full((8 * len(self.hexes), 3), -1)
        used = np.zeros(8, int)
        for s, face in enumerate(FACES):
            rows = np.flatnonzero(self.mate[s::6] >= 0)
            other = self.mate[6 * rows + s] // 6
            for k in face:
                local = np.argmax(self.hexes[other] == self.hexes[rows, k][:, None], axis=1)
                out[8 * rows + k, used[k]] = 8 * other + local
                used[k] += 1
        return out

    @cached_property
    def stars(self):
        """(corner rows by point, (P + 1,) where each point's begin)."""
        order = np.argsort(self.hexes.ravel(), kind="stable")
        return order, np.searchsorted(self.hexes.ravel()[order], np.arange(self.points + 1))

    def boundary(self, inside):
        """Rows of sides between hexes that are inside (H,) bool and what is not: quads outward."""
        taken = np.repeat(inside, 6)
        return np.flatnonzero(taken & ~np.append(np.repeat(inside, 6), False)[self.mate])

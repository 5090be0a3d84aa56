# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of a hex mesh: the shortest decides the time step of explicit solvers, and what spectral ones need."""
from dataclasses import dataclass

import numpy as np

from hexcon.femmesh.hexahedron import EDGES

HEXES_AT_ONCE = 1 << 16     # so that ten million need no more memory than their results


@dataclass
class Lengths:
    """Edge lengths of a hex mesh, in its units; edges are taken as straight.

    shortest, longest  of all edges;  shortest_hex  row of a hex that has the shortest
    aspect_ratio       (H,) longest over shortest edge of each hex, 1 at best; inf for an edge of no length
    """

    shortest: float
    longest: float
    shortest_hex: int
    aspect_ratio: np.ndarray

    def as_dict(self):
        """Plain numbers, for JSON."""
        return {"shortest_edge": self.shortest, "longest_edge": self.longest, "shortest_edge_hex": self.shortest_hex,
                "aspect_ratio": {"max": float(self.aspect_ratio.max()), "mean": float(self.aspect_ratio.mean()),
                                 "max_hex": int(self.aspect_ratio.argmax())}}


def lengths_of(points, hexes):
    """Lengths of a mesh. points (P,3) float; hexes (H,8|20) int, VTK order, 0-based, H > 0. Linear."""
    least, most = np.empty(len(hexes)), np.empty(len(hexes))
    for start in range(0, len(hexes), HEXES_AT_ONCE):
        rows = slice(start, start + HEXES_AT_ONCE)
        ends = points[hexes[rows, :8]][:, EDGES]
        edges = np.linalg.norm(ends[:, :, 1] - ends[:, :, 0], axis=2)
        least[rows], most[rows] = edges.min(axis=1), edges.max(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        aspect = np.where(least > 0, most / least, np.inf)
    return Lengths(float(least.min()), float(most.max()), int(least.argmin()), aspect)

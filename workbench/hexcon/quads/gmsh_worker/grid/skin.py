# SPDX-License-Identifier: LGPL-2.1-or-later
"""The boundary of a hex mesh as a graph that paths are sought in."""
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from .captured import HalfEdges, edge_keys, face_pairs


class Skin:
    """quads (n, 4), under (n,) and vertices (V,) of a hex mesh; inside, vertices are numbered 0 to V - 1.

    points (V, 3); rows (n, 4) the quads in those numbers; scale (V,) the longest of a vertex's edges; normals and
    centres (n, 3) of quads; edge_of (4 n,) undirected edge of a half-edge; joined {V a + b} of half-edges from a to b.
    Cost: O(H log H).
    """

    def __init__(self, points, hexes):
        sides, _, lone = face_pairs(hexes, len(points))
        self.quads, self.under = sides[lone], lone // 6
        self.vertices, rows = np.unique(self.quads, return_inverse=True)
        self.rows, self.points = rows.reshape(self.quads.shape), points[self.vertices]
        n = len(self.vertices)
        self.half_edges = HalfEdges(self.rows, n)
        tail, head = self.half_edges.tail, self.half_edges.head
        self.length = np.linalg.norm(self.points[tail] - self.points[head], axis=1)
        self.valence = np.bincount(tail, minlength=n)
        self.scale = np.zeros(n)
        np.maximum.at(self.scale, tail, self.length)
        self.edge_of = np.unique(edge_keys(tail, head, n), return_inverse=True)[1]
        self.tree = cKDTree(self.points)
        p = self.points[self.rows]
        normals = np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1])
        self.normals = normals / np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
        self.centres = p.mean(axis=1)
        self.joined = set((tail * n + head).tolist())
        self._first = np.argsort(tail, kind="stable")[np.concatenate([[0], np.cumsum(self.valence)[:-1]])]

        self.turn_of = self._turns()

    def _turns(self):
        """(4 n,) place of each half-edge among those that leave its tail, counter-clockwise."""
        out = np.zeros(4 * len(self.rows), int)
        here = self._first
        for k in range(1, int(self.valence.max())):
            here = self.half_edges.twin[np.where(here % 4, here - 1, here + 3)]
            more = k < self.valence
            out[here[more]] = k
        return out

    def outgoing(self, v):
        """Half-edges that leave vertex v, counter-clockwise seen from outside."""
        first = here = int(self._first[v])
        found = []
        while True:
            found.append(here)
            here = int(self.half_edges.twin[here - 1 if here % 4 else here + 3])
            if here == first:
                return found

    def directions(self, v):
        """(valence, 3) unit vectors along the edges of vertex v, counter-clockwise seen from outside."""
        d = self.points[self.half_edges.head[self.outgoing(v)]] - self.points[v]
        return d / np.maximum(np.linalg.norm(d, axis=1), 1e-300)[:, None]

    def pieces(self, border):
        """(n,) number of the piece each quad is in, and how many: quads joined over half-edges that are no `border`."""
        h = np.flatnonzero(~border)
        n = len(self.rows)
        joined = coo_matrix((np.ones(len(h), bool), (h // 4, self.half_edges.twin[h] // 4)), shape=(n, n))
        count, piece = connected_components(joined, directed=False)
        return piece, count

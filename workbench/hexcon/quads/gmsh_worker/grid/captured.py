# SPDX-License-Identifier: LGPL-2.1-or-later
"""A hex mesh that knows its CAD: the patch of each boundary quad, the curve of edges, the vertex of each corner."""
from dataclasses import dataclass
from functools import cached_property

import numpy as np

# Of a hex in VTK's order: faces counter-clockwise from outside; edges.
FACES = np.array([[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])
EDGES = np.array([[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]])


class NotCaptured(Exception):
    """What could not be captured: kind (corner, curve, patch, topology), words, place (3,) or None, CAD ids.

    .curves, .corners, .patches: 0-based ids of the model's; the model knows the CAD edges and faces behind them
    """

    def __init__(self, kind, words, place=None, curves=(), corners=(), patches=()):
        super().__init__(f"{kind}: {words}")
        self.kind, self.words = kind, words
        self.place = None if place is None else np.asarray(place, float)
        self.curves, self.corners, self.patches = (sorted(int(k) for k in ids) for ids in (curves, corners, patches))


def edge_keys(a, b, n):
    """One int64 for each undirected edge of vertices below n."""
    return np.minimum(a, b).astype(np.int64) * n + np.maximum(a, b)


def face_pairs(hexes, n):
    """(sides (6 H, 4) in the order of FACES, inner (k, 2) rows of sides that are one face, lone (m,) of the boundary).

    O(H log H). A face is told by its least vertex, the one across from it, and the lesser of the other two.
    """
    sides = hexes[:, FACES].reshape(-1, 4)
    rows = np.arange(len(sides))
    least = sides.argmin(axis=1)
    across = sides[rows, (least + 2) % 4]
    other = np.minimum(sides[rows, (least + 1) % 4], sides[rows, (least + 3) % 4])
    key = sides[rows, least].astype(np.int64) * n + across
    order = np.lexsort((other, key))
    same = (key[order][1:] == key[order][:-1]) & (other[order][1:] == other[order][:-1])
    single = np.ones(len(sides), bool)
    single[1:] &= ~same
    single[:-1] &= ~same
    at = np.flatnonzero(same)
    return sides, np.stack([order[at], order[at + 1]], axis=1), np.sort(order[single])


class HalfEdges:
    """Directed edges of quads: 4 q + k goes from corner k of quad q to the next, with q on its left.

    twin (4 n,) is the same edge from the other side. Raises ValueError where the quads are no closed oriented surface.
    """

    def __init__(self, quads, n):
        self.tail = quads.ravel().astype(np.int64)
        self.head = np.roll(quads, -1, axis=1).ravel().astype(np.int64)
        self.count = n
        forth, back = self.tail * n + self.head, self.head * n + self.tail
        order = np.argsort(forth)
        self._sorted, self._order = forth[order], order
        at = np.searchsorted(self._sorted, back).clip(0, len(forth) - 1)
        if (self._sorted[at] != back).any() or (self._sorted[1:] == self._sorted[:-1]).any():
            raise ValueError("the boundary is no closed, oriented surface of quads")
        self.twin = order[at]

    def find(self, tails, heads):
        """Half-edge of each (tail, head), -1 where there is none."""
        want = np.asarray(tails, np.int64) * self.count + np.asarray(heads, np.int64)
        at = np.searchsorted(self._sorted, want).clip(0, len(self._sorted) - 1)
        return np.where(self._sorted[at] == want, self._order[at], -1)


@dataclass(frozen=True)
class CapturedMesh:
    """Ids are 0-based rows of points, of hexes, of the model's patches, curves and corners.

    points         (P, 3)   float
    hexes          (H, 8)   VTK's order
    quads          (n, 4)   the faces in one hex only, counter-clockwise from outside
    patch          (n,)     of each quad
    under          (n,)     hex of each quad
    curve_edges    (m, 2)   boundary edges on curves, lesser vertex first
    curve          (m,)     of each such edge
    corner_vertex  (K,)     vertex of each corner
    """
    points: np.ndarray
    hexes: np.ndarray
    quads: np.ndarray
    patch: np.ndarray
    under: np.ndarray
    curve_edges: np.ndarray
    curve: np.ndarray
    corner_vertex: np.ndarray

    @cached_property
    def half_edges(self):
        return HalfEdges(self.quads, len(self.points))

    @cached_property
    def curve_of_half_edge(self):
        """(4 n,) curve of each half-edge, or -1."""
        out = np.full(4 * len(self.quads), -1)
        for a, b in ((0, 1), (1, 0)):
            out[self.half_edges.find(self.curve_edges[:, a], self.curve_edges[:, b])] = self.curve
        return out

    @cached_property
    def corner_of_vertex(self):
        """(P,) corner of each vertex, or -1."""
        out = np.full(len(self.points), -1)
        out[self.corner_vertex] = np.arange(len(self.corner_vertex))
        return out

    @cached_property
    def hexes_at_half_edge(self):
        """(4 n,) how many hexes have the edge of each half-edge."""
        surface = np.zeros(len(self.points), bool)
        surface[self.quads] = True
        ends = self.hexes[:, EDGES].reshape(-1, 2)
        ends = ends[surface[ends].all(axis=1)]
        keys = np.sort(edge_keys(ends[:, 0], ends[:, 1], len(self.points)))
        mine = edge_keys(self.half_edges.tail, self.half_edges.head, len(self.points))
        return np.searchsorted(keys, mine, side="right") - np.searchsorted(keys, mine, side="left")

    @cached_property
    def _edges_of_curves(self):
        """(edges in the order of their curves, first of each curve)."""
        order = np.argsort(self.curve, kind="stable")
        last = int(self.curve.max(initial=-1)) + 1
        return self.curve_edges[order], np.searchsorted(self.curve[order], np.arange(last + 1))

    def edges_of(self, c):
        """(k, 2) edges of curve c."""
        edges, first = self._edges_of_curves
        return edges[first[c]:first[c + 1]] if c + 1 < len(first) else edges[:0]

    def chain(self, model, c):
        """(k,) vertices of curve c in order from its start, its left patch on the left; closed: first is last.

        Where the curve has one patch on both sides and no corner, the direction is that of the curve's own arc length.
        Raises ValueError if its edges are no single path.
        """
        curve = model.curves[c]
        edges = self.edges_of(c)
        near = {}
        for a, b in edges.tolist():
            near.setdefault(a, []).append(b)
            near.setdefault(b, []).append(a)
        if not near:
            raise ValueError(f"curve {c} has no edges")
        start = min(near) if curve.start < 0 else int(self.corner_vertex[curve.start])
        if start not in near:
            raise ValueError(f"curve {c} does not begin at its corner")
        found, last = [start, min(near[start])], start
        while found[-1] != start and len(near[found[-1]]) == 2 and len(found) <= len(edges):
            a, b = near[found[-1]]
            last, onward = found[-1], b if a == last else a
            found.append(onward)
        if len(found) != len(edges) + 1:
            raise ValueError(f"the edges of curve {c} are no single path: {len(found) - 1} of {len(edges)}")
        if curve.start == curve.end and self._runs_back(curve, found):
            found.reverse()
        return np.array(found)

    def _runs_back(self, curve, chain):
        """Whether a closed chain goes against its curve."""
        if curve.left != curve.right:
            at = self.half_edges.find(chain[:1], chain[1:2])[0]
            return self.patch[at // 4] != curve.left
        s, _ = curve.lengths_of(self.points[chain])
        step = np.diff(s)
        step -= curve.length * np.round(step / curve.length)
        return step.sum() < 0

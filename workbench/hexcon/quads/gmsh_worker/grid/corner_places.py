# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which vertex of the skin each CAD corner takes: near, where its patches meet, with an edge for each of its curves.

A first assignment minimises the sum of each corner's own cost (Kuhn 1955); it is improved one corner, or a swap of
two, at a time with what depends on two corners: corners keep their places to one another, and those of a very short
curve become neighbours.
"""
import itertools

import numpy as np
from scipy.optimize import linear_sum_assignment
from scipy.spatial import cKDTree

from .captured import NotCaptured

REACH = 2.5             # of the local edge length: how far a corner may be from its vertex
CANDIDATES = 12         # vertices a corner chooses from
SHORT = 0.8             # of the local edge length: a shorter curve wants its corners on one edge
BLOCKED = 0.4           # cost of an edge between corners that no curve joins
APART = 0.8             # cost of corners of a very short curve that are no neighbours
SWEEPS = 6
LACK = 0.8             # cost of each edge that a vertex has too few: such edges can be made
ORDERS = 24             # cyclic orders of a corner's curves that are tried, where patches alone do not tell


class Ends:
    """The curve ends at a corner: ends [(curve, 1 leaves here / -1 arrives here)], their orders counter-clockwise."""

    def __init__(self, model, k, ends):
        self.ends = ends
        self.sides = [(model.curves[c].left, model.curves[c].right)[::sign] for c, sign in self.ends]   # left, right
        self.orders = self._orders() or [tuple(range(len(self.ends)))]
        self._curves = [model.curves[c] for c, _ in self.ends]
        self._place = model.corners[k]

    def _orders(self):
        """Counter-clockwise, an end's left patch is the next end's right one. All such orders, at most ORDERS."""
        found, n = [], len(self.ends)

        def go_on(order, rest):
            if len(found) >= ORDERS:
                return
            if not rest:
                if self.sides[order[-1]][0] == self.sides[order[0]][1]:
                    found.append(tuple(order))
                return
            for e in sorted(rest):
                if self.sides[order[-1]][0] == self.sides[e][1]:
                    go_on(order + [e], rest - {e})
        if n:
            go_on([0], frozenset(range(1, n)))
        return found

    def directions(self, step):
        """(n, 3) unit directions in which the curves leave, over a length `step`."""
        out = np.empty((len(self.ends), 3))
        for row, (curve, (_, sign)) in enumerate(zip(self._curves, self.ends)):
            s = min(step, 0.4 * curve.length)
            out[row] = curve.sampled(np.array([s if sign > 0 else curve.length - s]))[0] - self._place
        return out / np.maximum(np.linalg.norm(out, axis=1), 1e-300)[:, None]


def ends_of_corners(model):
    """Ends of every corner."""
    found = [[] for _ in model.corners]
    for c, curve in enumerate(model.curves):
        for sign, k in ((1, curve.start), (-1, curve.end)):
            if k >= 0:
                found[k].append((c, sign))
    return [Ends(model, k, ends) for k, ends in enumerate(found)]


def embedded(ends, directions, ports, forbidden=None):
    """(cost, port of each end) of the cheapest way to give each end a port of its own, in one of the cyclic orders.

    ports (m, 3) directions of a vertex's edges, counter-clockwise; forbidden (n, m) bool. Cost inf where there is none.
    O(orders n m^2).
    """
    n, m = len(directions), len(ports)
    if n == 0:
        return 0.0, []
    if n > m:
        return np.inf, None
    cost = 1.0 - directions @ ports.T
    if forbidden is not None:
        cost = np.where(forbidden, np.inf, cost)
    best, found = np.inf, None
    for order in ends.orders:
        rows = cost[list(order)]
        for first in range(m):
            turned = np.roll(rows, -first, axis=1)
            value, picks = _ascending_choice(turned)
            if value < best:
                best = value
                found = [0] * n
                for e, pick in zip(order, picks):
                    found[e] = (pick + first) % m
    return best / n, found


def _ascending_choice(cost):
    """Cheapest columns 0 = j0 < j1 < ... for the rows: (cost, columns)."""
    n, m = cost.shape
    value = np.full((n, m), np.inf)
    back = np.zeros((n, m), int)
    value[0, 0] = cost[0, 0]
    for i in range(1, n):
        low, at = np.inf, 0
        for j in range(i, m):
            if value[i - 1, j - 1] < low:
                low, at = value[i - 1, j - 1], j - 1
            value[i, j], back[i, j] = low + cost[i, j], at
    j = int(value[n - 1].argmin())
    total, picks = value[n - 1, j], [j]
    for i in range(n - 1, 0, -1):
        j = int(back[i, j])
        picks.append(j)
    return total, picks[::-1]


class CornerPlaces:
    """Places corners on the skin's vertices; `blame` makes a place dearer for the next call of `placed`."""

    def __init__(self, model, skin, guess):
        self.model, self.skin = model, skin
        self.ends = ends_of_corners(model)
        self._blamed = {}
        self._corners = np.asarray(model.corners, float).reshape(-1, 3)
        self._around = _patches_around(skin, guess)
        self._candidates = [self._costs(k) for k in range(len(model.corners))]
        self._near = self._neighbours()

    def _costs(self, k):
        """vertex -> cost, of the best few vertices."""
        skin, p = self.skin, self.model.corners[k]
        _, nearest = skin.tree.query(p)
        scale = skin.scale[nearest]
        rows = np.array(skin.tree.query_ball_point(p, REACH * scale) or [nearest])
        wanted = self.model.corner_patches[k]
        gap = np.linalg.norm(skin.points[rows] - p, axis=1) / scale
        missing = np.array([len(wanted - self._around[v]) for v in rows]) / max(1, len(wanted))
        lack = np.maximum(len(self.ends[k].ends) - skin.valence[rows], 0)
        cost = gap + missing + LACK * lack
        order = np.lexsort((rows, cost))[:CANDIDATES]
        directions = self.ends[k].directions(0.7 * scale)
        out = {}
        for v, value in zip(rows[order].tolist(), cost[order].tolist()):
            fit, _ = embedded(self.ends[k], directions, self.skin.directions(v))
            out[v] = value + (0.6 * fit if np.isfinite(fit) else 0.0)
        return out

    def _neighbours(self):
        """Per corner [(other corner, length of the curve between or inf)] of those that are near or joined."""
        corners = self._corners
        joined = {}
        for curve in self.model.curves:
            a, b = curve.start, curve.end
            if a >= 0 and a != b:
                for pair in ((a, b), (b, a)):
                    joined[pair] = min(joined.get(pair, np.inf), curve.length)
        if not len(corners):
            return []
        scale = self.skin.scale[self.skin.tree.query(corners)[1]]
        near = cKDTree(corners).query_ball_point(corners, REACH * scale)
        return [[(j, joined.get((k, j), np.inf), scale[k]) for j in sorted(found) if j != k]
                for k, found in enumerate(near)]

    def blame(self, k, v):
        """Make a place dearer, the more the worse it is: one that fits well is hardly at fault."""
        self._blamed[k, v] = self._blamed.get((k, v), 0.0) + 0.05 + 0.5 * min(1.0, self._candidates[k][v])

    def placed(self):
        """(K,) vertex of the skin for each corner. Raises NotCaptured."""
        corners = range(len(self.model.corners))
        if not len(corners):
            return np.zeros(0, int)
        columns = sorted({v for found in self._candidates for v in found})
        column = {v: i for i, v in enumerate(columns)}
        cost = np.full((len(corners), len(columns)), 1e6)
        for k in corners:
            for v, value in self._candidates[k].items():
                cost[k, column[v]] = value + self._blamed.get((k, v), 0.0)
        if len(columns) < len(corners):
            raise NotCaptured("corner", f"{len(corners)} corners crowd round {len(columns)} vertices: smaller elements "
                              "are needed", self.model.corners[0], corners=corners)
        rows, chosen = linear_sum_assignment(cost)
        for k, i in zip(rows, chosen):
            if cost[k, i] >= 1e6:
                raise NotCaptured("corner", f"no vertex is left for corner {k}: smaller elements are needed there",
                                  self.model.corners[k], corners=[k])
        vertex = np.array([columns[i] for i in chosen])
        self._improve(vertex)
        return vertex

    def _improve(self, vertex):
        at = {int(v): k for k, v in enumerate(vertex)}
        for _ in range(SWEEPS):
            moved = False
            for k in range(len(vertex)):
                here = int(vertex[k])
                best, found = 1e-9, None
                for v in self._candidates[k]:
                    other = at.get(v)
                    if v == here or (other is not None and here not in self._candidates[other]):
                        continue
                    gain = self._gain(vertex, k, v, other)
                    if gain > best:
                        best, found = gain, v
                if found is not None:
                    other = at.pop(found, None)
                    del at[here]
                    vertex[k], at[found] = found, k
                    if other is not None:
                        vertex[other], at[here] = here, other
                    moved = True
            if not moved:
                return

    def _gain(self, vertex, k, v, other):
        """By how much the cost falls when corner k takes v, and the corner there takes k's vertex."""
        changed = [k] if other is None else [k, other]
        before = sum(self._cost(vertex, j) for j in changed)
        here = vertex[k]
        vertex[k] = v
        if other is not None:
            vertex[other] = here
        after = sum(self._cost(vertex, j) for j in changed)
        vertex[k] = here
        if other is not None:
            vertex[other] = v
        return before - after

    def _cost(self, vertex, k):
        skin, v, count = self.skin, int(vertex[k]), len(self.skin.points)
        cost = self._candidates[k][v] + self._blamed.get((k, v), 0.0)
        if not self._near[k]:
            return cost
        others = [j for j, _, _ in self._near[k]]
        apart = skin.points[vertex[others]] - skin.points[v]
        off = apart - (self._corners[others] - self._corners[k])
        for (j, length, scale), far in zip(self._near[k], np.sqrt((off * off).sum(axis=1)).tolist()):
            cost += 0.4 * far / scale
            joined = v * count + int(vertex[j]) in skin.joined
            if joined and np.isinf(length):             # an edge that no curve can use
                cost += BLOCKED
            if length < SHORT * scale and not joined:
                cost += APART
        return cost


def _patches_around(skin, guess):
    """Per vertex the set of patches guessed for the quads round it."""
    out = [set() for _ in range(len(skin.points))]
    for v, p in itertools.chain.from_iterable(zip(skin.rows[:, k].tolist(), guess.tolist()) for k in range(4)):
        out[v].add(p)
    return out

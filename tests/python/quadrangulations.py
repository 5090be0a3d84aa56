# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quadrangulations of the sphere: those that a convex polyhedron can have, simple and 3-connected, and
random_simple_quadrangulation, which makes others too.

Given as quads (n, 4) int over the points 0 .. n + 1, turned alike; no coordinates, but sphere_points finds some.
3-connected means here: no edge twice, and no two points opposite each other in two quads. (Two points
whose removal cuts a simple quadrangulation are opposite in two quads, and the other way round.)
"""
import collections

import numpy as np
from scipy.sparse import coo_matrix, diags
from scipy.sparse.linalg import spsolve


def is_simple(quads):
    """No edge twice, and no quad with a point twice, for the quads (n, 4) of a sphere."""
    edges = np.sort(np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    twice = np.unique(edges, axis=0, return_counts=True)[1]
    corners = np.sort(quads, axis=1)
    return bool((twice == 2).all() and (corners[:, 1:] != corners[:, :-1]).all())


def is_polyhedral(quads):
    """Simple and 3-connected, for the quads (n, 4) of a sphere."""
    edges = np.sort(np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    diagonals = np.sort(np.vstack([quads[:, [0, 2]], quads[:, [1, 3]]]), axis=1)
    twice = np.unique(edges, axis=0, return_counts=True)[1]
    return bool((twice == 2).all() and len(np.unique(diagonals, axis=0)) == len(diagonals))


def double_wheel(spokes):
    """The pseudo-double wheel: 2 * spokes quads about two poles; of 3 spokes a cube."""
    ring = 2 + np.arange(2 * spokes)
    upper = [[0, ring[i], ring[i + 1], ring[(i + 2) % len(ring)]] for i in range(0, len(ring), 2)]
    lower = [[1, ring[(i + 2) % len(ring)], ring[i + 1], ring[i]] for i in range(-1, len(ring) - 1, 2)]
    return np.array(upper + lower)


INSETS = 0.03    # share of the steps of random_quadrangulation


def _pair(a, b):
    return (a, b) if a < b else (b, a)


class Moves:
    """A quadrangulation under change that stays simple and 3-connected.

    after     {(a, b): c} for each corner a, b, c of a quad
    diagonals set of (low, high): points opposite in a quad
    degree    list, of each point
    """

    def __init__(self, quads):
        self.after, self.diagonals = {}, set()
        self.degree = np.bincount(np.ravel(quads)).tolist()
        for quad in np.asarray(quads).tolist():
            self._add(*quad)

    def _add(self, a, b, c, d):
        self.after.update({(a, b): c, (b, c): d, (c, d): a, (d, a): b})
        self.diagonals |= {_pair(a, c), _pair(b, d)}

    def quad(self, a, b):
        """The quad with the edge a, b, beginning there."""
        c = self.after[a, b]
        return a, b, c, self.after[b, c]

    def quads(self):
        """(n, 4) int64."""
        found, left = [], dict.fromkeys(self.after)
        while left:
            quad = self.quad(*next(iter(left)))
            for k in range(4):
                del left[quad[k - 1], quad[k]]
            found.append(quad)
        return np.array(found, np.int64)

    def around(self, point, first):
        """The neighbours of a point in their order, from `first`."""
        ring, b = [first], self.after[first, point]
        while b != first:
            ring.append(b)
            b = self.after[b, point]
        return ring

    def slide(self, a, b, allow):
        """Turn the edge a, b to the next corners of the hexagon of its two quads.

        allow(change of the sum of squared degrees) -> bool. Returns whether it was done.
        """
        _, _, c, d = self.quad(a, b)
        _, _, e, f = self.quad(b, a)
        new = _pair(d, e), _pair(f, c)
        if (c, e) in self.after or not self.diagonals.isdisjoint(new):
            return False
        degree = self.degree
        if not allow(2 * (degree[c] + degree[e] - degree[a] - degree[b] + 2)):
            return False
        for point, more in ((a, -1), (b, -1), (c, 1), (e, 1)):
            degree[point] += more
        self.diagonals -= {_pair(b, d), _pair(a, f)}
        del self.after[a, b], self.after[b, a]
        self._add(c, d, a, e)
        self._add(e, f, b, c)
        return True

    def split(self, point, one, two):
        """Make a point two, with a quad between them that ends at two of its neighbours, not beside each other.

        Returns whether it was done.
        """
        if one == two or _pair(one, two) in self.diagonals:
            return False
        ring, new = self.around(point, one), len(self.degree)
        moved = ring[:ring.index(two) + 1]
        old = [self.quad(a, point) for a in moved[:-1]]
        for a, _, b, c in old:
            del self.after[a, point], self.after[point, b]
            self.diagonals.discard(_pair(point, c))
        for a, _, b, c in old:
            self._add(a, new, b, c)
        self._add(point, two, new, one)
        self.degree[point] += 2 - len(moved)
        self.degree.append(len(moved))
        self.degree[one] += 1
        self.degree[two] += 1
        return True

    def inset(self, a, b):
        """Put a smaller quad inside the one with the edge a, b, corners joined: 4 quads more."""
        outer, first = self.quad(a, b), len(self.degree)
        inner = range(first, first + 4)
        self.diagonals -= {_pair(outer[0], outer[2]), _pair(outer[1], outer[3])}
        for k in range(4):
            self._add(outer[k - 1], outer[k], inner[k], inner[k - 1])
            self.degree[outer[k]] += 1
        self._add(*inner)
        self.degree += [3] * 4


def random_quadrangulation(rng, n, evenness=0.0):
    """n quads (n, 4), n = 6 or n >= 8: from a pseudo-double wheel, of few spokes mostly, by splits, a few insets, and
    slides after each.

    evenness 0 takes every slide that keeps the class; above 0 those that spread the degrees are taken seldom, so
    that most are near 4 (1: nearly all are 3, 4 or 5).
    """
    if n < 6 or n == 7:
        raise ValueError("there is none of so few quads")
    if n == 6:
        return double_wheel(3)
    moves = Moves(double_wheel(min(3 + rng.geometric(0.8), n // 2)))

    def allow(change):
        return change <= 0 or rng.random() < np.exp(-evenness * change)

    def slide_some(tries):
        edges = list(moves.after)
        for k in rng.integers(len(edges), size=tries).tolist():
            if edges[k] in moves.after:
                moves.slide(*edges[k], allow)
    while (room := n + 2 - len(moves.degree)) > 0:
        if room >= 4 and rng.random() < INSETS:
            moves.inset(*list(moves.after)[rng.integers(len(moves.after))])
        else:
            point = int(rng.choice(np.flatnonzero(np.array(moves.degree) > 3)))
            ring = moves.around(point, next(b for a, b in moves.after if a == point))
            moves.split(point, *rng.permutation(ring)[:2].tolist())
        slide_some(8)
    for _ in range(40):
        slide_some(n)
    return moves.quads()


class SimpleMoves(Moves):
    """A quadrangulation under change that stays simple, and whose points keep `least_degree` neighbours, 2 or 3: there
    may be cycles of four edges with points on both sides. A point of two neighbours lies in two quads that share two
    edges (a face doublet)."""

    def __init__(self, quads, least_degree):
        super().__init__(quads)
        self.least_degree = least_degree

    def _add(self, a, b, c, d):
        self.after.update({(a, b): c, (b, c): d, (c, d): a, (d, a): b})    # no diagonals: they do not matter here

    def slide(self, a, b, allow):
        return min(self.degree[a], self.degree[b]) > self.least_degree and super().slide(a, b, allow)

    def split(self, point, one, two):
        ring = self.around(point, one)
        moved = ring.index(two) + 1
        return min(moved, len(ring) + 2 - moved) >= self.least_degree and super().split(point, one, two)


def random_simple_quadrangulation(rng, n, least_degree=2, evenness=0.0, three_connected=False):
    """n quads (n, 4) int64 over the points 0 .. n + 1, turned alike: simple, from few quads by splits of points, and
    slides after each.

    least_degree     2: about two points in five have two neighbours if evenness is 0; any n of at least 2. 3: none
                     has, but cycles of four edges separate points; n = 6 or n >= 8
    evenness         as random_quadrangulation
    three_connected  random_quadrangulation(rng, n, evenness) instead
    """
    if three_connected:
        return random_quadrangulation(rng, n, evenness)
    if n < 2 or (least_degree == 3 and n in (2, 3, 4, 5, 7)):
        raise ValueError("there is none of so few quads")
    few = double_wheel(3 if n == 6 else 4) if least_degree == 3 else [[0, 1, 2, 3], [3, 2, 1, 0]]
    moves = SimpleMoves(few, least_degree)

    def allow(change):
        return change <= 0 or rng.random() < np.exp(-evenness * change)
    while len(moves.degree) < n + 2:
        edges = list(moves.after)
        point, first = edges[rng.integers(len(edges))]
        moves.split(point, *rng.permutation(moves.around(point, first))[:2].tolist())
        _slide_some(rng, moves, 4, allow)
    _slide_some(rng, moves, 20 * n, allow)
    return moves.quads()


def _slide_some(rng, moves, tries, allow):
    edges = list(moves.after)
    for k in rng.integers(len(edges), size=tries).tolist():
        if edges[k] in moves.after:
            moves.slide(*edges[k], allow)


def sphere_points(quads):
    """(n + 2, 3) float64: distinct points of the unit sphere for a simple quadrangulation (n, 4), n >= 3.

    Most quads are counter-clockwise seen from outside; many are narrow, tiny or not convex, and some folded. Made by
    Tutte's drawing: each point in the mean of its neighbours and of the middles of its quads, those in the mean of
    their corners, the first quad outside; then up to the sphere.
    """
    quads = np.asarray(quads)
    n, size = len(quads), len(quads) + 2
    edges = np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2)
    arms = np.column_stack([quads[1:].ravel(), np.repeat(size + np.arange(n - 1), 4)])
    a, b = np.vstack([edges, arms, arms[:, ::-1]]).T
    joined = coo_matrix((np.ones(len(a)), (a, b)), shape=(size + n - 1,) * 2).tocsr()
    pull = diags(np.asarray(joined.sum(axis=1)).ravel()) - joined
    free = np.setdiff1d(np.arange(size + n - 1), quads[0])
    places = np.zeros((size + n - 1, 2))
    places[quads[0]] = [[-1, -1], [-1, 1], [1, 1], [1, -1]]
    places[free] = spsolve(pull.tocsr()[free][:, free].tocsc(), -pull.tocsr()[free] @ places)
    places = places[:size] - np.median(places[:size], axis=0)
    places /= np.median((places ** 2).sum(axis=1)) ** 0.5
    square = (places ** 2).sum(axis=1, keepdims=True)
    return np.hstack([2 * places, 1 - square]) / (1 + square)


def canonical_code(quads):
    """A tuple that two quadrangulations share if and only if they are isomorphic, mirror images included."""
    moves = Moves(quads)
    rings = [()] * len(moves.degree)
    for a, b in moves.after:
        if not rings[b]:
            rings[b] = moves.around(b, a)
    mirrored = [ring[::-1] for ring in rings]
    # Seen in the mirror, the corner a, b, c is the corner c, b, a. Codes begin at the rarest kind of corner only.
    corners = collections.defaultdict(list)
    for (a, b), c in moves.after.items():
        degrees = len(rings[a]), len(rings[b]), len(rings[c])
        corners[degrees].append((rings, a, b))
        corners[degrees[::-1]].append((mirrored, c, b))
    rare = min(corners, key=lambda kind: (len(corners[kind]), kind))
    return min(_code_from(*start) for start in corners[rare])


def _code_from(rings, a, b):
    """Neighbours of the points in the order of first sight, from the edge a, b."""
    number, entry, order, code = {a: 0, b: 1}, {a: b, b: a}, [a, b], []
    for point in order:
        ring = rings[point]
        start = ring.index(entry[point])
        for other in ring[start:] + ring[:start]:
            if other not in number:
                number[other] = len(order)
                entry[other] = point
                order.append(other)
            code.append(number[other])
        code.append(-1)
    return tuple(code)


def all_quadrangulations(most=14):
    """{number of quads: list of quads (n, 4)}, 6 <= n <= most, odd n too: every one, up to isomorphism.

    By the theorem of Brinkmann, Greenberg, Greenhill, McKay, Thomas and Wollan (2005): from the pseudo-double wheels
    by splitting points and by insets.
    """
    found = {n: {} for n in range(6, most + 1)}
    for n in range(6, most + 1):
        if n % 2 == 0:
            _keep(found[n], double_wheel(n // 2))
        for quads in found.get(n - 1, {}).values():
            for more in _all_splits(quads):
                _keep(found[n], more)
        for quads in found.get(n - 4, {}).values():
            for quad in quads:
                moves = Moves(quads)
                moves.inset(*quad[:2].tolist())
                _keep(found[n], moves.quads())
    return {n: list(classes.values()) for n, classes in found.items()}


def _keep(classes, quads):
    classes.setdefault(canonical_code(quads), quads)


def _all_splits(quads):
    """Every split of every point, once each."""
    whole = Moves(quads)
    for point in range(len(whole.degree)):
        ring = whole.around(point, next(a for a, b in whole.after if b == point))
        for i, one in enumerate(ring):
            for two in ring[i + 2:]:
                moves = Moves(quads)
                if moves.split(point, one, two):
                    yield moves.quads()

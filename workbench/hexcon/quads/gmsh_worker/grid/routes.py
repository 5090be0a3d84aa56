# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAD curves -> paths of the skin's edges that meet nowhere but in corners, by negotiation.

Every curve takes the cheapest path as if it were alone, at first at hardly any cost for places others use; then those
in conflict are ripped up and routed again, round after round, while sharing becomes dearer and places that were fought
over keep a price: McMurchie & Ebeling, PathFinder (FPGA 1995). A path follows its curve by arc length: an edge may not
jump from one arm of a bend to the other, and a closed curve is a path in the twofold cover, from an edge to itself one
turn on. A path has a cost for bends too: a quad with two edges on a curve wants a sheet more.
"""
import math

import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra
from scipy.spatial import cKDTree

from .captured import NotCaptured
from .corner_places import embedded

REACH = 2.5             # of the local edge length: vertices farther from a curve are none of its business
STRAY = 2.2             # a path that goes farther from its curve is none
ROUNDS, PATIENCE = 40, 13       # of negotiation; rounds in which no fewer curves are in conflict
FIRST_PRICE, DEARER, KEPT = 0.3, 1.35, 0.4     # of sharing: at first, by round; what a fought-over place keeps
BEND, BEND_CONVEX = 1.5, 0.3    # cost of a quad with two edges on a curve; on a convex one it has a cheap remedy
CONVEX = 140.0          # degrees inside
TURN = math.radians(45)     # by which a curve turns for each of its edges, at most
DENSE = 8               # samples of a curve for each edge length


class Band:
    """What of the skin a curve may use, as a graph with costs."""

    def __init__(self, model, skin, guess, c):
        self.curve = curve = model.curves[c]
        self.skin = skin
        self.vertices, self.s, self.gap = self._near()
        self.corners = [k for k in (curve.start, curve.end) if k >= 0]
        self.loop = curve.start == curve.end
        place = np.full(len(skin.points), -1)
        place[self.vertices] = np.arange(len(self.vertices))
        tail, head = skin.half_edges.tail, skin.half_edges.head
        h = np.flatnonzero((place[tail] >= 0) & (place[head] >= 0))
        self.h, self.tail, self.head = h, place[tail[h]], place[head[h]]
        self.row_of = place
        self.step = self._along(self.tail, self.head)
        keep = np.abs(self.step) <= np.maximum(3.0 * skin.length[h], 0.3 * skin.scale[tail[h]])
        self.h, self.tail, self.head, self.step = (x[keep] for x in (self.h, self.tail, self.head, self.step))
        self.base = self._costs(guess)
        first, second, bend = self._bends()
        self.rise, self.graph = self._graph(first, second, bend)

    def _near(self):
        """(vertices, arc length of the nearest point of the curve, distance in local edge lengths)."""
        skin, curve = self.skin, self.curve
        coarse = curve.sampled(np.linspace(0, curve.length, 64))
        scale = skin.scale[skin.tree.query(coarse)[1]].max()
        step = min(curve.length / 8, scale)
        s = np.linspace(0, curve.length, min(20000, int(math.ceil(curve.length / step)) + 1))
        some = skin.tree.query_ball_point(curve.sampled(s), (REACH + 0.6) * scale)
        rows = np.unique(np.concatenate([np.asarray(r, int) for r in some]))
        if not len(rows):
            return rows, np.zeros(0), np.zeros(0)
        count = int(np.clip(DENSE * curve.length / skin.scale[rows].min(), 32, 20000))
        s = np.linspace(0, curve.length, count, endpoint=not curve.closed)
        gap, at = cKDTree(curve.sampled(s)).query(skin.points[rows])
        gap = gap / skin.scale[rows]
        near = gap < REACH
        return rows[near], s[at[near]], gap[near]

    def _along(self, tail, head):
        """How far an edge goes along the curve; round a closed one the short way."""
        step = self.s[head] - self.s[tail]
        if self.loop:
            step -= self.curve.length * np.round(step / self.curve.length)
        return step

    def _costs(self, guess):
        skin, curve = self.skin, self.curve
        left, right = guess[self.h // 4], guess[skin.half_edges.twin[self.h] // 4]
        one = (left == curve.left) | (left == curve.right) | (right == curve.left) | (right == curve.right)
        both = (left == curve.right) & (right == curve.left)
        factor = np.where(one, 1.0, 2.0)
        factor[both] = 0.8
        factor[(left == curve.left) & (right == curve.right)] = 0.45
        d = 0.5 * (self.gap[self.tail] + self.gap[self.head])
        length = skin.length[self.h] / (0.5 * (skin.scale[skin.half_edges.tail[self.h]] +
                                               skin.scale[skin.half_edges.head[self.h]]))
        turn = self._turning(self.tail, self.head) / (1.2 * TURN)
        back = np.where(self.step < 0, 2.0, 1.0)
        return np.maximum(length, 0.3) * factor * (1 + 3 * d * d) * (1 + np.minimum(turn, 4) ** 4) * back

    def _bends(self):
        """Pairs of edges that follow one another, with the cost of the bend: (rows of h, rows of h, costs)."""
        skin, m = self.skin, len(self.h)
        order = np.argsort(self.tail, kind="stable")
        start = np.searchsorted(self.tail[order], np.arange(len(self.vertices) + 1))
        count = (start[1:] - start[:-1])[self.head]
        first = np.repeat(np.arange(m), count)
        place = np.arange(len(first)) - np.repeat(np.cumsum(count) - count, count)
        second = order[start[self.head[first]] + place]
        keep = self.head[second] != self.tail[first]
        first, second = first[keep], second[keep]
        back = skin.turn_of[skin.half_edges.twin[self.h[first]]]
        valence = skin.valence[self.vertices[self.head[first]]]
        left = (back - skin.turn_of[self.h[second]]) % valence
        one = np.minimum(left, valence - left) == 1
        three = np.maximum(left, valence - left) >= 3
        return first, second, one * (BEND_CONVEX if self.curve.angle < CONVEX else BEND) + 0.5 * BEND_CONVEX * three

    def _graph(self, first, second, bend):
        """(into how much higher a copy of the band each edge leads, _EdgeGraph): a loop goes into another copy."""
        m = len(self.h)
        wrap = self.s[self.head] - self.s[self.tail]
        rise = (wrap < -self.curve.length / 2).astype(int) - (wrap > self.curve.length / 2)
        if not self.loop:
            return rise, _EdgeGraph(m, first, second, bend)
        level = rise[second]
        up, down = level >= 0, level <= 0
        return rise, _EdgeGraph(2 * m, np.concatenate([first[up], first[down] + m]),
                                np.concatenate([second[up] + m * level[up], second[down] + m * (1 + level[down])]),
                                np.concatenate([bend[up], bend[down]]))

    def _turning(self, tail, head):
        """By how much the curve turns over an edge, in radians."""
        s = np.linspace(0, self.curve.length, 129)
        d = np.diff(self.curve.sampled(s), axis=0)
        d /= np.maximum(np.linalg.norm(d, axis=1), 1e-300)[:, None]
        angle = np.cumsum(np.concatenate([[0], np.arccos(np.clip((d[1:] * d[:-1]).sum(1), -1, 1)), [0]]))
        self.turning = angle[-1]
        if self.loop:
            self.turning += math.acos(np.clip(d[0] @ d[-1], -1, 1)) if self.curve.closed else 0.0
        at = np.interp(self.s, s, angle)
        turn = np.abs(at[head] - at[tail])
        if self.loop:
            turn = np.minimum(turn, np.abs(self.turning - turn))
        return turn

    def least_edges(self):
        """How many edges the curve should have at least."""
        by_turning = int(math.ceil(self.turning / TURN - 0.05))
        return max(by_turning, 4 if self.curve.closed else 3 if self.loop else 1)


class Routes:
    """Negotiates the paths of all curves between placed corners."""

    def __init__(self, model, skin, guess, bands, places, vertex):
        self.model, self.skin, self.bands, self.vertex = model, skin, bands, vertex
        n = len(skin.points)
        self.used = np.zeros(n, int)            # by how many curves, corners not counted
        self.price = np.zeros(n)
        self.corner = np.full(n, -1)
        self.corner[vertex] = np.arange(len(vertex))
        self.edge_used = np.zeros(len(skin.rows) * 2, int)
        self.edge_price = np.zeros(len(skin.rows) * 2)
        self._round_corners = [self.skin.outgoing(int(v)) for v in vertex]
        self.ports = self._ports(places)        # (curve, sign) -> half-edge it should leave its corner by
        self.port_price = {}                    # (curve, sign) -> price of another
        self.paths, self.edges = {}, {}         # vertices and undirected edges of each curve's path
        self.base = [band.base for band in bands]
        self._bars = {}
        self.tried = np.zeros(len(bands), int)  # how often more edges were asked of a curve

    def _ports(self, places):
        out = {}
        for k, ends in enumerate(places.ends):
            v = int(self.vertex[k])
            h = np.array(self._round_corners[k])
            forbidden = np.zeros((len(ends.ends), len(h)), bool)
            there = self.corner[self.skin.half_edges.head[h]]
            for row, (c, sign) in enumerate(ends.ends):
                other = self.model.curves[c].end if sign > 0 else self.model.curves[c].start
                forbidden[row] = (there >= 0) & ((there != other) | (other == k))
            directions = ends.directions(0.7 * self.skin.scale[v])
            cost, found = embedded(ends, directions, self.skin.directions(v), forbidden)
            if not np.isfinite(cost):
                raise NotCaptured("corner", f"corner {k} has not {len(ends.ends)} free edges, in the order of its "
                                  "curves", self.model.corners[k], corners=[k], curves=[c for c, _ in ends.ends])
            out |= {end: int(h[port]) for end, port in zip(ends.ends, found)}
        return out

    def negotiated(self):
        """curve -> vertices of its path, from its start; first is last for a closed one. Raises NotCaptured."""
        todo = sorted(range(len(self.bands)), key=lambda c: (self.model.curves[c].length, c))
        price, fewest, since = FIRST_PRICE, len(todo) + 1, 0
        for _ in range(ROUNDS):
            for c in todo:
                self._take_up(c)
                self._lay(c, self._route(c, price))
            wrong = self._conflicts() | self._disorder() | self._too_few()
            if not wrong:
                return self.paths
            todo = [c for c in sorted(wrong, key=lambda c: (self.model.curves[c].length, c))]
            price *= DEARER
            fewest, since = min(fewest, len(todo)), 0 if len(todo) < fewest else since + 1
            if since > PATIENCE:
                break
        crossed = np.flatnonzero((self.used > 1) | ((self.used > 0) & (self.corner >= 0)))
        place = self.skin.points[crossed[0]] if len(crossed) else self.model.curves[todo[0]].samples[0]
        raise NotCaptured("curve", "no paths that do not meet for curves " + ", ".join(map(str, todo[:6])) +
                          ": smaller elements are needed between them", place, curves=todo)

    def _lay(self, c, path, sign=1):
        if sign > 0:
            self.paths[c] = path
            self.edges[c] = self.skin.edge_of[self.skin.half_edges.find(path[:-1], path[1:])]
        inner = path[:-1] if self.bands[c].curve.closed else path[1:-1]
        np.add.at(self.used, inner, sign)
        np.add.at(self.edge_used, self.edges[c], sign)

    def _take_up(self, c):
        if c in self.paths:
            self._lay(c, self.paths[c], -1)
            del self.paths[c]

    def _conflicts(self):
        """Curves that share a vertex or an edge; these keep a price."""
        bad, bad_edge = self.used > 1, self.edge_used > 1
        self.price[bad] += KEPT
        self.edge_price[bad_edge] += KEPT
        wrong = set()
        for c, path in self.paths.items():
            if bad[path].any() or bad_edge[self.edges[c]].any():
                wrong.add(c)
        return wrong

    def _disorder(self):
        """Curves round corners that leave in an order that the patches between them do not allow."""
        open_ones = [(c, path) for c, path in self.paths.items() if not self.model.curves[c].closed]
        ends = [(c, sign) for c, _ in open_ones for sign in (1, -1)]
        tails = [v for _, path in open_ones for v in (path[0], path[-1])]
        heads = [v for _, path in open_ones for v in (path[1], path[-2])]
        leaves = dict(zip(self.skin.half_edges.find(tails, heads).tolist(), ends))
        wrong = set()
        for round_it in self._round_corners:
            ends = [leaves[h] for h in round_it if h in leaves]
            for (c, sign), (d, other) in zip(ends, ends[1:] + ends[:1]):
                left = (self.model.curves[c].left, self.model.curves[c].right)[::sign][0]
                right = (self.model.curves[d].left, self.model.curves[d].right)[::other][1]
                if left != right:
                    wrong |= {e[0] for e in ends}
                    for e in ends:
                        self.port_price[e] = self.port_price.get(e, 0.0) + 1.0
                    break
        return wrong

    def _too_few(self):
        """Curves with fewer edges than their turning wants: the edges they have become dearer, for a few rounds."""
        wrong = set()
        for c, path in self.paths.items():
            band = self.bands[c]
            if len(path) - 1 >= band.least_edges() or self.tried[c] >= 3:
                continue
            self.tried[c] += 1
            self.base[c] = self.base[c] * np.where(np.isin(self.skin.edge_of[band.h], self.edges[c]), 2.5, 1.0)
            wrong.add(c)
        return wrong

    def _route(self, c, price):
        band = self.bands[c]
        v, edge = band.vertices[band.head], self.skin.edge_of[band.h]
        cost = self.base[c] * (1 + price * (self.used[v] + self.edge_used[edge]))
        cost = cost + self.price[v] + self.edge_price[edge]
        barred, others = self._barred(c)
        cost[barred] = np.inf
        for end, rows in others:
            cost[rows] += 0.3 + self.port_price.get(end, 0.0)
        path = self._loop(band, cost) if band.loop else self._between(band, cost)
        if path is None:
            raise NotCaptured("curve", f"curve {c} of {band.curve.length:.3g} finds no path: it wants smaller elements",
                              band.curve.sampled(np.array([band.curve.length / 2]))[0], curves=[c])
        return path

    def _barred(self, c):
        """(edges that touch corners of others, [(end of the curve, edges at its corner that are not its port)])."""
        if c not in self._bars:
            band = self.bands[c]
            foreign = (self.corner[band.vertices] >= 0) & ~np.isin(band.vertices, self.vertex[band.corners])
            barred, others = foreign[band.head] | foreign[band.tail], []
            for sign in (1, -1):
                if (c, sign) in self.ports:
                    h = self.ports[c, sign]
                    at = band.vertices[band.tail if sign > 0 else band.head] == self.skin.half_edges.tail[h]
                    same = band.h == (h if sign > 0 else self.skin.half_edges.twin[h])
                    others.append(((c, sign), np.flatnonzero(at & ~same)))
            if not band.loop:
                start, goal = self._ends(band)
                barred |= (band.head == start) | (band.tail == goal)
            self._bars[c] = barred, others
        return self._bars[c]

    def _ends(self, band):
        return (int(band.row_of[self.vertex[k]]) for k in band.corners)

    def _between(self, band, cost):
        start, goal = self._ends(band)
        if min(start, goal) < 0:
            return None
        edges, _ = band.graph.cheapest(np.flatnonzero(band.tail == start), np.flatnonzero(band.head == goal), cost)
        return None if edges is None else _without_loops(_vertices(band, edges))

    def _loop(self, band, cost):
        """Once round: in two copies of the band, from an edge in the first to itself in the second."""
        m = len(band.h)
        if m < 3:
            return None
        best, found, twice = np.inf, None, np.concatenate([cost, cost])
        for starts, goals in self._turns_round(band, cost):
            edges, value = band.graph.cheapest(starts, goals + m, twice)
            if edges is None or value >= best:
                continue
            path = _vertices(band, edges % m)
            path = path if band.corners else path[1:]       # its first edge is its last
            if len(set(path.tolist())) == len(path) - 1 and len(path) >= 4:
                best, found = value, path
        return found

    def _turns_round(self, band, cost):
        """[(edges to begin with, to end with)]: those of the corner, or a good edge in each quarter, and itself."""
        if band.corners:
            k = int(band.row_of[self.vertex[band.corners[0]]])
            starts = np.flatnonzero((band.tail == k) & (band.rise == 0))
            return [(starts, np.flatnonzero(band.head == k))] if k >= 0 else []
        quarter = np.minimum((4 * band.s[band.tail] / band.curve.length).astype(int), 3)
        usable = np.isfinite(cost) & (band.rise == 0)
        return [(rows[one:one + 1], rows[one:one + 1]) for q in range(4)
                if len(rows := np.flatnonzero(usable & (quarter == q)))
                for one in [int(np.lexsort((band.h[rows], cost[rows]))[0])]]


class _EdgeGraph:
    """Edges as nodes; bend (t,): what it costs to go on from edge first to edge second, beside the first's own cost."""

    def __init__(self, count, first, second, bend):
        order = np.lexsort((second, first))
        self._first, self._bend = first[order], bend[order]
        start = np.concatenate([[0], np.cumsum(np.bincount(first, minlength=count))])
        self._graph = csr_matrix((self._bend.copy(), second[order], start), shape=(count, count))

    def cheapest(self, starts, goals, own):
        """(edges of the cheapest path from any start to any goal, cost), or (None, inf); own: costs of edges."""
        if not len(starts) or not len(goals):
            return None, np.inf
        self._graph.data = own[self._first] + self._bend
        far, before, _ = dijkstra(self._graph, indices=starts, return_predecessors=True, min_only=True)
        total = far[goals] + own[goals]
        best = int(total.argmin())
        if not np.isfinite(total[best]):
            return None, np.inf
        path = [int(goals[best])]
        while before[path[-1]] >= 0:
            path.append(int(before[path[-1]]))
        return np.array(path[::-1]), float(total[best])


def _vertices(band, edges):
    return band.vertices[np.concatenate([band.tail[edges[:1]], band.head[edges]])]


def _without_loops(path):
    """A path that meets itself, without what lies between."""
    out, place = [], {}
    for v in path.tolist():
        if v in place:
            for w in out[place[v] + 1:]:
                del place[w]
            del out[place[v] + 1:]
        else:
            place[v] = len(out)
            out.append(v)
    return np.array(out)

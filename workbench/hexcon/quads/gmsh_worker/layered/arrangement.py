# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plane arrangement of a solid's edges seen along a direction: vertices, pieces of curves, regions between them.

Curves are split where they cross and where another ends on them; pieces that lie on one another are one. So edges of
the CAD that lie over one another at several heights are one piece, which knows them all.
"""
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from ..plane_mesh import polygon_area
from ..segments import on_segments
from .fault import NotLayered
from .flat_edges import FlatEdge, crossings

OUTSIDE = -1
LINE = 33           # points of a curved piece
# Curves that cross are apart, so many tolerances from there, by more than this part of the way.
AWAY, TOUCHING = 30.0, 0.02


@dataclass
class Piece:
    """ends: vertices (two, or one twice); sources: [(FlatEdge, fraction at its start, at its end)], of the first it has
    its shape; line (n,2) along it; left, right: regions, or OUTSIDE."""

    ends: tuple
    sources: list
    line: np.ndarray
    left: int = OUTSIDE
    right: int = OUTSIDE

    @property
    def closed(self):
        return self.ends[0] == self.ends[1]

    def at(self, shares):
        """(n,2) places at shares of its length."""
        curve, start, end = self.sources[0]
        return curve.at(start + np.asarray(shares, float) * (end - start))

    def source(self, edges):
        """The first of its sources whose CAD edge is among these, or None."""
        return next((s for s in self.sources if s[0].edge in edges), None)


@dataclass
class Region:
    """loops: of (piece, forward), with the region on the left: the outer one first; width: twice its area by what is
    round it."""

    loops: list
    width: float

    @property
    def pieces(self):
        """The set of pieces round it."""
        return {c for loop in self.loops for c, _ in loop}


@dataclass
class Arrangement:
    """vertices (n,2), pieces, regions."""

    vertices: np.ndarray
    pieces: list
    regions: list

    def neighbours(self):
        """(piece, its region on the left, on the right) of those with two different sides."""
        return [(c, p.left, p.right) for c, p in enumerate(self.pieces) if p.left != p.right]


def arrange(solid, upright, edges, tolerance):
    """The Arrangement of CAD edges as upright.Upright sees them; those within the tolerance of a point are none.

    Raises NotLayered where what comes out is no set of regions. Some n log n of the edges and their crossings.
    """
    curves = [FlatEdge(solid, upright, e) for e in edges]
    curves = [c for c in curves if (c.high - c.low).max() > tolerance]
    met = _crossing_fractions(curves, tolerance)
    vertices = _vertices(curves, met, tolerance)
    pieces = _distinct(_split(curves, vertices, tolerance), tolerance)
    regions = _regions(vertices, pieces)
    return Arrangement(vertices, pieces, regions)


def _crossing_fractions(curves, tolerance):
    """(n,2) places where curves cross."""
    order = sorted(range(len(curves)), key=lambda k: curves[k].low[0])
    found, open_ = [], []
    for k in order:
        c = curves[k]
        open_ = [j for j in open_ if curves[j].high[0] >= c.low[0] - tolerance]
        for j in open_:
            o = curves[j]
            if o.low[1] <= c.high[1] + tolerance and c.low[1] <= o.high[1] + tolerance:
                found.append(_proper(c, o, tolerance))
        open_.append(k)
    return np.concatenate(found) if found else np.empty((0, 2))


def _proper(a, b, tolerance):
    """Crossings of two curves, but for those where they run along one another."""
    f, places = crossings(a, b)
    if not len(f):
        return places
    real = np.linalg.norm(b.at(f[:, 1]) - places, axis=1) < tolerance
    step = AWAY * tolerance / max(_length(a.xy), tolerance)
    for side in (-step, step):
        away = a.about((f[:, 0] + side).clip(0.0, 1.0))
        moved = np.linalg.norm(away - places, axis=1)
        real &= (moved < 0.1 * AWAY * tolerance) | (b.locate(away)[1] > TOUCHING * moved)
    return places[real]


def _vertices(curves, crossing, tolerance):
    """(n,2) ends of curves and crossings, those within the tolerance taken as one: the first of them."""
    points = np.concatenate([np.array([c.xy[k] for c in curves for k in (0, -1)]).reshape(-1, 2), crossing])
    a, b = cKDTree(points).query_pairs(tolerance, output_type="ndarray").T
    near = coo_matrix((np.ones(len(a)), (a, b)), shape=(len(points), len(points)))
    _, part = connected_components(near, directed=False)
    return points[np.sort(np.unique(part, return_index=True)[1])]


def _split(curves, vertices, tolerance):
    """Pieces of one source each."""
    tree, pieces = cKDTree(vertices), []
    for curve in curves:
        spacing = np.linalg.norm(np.diff(curve.xy, axis=0), axis=1).max()
        if len(curve.xy) == 2:
            near = tree.query_ball_point(curve.xy.mean(0), spacing / 2 + 2 * tolerance)
        else:
            near = sorted({v for vs in tree.query_ball_point(curve.xy, spacing + 2 * tolerance) for v in vs})
        ends = tree.query(curve.xy[[0, -1]])[1]
        stops = [(0.0, int(ends[0])), (1.0, int(ends[1]))]
        inner = [v for v in near if v not in ends]
        if inner:
            f, gap = curve.locate(vertices[inner])
            stops += [(float(x), v) for x, v, g in zip(f, inner, gap) if g < tolerance]
        stops.sort()
        for (f0, v0), (f1, v1) in zip(stops[:-1], stops[1:]):
            line = _line(curve, f0, f1)
            if v0 != v1 or np.ptp(line, axis=0).max() > 2 * tolerance:
                pieces.append(Piece((v0, v1), [(curve, f0, f1)], line))
    return pieces


def _line(curve, start, end):
    return curve.at(np.linspace(start, end, 2 if len(curve.xy) == 2 else LINE))


def _distinct(pieces, tolerance):
    """Pieces with all their sources: those that lie on one another are one."""
    groups = {}
    for piece in pieces:
        group = groups.setdefault(tuple(sorted(piece.ends)), [])
        for other in group:
            start, end = _along(other, piece.sources[0], piece, tolerance)
            if start is not None:
                other.sources.append((piece.sources[0][0], start, end))
                break
        else:
            group.append(piece)
    return [p for group in groups.values() for p in group]


def _along(piece, source, other, tolerance):
    """Fractions of another piece's curve at the start and the end of this one, or (None, None)."""
    curve, low, high = source
    f, gap = curve.locate(piece.at([0.25, 0.5, 0.75]), low, high)
    if gap.max() > tolerance:
        return None, None
    same = f[2] > f[0] if piece.closed else piece.ends == other.ends
    return (low, high) if same else (high, low)


def _regions(vertices, pieces):
    """The regions; sets left and right of the pieces."""
    loops = _traced(vertices, pieces)
    areas = [polygon_area(_polygon(pieces, loop)) for loop in loops]
    outer = [k for k, a in enumerate(areas) if a > 0]
    regions = [[loops[k]] for k in outer]
    polygons = [_polygon(pieces, loops[k]) for k in outer]
    for k, area in enumerate(areas):
        if area <= 0:
            found = _around(pieces, loops[k], loops, outer, polygons, areas)
            if found is not None:
                regions[found].append(loops[k])
    made = []
    for r, (loops_of, k) in enumerate(zip(regions, outer)):
        around = sum(_length(pieces[c].line) for loop in loops_of for c, _ in loop)
        area = areas[k] + sum(polygon_area(_polygon(pieces, lp)) for lp in loops_of[1:])
        made.append(Region(loops_of, 2 * area / max(around, 1e-300)))
        for loop in loops_of:
            for c, forward in loop:
                if forward:
                    pieces[c].left = r
                else:
                    pieces[c].right = r
    return made


def _traced(vertices, pieces):
    """Loops of (piece, forward): with what they bound on the left."""
    out = {}
    for c, p in enumerate(pieces):
        out.setdefault(p.ends[0], []).append((c, True))
        out.setdefault(p.ends[1], []).append((c, False))
    after = {}
    for ring in out.values():
        reach = 0.3 * min(_length(pieces[c].line) for c, _ in ring)
        ring.sort(key=lambda one: _heading(pieces[one[0]], one[1], reach))
        for k, (c, forward) in enumerate(ring):
            after[c, not forward] = ring[k - 1]         # arriving along it, leave by the next one clockwise
    loops, left = [], set(after)
    for first in sorted(after):
        if first not in left:
            continue
        loop, here = [], first
        while here in left:
            left.remove(here)
            loop.append(here)
            here = after[here]
        loops.append(loop)
    return loops


def _heading(piece, forward, reach):
    """Angle of a piece that leaves a vertex, some way off: curves that touch there differ in it."""
    line = piece.line if forward else piece.line[::-1]
    arc = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])
    away = np.array([np.interp(reach, arc, line[:, k]) for k in range(2)]) - line[0]
    return float(np.arctan2(away[1], away[0]))


def _polygon(pieces, loop):
    """(n,2) points along pieces, the first one again at the end."""
    lines = [pieces[c].line if forward else pieces[c].line[::-1] for c, forward in loop]
    return np.concatenate([lines[0]] + [line[1:] for line in lines[1:]])


def _length(line):
    return float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum())


def _around(pieces, hole, loops, outer, polygons, areas):
    """Index into outer of the smallest loop that holds another loop, or None."""
    own = {c for c, _ in hole}
    point = pieces[hole[0][0]].line.mean(0) if len(pieces[hole[0][0]].line) == 2 else \
        pieces[hole[0][0]].line[LINE // 2]
    best = None
    for n, k in enumerate(outer):
        if own & {c for c, _ in loops[k]} or not inside(polygons[n], point):
            continue
        if best is None or areas[k] < areas[outer[best]]:
            best = n
    if best is None and own & {c for k in outer for c, _ in loops[k]}:
        return None                                         # the rim of all, or of an island
    return best


def inside(polygon, point):
    """Whether a point is inside a closed polygon (n,2), by crossings to its right."""
    a, b = polygon[:-1], polygon[1:]
    up = (a[:, 1] > point[1]) != (b[:, 1] > point[1])
    with np.errstate(divide="ignore", invalid="ignore"):
        x = a[:, 0] + (point[1] - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 0] - a[:, 0])
    return bool((up & (x > point[0])).sum() % 2)


def inner_point(arrangement, region):
    """(2,) a point well inside a region: the middle of the widest span on several lines across it."""
    polygons = [_polygon(arrangement.pieces, loop) for loop in region.loops]
    low, high = polygons[0][:, 1].min(), polygons[0][:, 1].max()
    best, room = None, -1.0
    a, b = (np.concatenate([p[ends] for p in polygons]) for ends in (slice(None, -1), slice(1, None)))
    for y in low + (high - low) * np.array([0.5, 0.31, 0.72, 0.13, 0.87, 0.43, 0.61]):
        up = (a[:, 1] > y) != (b[:, 1] > y)
        x = np.sort(a[up, 0] + (y - a[up, 1]) / (b[up, 1] - a[up, 1]) * (b[up, 0] - a[up, 0]))
        for x0, x1 in zip(x[::2], x[1::2]):
            p = np.array([(x0 + x1) / 2, y])
            d = float(np.linalg.norm(on_segments(p, a, b)[0] - p, axis=1).min())
            if d > room:
                best, room = p, d
    if best is None:
        raise NotLayered("a region has no inside")
    return best

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where nodes that lie on sides of a solid are at any height: on the CAD face between its edges, or on an edge."""
import numpy as np
from scipy.spatial import cKDTree

from .roles import Role

NEAR = 1e-9         # of the diagonal: heights nearer to a rim than this are its own


def sides_of(piece, solid, roles, heights):
    """[(side, lower source, upper source)] over a piece of the arrangement.

    heights: callable (source) -> (n,) heights of it along the piece
    """
    edges = {}
    for source in piece.sources:
        for face in set(solid.faces_of[source[0].edge]):
            if roles[face] is Role.SIDE:
                edges.setdefault(face, []).append(source)
    found = []
    for face, sources in edges.items():
        sources.sort(key=lambda s: heights(s).mean())
        found += [(face, low, high) for low, high in zip(sources[::2], sources[1::2])]
    return found


class SidePlaces:
    """Spans of heights over nodes, in which they lie on a side or on an edge that rises.

    places: places.Places; upright: upright.Upright, on whose sides no node stands over its place in the plane
    """

    def __init__(self, places, arrangement, roles, upright):
        self._plane, self._upright = places.plane, upright
        self._near = NEAR * places.solid.diagonal
        node, low, high, tag, start, end = [], [], [], [], [], []

        def add(nodes, of, p, q):
            for kept, value in ((node, nodes), (low, self._plane.height(p)), (high, self._plane.height(q)),
                                (tag, np.full(len(nodes), of)), (start, p), (end, q)):
                kept.append(value)
        for c, ids in places.flat.on_piece.items():
            for face, *rims in sides_of(arrangement.pieces[c], places.solid, roles,
                                        lambda s, c=c: self._plane.height(places.on_source(c, s))):
                add(ids, face, *(places.on_source(c, rim) for rim in rims))
        tree = cKDTree(arrangement.vertices)
        for edge in upright.lateral:
            ends = [places.solid.vertex[v] for v in places.solid.ends[edge]]
            ends.sort(key=self._plane.height)
            at = tree.query(upright.corners[places.solid.ends[edge][0]])[1]
            add(np.array([at]), -edge, *(p[None] for p in ends))
        self._node, self._low, self._high, self._tag, self._start, self._end = (
            np.concatenate(rows) for rows in (node, low, high, tag, start, end))
        self._row = np.full(len(places.flat.nodes), -1)

    def at(self, nodes, heights):
        """(n,3) places of nodes at heights (n,), NaN of those that are on no side there."""
        made = np.full((len(nodes), 3), np.nan)
        if not len(nodes):
            return made
        self._row[nodes] = np.arange(len(nodes))
        row = self._row[self._node]
        z = np.where(row >= 0, heights[row], np.nan)
        spans = np.flatnonzero((z > self._low + self._near) & (z < self._high - self._near))
        for tag in sorted(set(self._tag[spans].tolist()), reverse=True):     # edges last: they are where faces end
            of = spans[self._tag[spans] == tag]
            made[row[of]] = self._places(tag, of, z[of])
        self._row[nodes] = -1
        return made

    def _places(self, tag, spans, z):
        if tag < 0:
            return self._upright.on_edge(-tag, z)
        share = (z - self._low[spans]) / (self._high[spans] - self._low[spans])
        p = self._start[spans] + share[:, None] * (self._end[spans] - self._start[spans])
        return self._upright.section(tag, p, z) if tag in self._upright.moving else p

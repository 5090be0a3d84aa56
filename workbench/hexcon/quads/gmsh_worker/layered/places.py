# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the nodes of a flat mesh lie in space: on CAD edges, caps and sides, and between them."""
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from ..plane_mesh import harmonic
from .fault import NotLayered
from .heights import source_points
from .side_places import SidePlaces


class Places:
    """Of a mesh.Standing, for the nodes of a FlatMesh."""

    def __init__(self, standing, flat):
        self.solid, self.plane, self.flat = standing.shape.solid, standing.plane, flat
        self._heights, self._pieces, self._size = standing.heights, standing.arrangement.pieces, standing.size
        self._edges = {f: {abs(e) for e in self.solid.boundary[f]} for f in self.solid.faces}
        self._on_edge = {}
        self._sides = SidePlaces(self, standing.arrangement, standing.roles, standing.upright) \
            if standing.upright.moving else None

    def on_source(self, c, source):
        """(n,3) points of a CAD edge over the nodes of a piece."""
        key = c, source[0].edge, source[1]
        if key not in self._on_edge:
            self._on_edge[key] = source_points(self._pieces[c], source, self.flat.stops[c])
        return self._on_edge[key]

    def sheet(self, ends, rims, quads, nominal):
        """(nodes, 3) places of a level, NaN where it has no node.

        ends: of (cap, pieces round its region, nodes of that); rims: of (piece, source) that it runs along;
        quads (n,4): all of the level; nominal: its height
        """
        sheet, caps = np.full((len(self.flat.nodes), 3), np.nan), []
        for cap, pieces, _ in ends:
            self._onto_edges(sheet, cap, pieces)
        for c, source in rims:
            self._onto(sheet, c, source)
        for cap, _, nodes in ends:
            rest = nodes[np.isnan(sheet[nodes, 0])]
            caps.append((cap, rest))
        ids, packed = np.unique(quads, return_inverse=True)
        packed = packed.reshape(-1, 4)
        z = self._between(sheet, ids, packed, nominal)
        xy = self.flat.nodes[ids]
        if self._sides:
            rest = np.flatnonzero(np.isnan(sheet[ids, 0]))
            sheet[ids[rest]] = self._sides.at(ids[rest], z[rest])
            xy = self._shifted(sheet, ids, packed)
        row = np.full(len(sheet), -1)
        row[ids] = np.arange(len(ids))
        for cap, nodes in caps:
            nodes = nodes[np.isnan(sheet[nodes, 0])]
            at = row[nodes]
            sheet[nodes] = self.plane.lift(xy[at], self._heights.of_face(cap, xy[at], z[at]))
        rest = np.flatnonzero(np.isnan(sheet[ids, 0]))
        if len(rest):
            z = self._between(sheet, ids, packed, nominal)
            sheet[ids[rest]] = self.plane.lift(xy[rest], z[rest])
        return sheet

    def layer(self, nodes, low, high, share):
        """(n,3) places of nodes between (n,3) places of two sheets, at a share of the way."""
        made = low + (high - low) * share
        if self._sides:
            on = self._sides.at(nodes, self.plane.height(made))
            known = ~np.isnan(on[:, 0])
            made[known] = on[known]
        return made

    def _onto_edges(self, sheet, cap, pieces):
        for c in pieces:
            source = self._pieces[c].source(self._edges[cap])
            if source is not None:
                self._onto(sheet, c, source)

    def _onto(self, sheet, c, source):
        ids, made = self.flat.on_piece[c], self.on_source(c, source)
        both = ~np.isnan(sheet[ids, 0])
        if both.any() and np.linalg.norm(sheet[ids[both]] - made[both], axis=1).max() > 1e-3 * self._size:
            faces = self.solid.faces_of[source[0].edge]
            raise NotLayered("a level has two heights at one place: a ramp ends on a wall", faces)
        sheet[ids[~both]] = made[~both]

    def _between(self, sheet, ids, quads, nominal):
        """(n,) heights of nodes: harmonic between those that are known."""
        known = ~np.isnan(sheet[ids, 0])
        z = np.full((len(ids), 1), nominal)
        z[known, 0] = self.plane.height(sheet[ids[known]])
        if not known.all() and np.abs(z - nominal).max() > 1e-12 * self.solid.diagonal:
            z = _smooth(z, quads, known)
        return z[:, 0]

    def _shifted(self, sheet, ids, quads):
        """(n,2) places of nodes: away from those in the plane as their neighbours are, whose places are known."""
        known = ~np.isnan(sheet[ids, 0])
        shift = np.zeros((len(ids), 2))
        shift[known] = self.plane.flat(sheet[ids[known]]) - self.flat.nodes[ids[known]]
        if not known.all() and np.abs(shift).max() > 1e-12 * self.solid.diagonal:
            shift = _smooth(shift, quads, known)
        return self.flat.nodes[ids] + shift


def _smooth(values, quads, known):
    """Harmonic values; parts of the sheet in which nothing is known stay as they are."""
    n = len(values)
    a, b = quads.ravel(), np.roll(quads, -1, axis=1).ravel()
    _, part = connected_components(coo_matrix((np.ones(len(a)), (a, b)), shape=(n, n)), directed=False)
    fixed = known | ~np.isin(part, part[known])
    return harmonic(values, quads, fixed)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the nodes of a flat mesh lie in space: on CAD edges, caps and sides, and between them."""
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from ..plane_mesh import harmonic
from .fault import NotLayered
from .heights import source_points
from .shifts import shifts
from .side_places import SidePlaces


@dataclass
class Sheet:
    """Of a level: places (nodes, 3) of the flat mesh's nodes, NaN of others and of those not yet placed; ids (n,):
    its nodes; quads (m,4) of rows of these; caps: of (cap, nodes on it that are on no edge); nominal: its height;
    heights (n,): first ones of its nodes."""

    places: np.ndarray
    ids: np.ndarray
    quads: np.ndarray
    caps: list
    nominal: float
    heights: np.ndarray


class Places:
    """Of a mesh.Standing, for the nodes of a FlatMesh."""

    def __init__(self, standing, flat):
        self.solid, self.plane, self.flat = standing.shape.solid, standing.plane, flat
        self._heights, self._pieces, self._size = standing.heights, standing.arrangement.pieces, standing.size
        self._on_edge = {}
        self._sides = SidePlaces(self, standing.arrangement, standing.roles, standing.upright) \
            if standing.upright.moving else None

    def on_source(self, c, source):
        """(n,3) points of a CAD edge over the nodes of a piece."""
        key = c, source[0].edge, source[1]
        if key not in self._on_edge:
            self._on_edge[key] = source_points(self._pieces[c], source, self.flat.stops[c])
        return self._on_edge[key]

    def begun(self, ends, rims, quads, nominal):
        """The Sheet of a level, with the places of its nodes on edges and sides.

        ends: of (cap, pieces round its region, nodes of that); rims: of (piece, source) that it runs along;
        quads (n,4): all of the level; nominal: its height
        """
        places, caps = np.full((len(self.flat.nodes), 3), np.nan), []
        for cap, pieces, _ in ends:
            self._onto_edges(places, cap, pieces)
        for c, source in rims:
            self._onto(places, c, source)
        for cap, _, nodes in ends:
            caps.append((cap, nodes[np.isnan(places[nodes, 0])]))
        ids, packed = np.unique(quads, return_inverse=True)
        sheet = Sheet(places, ids, packed.reshape(-1, 4), caps, nominal, None)
        sheet.heights = self._between(sheet)
        if self._sides:
            rest = np.flatnonzero(np.isnan(places[ids, 0]))
            places[ids[rest]] = self._sides.at(ids[rest], sheet.heights[rest])
        return sheet

    def all_sheets(self, begun, stacks):
        """{level: (nodes, 3) places, NaN where it has no node}, of {level: Sheet}. stacks: as shifts takes them."""
        shift = {level: 0.0 for level in begun}
        if self._sides:
            known = {level: self.plane.flat(sheet.places[sheet.ids]) - self.flat.nodes[sheet.ids]
                     for level, sheet in begun.items()}
            shift = shifts(begun, stacks, known, self._size, 1e-12 * self.solid.diagonal)
        return {level: self._finished(sheet, self.flat.nodes[sheet.ids] + shift[level])
                for level, sheet in begun.items()}

    def _finished(self, sheet, xy):
        """(nodes, 3) places: the rest on caps, and between all of these. xy (n,2): of the sheet's nodes."""
        places, row = sheet.places, np.full(len(sheet.places), -1)
        row[sheet.ids] = np.arange(len(sheet.ids))
        for cap, nodes in sheet.caps:
            nodes = nodes[np.isnan(places[nodes, 0])]
            at = row[nodes]
            places[nodes] = self.plane.lift(xy[at], self._heights.of_face(cap, xy[at], sheet.heights[at]))
        rest = np.flatnonzero(np.isnan(places[sheet.ids, 0]))
        if len(rest):
            places[sheet.ids[rest]] = self.plane.lift(xy[rest], self._between(sheet)[rest])
        return places

    def layer(self, nodes, low, high, share):
        """(n,3) places of nodes between (n,3) places of two sheets, at a share of the way."""
        made = low + (high - low) * share
        if self._sides:
            on = self._sides.at(nodes, self.plane.height(made))
            known = ~np.isnan(on[:, 0])
            made[known] = on[known]
        return made

    def _onto_edges(self, sheet, cap, pieces):
        edges = self._heights.edges_of(cap)
        for c in pieces:
            source = self._pieces[c].source(edges)
            if source is not None:
                self._onto(sheet, c, source)

    def _onto(self, sheet, c, source):
        ids, made = self.flat.on_piece[c], self.on_source(c, source)
        both = ~np.isnan(sheet[ids, 0])
        if both.any() and np.linalg.norm(sheet[ids[both]] - made[both], axis=1).max() > 1e-3 * self._size:
            faces = self.solid.faces_of[source[0].edge]
            raise NotLayered("a level has two heights at one place: a ramp ends on a wall", faces)
        sheet[ids[~both]] = made[~both]

    def _between(self, sheet):
        """(n,) heights of a sheet's nodes: harmonic between those that are known."""
        known = ~np.isnan(sheet.places[sheet.ids, 0])
        z = np.full((len(sheet.ids), 1), sheet.nominal)
        z[known, 0] = self.plane.height(sheet.places[sheet.ids[known]])
        if not known.all() and np.abs(z - sheet.nominal).max() > 1e-12 * self.solid.diagonal:
            z = _smooth(z, sheet.quads, known)
        return z[:, 0]


def _smooth(values, quads, known):
    """Harmonic values; parts of the sheet in which nothing is known stay as they are."""
    n = len(values)
    a, b = quads.ravel(), np.roll(quads, -1, axis=1).ravel()
    _, part = connected_components(coo_matrix((np.ones(len(a)), (a, b)), shape=(n, n)), directed=False)
    fixed = known | ~np.isin(part, part[known])
    return harmonic(values, quads, fixed)

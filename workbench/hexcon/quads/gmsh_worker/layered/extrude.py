# SPDX-License-Identifier: LGPL-2.1-or-later
"""The quads of an arrangement through all levels: points, hexes, and the CAD face of each quad of their boundary."""
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from ..plane_mesh import harmonic
from .fault import NotLayered
from .heights import source_points
from .roles import Role

_WALL = -1
_SIDES = np.array([[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])


@dataclass
class LayeredMesh:
    """points (P,3), hexes (H,8), quads (n,4) outward, faces (n,): CAD faces; rings: how many layers of hexes; levels:
    how many; flat: the FlatMesh, plane: the CapPlane that it is in."""

    points: np.ndarray
    hexes: np.ndarray
    quads: np.ndarray
    faces: np.ndarray
    rings: int
    levels: int
    flat: object
    plane: object


class Places:
    """Where the nodes of a flat mesh lie on CAD edges and caps."""

    def __init__(self, shape, plane, arrangement, heights, flat):
        self.solid, self.plane, self.flat = shape.solid, plane, flat
        self._heights = heights
        self._pieces = arrangement.pieces
        self._edges = {f: {abs(e) for e in self.solid.boundary[f]} for f in self.solid.faces}
        self._on_edge = {}

    def on_source(self, c, source):
        """(n,3) points of a CAD edge over the nodes of a piece."""
        key = c, source[0].edge, source[1]
        if key not in self._on_edge:
            n = len(self.flat.on_piece[c]) - 1
            self._on_edge[key] = source_points(self._pieces[c], source, np.arange(n + 1) / n)
        return self._on_edge[key]

    def on_cap(self, face, pieces, nodes):
        """(n,3) points over nodes of a region: of the cap's edges where it ends, else of its surface.

        pieces: those round the region
        """
        xy = self.flat.nodes[nodes]
        places = np.full((len(nodes), 3), np.nan)
        row = {int(v): k for k, v in enumerate(nodes)}
        for c in pieces:
            source = self._pieces[c].source(self._edges[face])
            if source is not None:
                places[[row[int(v)] for v in self.flat.on_piece[c]]] = self.on_source(c, source)
        rest = np.isnan(places[:, 0])
        if rest.any():
            first = self._first(xy, places, rest)
            places[rest] = self.plane.lift(xy[rest], self._heights.of_face(face, xy[rest], first))
        return places

    def _first(self, xy, places, rest):
        """First guesses of heights: those of the nearest nodes on edges."""
        if rest.all():
            return None
        near = cKDTree(xy[~rest]).query(xy[rest])[1]
        return self.plane.height(places[~rest])[near]


def extrude(shape, plane, arrangement, columns, levels, heights, flat, roles, size, layers=None):
    """The LayeredMesh. layers: as mesh.Standing.mesh takes it. Raises NotLayered."""
    places = Places(shape, plane, arrangement, heights, flat)
    around = {r: sorted(arrangement.regions[r].pieces) for r in flat.quads}
    nodes_of = {r: np.unique(q) for r, q in flat.quads.items()}
    sheets = _sheets(places, columns, levels, around, nodes_of, size)
    rings = _rings(columns, levels, nodes_of, sheets, plane, size, layers or (lambda *_: None))
    return _Build(places, columns, levels, nodes_of, sheets, rings).mesh(arrangement, roles)


def _sheets(places, columns, levels, around, nodes_of, size):
    """level -> (len(nodes), 3) places, NaN where it has no node."""
    total = len(places.flat.nodes)
    quads_of = {}
    for column, stack in zip(columns, levels.stacks):
        for level in stack:
            quads_of.setdefault(level, {})[column.region] = places.flat.quads[column.region]
    sheets = {}
    for level, quads in quads_of.items():
        sheet = np.full((total, 3), np.nan)
        for k, end in levels.ends_of(level):
            column = columns[k]
            nodes = nodes_of[column.region]
            made = places.on_cap(column.cap(end), around[column.region], nodes)
            _agree(sheet[nodes], made, size, column.cap(end))
            known = ~np.isnan(sheet[nodes, 0])
            made[known] = sheet[nodes][known]
            sheet[nodes] = made
        sheets[level] = _filled(sheet, np.concatenate(list(quads.values())), places, levels.nominal[level])
    return sheets


def _agree(before, made, size, face):
    both = ~np.isnan(before[:, 0])
    if both.any() and np.linalg.norm(before[both] - made[both], axis=1).max() > 1e-3 * size:
        raise NotLayered(f"a level has two heights at one place: a ramp ends on a wall at Face{face}", [face])


def _filled(sheet, quads, places, nominal):
    """The sheet with the rest of its nodes: over their places in the plane, at heights between those that are known."""
    ids, packed = np.unique(quads, return_inverse=True)
    known = ~np.isnan(sheet[ids, 0])
    if known.all():
        return sheet
    z = np.full((len(ids), 1), nominal)
    if known.any():
        z[known, 0] = places.plane.height(sheet[ids[known]])
        if np.abs(z - nominal).max() > 1e-12 * places.solid.diagonal:
            z = _smooth(z, packed.reshape(-1, 4), known, nominal)
    sheet[ids[~known]] = places.plane.lift(places.flat.nodes[ids[~known]], z[~known, 0])
    return sheet


def _smooth(z, quads, known, nominal):
    """Harmonic heights; parts of the sheet in which nothing is known stay level."""
    n = len(z)
    a, b = quads.ravel(), np.roll(quads, -1, axis=1).ravel()
    _, part = connected_components(coo_matrix((np.ones(len(a)), (a, b)), shape=(n, n)), directed=False)
    fixed = known | ~np.isin(part, part[known])
    return harmonic(z, quads, fixed)


def _rings(columns, levels, nodes_of, sheets, plane, size, layers):
    """(lower level, upper level) -> (n,) shares at which layers of hexes lie between them."""
    gaps = {}
    for column, stack in zip(columns, levels.stacks):
        nodes = nodes_of[column.region]
        z = [plane.height(sheets[level][nodes]) for level in stack]
        for a, b, low, high in zip(stack[:-1], stack[1:], z[:-1], z[1:]):
            gap = high - low
            if not gap.min() > 1e-3 * size:
                raise NotLayered("levels meet or cross", [column.low, column.high])
            gaps.setdefault((a, b), []).append((gap.sum(), len(gap)))
    made = {pair: layers(*pair) for pair in gaps}
    return {pair: _even(sum(g for g, _ in rows) / sum(n for _, n in rows) / size) if made[pair] is None else made[pair]
            for pair, rows in gaps.items()}


def _even(layers):
    count = max(1, int(np.rint(layers)))
    return np.arange(count + 1) / count


class _Build:
    """Numbers nodes, and puts hexes between sheets."""

    def __init__(self, places, columns, levels, nodes_of, sheets, rings):
        self._places, self._columns, self._levels = places, columns, levels
        self._nodes_of, self._sheets, self._rings = nodes_of, sheets, rings
        self._ids, self._points, self._count = {}, [], 0

    def mesh(self, arrangement, roles):
        flat = self._places.flat
        hexes, faces, owners = [], [], []
        for column, stack in zip(self._columns, self._levels.stacks):
            quads = flat.quads[column.region]
            layers = self._layers(self._nodes_of[column.region], stack)
            for n, (low, high) in enumerate(zip(layers[:-1], layers[1:])):
                made = np.concatenate([low[quads], high[quads]], axis=1)
                hexes.append(made)
                bottom, top = n == 0, n == len(layers) - 2
                faces += [made[:, [0, 3, 2, 1]], made[:, 4:], made[:, _SIDES].reshape(-1, 4)]
                owners += [np.full(len(quads), column.low if bottom else 0),
                           np.full(len(quads), column.high if top else 0), np.full(4 * len(quads), _WALL)]
        points = np.concatenate(self._points)
        hexes, faces, owners = np.concatenate(hexes), np.concatenate(faces), np.concatenate(owners)
        alone = once(faces)
        quads, owners = faces[alone], owners[alone]
        walls = np.flatnonzero(owners == _WALL)
        owners[walls] = self._wall_faces(arrangement, roles, points, quads[walls])
        if (owners == 0).any():
            raise NotLayered("columns do not meet: a level is missing on one side of a piece")
        rings = sum(len(shares) - 1 for shares in self._rings.values())
        return LayeredMesh(points, hexes, quads, owners, rings, len(self._sheets), flat, self._places.plane)

    def _layers(self, nodes, stack):
        """List of (total,) ids of points, -1 where there is none, from the lowest up."""
        layers = [self._numbered((stack[0],), nodes, self._sheets[stack[0]][nodes])]
        for a, b in zip(stack[:-1], stack[1:]):
            low, high = self._sheets[a][nodes], self._sheets[b][nodes]
            layers += [self._numbered((a, b, j), nodes, low + (high - low) * share)
                       for j, share in enumerate(self._rings[a, b][1:-1], 1)]
            layers.append(self._numbered((b,), nodes, high))
        return layers

    def _numbered(self, key, nodes, places):
        ids = self._ids.setdefault(key, np.full(len(self._places.flat.nodes), -1))
        new = ids[nodes] < 0
        ids[nodes[new]] = self._count + np.arange(new.sum())
        self._points.append(places[new])
        self._count += int(new.sum())
        return ids

    def _wall_faces(self, arrangement, roles, points, quads):
        """(n,) the side that each wall quad lies on: over its place, between the edges where that side ends."""
        node = np.empty(len(points), int)
        for ids in self._ids.values():
            used = np.flatnonzero(ids >= 0)
            node[ids[used]] = used
        segment = {}
        for c, ids in self._places.flat.on_piece.items():
            for k, (a, b) in enumerate(zip(ids[:-1], ids[1:])):
                segment[min(a, b), max(a, b)] = c, k
        z = self._places.plane.height(points[quads]).mean(1)
        owners, sides = np.zeros(len(quads), int), {}
        for row, quad in enumerate(node[quads]):
            c, k = segment[min(quad[:2]), max(quad[:2])]
            if c not in sides:
                sides[c] = self._sides_on(c, arrangement.pieces[c], roles)
            owners[row] = next((face for face, low, high in sides[c] if low[k] < z[row] < high[k]), 0)
        return owners

    def _sides_on(self, c, piece, roles):
        """[(side, heights of its lower edge in the middle of each interval, of its upper edge)]."""
        edges = {}
        for source in piece.sources:
            height = self._places.plane.height(self._places.on_source(c, source))
            for face in set(self._places.solid.faces_of[source[0].edge]):
                if roles[face] is Role.SIDE:
                    edges.setdefault(face, []).append((height[:-1] + height[1:]) / 2)
        found = []
        for face, rows in edges.items():
            rows.sort(key=lambda row: row.mean())
            found += [(face, low, high) for low, high in zip(rows[::2], rows[1::2])]
        return found


def once(faces):
    """Rows of the faces that come once, in whichever sense."""
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    return np.sort(first[count == 1])

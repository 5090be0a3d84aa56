# SPDX-License-Identifier: LGPL-2.1-or-later
"""The quads of an arrangement through all levels: points, hexes, and the CAD face of each quad of their boundary."""
from dataclasses import dataclass

import numpy as np

from .fault import NotLayered
from .places import Places

STOPS = 32          # heights between two levels at which sizes are asked for
_WALL = -1
_SIDES = np.array([[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])


@dataclass
class LayeredMesh:
    """points (P,3), hexes (H,8), quads (n,4) outward, faces (n,): CAD faces; rings: how many layers of hexes; levels:
    how many; flat: the FlatMesh, plane: the CapPlane that it is in; aslant: how many sides are not along its normal;
    node, level (P,): of the FlatMesh under each point, and number of its level, -1 between levels; None where sheets
    went in; blends: how many CAD faces of blends have rows of quads by sheets."""

    points: np.ndarray
    hexes: np.ndarray
    quads: np.ndarray
    faces: np.ndarray
    rings: int
    levels: int
    flat: object
    plane: object
    aslant: int
    node: "np.ndarray | None" = None
    level: "np.ndarray | None" = None
    blends: int = 0


def extrude(standing, flat, field, layers=None):
    """The LayeredMesh of a mesh.Standing. field: SizeField; layers: as its mesh takes them. Raises NotLayered."""
    places, columns, levels = Places(standing, flat), standing.columns, standing.levels
    around = {r: sorted(standing.arrangement.regions[r].pieces) for r in flat.quads}
    nodes_of = {r: np.unique(q) for r, q in flat.quads.items()}
    sheets = _sheets(places, columns, levels, around, nodes_of)
    rings = _rings(standing, nodes_of, sheets, field, layers or (lambda *_: None))
    return _Build(places, columns, levels, nodes_of, sheets, rings).mesh(standing)


def _sheets(places, columns, levels, around, nodes_of):
    """level -> (len(nodes), 3) places, NaN where it has no node."""
    quads_of = {}
    for column, stack in zip(columns, levels.stacks):
        for level in stack:
            quads_of.setdefault(level, {})[column.region] = places.flat.quads[column.region]
    begun = {}
    for level, quads in quads_of.items():
        ends = [(columns[k].cap(end), columns[k].region) for k, end in levels.ends_of(level)]
        begun[level] = places.begun([(cap, around[r], nodes_of[r]) for cap, r in ends], levels.rims_of(level),
                                    np.concatenate(list(quads.values())), levels.nominal[level])
    return places.all_sheets(begun, [(nodes_of[c.region], stack) for c, stack in zip(columns, levels.stacks)])


def _rings(standing, nodes_of, sheets, field, layers):
    """(lower level, upper level) -> (n,) shares at which layers of hexes lie between them."""
    gaps, plane = {}, standing.plane
    for column, stack in zip(standing.columns, standing.levels.stacks):
        nodes = nodes_of[column.region]
        for pair in zip(stack[:-1], stack[1:]):
            low, high = (sheets[level][nodes] for level in pair)
            gap = plane.height(high) - plane.height(low)
            if not gap.min() > 1e-3 * field.size:
                raise NotLayered("levels meet or cross", [column.low, column.high])
            gaps.setdefault(pair, []).append((gap, _least_sizes(field, low, high)))
    made = {pair: layers(*pair) for pair in gaps}
    return {pair: _layers(rows, standing.stops_between(*pair)) if made[pair] is None else made[pair]
            for pair, rows in gaps.items()}


def _least_sizes(field, low, high):
    """(STOPS,) sizes at heights between two sheets, the least over any of their nodes."""
    if field.even:
        return np.full(STOPS, field.size)
    shares = (np.arange(STOPS) + 0.5)[:, None, None] / STOPS
    return field((low + (high - low) * shares).reshape(-1, 3)).reshape(STOPS, -1).min(1)


def _layers(rows, stops):
    """(n,) shares, stops among them, of (gaps over nodes, least sizes): as many as the mean gap has elements."""
    gap = sum(g.sum() for g, _ in rows) / sum(len(g) for g, _ in rows)
    sizes = np.min([s for _, s in rows], axis=0)
    sums = np.concatenate([[0.0], np.cumsum(gap / STOPS / sizes)])
    shares = np.arange(STOPS + 1) / STOPS
    at = np.interp(stops, shares, sums)
    ends = []
    for low, high in zip(at[:-1], at[1:]):
        count = max(1, int(np.rint(high - low)))
        ends.append(low + (high - low) * np.arange(1, count + 1) / count)
    return np.interp(np.concatenate([[0.0], *ends]), sums, shares)


class _Build:
    """Numbers nodes, and puts hexes between sheets."""

    def __init__(self, places, columns, levels, nodes_of, sheets, rings):
        self._places, self._columns, self._levels = places, columns, levels
        self._nodes_of, self._sheets, self._rings = nodes_of, sheets, rings
        self._ids, self._points, self._count = {}, [], 0

    def mesh(self, standing):
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
        node, level = self._origins(len(points))
        owners[walls] = self._wall_faces(standing, points, quads[walls], node)
        if (owners == 0).any():
            raise NotLayered("columns do not meet: a level is missing on one side of a piece")
        rings = sum(len(shares) - 1 for shares in self._rings.values())
        return LayeredMesh(points, hexes, quads, owners, rings, len(self._sheets), flat, self._places.plane,
                           len(standing.aslant), node, level)

    def _layers(self, nodes, stack):
        """List of (total,) ids of points, -1 where there is none, from the lowest up."""
        layers = [self._numbered((stack[0],), nodes, self._sheets[stack[0]][nodes])]
        for a, b in zip(stack[:-1], stack[1:]):
            low, high = self._sheets[a][nodes], self._sheets[b][nodes]
            layers += [self._numbered((a, b, j), nodes, self._places.layer(nodes, low, high, share))
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

    def _origins(self, count):
        """((P,) node of the flat mesh under each point, (P,) number of its level or -1)."""
        node, level = np.empty(count, int), np.full(count, -1)
        number = {one: k for k, one in enumerate(sorted(self._sheets))}
        for key, ids in self._ids.items():
            used = np.flatnonzero(ids >= 0)
            node[ids[used]] = used
            if len(key) == 1:
                level[ids[used]] = number[key[0]]
        return node, level

    def _wall_faces(self, standing, points, quads, node):
        """(n,) the side that each wall quad lies on: over its place, between the edges where that side ends."""
        segment = {}
        for c, ids in self._places.flat.on_piece.items():
            for k, (a, b) in enumerate(zip(ids[:-1], ids[1:])):
                segment[min(a, b), max(a, b)] = c, k
        z = self._places.plane.height(points[quads]).mean(1)
        owners, sides = np.zeros(len(quads), int), {}
        for row, quad in enumerate(node[quads]):
            c, k = segment[min(quad[:2]), max(quad[:2])]
            if c not in sides:
                sides[c] = self._sides_on(c, standing)
            owners[row] = next((face for face, low, high in sides[c] if low[k] < z[row] < high[k]), 0)
        return owners

    def _sides_on(self, c, standing):
        """As standing.walls_over, in the middle of each interval."""
        def heights(source):
            z = self._places.plane.height(self._places.on_source(c, source))
            return (z[:-1] + z[1:]) / 2
        return standing.walls_over(c, heights)


def once(faces):
    """Rows of the faces that come once, in whichever sense."""
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    return np.sort(first[count == 1])

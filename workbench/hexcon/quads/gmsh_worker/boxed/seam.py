# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a box and its neighbours agree on: where lines and levels meet its sides, and how often those are divided.

Along a box its sides are divided between stations, across and upwards as the neighbours are: what is in it takes over
the nodes that it finds there. Both follow from lengths alone (box.intervals), so that neighbours need not be asked.
"""
import numpy as np

from .box import intervals


def own_stations(box, standing):
    """{level: where it reaches the sides of a box, along its axis}, of a piece in it; its ends left out."""
    origin, on, found = float(box.feature.origin @ box.feature.axis), _outline(box, standing), {}
    for k, (column, stack) in enumerate(zip(standing.columns, standing.levels.stacks)):
        pieces = standing.arrangement.regions[column.region].pieces
        if pieces & on:
            found |= {level: _height(standing, pieces - on, k, level) - origin for level in stack[1:-1]}
    return found


def _height(standing, pieces, column, level):
    """Of a level that begins or ends in a neighbour of a column: where they meet."""
    ends = [end for end in standing.levels.ends_of(level) if end[0] != column]
    for c in sorted(pieces):
        for k, end in ends:
            if k in standing.levels.beside(c):
                return float(standing.heights.over_piece(c, standing.columns[k].cap(end)).mean())
    return standing.levels.nominal[level]


def _outline(box, standing, closed=True):
    """Pieces of a piece's arrangement, along the axis, on those sides of its box that count; closed: (4,) which."""
    return {c for c, p in enumerate(standing.arrangement.pieces)
            if (box.sides_of(box.feature.local(standing.plane.lift(p.line))).all(0) & closed).any()}


def add_lines(box, standing):
    """Whether lines of the rest meet a box where it has no station yet: now it has."""
    used = sorted({v for p in standing.arrangement.pieces for v in p.ends})
    local = box.feature.local(standing.plane.lift(standing.arrangement.vertices[used]))
    along = local[(np.abs(local[:, 1:2] - [box.low[0], box.high[0]]) < box.near).any(1), 0]
    inner = along[(along > along.min() + box.near) & (along < along.max() - box.near)] if len(along) else along
    return any([box.add_station(s) for s in np.sort(inner)])


def strip_counts(boxes, rows, standing, size):
    """fixed of Standing.mesh for a part of the rest: on the long sides of boxes, and across them.

    rows: of each box, see rows_of
    """
    def fixed(piece):
        for box, across in zip(boxes, rows):
            count = _strip_count(box, across, box.feature.local(standing.plane.lift(piece.line)), size)
            if count:
                return count
        return None
    return fixed


def rows_of(box, standings):
    """Places across a box where lines of any part of the rest end in its strip, its sides among them, rising."""
    found = [box.low[0], box.high[0]]
    for standing in standings:
        for p in standing.arrangement.pieces:
            y = box.feature.local(standing.plane.lift(p.line))[:, 1]
            if _in_strip(box, y):
                found += [y[0], y[-1]]
    return _distinct(sorted(found), 10 * box.near)


def _in_strip(box, y):
    return y.min() > box.low[0] - box.near and y.max() < box.high[0] + box.near


def _strip_count(box, rows, line, size):
    """Intervals of a line (n,3) in local coordinates, where a box decides; or None."""
    y, (a, b) = line[:, 1], sorted(line[[0, -1], 1])
    if any(np.abs(y - v).max() < box.near for v in (box.low[0], box.high[0])):
        return intervals(abs(line[-1, 0] - line[0, 0]), size)
    if b - a < box.near or not _in_strip(box, y):
        return None
    stops = [v for v in rows if a - box.near < v < b + box.near]
    return sum(intervals(high - low, size) for low, high in zip(stops[:-1], stops[1:]))


def outline(box, meshes, rows, size):
    """((n,2) places round a box, its corners and where meshes beside it have nodes; (4,) bool: which sides have some).

    rows: places across it where it is divided
    """
    heights, closed = list(box.corners()[1:3, 1]), np.zeros(4, bool)
    for mesh in meshes:
        local = box.feature.local(mesh.points)
        on = box.sides_of(local)
        of_mesh = on[mesh.quads].all(1).any(0)
        closed |= of_mesh
        heights += local[(on & of_mesh)[:, :2].any(1), 2].tolist()
    across, up = _divided(rows, size), _distinct(sorted(heights), 10 * box.near)
    (y0, z0), (y1, z1) = box.low, box.high
    low, high = (across if closed[k] else [y0, y1] for k in (2, 3))
    left, right = (up if closed[k] else [z0, z1] for k in (0, 1))
    return np.array([(y, z0) for y in low[:-1]] + [(y1, z) for z in right[:-1]] +
                    [(y, z1) for y in high[:0:-1]] + [(y0, z) for z in left[:0:-1]]), closed


def _divided(stops, size):
    """Stops, and even places between them."""
    parts = [np.linspace(a, b, intervals(b - a, size) + 1)[:-1] for a, b in zip(stops[:-1], stops[1:])]
    return [*np.concatenate(parts).tolist(), stops[-1]]


def ones(box, standing, closed):
    """fixed of Standing.mesh for a piece in a box whose outline is split at all nodes of its neighbours."""
    on = {id(standing.arrangement.pieces[c]) for c in _outline(box, standing, closed)}
    return lambda piece: 1 if id(piece) in on else None


def layers_beside(boxes, standings, size):
    """layers of Standing.mesh, for each part of the rest: also at levels that reach a box, so on all sides of it."""
    heights = sorted({z for s in standings for z in s.levels.nominal.values()})
    spans = [box.feature.origin @ box.feature.up + np.array([box.low[1] - box.near, box.high[1] + box.near])
             for box in boxes]
    reach = [z for z in heights if any(low <= z <= high for low, high in spans)]

    def of(levels):
        def layers(low, high):
            a, b = levels.nominal[low], levels.nominal[high]
            stops = _distinct([z for z in reach if a + 1e-3 * size < z < b - 1e-3 * size], 1e-3 * size)
            return _shares([a, *stops, b], size) if stops else None
        return layers
    return [of(standing.levels) for standing in standings]


def layers_along(box, standing, size):
    """layers of Standing.mesh for a piece in a box: where its neighbours have nodes along its sides."""
    at = own_stations(box, standing) | _ends(box, standing)

    def layers(low, high):
        if low not in at or high not in at:
            return None
        a, b = at[low], at[high]
        return _shares([a, *sorted(s for s in box.stations if a + 10 * box.near < s < b - 10 * box.near), b], size)
    return layers


def _ends(box, standing):
    """{level: where it ends a piece at the sides of its box, along its axis}."""
    origin, on, found = float(box.feature.origin @ box.feature.axis), _outline(box, standing), {}
    for column, stack in zip(standing.columns, standing.levels.stacks):
        for c in standing.arrangement.regions[column.region].pieces & on:
            for level, cap in ((stack[0], column.low), (stack[-1], column.high)):
                found.setdefault(level, []).append(float(standing.heights.over_piece(c, cap).mean()) - origin)
    return {level: float(np.mean(along)) for level, along in found.items()}


def _distinct(values, near):
    """Rising values without those that are nearer than that to the one before."""
    kept = []
    for value in values:
        if not kept or value - kept[-1] > near:
            kept.append(value)
    return kept


def _shares(stops, size):
    """(n,) from 0 to 1: stops, and even places between them."""
    return (np.array(_divided(stops, size)) - stops[0]) / (stops[-1] - stops[0])

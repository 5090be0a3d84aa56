# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the recognised sweep to the plane outline of its lower cap."""
import numpy as np

from .outline import Outline, even, least_count
from .plane_mesh import polygon_area
from .recognise import Column, Sweep
from .spacing import STATIONS, spacing_of


class CapPlane:
    """A plane frame for a cap: plane coordinates (m,2) and back to points (m,3) of the plane."""

    def __init__(self, origin, normal):
        self.origin = origin
        self.normal = normal / np.linalg.norm(normal)
        axis = np.eye(3)[np.argmin(np.abs(self.normal))]
        self.u = np.cross(axis, self.normal)
        self.u /= np.linalg.norm(self.u)
        self.v = np.cross(self.normal, self.u)

    @classmethod
    def round(cls, points):
        """For a closed chain (m,3), counter-clockwise about the normal by definition."""
        origin = points.mean(axis=0)
        d = points - origin
        return cls(origin, np.cross(d, np.roll(d, -1, axis=0)).sum(axis=0))

    @classmethod
    def of_quads(cls, points, quads):
        """For a nearly plane quad mesh, in which it is counter-clockwise."""
        p = points[quads]
        return cls(points.mean(axis=0), np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1]).sum(axis=0))

    def flat(self, points):
        d = points - self.origin
        return np.stack([d @ self.u, d @ self.v], -1)

    def height(self, points):
        return (points - self.origin) @ self.normal

    def lift(self, flat, height=0.0):
        height = np.broadcast_to(np.asarray(height, float), flat.shape[:1])
        return (self.origin + flat[:, :1] * self.u + flat[:, 1:] * self.v + height[:, None] * self.normal)


def front_edges(columns, level):
    """Signed edges round one loop, and their column numbers: level 0 is the lower cap, -1 the upper."""
    edges = [(k, e) for k, c in enumerate(columns) for e in c.fronts[level]]
    return [e for _, e in edges], np.array([k for k, _ in edges])


def chain_points(solid, edges, shares):
    """(N,3): points along consecutive signed edges, at shares (n,) of the length of each."""
    return np.concatenate([solid.edge_points(e, s) for e, s in zip(edges, shares)])


def orient(solid, sweep):
    """(Sweep, CapPlane, CapPlane): outer loop first, and the planes of the lower and the upper cap, in which the outer
    loop runs counter-clockwise and holes clockwise."""
    sweep = Sweep(sweep.bottom, sweep.top, [_aligned(solid, columns) for columns in sweep.loops], sweep.levels)
    rough = [_rough(solid, columns, 0) for columns in sweep.loops]
    extent = [np.linalg.norm(r.max(axis=0) - r.min(axis=0)) for r in rough]
    outer = int(np.argmax(extent))
    plane = CapPlane.round(rough[outer])
    loops = [sweep.loops[outer]]
    for k, columns in enumerate(sweep.loops):
        if k != outer:
            clockwise = polygon_area(plane.flat(rough[k])) < 0
            loops.append(columns if clockwise else _reversed(columns))
    top_plane = CapPlane.round(_rough(solid, loops[0], -1))
    return Sweep(sweep.bottom, sweep.top, loops, sweep.levels), plane, top_plane


def _rough(solid, columns, level):
    """(m,3) points round a loop, enough to tell its plane."""
    edges = front_edges(columns, level)[0]
    return chain_points(solid, edges, *even([[1 if solid.is_line(abs(e)) else 24 for e in edges]]))


def _reversed(columns):
    """The same loop walked the other way."""
    turned = []
    for c in reversed(columns):
        fronts = [[-e for e in reversed(front)] for front in c.fronts]
        turned.append(Column(list(c.faces), fronts, list(c.right), list(c.left)))
    return turned


def _aligned(solid, columns):
    """Closed front edges (one column with a seam) have no direction of their own: take that of the lowest front."""
    for c in columns:
        if len(c.fronts[0]) != 1 or solid.start(c.fronts[0][0]) != solid.end(c.fronts[0][0]):
            continue
        t = np.arange(24) / 24
        below = solid.edge_points(c.fronts[0][0], t)
        for k in range(1, len(c.fronts)):
            both = [solid.edge_points(s * c.fronts[k][0], t) for s in (1, -1)]
            fit = [((p - p.mean(0)) * (below - below.mean(0))).sum() for p in both]
            if fit[1] > fit[0]:
                c.fronts[k] = [-c.fronts[k][0]]
            below = both[int(fit[1] > fit[0])]
    return columns


def outline_of(solid, sweep, plane, top_plane, field):
    """The Outline of the lower cap for a SizeField, with the upper cap beside it."""
    desired, least, turn, direction, spacing = [], [], [], [], []
    for columns in sweep.loops:
        fronts = [front_edges(columns, level)[0] for level in (0, -1)]
        lengths = np.array([[solid.length(e) for e in edges] for edges in fronts])
        desired.append(lengths.mean(axis=0) / field.size)
        if not field.even:
            spacing.append([spacing_of(field, [solid.edge_points(e, STATIONS) for e in pair]) for pair in zip(*fronts)])
            desired[-1] = np.array([own.wanted for own in spacing[-1]]) * lengths.mean(axis=0) / lengths[0]
        least.append(np.array([max(least_count(solid.turning(e), _closed(solid, e)) for e in pair)
                               for pair in zip(*fronts)]))
        out, below = _directions(solid, fronts[0], plane)
        _, above = _directions(solid, fronts[1], top_plane)
        turn.append(np.where(np.abs(above) < np.abs(below), above, below))
        direction.append(out)

    def placed(level, frame):
        return lambda shares: [frame.flat(chain_points(solid, front_edges(columns, level)[0], s))
                               for columns, s in zip(sweep.loops, shares)]

    return Outline(desired, least, turn, direction, placed(0, plane), placed(-1, top_plane), field.size,
                   spacing or None)


def _closed(solid, e):
    return solid.start(e) == solid.end(e)


def _directions(solid, edges, plane):
    """Angles in radians, in the plane: direction at the start of each edge, and left turn from the edge before."""
    into = np.array([solid.tangent(e, at_end=True) for e in edges[-1:] + edges[:-1]])
    out = np.array([solid.tangent(e) for e in edges])
    before, after = (np.arctan2(d @ plane.v, d @ plane.u) for d in (into, out))
    return after, (after - before + np.pi) % (2 * np.pi) - np.pi

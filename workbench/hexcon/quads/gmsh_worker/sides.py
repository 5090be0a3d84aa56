# SPDX-License-Identifier: LGPL-2.1-or-later
"""The side walls of a sweep: rings of points from the lower cap's outline to the upper cap's."""
import numpy as np

from .boundary import chain_points, front_edges
from .outline import least_count
from .plane_mesh import coons, grid_quads
from .smooth import space_quality
from .spacing import STATIONS, spacing_of

POOR = 0.3      # scaled Jacobian of a wall below which another way to fill it is tried


class Rings:
    """Points and faces of the walls.

    points   (R+1, Nb, 3): ring r of the boundary points, loop after loop
    faces    (R, Nb): CAD face of the quad above ring r between boundary point i and the next of its loop
    after    (Nb,): the next boundary point of the same loop
    """

    def __init__(self, solid, sweep, shares, field):
        """shares: of the cap's Outline, per loop and edge; field: SizeField."""
        self.solid, self.sweep = solid, sweep
        self.rises = _rises(solid, sweep, field)        # per level (n+1,) shares of it at which its rings lie
        self.stops = [0, *np.cumsum([len(rise) - 1 for rise in self.rises]).tolist()]
        total = sum(len(s) for loop in shares for s in loop)
        self.points = np.full((self.stops[-1] + 1, total, 3), np.nan)
        self.faces = np.zeros((self.stops[-1], total), int)
        self.after = np.empty(total, int)
        self.blocks = []          # (CAD face, first ring, last ring, boundary points (n+1,), its edges in parameters)
        at = 0
        for columns, loop in zip(sweep.loops, shares):
            self._place_loop(columns, loop, at)
            at += sum(map(len, loop))
        self._fill_blocks()

    def _place_loop(self, columns, shares, at):
        """Points on all CAD edges of one loop's walls."""
        total = sum(map(len, shares))
        self.after[at:at + total] = at + (np.arange(total) + 1) % total
        owner = front_edges(columns, 0)[1]
        rise = _level_fractions(self.solid, columns, self.stops, self.rises)
        first = at
        for k, column in enumerate(columns):
            mine = [s for s, column_of in zip(shares, owner) if column_of == k]
            n = sum(map(len, mine))
            ids = at + (first - at + np.arange(n + 1)) % total
            self._place_fronts(column, mine, ids)
            self.points[:, ids[0]] = self._chain(column.left, rise)
            levels = [0] + [self.stops[-1]] if len(column.faces) == 1 else self.stops
            for level, (face, low, high) in enumerate(zip(column.faces, levels[:-1], levels[1:])):
                self.blocks.append((face, low, high, ids, self._edges_on_face(column, level, mine, rise)))
                self.faces[low:high, ids[:-1]] = face
            first += n

    def _place_fronts(self, column, shares, ids):
        levels = [0, self.stops[-1]] if len(column.faces) == 1 else self.stops
        for ring, front in zip(levels, column.fronts):
            self.points[ring, ids[:-1]] = chain_points(self.solid, front, shares)

    def _chain(self, chain, rise):
        """(R+1,3): points up a lateral chain; `rise` are its arc-length fractions per ring if it is one edge."""
        if len(chain) == 1:
            return self.solid.edge_points(chain[0], rise)
        parts = [self.solid.edge_points(e, rise) for e, rise in zip(chain, self.rises)]
        return np.concatenate([parts[0]] + [p[1:] for p in parts[1:]])

    def _fill_blocks(self):
        """Interior points of every side face: transfinite, or by the sweep's own motion, then onto the CAD."""
        motion = _rigid_motion(self.points, self.rises)
        for face, low, high, ids, edges in self.blocks:
            if len(ids) < 3 or high - low < 2:
                continue
            p = self.points[low:high + 1][:, ids]
            if motion is not None:
                grid = self._projected(face, p, motion[low:high + 1][:, ids])
            else:
                grid = self._interpolated(face, p, edges)
            self.points[low + 1:high, ids[1:-1]] = grid[1:-1, 1:-1]

    def _interpolated(self, face, p, edges):
        """Transfinite, in the face's own parameters where it is freeform, else in space; the better if one folds."""
        made = []
        if not self.solid.is_elementary(face):
            made.append(self._in_parameters(face, p, edges))
        if not made or made[0] is None or _worst(made[0]) < POOR:
            made.append(self._projected(face, p, coons(p[0], p[:, -1], p[-1], p[:, 0])))
        return max((g for g in made if g is not None), key=_worst)

    def _projected(self, face, p, grid):
        """p (m,n,3) with its interior taken from a grid near the face, put on the face."""
        result = p.copy()
        result[1:-1, 1:-1] = self.solid.project(2, face, grid[1:-1, 1:-1]).reshape(result[1:-1, 1:-1].shape)
        return result

    def _in_parameters(self, face, p, edges):
        """p with its interior interpolated in the face's parameters; None where its edges do not meet there."""
        bottom, right, top, left = edges()
        scale = np.ptp(np.concatenate([bottom, right, top, left]), axis=0).max()
        gaps = [bottom[0] - left[0], bottom[-1] - right[0], top[0] - left[-1], top[-1] - right[-1]]
        if np.abs(gaps).max() > 1e-4 * scale:
            return None
        grid = coons(bottom, right, top, left)[1:-1, 1:-1]
        result = p.copy()
        result[1:-1, 1:-1] = self.solid.face_points(face, grid).reshape(grid.shape[:2] + (3,))
        return result

    def _edges_on_face(self, column, k, shares, rise):
        """Callable -> (bottom, right, top, left) surface parameters round face k of a column."""
        face, solid = column.faces[k], self.solid

        def front(edges):
            parts = [solid.edge_on_face(e, np.append(s, 1.0), face) for e, s in zip(edges, shares)]
            return np.concatenate([parts[0]] + [q[1:] for q in parts[1:]])

        def lateral(chain, side):
            if len(column.faces) > 1:
                return solid.edge_on_face(chain[k], self.rises[k], face, side)
            if len(chain) == 1:
                return solid.edge_on_face(chain[0], rise, face, side)
            parts = [solid.edge_on_face(e, own, face, side) for e, own in zip(chain, self.rises)]
            return np.concatenate([parts[0]] + [q[1:] for q in parts[1:]])

        def edges():
            bottom, top = front(column.fronts[k]), front(column.fronts[k + 1])
            sides = [lateral(column.left, side) for side in (0, 1)]
            if [abs(e) for e in column.left] != [abs(e) for e in column.right]:
                return bottom, lateral(column.right, 0), top, sides[0]
            near = [np.abs(s[0] - bottom[0]).max() for s in sides]
            return bottom, sides[int(near[0] < near[1])], top, sides[int(near[0] >= near[1])]
        return edges

    def quads(self):
        """(R*Nb,4) point numbers ring * Nb + i, and their faces; seen with the lower cap's outline turning left."""
        rings, total = self.faces.shape
        base = (np.arange(rings) * total)[:, None]
        i = np.arange(total)[None, :]
        j = self.after[None, :]
        quads = np.stack([base + i, base + j, base + total + j, base + total + i], -1)
        return quads.reshape(-1, 4), self.faces.ravel()


def _worst(grid):
    """Smallest scaled Jacobian of a structured grid (m,n,3) in space."""
    ids = np.arange(grid.shape[0] * grid.shape[1]).reshape(grid.shape[:2])
    return float(space_quality(grid.reshape(-1, 3), grid_quads(ids)).min())


def _rises(solid, sweep, field):
    """Per level the shares, from 0 to 1, at which its rings lie."""
    edges = [[] for _ in range(sweep.levels)]
    for columns in sweep.loops:
        for c in columns:
            if len(c.left) == sweep.levels:
                for k, e in enumerate(c.left):
                    edges[k].append(e)
    return [_rise(solid, level, field) for level in edges]


def _rise(solid, edges, field):
    """Of one level, by all of its lateral edges."""
    least = max(1, *(least_count(solid.turning(e), False) for e in edges))
    mean = np.mean([solid.length(e) for e in edges])
    if field.even:
        return _even(max(least, int(np.rint(mean / field.size))))
    own = spacing_of(field, [solid.edge_points(e, STATIONS) for e in edges])
    return own.stops(max(least, int(np.rint(own.wanted * mean / solid.length(edges[0])))))


def _even(count):
    return np.arange(count + 1) / count


def _level_fractions(solid, columns, stops, rises):
    """(R+1,) arc-length fraction of each ring, from the chains that have all levels."""
    rings = np.arange(stops[-1] + 1)
    full = [[solid.length(e) for e in c.left] for c in columns if len(c.left) == len(stops) - 1]
    if len(stops) == 2:
        return rises[0]
    if not full:
        return rings / stops[-1]
    ends = np.concatenate([[0.0], np.mean([np.cumsum(f) / np.sum(f) for f in full], axis=0)])
    return np.concatenate([[0.0], *(a + (b - a) * rise[1:] for a, b, rise in zip(ends, ends[1:], rises))])


def _rigid_motion(points, rises):
    """(R+1,Nb,3): the lower outline turned about an axis (and moved along it), ring by ring.

    None unless that gives the upper outline and the lateral edges.
    """
    a, b = points[0], points[-1]
    rise = rises[0] if len(rises) == 1 else _even(len(points) - 1)
    ca, cb = a.mean(0), b.mean(0)
    u, _, vt = np.linalg.svd((a - ca).T @ (b - cb))
    turn = vt.T @ np.diag([1.0, 1.0, np.sign(np.linalg.det(vt.T @ u.T))]) @ u.T
    scale = np.linalg.norm(a - ca, axis=1).max()
    if np.abs((a - ca) @ turn.T + cb - b).max() > 1e-6 * scale:
        return None
    axis, angle = _axis_angle(turn)
    if abs(angle) < 1e-3:
        return None
    along = axis * float(axis @ (cb - ca))
    centre = np.linalg.lstsq(np.eye(3) - turn, cb - turn @ ca - along, rcond=None)[0]
    known = np.isfinite(points).all(axis=(0, 2))
    for total in (angle, angle - np.copysign(2 * np.pi, angle)):
        made = np.stack([(a - centre) @ _rotation(axis, total * share).T + centre + along * share
                         for share in rise])
        if np.abs(made[:, known] - points[:, known]).max() < 1e-5 * scale:
            return made
    return None


def _axis_angle(turn):
    """Axis (3,) and angle of a rotation matrix; good near half a turn as well."""
    values, vectors = np.linalg.eig(turn)
    axis = np.real(vectors[:, np.argmin(np.abs(values - 1.0))])
    axis /= np.linalg.norm(axis)
    side = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    side /= np.linalg.norm(side)
    turned = turn @ side
    return axis, float(np.arctan2(np.cross(side, turned) @ axis, side @ turned))


def _rotation(axis, angle):
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * (k @ k)

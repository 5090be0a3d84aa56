# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rooms: boxes round places where round faces meet in ways that no layers have."""
from dataclasses import dataclass

import gmsh
import numpy as np

from ..layered.roles import PARALLEL

ROUND = ("Cylinder", "Cone", "Torus")
SAMPLES = 33        # of an edge
MARGIN = 0.75       # of the size: how far a room goes beyond what it is for
CLEAR = 0.6         # of the size: what a side leaves to a plane or a round face along it, at least
STEEP = 0.7         # of a radius: a side farther from the axis cuts a round face too aslant
MOST_MOVES = 8
AXES = 12           # of the solid's faces, those of most area


@dataclass
class Room:
    """frame (3,3): unit rows; low, high (3,): along them."""

    frame: np.ndarray
    low: np.ndarray
    high: np.ndarray

    def local(self, points):
        """(n,3) coordinates along the frame."""
        return np.asarray(points, float).reshape(-1, 3) @ self.frame.T

    def corners(self):
        """(8,3) in space."""
        ends = np.stack([self.low, self.high])
        return np.stack(np.meshgrid(*ends.T, indexing="ij"), -1).reshape(-1, 3) @ self.frame

    def block(self):
        """Tag of its volume in the current gmsh model."""
        occ, (x, y, z) = gmsh.model.occ, np.stack([self.low, self.high], 1)
        base = np.array([(x[0], y[0], z[0]), (x[1], y[0], z[0]), (x[1], y[1], z[0]), (x[0], y[1], z[0])])
        points = [occ.addPoint(*p) for p in base @ self.frame]
        lines = [occ.addLine(a, b) for a, b in zip(points, points[1:] + points[:1])]
        face = occ.addPlaneSurface([occ.addCurveLoop(lines)])
        pulled = occ.extrude([(2, face)], *((z[1] - z[0]) * self.frame[2]))
        return next(tag for dim, tag in pulled if dim == 3)

    def is_side_of(self, middles, skin, near):
        """Whether middles (n,3) of what lies in a plane are on its surface, and inside the solid of a whole.Skin."""
        return bool(self.on_sides(middles, near).all() and np.median(skin.near(middles)[1]) > near)

    def on_sides(self, points, near):
        """(n,) bool: which points (n,3) are on its surface, to within that."""
        local = self.local(points)
        inside = ((local > self.low - near) & (local < self.high + near)).all(1)
        return inside & ((np.abs(local - self.low) < near) | (np.abs(local - self.high) < near)).any(1)


def rooms_of(shape, size, wide):
    """[Room] round the edges of a roles.Shape where round faces about different axes meet, or a plane cuts one aslant.

    wide: all of the section of what meets is inside, not only the edges
    """
    rooms, axes = [], shape.directions(AXES)
    for edge in shape.solid.edges:
        pair = sorted(set(shape.solid.faces_of[edge]))
        if len(pair) == 2 and (frame := _frame(*(shape.carriers[f] for f in pair), axes)) is not None:
            rooms.append(_room(shape, edge, pair, frame, size, wide))
    rooms = [_settled(shape, room, size) for room in _apart(rooms)]
    return _apart(rooms)


def _frame(one, other, axes):
    """(3,3) where two carriers meet in no way that layers have; None where they do. axes: of the solid's faces."""
    if one.kind not in ROUND:
        one, other = other, one
    if one.kind not in ROUND or other.kind not in (*ROUND, "Plane"):
        return None
    a, b = one.axis, other.axis
    along = abs(a @ b)
    if along > 1.0 - PARALLEL ** 2 or (other.kind == "Plane" and along < PARALLEL):
        return None
    normal = np.cross(a, b)
    normal = normal / np.linalg.norm(normal)
    if other.kind == "Plane":
        normal = next((d for d in axes if abs(d @ b) < PARALLEL), normal)
        return np.stack([b, normal, np.cross(b, normal)])
    return np.stack([a, np.cross(normal, a), normal])


def _room(shape, edge, faces, frame, size, wide):
    solid = shape.solid
    oblique = [f for f in faces if shape.carriers[f].kind in ROUND] if any(
        shape.carriers[f].kind == "Plane" for f in faces) else []
    edges = {edge} | {abs(e) for f in oblique for e in solid.boundary[f]}
    local = np.concatenate([solid.edge_points(e, np.linspace(0.0, 1.0, SAMPLES)) for e in sorted(edges)]) @ frame.T
    low, high = local.min(0), local.max(0)
    for carrier in (shape.carriers[f] for f in faces if wide):
        if carrier.kind == "Cylinder":
            across = np.abs(frame @ carrier.axis) < PARALLEL
            centre = frame @ carrier.origin
            low = np.where(across, np.minimum(low, centre - carrier.radius), low)
            high = np.where(across, np.maximum(high, centre + carrier.radius), high)
    return Room(frame, low - MARGIN * size, high + MARGIN * size)


def _apart(rooms):
    """Rooms that overlap as one."""
    for k, room in enumerate(rooms):
        for j in range(k):
            local = rooms[j].local(room.corners())
            if (local.min(0) < rooms[j].high).all() and (local.max(0) > rooms[j].low).all():
                both = Room(rooms[j].frame, np.minimum(rooms[j].low, local.min(0)),
                            np.maximum(rooms[j].high, local.max(0)))
                return _apart([r for n, r in enumerate(rooms) if n not in (j, k)] + [both])
    return rooms


def _settled(shape, room, size):
    """The room with its sides moved out until each is clear of planes along it, and cuts no round face aslant."""
    solid = shape.solid
    local = room.local(np.concatenate([solid.edge_points(e, np.linspace(0.0, 1.0, SAMPLES)) for e in solid.edges]))
    far = solid.diagonal
    low, high = room.low.copy(), room.high.copy()
    for k in range(3):
        normal = room.frame[k]
        low[k] = -_side(shape, -normal, -low[k], -local[:, k].min(), size, far)
        high[k] = _side(shape, normal, high[k], local[:, k].max(), size, far)
    return Room(room.frame, low, high)


def _side(shape, normal, at, end, size, far):
    """Where a side with this outward normal is, from `at` on outwards; beyond the end of the solid: far away."""
    for _ in range(MOST_MOVES):
        if at > end - CLEAR * size:
            return end + far
        moved = max((_moved(c, normal, at, size) for c in shape.carriers.values()), default=at)
        if moved <= at:
            return at
        at = moved
    return at


def _moved(carrier, normal, at, size):
    """Where a side goes to that is in the way of a face."""
    if carrier.kind == "Plane" and abs(carrier.axis @ normal) > 1.0 - PARALLEL ** 2:
        place = carrier.origin @ normal
        return place if at < place < at + CLEAR * size else at
    if carrier.kind == "Cylinder" and abs(carrier.axis @ normal) < PARALLEL:
        off = at - carrier.origin @ normal
        if STEEP * carrier.radius < abs(off) < carrier.radius + 0.3 * size and off > 0.0:
            return carrier.origin @ normal + carrier.radius + MARGIN * size
    return at

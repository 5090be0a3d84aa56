# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sides that lie aslant, seen along a direction as if they stood upright: one curve of the plane for all their heights.

Sides that meet in edges which rise along the direction are a *storey*. Its sides are seen where they, prolonged, are at
one height; edges that rise are seen as points, and the edges above and below a side as one curve. Storeys that stand
on one another, with a level edge between them, are seen one through the other, so they have one curve as well.
"""
import numpy as np

from .fault import NotLayered
from .roles import Role

RISES = 0.5         # of an edge's length: an edge between two sides with a greater rise parts them, else it joins them
LEVEL = 1e-6        # of the diagonal: by which a level edge may rise
STEPS, DONE = 30, 1e-13     # of Newton's method; of the diagonal, the last of them
LEAST_LEVEL = 0.2   # of a normal, that is across the direction, at least
SAMPLES = 65        # of an edge, for its heights


class Upright:
    """Of a solid's edges along a direction.

    shape: roles.Shape; plane: CapPlane whose normal that is; roles: {CAD face: Role}; aslant: sides that are not
    along it. moving: faces whose places are not seen where they are; corners: vertex of the CAD -> (2,) where it is
    seen, of those on such faces; lateral: edges that are seen as points
    """

    def __init__(self, shape, plane, roles, aslant):
        self._shape, self._plane, self._solid = shape, plane, shape.solid
        self._tiny = DONE * shape.solid.diagonal
        solid = shape.solid
        sides = {f for f in solid.faces if roles[f] is Role.SIDE} if aslant else set()
        between = [e for e in solid.edges if len(set(solid.faces_of[e])) == 2
                   and sides.issuperset(solid.faces_of[e])]
        rising = [e for e in between if self._rises(e)]
        joining = sorted(set(between) - set(rising))
        storeys = _joined(sorted(sides), [solid.faces_of[e] for e in rising])
        self._seats = {}        # face -> (height, [(face below or above, (k,3) of their edge)]); None: stands upright
        for group in _groups(storeys, [solid.faces_of[e] for e in between]):
            if any(f in aslant for storey in group for f in storeys[storey]):
                self._seat(group, storeys, joining, aslant)
        self.moving = {f for f, seat in self._seats.items() if seat is not None}
        self.lateral = [e for e in rising if solid.faces_of[e][0] in self._seats]
        self.corners = self._corners()

    # -- which heights -------------------------------------------------------

    def heights(self, edge):
        """((k,) fractions along an edge, (k,) heights there)."""
        f = np.linspace(0.0, 1.0, 2 if self._solid.is_line(edge) else SAMPLES)
        return f, self._plane.height(self._solid.edge_points(edge, f))

    def _rises(self, edge):
        low, high = self._solid.ends[edge]
        rise = abs(self._plane.height(self._solid.vertex[high]) - self._plane.height(self._solid.vertex[low]))
        return rise > RISES * self._solid.length(edge)

    def _level(self, edge):
        """Height of an edge that joins two sides."""
        z = self.heights(edge)[1]
        if np.ptp(z) > LEVEL * self._solid.diagonal:
            raise NotLayered("sides aslant meet in an edge that is not level", self._solid.faces_of[edge])
        return float(z.mean())

    def _seat(self, group, storeys, joining, aslant):
        """Seats of the faces of storeys that stand on one another: seen through one that is upright, or the largest."""
        area = self._solid.area
        order = sorted(group, key=lambda s: (any(f in aslant for f in storeys[s]), -sum(map(area, storeys[s])), s))
        of = {f: s for s in group for f in storeys[s]}
        joints = [(e, *self._solid.faces_of[e]) for e in joining if self._solid.faces_of[e][0] in of]
        joints = [joint for joint in joints if of[joint[1]] != of[joint[2]]]
        done, todo = {order[0]}, [order[0]]
        upright = not any(f in aslant for f in storeys[order[0]])
        height = None if upright else self._own_height(storeys[order[0]], [e for e, *ends in joints
                                                                           if any(of[f] == order[0] for f in ends)])
        self._seats |= {f: None if upright else (height, []) for f in storeys[order[0]]}
        while todo:
            here = todo.pop()
            for _, one, other in joints:
                for mine, theirs in ((one, other), (other, one)):
                    if of[mine] == here and of[theirs] not in done:
                        self._stand(storeys[of[theirs]], of[theirs], here, of, joints)
                        done.add(of[theirs])
                        todo.append(of[theirs])

    def _own_height(self, faces, joining):
        """Of the storey through which others are seen: of its one level edge, else the mean of its sides."""
        levels = [self._level(e) for e in joining]
        if levels and np.ptp(levels) < LEVEL * self._solid.diagonal:
            return levels[0]
        area = np.array([self._solid.area(f) for f in faces])
        return float(area @ [self._middle(f) for f in faces] / area.sum())

    def _middle(self, face):
        z = np.concatenate([self.heights(abs(e))[1] for e in self._solid.boundary[face]])
        return float(z.min() + z.max()) / 2

    def _stand(self, faces, own, below, of, joints):
        """Seat the faces of a storey on those of another."""
        rows = [(e, one, other) if of[one] == own else (e, other, one) for e, one, other in joints
                if {of[one], of[other]} == {own, below}]
        heights = [self._level(e) for e, *_ in rows]
        if np.ptp(heights) > LEVEL * self._solid.diagonal:
            raise NotLayered("sides aslant stand on others at several heights", [f for _, *both in rows for f in both])
        at = np.linspace(0.0, 1.0, SAMPLES)
        for face in faces:
            mine = [row for row in rows if row[1] == face] or rows
            self._seats[face] = heights[0], [(other, self._solid.edge_points(e, at)) for e, _, other in mine]

    # -- where places are seen ------------------------------------------------

    def section(self, face, points, heights):
        """(n,3) places of a side at heights (n,), the surface prolonged: by Newton's method across the direction."""
        d, carrier = self._plane.normal, self._shape.carriers[face]
        p = points + (np.asarray(heights) - self._plane.height(points))[:, None] * d
        for _ in range(STEPS):
            foot, normal = carrier.project(p)
            level = normal - (normal @ d)[:, None] * d
            size = np.maximum((level * level).sum(1), LEAST_LEVEL ** 2)
            move = (((foot - p) * normal).sum(1) / size)[:, None] * level
            if not np.isfinite(move).all():
                break
            p = p + move
            if np.abs(move).max(initial=0.0) < self._tiny:
                return p
        if not np.isfinite(move).all() or np.abs(move).max(initial=0.0) > 1e5 * self._tiny:
            raise NotLayered(f"Face{face} is not at all heights of its edges", [face])
        return p

    def _seen(self, face, points):
        """(n,3) places of a side, moved to where it is seen."""
        seat = self._seats.get(face)
        if seat is None or not len(points):
            return points
        height, stands_on = seat
        points = self.section(face, points, np.full(len(points), height))
        if len(stands_on) < 2:
            return self._seen(stands_on[0][0], points) if stands_on else points
        far = np.stack([np.linalg.norm(points[:, None] - line, axis=2).min(1) for _, line in stands_on], 1)
        moved = points.copy()
        for k, (other, _) in enumerate(stands_on):
            rows = far.argmin(1) == k
            moved[rows] = self._seen(other, points[rows])
        return moved

    def _corners(self):
        """Vertices on sides that are not seen where they are, or beside those: one place for those above another."""
        solid, of = self._solid, self._seats
        ends = [solid.ends[e] for e in self.lateral]
        together = _joined(sorted({v for pair in ends for v in pair}), ends)
        first = {v: k for k, group in together.items() for v in group}
        edges = {}
        for e in self.lateral:
            edges.setdefault(first[solid.ends[e][0]], []).append(e)
        for e in sorted(set(solid.edges) - set(self.lateral)):
            a, b = solid.ends[e]
            if a != b and a in first and first[a] == first.get(b):
                raise NotLayered("sides aslant meet in a point", solid.faces_of[e])
        found = {}
        for k, group in together.items():
            edge = max(edges[k], key=lambda e: (of[solid.faces_of[e][0]] is None, solid.length(e), -e))
            found |= dict.fromkeys(group, self._corner(edge))
        for e in solid.edges:
            for face in solid.faces_of[e]:
                for v in solid.ends[e] if face in of else ():
                    if v not in found:
                        found[v] = self._plane.flat(self._seen(face, solid.vertex[v][None]))[0]
        return found

    def _corner(self, edge):
        """(2,) where an edge that rises is seen."""
        face = self._solid.faces_of[edge][0]
        if self._seats[face] is None:
            return self._plane.flat(self._solid.vertex[self._solid.ends[edge][0]])
        place = self._at_height(edge, self._seats[face][0])
        return self._plane.flat(self._seen(face, place[None]))[0]

    def _at_height(self, edge, height):
        """(3,) a place of an edge that rises, prolonged beyond its ends."""
        f, z = self.heights(edge)
        if z.min() <= height <= z.max():
            return self.on_edge(edge, np.array([height]))[0]
        end = 0.0 if abs(z[0] - height) < abs(z[-1] - height) else 1.0
        p, q = self._solid.edge_points(edge, np.array([end, abs(end - 1e-3)]))
        place = p + (q - p) * (height - self._plane.height(p)) / ((q - p) @ self._plane.normal)
        for _ in range(STEPS):      # on to both surfaces, which may touch there
            before = place
            for face in self._solid.faces_of[edge]:
                place = self.section(face, place[None], np.array([height]))[0]
            if np.abs(place - before).max() < self._tiny:
                break
        return place

    def on_edge(self, edge, heights):
        """(n,3) places of an edge that rises, at heights between its ends."""
        f, z = self.heights(edge)
        if z[0] > z[-1]:
            f, z = f[::-1], z[::-1]
        at = np.interp(heights, z, f)
        for _ in range(STEPS if len(f) > 2 else 0):
            step = 1e-5
            low, high = (at - step).clip(0, 1), (at + step).clip(0, 1)
            here, below, above = (self._plane.height(self._solid.edge_points(edge, x)) for x in (at, low, high))
            move = (heights - here) * (high - low) / np.where(above == below, np.inf, above - below)
            at = (at + move).clip(0.0, 1.0)
            if np.abs(move).max(initial=0.0) < 1e-13:
                break
        return self._solid.edge_points(edge, at)

    def flat(self, edge, fractions, points):
        """(n,2) where places (n,3) of an edge, at fractions of its length, are seen."""
        ends = [self.corners.get(v) for v in self._solid.ends[edge]]
        sides = [f for f in self._solid.faces_of[edge] if f in self._seats]
        if not sides and all(end is None for end in ends):
            return self._plane.flat(points)
        if edge in self.lateral:
            return np.repeat(ends[0][None], len(points), 0)
        if not sides:
            return self._stretched(edge, fractions, points, None)
        face = next((f for f in sides if self._seats[f] is None), sides[0])
        seen = self._stretched(edge, fractions, points, face)
        seat = self._seats[face]
        if seat is not None and not seat[1] and self._shape.carriers[face].kind != "Plane":
            height = np.full(len(seen), seat[0])
            return self._plane.flat(self.section(face, self._plane.lift(seen, height), height))
        return seen

    def _stretched(self, edge, fractions, points, face):
        """Where places are seen by a side, or as they are: stretched so that they end in the vertices."""
        ends = self._solid.ends[edge]
        both = np.concatenate([points, [self._solid.vertex[v] for v in ends]])
        seen = self._plane.flat(self._seen(face, both))
        off = [self.corners.get(v, at) - at for v, at in zip(ends, seen[-2:])]
        f = np.asarray(fractions, float)[:, None]
        return seen[:-2] + (1.0 - f) * off[0] + f * off[1]

    def moves(self, edge):
        """Whether an edge is not seen where it is."""
        return bool(self._moved_sides(edge)) or any(v in self.corners for v in self._solid.ends[edge])

    def is_straight(self, edge):
        """Whether a straight edge is seen as a straight line."""
        return all(self._shape.carriers[f].kind == "Plane" for f in self._moved_sides(edge))

    def _moved_sides(self, edge):
        return [f for f in self._solid.faces_of[edge] if f in self.moving]


def _joined(things, pairs):
    """{the first of a group: the group, in order} of things that pairs join."""
    root = {t: t for t in things}

    def find(t):
        while root[t] != t:
            root[t] = root[root[t]]
            t = root[t]
        return t
    for a, b in pairs:
        a, b = sorted((find(a), find(b)))
        root[b] = a
    groups = {}
    for t in sorted(things):
        groups.setdefault(find(t), []).append(t)
    return groups


def _groups(storeys, pairs):
    """Lists of storeys that any edge joins."""
    of = {f: s for s, faces in storeys.items() for f in faces}
    return list(_joined(list(storeys), [(of[a], of[b]) for a, b in pairs]).values())

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A box round a cross feature: where its sides are, and how it is divided."""
from dataclasses import dataclass, field

import gmsh
import numpy as np

from ..layered.roles import PARALLEL
from .features import together

ROOMS = (1.6, 1.3)          # half widths of a box to try, in radii of the feature
NARROW, LEAST = 0.3, 0.04   # what must be beside it, and how near a plane may be, in radii
BROAD, APART = 1.5, 0.8     # the most of that, in radii, and what of the size is to be beside a small feature
BESIDE = 0.6                # of the size: what is left between a box and a plane, at least, or nothing
PLANE, SAME = 1e-9, 1e-6     # of a normal, that is off; of the diagonal: nearer is one place


@dataclass
class Box:
    """feature: features.Feature; low, high (2,): across it and up from its axis; ends (2,): along it, beyond the solid;
    near: what is one place; stations: along it, where its neighbour has lines or it has levels: so has the other."""

    feature: object
    low: np.ndarray
    high: np.ndarray
    ends: tuple
    near: float
    stations: list = field(default_factory=list)

    def corners(self):
        """(4,2) across and up, counter-clockwise."""
        (y0, z0), (y1, z1) = self.low, self.high
        return np.array([(y0, z0), (y1, z0), (y1, z1), (y0, z1)])

    def blocks(self):
        """Tags of volumes of the current gmsh model: it, cut at its stations."""
        cuts = [self.ends[0], *sorted(self.stations), self.ends[1]]
        return [self.prism(self.corners(), a, b) for a, b in zip(cuts[:-1], cuts[1:])]

    def prism(self, outline, start, end):
        """Tag of a volume of the current gmsh model: an outline (n,2) across and up, pulled along the axis."""
        occ, f = gmsh.model.occ, self.feature
        points = [occ.addPoint(*p) for p in f.place(np.column_stack([np.full(len(outline), start), outline]))]
        lines = [occ.addLine(a, b) for a, b in zip(points, points[1:] + points[:1])]
        face = occ.addPlaneSurface([occ.addCurveLoop(lines)])
        pulled = occ.extrude([(2, face)], *((end - start) * f.axis))
        return next(tag for dim, tag in pulled if dim == 3)

    def add_station(self, along):
        """Whether there was none."""
        if any(abs(along - s) < 10 * self.near for s in self.stations):
            return False
        self.stations.append(float(along))
        return True

    def sides_of(self, local):
        """(n,4) bool: on which sides points (n,3) are, in local coordinates: low and high across, low and high up."""
        inside = ((local[:, 1:] > self.low - self.near) & (local[:, 1:] < self.high + self.near)).all(1)
        on = [np.abs(local[:, 1 + k] - v[k]) < self.near for k in (0, 1) for v in (self.low, self.high)]
        return np.stack(on, 1) & inside[:, None]


def boxes_round(found, shape, size, room):
    """[Box] of features; those with parallel axes whose boxes would overlap have one in common. room: of ROOMS."""
    boxes = [_box_round(feature, shape, size, room) for feature in found]
    for k, box in enumerate(boxes):
        for j in range(k):
            if _overlap(boxes[j], box):
                rest = [f for n, f in enumerate(found) if n not in (j, k)]
                return boxes_round([*rest, together(found[j], found[k])], shape, size, room)
    return boxes


def _overlap(box, other):
    if np.linalg.norm(np.cross(box.feature.axis, other.feature.axis)) > PARALLEL:
        return False
    corners = box.feature.local(other.feature.place(np.column_stack([np.zeros(4), other.corners()])))[:, 1:]
    return bool((corners.min(0) < box.high + box.near).all() and (corners.max(0) > box.low - box.near).all())


def _box_round(feature, shape, size, room):
    """The Box of a feature: away from planes of the solid, or with sides in them."""
    solid = shape.solid
    sides = np.stack([np.cross(feature.up, feature.axis), feature.up])
    planes = [[float((c.origin - feature.origin) @ side) for c in shape.carriers.values()
               if c.kind == "Plane" and abs(c.axis @ side) > 1 - PLANE] for side in sides]
    scale = feature.scale
    beside = max((room - 1) * scale, min(APART * size, BROAD * scale) * (room == ROOMS[0]))
    low = np.array([-_side([-p for p in of_side], -end, scale, beside, BESIDE * size)
                    for of_side, end in zip(planes, feature.low)])
    high = np.array([_side(of_side, end, scale, beside, BESIDE * size) for of_side, end in zip(planes, feature.high)])
    along = feature.local(list(solid.vertex.values()))[:, 0]
    return Box(feature, low, high, (along.min() - solid.diagonal, along.max() + solid.diagonal), SAME * solid.diagonal)


def _side(planes, end, scale, beside, left):
    """Where a side of a box is, beside what ends there: away from planes beyond, or in one."""
    beyond = min((p for p in planes if p > end + LEAST * scale), default=np.inf)
    if beyond > end + beside + left:
        return end + beside
    return beyond - left if beyond - left > end + NARROW * scale else beyond


def intervals(length, size):
    """How many intervals a line on a box gets, on whichever side: so that both agree."""
    return max(1, int(np.floor(length / size + 0.5 - 1e-6)))       # a half goes the same way on both sides

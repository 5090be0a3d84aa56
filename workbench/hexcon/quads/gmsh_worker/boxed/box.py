# SPDX-License-Identifier: LGPL-2.1-or-later
"""A box round a cross feature: where its sides are, and how it is divided."""
from dataclasses import dataclass, field

import gmsh
import numpy as np

ROOMS = (1.6, 1.3)          # half widths of a box to try, in radii of the feature
NARROW, LEAST = 1.3, 1.04   # the least half width, and how near a plane may be, in radii
BROAD, APART = 2.5, 0.8     # the widest, in radii, and what of the size is to be beside a small feature
BESIDE = 0.6                # of the size: what is left between a box and a plane, at least, or nothing
PLANE = 1e-9                # of a normal, that is off


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


def box_round(feature, shape, size, room):
    """The Box of a feature: away from planes of the solid, or with sides in them; room: of ROOMS."""
    solid = shape.solid
    wide = max(room * feature.radius, min(feature.radius + APART * size, BROAD * feature.radius) * (room == ROOMS[0]))
    sides = np.stack([np.cross(feature.up, feature.axis), feature.up])
    planes = [[float((c.origin - feature.origin) @ side) for c in shape.carriers.values()
               if c.kind == "Plane" and abs(c.axis @ side) > 1 - PLANE] for side in sides]
    low = np.array([-_side([-p for p in of_side], feature.radius, wide, BESIDE * size) for of_side in planes])
    high = np.array([_side(of_side, feature.radius, wide, BESIDE * size) for of_side in planes])
    along = feature.local(list(solid.vertex.values()))[:, 0]
    return Box(feature, low, high, (along.min() - solid.diagonal, along.max() + solid.diagonal), 1e-6 * solid.diagonal)


def _side(planes, radius, wide, beside):
    """Where a side of a box is: away from planes beyond it, or in one."""
    beyond = min((p for p in planes if p > LEAST * radius), default=np.inf)
    if beyond > wide + beside:
        return wide
    return beyond - beside if beyond - beside > NARROW * radius else beyond


def intervals(length, size):
    """How many intervals a line on a box gets, on whichever side: so that both agree."""
    return max(1, int(np.floor(length / size + 0.5 - 1e-6)))       # a half goes the same way on both sides

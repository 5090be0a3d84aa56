# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each CAD face is along a direction: a cap over the material or under it, or a side."""
from enum import Enum

import numpy as np

from ..grid.carriers import surface_carrier
from ..grid.tessellation import Tessellation

PARALLEL = 1e-4         # sine of an angle below which a face is along a direction, or two axes are one
HANGING = 1e-3          # the same for caps that end along it, as fillets do


class Role(Enum):
    """UP: a cap with material below it; DOWN: with material above; SIDE: along the direction, or nearly; NONE: none."""

    UP = 1
    DOWN = -1
    SIDE = 0
    NONE = None


class Shape:
    """Normals and closed forms of a solid's faces, whatever the direction.

    carriers    CAD face -> grid.carriers.Carrier
    normals     CAD face -> (n,3) outward unit normals at places inside it
    volume      of the solid
    """

    def __init__(self, solid, size):
        self.solid = solid
        made = Tessellation(solid, max(size, solid.diagonal / 40.0))
        self.carriers = {f: surface_carrier(f, solid.diagonal) for f in solid.faces}
        self.volume = solid.exact_volume
        self.normals = {f: _normals(self.carriers[f], made, np.flatnonzero(made.face == f)) for f in solid.faces}

    def roles(self, direction, steep=PARALLEL):
        """{CAD face: Role}. steep: sine of the angle to the direction up to which a face is a side."""
        return {f: _role(n @ direction, steep) for f, n in self.normals.items()}

    def aslant(self, direction, roles):
        """The sides that are not along a direction."""
        return {f for f, n in self.normals.items()
                if roles[f] is Role.SIDE and np.abs(n @ direction).max() >= PARALLEL}

    def part(self, faces):
        """Of the area of all faces."""
        return sum(self.solid.area(f) for f in faces) / sum(self.solid.area(f) for f in self.solid.faces)

    def directions(self, most):
        """At most so many distinct unit axes (3,) of faces, those first that most area has."""
        axes, areas = [], []
        for face, carrier in self.carriers.items():
            if carrier.kind in ("other", "Sphere"):
                continue
            area = self.solid.area(face)
            same = [k for k, a in enumerate(axes) if abs(a @ carrier.axis) > 1.0 - PARALLEL ** 2]
            if same:
                areas[same[0]] += area
            else:
                axes.append(carrier.axis)
                areas.append(area)
        return [_upward(axes[k]) for k in sorted(range(len(axes)), key=lambda k: -areas[k])[:most]]


def _upward(axis):
    """The axis turned so that its greatest part is positive: results do not depend on how a file has it."""
    return axis if axis[np.argmax(np.round(np.abs(axis), 6))] > 0 else -axis


def _normals(carrier, made, rows):
    corners = made.points[made.triangles[rows]]
    outward = made.normals_at(rows)
    if carrier.kind == "Plane":
        return np.sign((outward @ carrier.axis).sum()) * carrier.axis[None]
    normals = carrier.project(corners.mean(1))[1]
    unknown = ~np.isfinite(normals).all(1)
    normals[unknown] = outward[unknown]
    return normals * np.where((normals * outward).sum(1) < 0.0, -1.0, 1.0)[:, None]


def _role(along, steep):
    if np.abs(along).max() < steep:
        return Role.SIDE
    if along.min() > -HANGING:
        return Role.UP
    if along.max() < HANGING:
        return Role.DOWN
    return Role.NONE

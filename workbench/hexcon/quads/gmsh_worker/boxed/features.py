# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cross features: faces that hang over, as seen along a direction, about axes that lie across it."""
from dataclasses import dataclass

import numpy as np

from ..layered.fault import NotLayered
from ..layered.roles import PARALLEL, Role

TURNED = ("Cylinder", "Cone", "Torus")
SAMPLES = 33        # of an edge: with its quarters, where a circle reaches farthest


@dataclass
class Feature:
    """axis, origin (3,): of its faces; up (3,): the layers' direction; faces; low, high (2,): where they end, across
    the axis and up from it."""

    axis: np.ndarray
    origin: np.ndarray
    up: np.ndarray
    faces: list
    low: np.ndarray = None
    high: np.ndarray = None

    @property
    def scale(self):
        """The radius of what is round."""
        return float((self.high - self.low).min() / 2)

    def local(self, points):
        """(n,3): along the axis, across it, up from it."""
        d = np.asarray(points, float).reshape(-1, 3) - self.origin
        return np.stack([d @ self.axis, d @ np.cross(self.up, self.axis), d @ self.up], 1)

    def place(self, local):
        """(n,3) points of local coordinates."""
        local = np.asarray(local, float).reshape(-1, 3)
        return self.origin + local @ np.stack([self.axis, np.cross(self.up, self.axis), self.up])


def features(shape, direction, roles):
    """[Feature] of the faces without a role. Raises NotLayered where one has no axis across the direction."""
    found = []
    for face in (f for f in shape.solid.faces if roles[f] is Role.NONE):
        carrier = shape.carriers[face]
        if carrier.kind not in TURNED or abs(carrier.axis @ direction) > PARALLEL:
            raise NotLayered(f"Face{face} hangs over, and is not round about an axis across the layers", [face])
        same = [g for g in found if _coaxial(g, carrier, shape.solid.diagonal)]
        if same:
            same[0].faces.append(face)
        else:
            found.append(Feature(carrier.axis, carrier.origin, direction, [face]))
    for feature in found:
        feature.low, feature.high = _reach(shape.solid, feature)
    return found


def together(feature, other):
    """Two features with parallel axes as one, about the first one's axis."""
    (y0, z0), (y1, z1) = other.low, other.high
    corners = feature.local(other.place([(0.0, y, z) for y in (y0, y1) for z in (z0, z1)]))[:, 1:]
    return Feature(feature.axis, feature.origin, feature.up, feature.faces + other.faces,
                   np.minimum(feature.low, corners.min(0)), np.maximum(feature.high, corners.max(0)))


def _coaxial(feature, carrier, scale):
    off = np.cross(carrier.origin - feature.origin, feature.axis)
    return abs(carrier.axis @ feature.axis) > 1.0 - PARALLEL ** 2 and np.linalg.norm(off) < 1e-6 * scale


def _reach(solid, feature):
    points = np.concatenate([solid.edge_points(e, np.linspace(0.0, 1.0, SAMPLES))
                             for face in feature.faces for e in solid.boundary[face]])
    local = feature.local(points)[:, 1:]
    return local.min(0), local.max(0)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The axis about which all faces of a solid are surfaces of revolution."""
from dataclasses import dataclass

import numpy as np

from ..fault import WorkerFault
from ..grid.carriers import curve_carrier, surface_carrier

SAMPLES = 17        # along an edge
PARALLEL = 1e-8     # sine of the angle between two axes that are one


@dataclass(frozen=True)
class Axis:
    """origin (3,), direction (3,) unit; across (2,3): unit vectors that make a right-handed frame before it."""

    origin: np.ndarray
    direction: np.ndarray
    across: np.ndarray

    @classmethod
    def through(cls, origin, direction, towards=None):
        """towards (3,): a point in whose direction from the axis the angle is 0."""
        direction = direction / np.linalg.norm(direction)
        side = np.eye(3)[np.argmin(np.abs(direction))] if towards is None else towards - origin
        side = side - (side @ direction) * direction
        side = side / np.linalg.norm(side)
        return cls(np.asarray(origin, float), direction, np.stack([side, np.cross(direction, side)]))

    def flat(self, points):
        """(radius, height) (m,2) and angle (m,) of points (m,3)."""
        rel = np.asarray(points, float) - self.origin
        x, y = rel @ self.across[0], rel @ self.across[1]
        return np.stack([np.hypot(x, y), rel @ self.direction], -1), np.arctan2(y, x)

    def place(self, flat, angle):
        """(m,3) points at (radius, height) (m,2) and angle (m,) or one number."""
        flat = np.asarray(flat, float).reshape(-1, 2)
        c, s = np.cos(angle), np.sin(angle)
        return (self.origin + (flat[:, 0] * c)[:, None] * self.across[0] + (flat[:, 0] * s)[:, None] * self.across[1]
                + flat[:, 1:] * self.direction)

    @property
    def word(self):
        """x, y, z, or the direction in figures."""
        k = int(np.argmax(np.abs(self.direction)))
        if abs(self.direction[k]) > 1.0 - 1e-12:
            return "xyz"[k]
        return "({:.3f}, {:.3f}, {:.3f})".format(*self.direction)


def axis_of(solid):
    """(Axis, {face: Carrier}). Raises WorkerFault NOT_REVOLVED, with the face that has none or another axis."""
    carriers = {f: surface_carrier(f, solid.diagonal) for f in solid.faces}
    found = _proposed(solid, carriers)
    if found is None:
        raise WorkerFault("NOT_REVOLVED", "no face or edge has an axis")
    axis = Axis.through(*found)
    for face, carrier in carriers.items():
        fault = _unlike(solid, axis, face, carrier)
        if fault:
            raise WorkerFault("NOT_REVOLVED", f"Face{face} {fault}", [face])
    return axis, carriers


def _proposed(solid, carriers):
    """(origin, direction) of the first face or edge that has an axis, the largest face first."""
    faces = sorted(carriers, key=lambda f: (-round(solid.area(f), 9), f))
    for face in faces:
        if carriers[face].kind in ("Cylinder", "Cone", "Torus"):
            return carriers[face].origin, carriers[face].axis
    centres = [carriers[f].origin for f in faces if carriers[f].kind == "Sphere"]
    planes = [carriers[f].axis for f in faces if carriers[f].kind == "Plane"]
    if centres:
        away = max((c - centres[0] for c in centres), key=np.linalg.norm)
        return centres[0], planes[0] if planes else away if np.linalg.norm(away) > solid.tolerance else np.eye(3)[2]
    for edge in (e for e in solid.edges if len(set(solid.faces_of[e])) == 2):
        carrier = curve_carrier(edge, solid.diagonal)
        if carrier.kind == "Circle":
            return carrier.origin, carrier.axis
        circle = _circle_through(solid.edge_points(edge, np.linspace(0.0, 1.0, SAMPLES)), solid.tolerance)
        if circle is not None:
            return circle
    return None


def _circle_through(points, tolerance):
    """(centre, normal) of a circle that all points lie on, None where there is none."""
    a, b, c = points[0], points[len(points) // 3], points[2 * len(points) // 3]
    u, v = b - a, c - a
    normal = np.cross(u, v)
    square = normal @ normal
    if square < 1e-12 * (u @ u) * (v @ v):
        return None
    centre = a + ((u @ u) * np.cross(v, normal) + (v @ v) * np.cross(normal, u)) / (2.0 * square)
    normal = normal / np.sqrt(square)
    rel = points - centre
    off = max(np.abs(rel @ normal).max(), np.ptp(np.linalg.norm(rel, axis=1)))
    return (centre, normal) if off < tolerance else None


def _unlike(solid, axis, face, carrier):
    """Why a face is no surface of revolution about the axis, in words; "" where it is one."""
    if carrier.kind == "other":
        return _freeform_fault(solid, axis, face)
    if carrier.kind != "Sphere" and np.linalg.norm(np.cross(carrier.axis, axis.direction)) > PARALLEL:
        return "is across the axis" if carrier.kind == "Plane" else "has another axis"
    if carrier.kind == "Plane":
        return ""
    off = axis.flat(carrier.origin[None])[0][0, 0]
    return f"has its axis {off:.3g} beside that of the others" if off > solid.tolerance else ""


def _freeform_fault(solid, axis, face):
    """Points of its edges, turned about the axis, must lie on the face's surface, which gmsh extends nowhere: so only
    turns that stay inside count, and a face must have some."""
    points = np.concatenate([solid.edge_points(e, np.linspace(0.05, 0.95, 7)) for e in solid.boundary[face]])
    flat, angle = axis.flat(points)
    worst = np.full(len(points), np.inf)
    for turn in (0.4, -0.4, 1.1, -1.1):
        moved = axis.place(flat, angle + turn)
        worst = np.minimum(worst, np.linalg.norm(solid.project(2, face, moved) - moved, axis=1))
    return "" if worst.max() <= solid.tolerance else "is no surface of revolution about the axis"

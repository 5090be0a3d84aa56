# SPDX-License-Identifier: LGPL-2.1-or-later
"""The half section of a body of revolution: one curve a band, in loops, and the pieces of the axis inside the body."""
from dataclasses import dataclass

import numpy as np

from ..fault import WorkerFault
from .bands import moments

FINE = 513          # points by which a curve's length and turning are measured
AGREES = 1e-4       # part of its area by which a curve, turned round, may differ from its band


@dataclass
class ProfileCurve:
    """The curve of one band, from `start` to `end`.

    band         number of the band, -1 for a core's line;  ends: numbers of vertices
    exact        callable: shares (m,) of the parameter -> (m,2) radius and height
    """

    band: int
    ends: tuple
    exact: object

    def __post_init__(self):
        self._t = np.linspace(0.0, 1.0, FINE)
        self.fine = self.exact(self._t)
        steps = np.diff(self.fine, axis=0)
        self._arc = np.concatenate([[0.0], np.cumsum(np.linalg.norm(steps, axis=1))])
        way = steps / np.maximum(np.linalg.norm(steps, axis=1, keepdims=True), 1e-300)
        bend = np.arctan2(way[:-1, 0] * way[1:, 1] - way[:-1, 1] * way[1:, 0], (way[1:] * way[:-1]).sum(1))
        self.turning = float(np.abs(bend).sum()) * (FINE - 1) / (FINE - 2)
        self.length = float(self._arc[-1])

    def at(self, fractions):
        """(m,2) points at fractions (m,) of its length."""
        return self.exact(np.interp(np.asarray(fractions, float) * self.length, self._arc, self._t))

    def tangent(self, at_end=False):
        """(2,) unit direction at its start, or at its end."""
        p = self.exact(np.array([1.0 - 1e-4, 1.0] if at_end else [0.0, 1e-4]))
        return (p[1] - p[0]) / max(np.linalg.norm(p[1] - p[0]), 1e-300)

    def part(self, first, last, ends):
        """The curve between two fractions of its length."""
        a, b = np.interp(np.array([first, last]) * self.length, self._arc, self._t)
        return ProfileCurve(self.band, ends, lambda t: self.exact(a + np.asarray(t, float) * (b - a)))

    def reversed(self):
        return ProfileCurve(self.band, self.ends[::-1], lambda t: self.exact(1.0 - np.asarray(t, float)))


@dataclass
class HalfSection:
    """vertices (k,2) radius and height; curves: list of ProfileCurve; tips: vertices on the axis, by height, two for
    each piece of the axis inside the body."""

    vertices: np.ndarray
    curves: list
    tips: list


def half_section(solid, axis, bands, carriers):
    """The HalfSection. Raises WorkerFault NOT_REVOLVED where a band's curve is not found or the curves do not close."""
    vertices, curves = [], []

    def vertex(place):
        for k, other in enumerate(vertices):
            if np.linalg.norm(place - other) <= 10 * solid.tolerance:
                return k
        vertices.append(np.array(place))
        return len(vertices) - 1
    for number, band in enumerate(bands):
        line = _line_of(solid, axis, band, carriers[band.faces[0]])
        ends = line(np.array([0.0, 1.0]))
        curves.append(ProfileCurve(number, (vertex(ends[0]), vertex(ends[1])), line))
    degree = np.bincount(np.ravel([c.ends for c in curves]), minlength=len(vertices))
    on_axis = np.array([v[0] <= 10 * solid.tolerance for v in vertices])
    if (degree[on_axis] != 1).any() or (degree[~on_axis] != 2).any() or on_axis.sum() % 2:
        raise WorkerFault("NOT_REVOLVED", "the faces' sections do not close: surfaces touch at the axis or in a circle")
    tips = sorted(np.flatnonzero(on_axis).tolist(), key=lambda v: vertices[v][1])
    return HalfSection(np.array(vertices), curves, tips)


def _line_of(solid, axis, band, carrier):
    """Callable t -> (m,2): of the lines that the band's section can be, the one with the band's area and middle."""
    wanted = moments(band, axis, solid)
    best = None
    for line in _LINES[band.kind](solid, axis, band, carrier):
        made = _turned_moments(line)
        off = max(abs(made[0] - wanted[0]), abs(made[1] - wanted[1]) / solid.diagonal) / max(wanted[0], 1e-300)
        if best is None or off < best[0]:
            best = off, line
    if best is None or not best[0] <= AGREES:
        raise WorkerFault("NOT_REVOLVED", f"Face{band.faces[0]} is not a full turn of its section", band.faces)
    return best[1]


def _turned_moments(line):
    """(area, integral of height) of a line turned round the axis."""
    p = line(np.linspace(0.0, 1.0, 4 * FINE))
    step, middle = np.linalg.norm(np.diff(p, axis=0), axis=1), (p[1:] + p[:-1]) / 2
    area = 2 * np.pi * middle[:, 0] * step
    return np.array([area.sum(), (area * middle[:, 1]).sum()])


def straight(a, b):
    """Callable t -> (m,2) on a line."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    return lambda t: a + np.asarray(t, float)[:, None] * (b - a)


def _arc(centre, radius, start, end):
    centre = np.asarray(centre, float)

    def points(t):
        angle = start + np.asarray(t, float) * (end - start)
        return centre + radius * np.stack([np.cos(angle), np.sin(angle)], -1)
    return points


def _from_axis(line):
    """Poles are on the axis, whatever the rounding of the cosine."""
    return lambda t: np.maximum(line(t), [0.0, -np.inf])


def _flat_lines(solid, axis, band, carrier):
    """Of a cylinder or a plane: between two rims; of a plane also from its rim to the axis."""
    if len(band.rims) == 2:
        return [straight(*band.rims)]
    if len(band.rims) == 1 and band.kind == "Plane":
        return [straight((0.0, band.rims[0][1]), band.rims[0])]
    return []


def _cone_lines(solid, axis, band, carrier):
    apex = axis.flat(carrier.origin[None])[0][0]
    return [straight(*band.rims)] if len(band.rims) == 2 else [straight((0.0, apex[1]), band.rims[0])] \
        if len(band.rims) == 1 else []


def _sphere_lines(solid, axis, band, carrier):
    """Between two rims; from a rim to either pole; from pole to pole."""
    height = axis.flat(carrier.origin[None])[0][0, 1]
    latitudes = [float(np.arctan2(z - height, r)) for r, z in band.rims]
    poles = [-np.pi / 2, np.pi / 2]
    pairs = {2: [latitudes], 1: [latitudes + [pole] for pole in poles], 0: [poles]}[len(latitudes)]
    return [_from_axis(_arc((0.0, height), carrier.radius, *pair)) for pair in pairs]


def _torus_lines(solid, axis, band, carrier):
    """Either way round from rim to rim, or all round."""
    centre = np.array([carrier.radius, axis.flat(carrier.origin[None])[0][0, 1]])
    angles = [float(np.arctan2(*(np.asarray(rim) - centre)[::-1])) for rim in band.rims]
    if len(angles) == 2:
        gap = (angles[1] - angles[0]) % (2 * np.pi)
        return [_arc(centre, carrier.minor, angles[0], angles[0] + g) for g in (gap, gap - 2 * np.pi)]
    start = angles[0] if angles else -np.pi / 2
    return [_arc(centre, carrier.minor, start, start + 2 * np.pi)]


def _meridian_lines(solid, axis, band, carrier):
    """Of a freeform band: its first meridian."""
    return [lambda t, edge=edge: axis.flat(solid.edge_points(edge, t))[0] for edge in band.meridians[:1]]


_LINES = {"Plane": _flat_lines, "Cylinder": _flat_lines, "Cone": _cone_lines, "Sphere": _sphere_lines,
          "Torus": _torus_lines, "other": _meridian_lines}

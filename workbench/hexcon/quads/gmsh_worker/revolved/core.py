# SPDX-License-Identifier: LGPL-2.1-or-later
"""The core of a turned body: where it reaches its axis, a pile of discs takes the place of what would be turned.

Along each piece of the axis inside the body a *core line* runs through the half section, from the curve that ends in
the piece's lower tip to the one that ends in its upper tip.
"""
from dataclasses import dataclass

import numpy as np

from ..fault import WorkerFault
from ..plane.region import PlaneRegion
from ..smooth import optimise
from ..templates import ogrid_mesh
from .half_section import HalfSection, ProfileCurve, straight

SHARE = 0.55        # of the curve at a tip, from the tip on, is the core's; less where that is too near to other curves
SHARE_OF_ONE = 0.3  # where both tips end one curve
CLEAR = 0.4         # of the core's radius: how near other curves may come
SHRINK, SHRINKS = 0.75, 12
POINTED = 0.1       # sine of the slope at a tip, above which it is a point of the mesh


@dataclass
class Core:
    """line: number of its ProfileCurve in the section, upwards; low, high: ProfileCurves from the tips to its ends."""

    line: int
    low: ProfileCurve
    high: ProfileCurve

    @property
    def pointed(self):
        """Whether the body has a point at a tip."""
        return any(abs(c.tangent()[1]) > POINTED for c in (self.low, self.high))


def with_cores(section):
    """(HalfSection without its pieces near the axis but with core lines, list of Core).

    Raises WorkerFault NOT_REVOLVED where no straight core line keeps clear of other curves.
    """
    vertices, curves, cores = [*section.vertices], list(section.curves), []
    for low, high in zip(section.tips[::2], section.tips[1::2]):
        pieces = _shares(section, low, high)
        ends = []
        for tip, share in pieces:
            number = next(k for k, c in enumerate(curves) if tip in c.ends)
            curve = curves[number] if curves[number].ends[0] == tip else curves[number].reversed()
            vertices.append(curve.at([share])[0])
            ends.append(curve.part(0.0, share, (tip, len(vertices) - 1)))
            curves[number] = curve.part(share, 1.0, (len(vertices) - 1, curve.ends[1]))
        a, b = (end.ends[1] for end in ends)
        curves.append(ProfileCurve(-1, (a, b), straight(vertices[a], vertices[b])))
        cores.append(Core(len(curves) - 1, *ends))
    return HalfSection(np.array(vertices), curves, []), cores


def _shares(section, low, high):
    """[(tip, share of the curve that ends there)] for both, as large as keeps clear of the other curves."""
    ends = [next(c for c in section.curves if tip in c.ends) for tip in (low, high)]
    away = [c if c.ends[0] == tip else c.reversed() for c, tip in zip(ends, (low, high))]
    others = [c.fine for c in section.curves if not any(c is end for end in ends)]
    share = SHARE_OF_ONE if ends[0] is ends[1] else SHARE
    for _ in range(SHRINKS):
        a, b = (curve.at([share])[0] for curve in away)
        if _is_clear(a, b, np.concatenate(others) if others else np.empty((0, 2))):
            # the second share is one of what the first has left of the curve that both end
            second = share / (1.0 - share) if ends[0] is ends[1] else share
            return [(low, share), (high, second)]
        share *= SHRINK
    raise WorkerFault("NOT_REVOLVED", "other faces come too near to the axis")


def _is_clear(a, b, points):
    """Whether points (m,2) beside the line from a to b are outside of it by CLEAR of its radius there."""
    if b[1] <= a[1]:
        return False
    t = (points[:, 1] - a[1]) / (b[1] - a[1])
    beside = (t > 0.0) & (t < 1.0)
    line = a[0] + t * (b[0] - a[0])
    return bool((points[beside, 0] > (1.0 + CLEAR) * line[beside]).all())


def disc(around):
    """(points (m,2), quads) of the unit disc, its `around` points on the circle first, the first at angle 0.

    around: a multiple of four; with a point in the middle where it is one of eight.
    """
    angle = 2 * np.pi * np.arange(around) / around
    circle = np.stack([np.cos(angle), np.sin(angle)], -1)
    region = PlaneRegion([circle], [np.zeros(around)])
    points, quads = ogrid_mesh(region.outline(2 * np.pi / around), [np.ones(around, int)], circle)
    points = optimise(points, quads, np.arange(len(points)) < around)
    points[np.argmin(np.linalg.norm(points, axis=1))] *= around % 8 != 0
    return points, quads

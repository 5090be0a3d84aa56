# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two problems of elasticity with known answers: a thick pipe (Lame), a plate with a hole (Kirsch)."""
from dataclasses import dataclass

import numpy as np
from bodies import quarter_pipe, quarter_plate

YOUNG = 210000.0
NEAR = 1e-6


@dataclass
class Problem:
    """make: draws the body, by gmsh's occ; sizes: of elements; held: [(axis, place)] planes that do not move across.

    moved(points (n,3)) -> (n,3); stress(points) -> (n,6) as CalculiX orders it: xx, yy, zz, xy, yz, zx
    loaded(corners (n,k,3)) -> (n,) which facets have the exact stress as their load; outwards(points (n,3)) -> (n,3):
    that way out of the body there;  peak(points) -> (n,) where the greatest stress is looked at
    """
    make: object
    sizes: tuple
    poisson: float
    held: tuple
    moved: object
    stress: object
    loaded: object
    outwards: object
    peak: object


def _turned(points, across, along, beside, shear):
    """(n,6) in x, y, z of stresses across the radius' circles, along them, beside the plane, and of shear."""
    c, s = (points[:, :2] / np.hypot(*points[:, :2].T)[:, None]).T
    zero = 0 * c
    return np.column_stack([across * c * c + along * s * s - 2 * shear * s * c,
                            across * s * s + along * c * c + 2 * shear * s * c, beside + zero,
                            (across - along) * s * c + shear * (c * c - s * s), zero, zero])


INNER, OUTER, PRESSURE, LAME = 5.0, 10.0, 100.0, 0.3
_RATIO = PRESSURE * INNER ** 2 / (OUTER ** 2 - INNER ** 2)


def _pipe_moved(points):
    radius = np.hypot(*points[:, :2].T)
    out = (1 + LAME) / YOUNG * _RATIO * ((1 - 2 * LAME) * radius + OUTER ** 2 / radius)
    return points * (1, 1, 0) * (out / radius)[:, None]


def _pipe_stress(points):
    bend = (OUTER / np.hypot(*points[:, :2].T)) ** 2
    return _turned(points, _RATIO * (1 - bend), _RATIO * (1 + bend), 2 * LAME * _RATIO, 0 * bend)


HOLE, SIDE, PULL = 5.0, 20.0, 100.0     # Poisson's ratio 0: there plane stress is exact in three dimensions


def _plate_stress(points):
    bend, angle = (HOLE / np.hypot(*points[:, :2].T)) ** 2, np.arctan2(points[:, 1], points[:, 0])
    two = np.cos(2 * angle)
    return _turned(points, PULL / 2 * (1 - bend + (1 - 4 * bend + 3 * bend ** 2) * two),
                   PULL / 2 * (1 + bend - (1 + 3 * bend ** 2) * two), 0.0,
                   -PULL / 2 * (1 + 2 * bend - 3 * bend ** 2) * np.sin(2 * angle))


def _plate_moved(points):
    """Of Poisson's ratio 0: the integrals of the strains."""
    radius, angle = np.hypot(*points[:, :2].T), np.arctan2(points[:, 1], points[:, 0])
    bend = (HOLE / radius) ** 2
    out = PULL / (2 * YOUNG) * radius * (1 + bend + (1 + 4 * bend - bend ** 2) * np.cos(2 * angle))
    round_ = -PULL / (2 * YOUNG) * radius * (1 + 2 * bend + bend ** 2) * np.sin(2 * angle)
    c, s = np.cos(angle), np.sin(angle)
    return np.column_stack([out * c - round_ * s, out * s + round_ * c, 0 * out])


def _largest_axis(points):
    return np.eye(3)[np.argmax(points[:, :2], axis=1)]


PROBLEMS = {
    "thick pipe": Problem(
        quarter_pipe, (4.0, 2.0, 1.0, 0.5), LAME, ((0, 0.0), (1, 0.0), (2, 0.0), (2, 2.0)), _pipe_moved, _pipe_stress,
        lambda corners: (np.abs(np.hypot(corners[..., 0], corners[..., 1]) - INNER) < NEAR).all(axis=1),
        lambda points: -points * (1, 1, 0),
        lambda points: np.abs(np.hypot(*points[:, :2].T) - INNER) < 1e-3),
    "plate with a hole": Problem(
        quarter_plate, (6.0, 3.0, 1.5, 0.75), 0.0, ((0, 0.0), (1, 0.0), (2, 0.0)), _plate_moved, _plate_stress,
        lambda corners: (np.abs(corners[..., :2] - SIDE) < NEAR).all(axis=1).any(axis=1), _largest_axis,
        lambda points: (points[:, 0] < NEAR) & (points[:, 1] < HOLE + NEAR))}

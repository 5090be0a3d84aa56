# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random solids that are sweeps, by seed: nothing was tuned for them. Needs FreeCAD."""
import math

import numpy as np
from quads_solids import Part, Vector, prism


def _polygon(rng, corners, radius, jitter, z=0.0):
    """Corners on a circle, their angles moved by up to jitter of a step."""
    steps = np.arange(corners) + rng.uniform(-jitter, jitter, corners)
    return [(radius * math.cos(a), radius * math.sin(a), z)
            for a in 2 * math.pi * steps / corners]


def frustum(rng):
    """A cone or a pyramid of 3 to 8 sides, cut at 0.3 to 1 of its base."""
    ratio, radius, height = rng.uniform(0.3, 1.0), rng.uniform(3, 10), rng.uniform(3, 20)
    sides = int(rng.integers(2, 9))
    if sides == 2:
        return Part.makeCone(radius, ratio * radius, height), 0.3 * radius
    base = _polygon(rng, sides, radius, 0.2)
    top = [(ratio * x, ratio * y, height) for x, y, _ in base]
    wires = [Part.makePolygon([Vector(*p) for p in ring + ring[:1]]) for ring in (base, top)]
    return Part.makeLoft(wires, True, True), rng.uniform(0.15, 0.4) * radius


def prism_of_ngon(rng):
    """3 to 9 sides, angles uneven, of any height."""
    radius, height = rng.uniform(2, 10), rng.uniform(1, 30)
    base = _polygon(rng, int(rng.integers(3, 10)), radius, 0.2)
    return prism(base, (0, 0, height)), rng.uniform(0.1, 0.5) * radius


def sheared_prism(rng):
    """An n-gon pulled along a direction up to 30 degrees off its normal."""
    radius, height = rng.uniform(3, 10), rng.uniform(4, 20)
    slope, turn = math.tan(math.radians(rng.uniform(0, 30))), rng.uniform(0, 2 * math.pi)
    base = _polygon(rng, int(rng.integers(3, 8)), radius, 0.2)
    shift = (slope * height * math.cos(turn), slope * height * math.sin(turn), height)
    return prism(base, shift), rng.uniform(0.15, 0.4) * radius


def holed_plate(rng):
    """A plate with 1 to 4 round holes wherever they have room."""
    length, width, thickness = rng.uniform(20, 60), rng.uniform(15, 40), rng.uniform(2, 8)
    plate, holes = Part.makeBox(length, width, thickness), []
    wanted = int(rng.integers(1, 5))
    for _ in range(200):
        radius = rng.uniform(1.5, 5)
        if min(length, width) < 2 * radius + 3:
            continue
        x, y = rng.uniform(radius + 1, length - radius - 1), rng.uniform(radius + 1,
                                                                         width - radius - 1)
        if len(holes) < wanted and all(math.hypot(x - a, y - b) > radius + r + 1
                                       for a, b, r in holes):
            holes.append((x, y, radius))
            plate = plate.cut(Part.makeCylinder(radius, thickness, Vector(x, y, 0)))
    return plate, rng.uniform(1.5, 4)


KINDS = {"frustum": frustum, "prism": prism_of_ngon, "sheared": sheared_prism,
         "plate": holed_plate}


def random_solid(kind, seed):
    """(shape, size) of one of KINDS."""
    return KINDS[kind](np.random.default_rng([list(KINDS).index(kind), seed]))

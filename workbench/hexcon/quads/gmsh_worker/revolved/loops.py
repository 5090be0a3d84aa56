# SPDX-License-Identifier: LGPL-2.1-or-later
"""The curves of a half section in loops: the outer one counter-clockwise, holes clockwise."""
import numpy as np

from ..fault import WorkerFault
from ..plane_mesh import polygon_area


class Loops:
    """loops: list of lists of (number of the curve, ProfileCurve in the loop's sense); the outer one first."""

    def __init__(self, section):
        self.section = section
        self.loops = [_oriented(loop) for loop in _traced(section)]
        self.loops.sort(key=lambda loop: -abs(_area(loop)))
        self.loops[1:] = [[(k, c.reversed()) for k, c in reversed(loop)] for loop in self.loops[1:]]

    def place(self, shares):
        """list of (N,2) points at shares of each curve's length, per loop and curve; vertices as they are."""
        placed = []
        for loop, own in zip(self.loops, shares):
            parts = [c.at(s) for (_, c), s in zip(loop, own)]
            for part, (_, c) in zip(parts, loop):
                part[0] = self.section.vertices[c.ends[0]]
            placed.append(np.concatenate(parts))
        return placed

    def volume(self, shares, cores):
        """Of the section's polygon turned round: what the mesh would have with many quads round (Pappus)."""
        total = 0.0
        for loop, parts, points in zip(self.loops, shares, self.place(shares)):
            own = np.repeat([c.band >= 0 for _, c in loop], [len(s) for s in parts])
            total += _frusta(points[own], np.roll(points, -1, axis=0)[own])
        return total + sum(_frusta(c.low.fine[:-1], c.low.fine[1:]) - _frusta(c.high.fine[:-1], c.high.fine[1:])
                           for c in cores)


def _frusta(a, b):
    """Signed volume under the cones that lines from a (m,2) to b (m,2) sweep round the axis."""
    (r, z), (s, w) = a.T, b.T
    return np.pi / 3 * float(((r * r + r * s + s * s) * (w - z)).sum())


def _traced(section):
    left, loops = list(enumerate(section.curves)), []
    while left:
        loop = [left.pop(0)]
        while loop[-1][1].ends[1] != loop[0][1].ends[0]:
            here = loop[-1][1].ends[1]
            found = next((k for k, (_, c) in enumerate(left) if here in c.ends), None)
            if found is None:
                raise WorkerFault("NOT_REVOLVED", "the section's curves do not close")
            number, curve = left.pop(found)
            loop.append((number, curve if curve.ends[0] == here else curve.reversed()))
        loops.append(loop)
    return loops


def _area(loop):
    return polygon_area(np.concatenate([c.fine[:-1] for _, c in loop]))


def _oriented(loop):
    return loop if _area(loop) > 0 else [(k, c.reversed()) for k, c in reversed(loop)]

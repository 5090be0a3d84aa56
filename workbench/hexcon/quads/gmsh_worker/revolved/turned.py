# SPDX-License-Identifier: LGPL-2.1-or-later
"""From quads of the half section to the quads and hexes of the body."""
import numpy as np

from .core import disc


class Turned:
    """points (P,3), hexes (H,8) in VTK order, quads (n,4) outward, bands (n,): number of each quad's Band,
    middles (n,): angle of each quad's middle, NaN on a core."""

    def __init__(self, axis, around, flat, plane_quads, sides, cores):
        """flat (m,2) radius and height; plane_quads counter-clockwise; around: number round.

        sides  (start (s,), end (s,), band (s,)): the section's boundary intervals, the body on the left, but core lines
        cores  list of (Core, ids (k,) of its line's points upwards, low band, high band)
        """
        self.axis, self.around, self.flat = axis, around, flat
        self.points, self.hexes = [self._rings()], []
        self._count, self._quads, self._bands, self._middles = around * len(flat), [], [], []
        self._turn(plane_quads, sides)
        if cores:
            made = disc(around)
            for core in cores:
                self._pile(*core, *made)
        self.points, self.hexes = np.concatenate(self.points), np.concatenate(self.hexes)
        self.quads, self.bands = np.concatenate(self._quads), np.concatenate(self._bands)
        self.middles = np.concatenate(self._middles)

    def _rings(self):
        """Section after section; the first at angle 0."""
        angle = np.repeat(2 * np.pi * np.arange(self.around) / self.around, len(self.flat))
        return self.axis.place(np.tile(self.flat, (self.around, 1)), angle)

    def _turn(self, plane_quads, sides):
        m, n = len(self.flat), self.around
        here = (np.arange(n) * m)[:, None, None]
        there = ((np.arange(n) + 1) % n * m)[:, None, None]
        # radius x height points backwards round the axis, so the section ahead is the hex's lower face
        self.hexes.append(np.concatenate([plane_quads + there, plane_quads + here], axis=2).reshape(-1, 8))
        start, end, band = sides
        a, b = here[:, :, 0], there[:, :, 0]
        self._quads.append(np.stack([a + start, b + start, b + end, a + end], -1).reshape(-1, 4))
        self._bands.append(np.tile(band, n))
        self._middles.append(np.repeat(2 * np.pi * (np.arange(n) + 0.5) / n, len(start)))

    def _pile(self, core, ids, low_band, high_band, points, quads):
        """Discs from the core's lower end to its upper one, through the points of its line."""
        n, radius = self.around, np.linalg.norm(points, axis=1)
        angle = np.arctan2(points[:, 1], points[:, 0])
        low, high = core.low.at(radius), core.high.at(radius)
        heights = self.flat[ids, 1]
        layers = []
        for k, t in enumerate((heights - heights[0]) / (heights[-1] - heights[0])):
            inner = ((1.0 - t) * low + t * high)[n:]
            self.points.append(self.axis.place(inner, angle[n:]))
            own = self._count + np.arange(len(inner))
            self._count += len(inner)
            layers.append(np.concatenate([np.arange(n) * len(self.flat) + ids[k], own]))
        for below, above in zip(layers, layers[1:]):
            self.hexes.append(np.concatenate([below[quads], above[quads]], axis=1))
        for layer, turned, band in ((layers[0], -1, low_band), (layers[-1], 1, high_band)):
            self._quads.append(layer[quads[:, ::turned]])
            self._bands.append(np.full(len(quads), band))
            middle = points[quads].mean(axis=1)
            self._middles.append(np.arctan2(middle[:, 1], middle[:, 0]))

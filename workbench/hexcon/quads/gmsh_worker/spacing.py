# SPDX-License-Identifier: LGPL-2.1-or-later
"""Intervals along a curve, as long as sizes by place want them beside each other."""
import numpy as np

from .outline import TURN_OPEN

SAME = 1e-9         # part by which sizes differ that are one
STATIONS = np.arange(65) / 64       # shares of an edge at which sizes are asked for


class Spacing:
    """Along a curve. wanted: number of intervals (float)."""

    def __init__(self, shares, line, sizes):
        """shares (n,) of its length, evenly from 0 to 1; line (n,2 or 3), sizes (n,) there."""
        self._shares, self._even = shares, bool(np.ptp(sizes) <= SAME * sizes.max())
        density = length_of(line) / sizes
        if not self._even:      # where it is coarse it may not turn too much
            density = np.maximum(density, _turning(line) / TURN_OPEN)
        self._sums = np.concatenate([[0.0], np.cumsum((density[1:] + density[:-1]) / 2 * np.diff(shares))])
        self.wanted = float(self._sums[-1])

    def stops(self, count):
        """(count + 1,) shares between which that many intervals lie, each as long as the others beside the sizes."""
        even = np.arange(count + 1) / count
        return even if self._even else np.interp(even * self._sums[-1], self._sums, self._shares)


def spacing_of(field, stations):
    """The Spacing of a curve by a SizeField, which several places want for each station: the least size counts.

    stations: list of (n,3) evenly along it; the first is the curve
    """
    sizes = np.min([field(points) for points in stations], axis=0)
    return Spacing(np.arange(len(sizes)) / (len(sizes) - 1), stations[0], sizes)


def length_of(line):
    """Of a polygon (n,2 or 3)."""
    return float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum())


def _turning(line):
    """(n,) radians by which a line of even steps turns there, for all of its length."""
    way = np.diff(line, axis=0)
    way = way / np.maximum(np.linalg.norm(way, axis=1, keepdims=True), 1e-300)
    turn = 2.0 * np.arcsin(np.clip(np.linalg.norm(np.diff(way, axis=0), axis=1) / 2.0, 0.0, 1.0))
    return np.concatenate([turn[:1], turn, turn[-1:]]) * len(way)

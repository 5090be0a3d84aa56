# SPDX-License-Identifier: LGPL-2.1-or-later
"""The outline of a cap in its plane, and how many intervals its edges are to have."""
from dataclasses import dataclass

import numpy as np

CORNER = np.radians(25.0)          # a vertex that turns more is a corner
TURN_CLOSED = np.radians(30.0)     # largest turning per interval on a full circle: 12 a circle
TURN_OPEN = np.radians(45.0)       # the same on an open arc
LARGEST = 1.8       # times the wanted size: longer is no interval of a lattice for the sake of others


@dataclass
class Outline:
    """Loops of a cap: the outer one first and counter-clockwise, holes clockwise.

    desired[l]   (k,) float: ideal interval count of each edge of loop l
    least[l]     (k,) int: smallest count that still follows the edge
    turn[l]      (k,) float: angle in radians by which the outline turns left at the start of each edge, on the cap
                 where it turns less
    direction[l] (k,) float: angle in radians of the outline at the start of each edge
    place        callable: shares -> list of (N,2) boundary points per loop; shares: list per loop of list per edge of
                 (n,) parts of its length at which its intervals begin, the first 0 (see even)
    place_top    callable: the same for the other cap, in its own plane
    size         wanted edge length
    spacing      per loop and edge a spacing.Spacing, where sizes differ by place; None: intervals are even
    """
    desired: list
    least: list
    turn: list
    direction: list
    place: object
    place_top: object
    size: float
    spacing: "list | None" = None

    def divided(self, counts):
        """Shares, for counts per loop and edge."""
        if self.spacing is None:
            return even(counts)
        return [[own.stops(n)[:-1] for own, n in zip(loop, c)] for loop, c in zip(self.spacing, counts)]

    def corners(self, loop=0):
        """Edge numbers of a loop that start at a corner."""
        return np.flatnonzero(np.abs(self.turn[loop]) > CORNER)

    def limit(self):
        """The scaled Jacobian no all-quad mesh can exceed."""
        return sharpest_sine(self.turn)


def sharpest_sine(turns):
    """Sine of the sharpest corner, 1 where none is sharper than a right angle. turns: radians per loop and corner."""
    sharp = [np.pi - t for turn in turns for t in turn if t > np.pi / 2]
    return float(np.sin(min(sharp))) if sharp else 1.0


def even(counts):
    """Shares of equal intervals, for counts per loop and edge."""
    return [[np.arange(n) / n for n in c] for c in counts]


def least_count(turning, closed):
    """Smallest interval count of an edge with this total turning in radians."""
    if closed:
        return max(3, int(np.ceil(turning / TURN_CLOSED - 0.05)))
    return max(1, int(np.ceil(turning / TURN_OPEN - 0.05)))


def rounded(desired, least):
    """Integer counts nearest to the desired ones."""
    return np.maximum(np.rint(desired).astype(int), least)


def with_total(desired, least, total, step=1):
    """Counts with the given sum, multiples of `step`, as near to desired as can be; None if least forbids it."""
    counts = step * np.maximum(np.rint(np.asarray(desired) / step), np.ceil(np.asarray(least) / step)).astype(int)
    lowest = step * np.ceil(np.asarray(least) / step).astype(int)
    while counts.sum() != total:
        if counts.sum() < total:
            k = int(np.argmin(_cost(counts + step, desired) - _cost(counts, desired)))
            counts[k] += step
        else:
            change = _cost(counts - step, desired) - _cost(counts, desired)
            change[counts - step < lowest] = np.inf
            k = int(np.argmin(change))
            if not np.isfinite(change[k]):
                return None
            counts[k] -= step
        if abs(counts.sum() - total) % step:
            return None
    return counts


def balanced(desired, least, first, second):
    """Counts for which the sum over edges `first` equals that over `second` (bool masks)."""
    counts = rounded(desired, least)
    while counts[first].sum() != counts[second].sum():
        small, large = (first, second) if counts[first].sum() < counts[second].sum() else (second, first)
        grow = np.where(small, _cost(counts + 1, desired) - _cost(counts, desired), np.inf)
        shrink = np.where(large & (counts > least), _cost(counts - 1, desired) - _cost(counts, desired), np.inf)
        if shrink.min() < grow.min():
            counts[int(np.argmin(shrink))] -= 1
        else:
            counts[int(np.argmin(grow))] += 1
    return counts


def _cost(counts, desired):
    """How bad a count is: squared logarithm of the ratio, weighted by length."""
    desired = np.maximum(np.asarray(desired, float), 0.05)
    return desired * np.log(np.maximum(counts, 0.1) / desired) ** 2

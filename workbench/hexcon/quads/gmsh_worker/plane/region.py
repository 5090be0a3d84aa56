# SPDX-License-Identifier: LGPL-2.1-or-later
"""A region of a plane with points on its boundary."""
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..outline import CORNER, Outline, sharpest_sine
from ..plane_mesh import polygon_area


@dataclass(frozen=True)
class PlaneRegion:
    """What is to be meshed, and what may not be changed.

    loops  list of (N,2) float64 points: the outer loop first and counter-clockwise, holes clockwise; the first point
           of a loop is not repeated at its end. A quad mesh needs an even number of points in all.
    turns  list of (N,): radians by which the outline turns left at each point, 0 where it is smooth there, however
           coarsely it is divided. None: what the polygon turns by, if that is more than a corner's least.
    """

    loops: list
    turns: "list | None" = None

    def __post_init__(self):
        loops = [np.asarray(loop, float).reshape(-1, 2) for loop in self.loops]
        turns = self.turns if self.turns is not None else [_corners_of(loop) for loop in loops]
        object.__setattr__(self, "loops", loops)
        object.__setattr__(self, "turns", [np.asarray(t, float) for t in turns])

    @cached_property
    def boundary(self):
        """(sum N, 2) all points, loop after loop."""
        return np.concatenate(self.loops)

    @cached_property
    def after(self):
        """(sum N,) the next point of each along its loop."""
        sizes = np.array([len(loop) for loop in self.loops])
        starts = np.concatenate([[0], np.cumsum(sizes)[:-1]])
        return np.concatenate([s + (np.arange(n) + 1) % n for s, n in zip(starts, sizes)])

    @cached_property
    def corners(self):
        """Per loop the rows of points where it has a corner."""
        return [np.flatnonzero(np.abs(t) > CORNER) for t in self.turns]

    @cached_property
    def area(self):
        """Of the polygon, less its holes."""
        return sum(polygon_area(loop) for loop in self.loops)

    @cached_property
    def limit(self):
        """The scaled Jacobian that no quad mesh can exceed: of the polygon, whose corners are blunter than cusps."""
        return sharpest_sine([_turns_of(loop)[rows] for loop, rows in zip(self.loops, self.corners)])

    def outline(self, size):
        """The Outline of which each edge is one interval of this boundary. size: wanted edge length inside."""
        ways = [np.roll(loop, -1, axis=0) - loop for loop in self.loops]
        ones = [np.ones(len(loop), int) for loop in self.loops]
        return Outline([one.astype(float) for one in ones], ones, self.turns,
                       [np.arctan2(w[:, 1], w[:, 0]) for w in ways], lambda shares: self.loops, None, size)


def _turns_of(loop):
    """(N,) left turn of a polygon at its points."""
    ahead = np.roll(loop, -1, axis=0) - loop
    heading = np.arctan2(ahead[:, 1], ahead[:, 0])
    return (heading - np.roll(heading, 1) + np.pi) % (2 * np.pi) - np.pi


def _corners_of(loop):
    """(N,) the same, 0 where that is no corner."""
    turn = _turns_of(loop)
    return np.where(np.abs(turn) > CORNER, turn, 0.0)

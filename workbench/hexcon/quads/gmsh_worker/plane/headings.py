# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which way each piece of an outline runs in a square lattice, and where it turns there.

A *run* is a part of a loop that follows one direction of the lattice, however it bends: an L with a rounded corner has
six, a round hole has four. Submapping (Whiteley, White, Benzley and Blacker 1996) asks the same of corners alone.
"""
from dataclasses import dataclass

import numpy as np

RIGHT = np.pi / 2


@dataclass(frozen=True)
class Run:
    """loop, heading (0: along the frame's x, 1: y, 2, 3); segments (k,): of the loop, in order; hard: whether it begins
    at a corner of the outline, so that no point may be moved over its start.

    place     the frame's y of a run along x, x of one along y: mean by length;  low, high: its extent along itself
    ends      (k,2) where each segment begins and ends along the run, the lesser first
    """

    loop: int
    heading: int
    segments: np.ndarray
    hard: bool
    place: float
    low: float
    high: float
    ends: np.ndarray


def frame_of(loops):
    """Angle in radians from 0 to a quarter turn in which most of the outline's length runs straight along axes."""
    ways = np.concatenate([np.roll(p, -1, axis=0) - p for p in loops])
    way = ways[:, 0] + 1j * ways[:, 1]
    length = np.abs(way)
    total = (length * (way / np.maximum(length, 1e-300)) ** 4).sum()
    return float(np.angle(total) / 4) if abs(total) > 1e-9 * length.sum() else 0.0


def runs_of(loops, corner):
    """list of lists of Run, None where a loop turns back on itself or never turns.

    loops   list of (N,2) points in the frame;  corner: list of (N,) bool, whether the outline has a corner at a point
    """
    found = []
    for number, (points, hard) in enumerate(zip(loops, corner)):
        headings = _quantised(points)
        before = np.roll(headings, 1)
        before[0] += _closing(headings)
        change = np.flatnonzero(headings != before)
        if len(change) < 4 or _steps(headings, change) is None:
            return None
        ends = np.append(change[1:], change[0] + len(points))
        found.append([_run(points, number, int(headings[a]) % 4, np.arange(a, b) % len(points), bool(hard[a]))
                      for a, b in zip(change, ends)])
    return found


def _quantised(points):
    """(N,) direction of each segment in quarter turns, not reduced: they add up along the loop."""
    way = np.roll(points, -1, axis=0) - points
    angle = np.arctan2(way[:, 1], way[:, 0])
    turn = (np.diff(angle) + np.pi) % (2 * np.pi) - np.pi
    unwrapped = angle[0] + np.concatenate([[0.0], np.cumsum(turn)])
    return np.floor(unwrapped / RIGHT + 0.5 - 1e-6).astype(int)


def _closing(headings):
    """What the first heading is more than if the loop went on after the last: 4 or -4 a full turn."""
    return int(4 * np.rint((headings[0] - headings[-1]) / 4.0))


def _steps(headings, change):
    """(runs,) by how much each run turns against the one before; None unless all are 1 or -1."""
    at = headings[change]
    steps = (at - np.roll(at, 1) + 2) % 4 - 2
    return steps if (np.abs(steps) == 1).all() else None


def _run(points, loop, heading, segments, hard):
    ends = points[segments], points[(segments + 1) % len(points)]
    across = 1 - heading % 2
    length = np.linalg.norm(ends[1] - ends[0], axis=1)
    middle = (ends[0][:, across] + ends[1][:, across]) / 2
    along = np.sort(np.stack([e[:, 1 - across] for e in ends], axis=1), axis=1)
    return Run(loop, heading, segments, hard, float((middle * length).sum() / length.sum()),
               float(along.min()), float(along.max()), along)

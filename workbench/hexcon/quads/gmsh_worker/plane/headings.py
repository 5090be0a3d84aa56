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
    """loop: of the chart; heading: 0 along its x, 1 along its y, 2, 3; hard: whether its start must stay where it is.

    segments  (k,) rows of the chart's loop, in order;  source: (k,) of the region, -1 on a cut
    place     the chart's y of a run along x, x of one along y: mean by length;  low, high: its extent along itself
    ends      (k,2) where each segment begins and ends along the run, the lesser first
    length    (k,) in the chart
    """

    loop: int
    heading: int
    hard: bool
    segments: np.ndarray
    source: np.ndarray
    place: float
    low: float
    high: float
    ends: np.ndarray
    length: np.ndarray

    @property
    def is_cut(self):
        return self.source[0] < 0


def runs_of(chart):
    """list of lists of Run, of a list of ChartLoop; None where a loop turns back on itself or never turns."""
    found = []
    for number, loop in enumerate(chart):
        headings = _quantised(loop.points)
        before = np.roll(headings, 1)
        before[0] += _closing(headings)
        change = np.flatnonzero(headings != before)
        if len(change) < 4 or not _turns_by_one(headings[change]):
            return None
        ends = np.append(change[1:], change[0] + len(headings))
        runs = [_run(loop, number, int(headings[a]) % 4, np.arange(a, b) % len(headings)) for a, b in zip(change, ends)]
        if any((run.source < 0).any() and (len(run.source) > 1 or not run.hard) for run in runs):
            return None         # a cut runs on into the outline
        found.append(runs)
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


def _turns_by_one(headings):
    """Whether each run turns by a quarter against the one before."""
    return bool((np.abs((headings - np.roll(headings, 1) + 2) % 4 - 2) == 1).all())


def _run(loop, number, heading, segments):
    start, end = loop.points[segments], loop.points[(segments + 1) % len(loop.points)]
    across = 1 - heading % 2
    length = np.linalg.norm(end - start, axis=1)
    middle = (start[:, across] + end[:, across]) / 2
    along = np.sort(np.stack([start[:, 1 - across], end[:, 1 - across]], axis=1), axis=1)
    return Run(number, heading, bool(loop.hard[segments[0]]), segments, loop.source[segments],
               float((middle * length).sum() / length.sum()), float(along.min()), float(along.max()), along, length)

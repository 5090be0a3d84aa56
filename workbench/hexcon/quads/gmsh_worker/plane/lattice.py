# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quads of a square lattice for regions whose outline runs mostly along two directions, with holes of any shape.

Corners, rounded corners and round holes are corners of the lattice polygon. A *pillow*, one ring of quads along a loop,
takes its corners off the boundary: round a hole that is an o-grid.
"""
import numpy as np

from ..outline import CORNER, even, with_total
from ..plane_mesh import harmonic
from ..submap import inside_of, numbered
from .headings import frame_of, runs_of
from .lattice_counts import lattice_lines, run_counts
from .region import region_of

FINE = 16       # points of an edge by which an outline without divisions is looked at


class LatticeCounts(list):
    """Interval counts per loop and edge, with the lattice that they are of.

    runs    list of lists of Run;  lines: (runs,) lattice line of each, loop after loop
    begins  per loop (number of a run, the row of the loop's points where it begins)
    """

    def __init__(self, counts, runs, lines, begins):
        super().__init__(counts)
        self.runs, self.lines, self.begins = runs, lines, begins


def lattice_plan(outline):
    """LatticeCounts of an Outline without divisions, or None where there is no lattice for it."""
    loops = outline.place(even([np.full(len(d), FINE) for d in outline.desired]))
    corner = [np.repeat(np.abs(t) > CORNER, FINE) & (np.arange(FINE * len(t)) % FINE == 0) for t in outline.turn]
    runs = runs_of(_framed(loops), corner)
    if runs is None:
        return None
    parts = [[_parts_of(run) for run in loop] for loop in runs]
    least = [[[max(1, int(np.ceil(few[e] * share - 1e-9))) for e, share in own] for own in loop]
             for loop, few in zip(parts, outline.least)]
    weights = [np.repeat(np.maximum(d, few), FINE) / FINE for d, few in zip(outline.desired, outline.least)]
    lines = lattice_lines(runs, weights, [[sum(few) for few in loop] for loop in least])
    straight = [_straight(loop) for loop in loops]
    return None if lines is None else _shared_out(outline, runs, lines, parts, least, straight)


def _straight(loop):
    """(edges,) bool, of a loop with FINE points an edge."""
    chains = np.append(loop, loop[:1], axis=0)
    length = np.linalg.norm(np.diff(chains, axis=0), axis=1).reshape(-1, FINE).sum(axis=1)
    return np.linalg.norm(chains[FINE::FINE] - chains[:-1:FINE], axis=1) > (1.0 - 1e-9) * length


def _parts_of(run):
    """[(edge, what part of it)] in order."""
    edge = run.segments // FINE
    first = np.flatnonzero(np.r_[True, edge[1:] != edge[:-1]])
    return [(int(edge[a]), (b - a) / FINE) for a, b in zip(first, np.append(first[1:], len(edge)))]


def _shared_out(outline, runs, lines, parts, least, straight):
    """LatticeCounts: the intervals of each run given to its edges, or None."""
    result, begins, first = [], [], 0
    for k, loop in enumerate(runs):
        totals = run_counts(loop, lines, first)
        first += len(loop)
        counts, before = np.zeros(len(outline.desired[k]), int), []
        for own, few, total in zip(parts[k], least[k], totals):
            wanted = np.maximum([outline.desired[k][e] * share for e, share in own], few)
            made = _given(wanted, np.array(few), int(total), straight[k][[e for e, _ in own]])
            if made is None:
                return None
            before.append(made)
            for (e, _), n in zip(own, made):
                counts[e] += n
        result.append(counts)
        begins.append(_begin_of_first(loop, parts[k], before, counts))
    return LatticeCounts(result, runs, lines, begins)


def _given(wanted, least, total, straight):
    """Intervals of a run's parts with the given sum: curved ones have what they want, if straight ones do the rest."""
    counts = np.maximum(np.rint(wanted).astype(int), least)
    rest = total - int(counts[~straight].sum())
    if not straight.any() or rest < least[straight].sum():
        return with_total(wanted, least, total)
    counts[straight] = with_total(wanted[straight], least[straight], rest)
    return counts


def _begin_of_first(loop, parts, made, counts):
    """(0, row): where the first run begins: at the start of its first edge, or inside, after what others have of it."""
    edge, share = parts[0][0]
    row = int(np.concatenate([[0], np.cumsum(counts)])[edge])
    if loop[0].segments[0] % FINE == 0:
        return 0, row
    at_end = [(own[-1][0] == edge and i > 0) for i, own in enumerate(parts)]
    if len(counts) > 1 and any(at_end):
        return 0, (row + int(made[at_end.index(True)][-1])) % int(counts.sum())
    return 0, int(np.rint(row + loop[0].segments[0] % FINE / FINE * counts[edge])) % int(counts.sum())


def _framed(loops):
    """The loops turned into the frame in which most of them runs along axes."""
    angle = frame_of(loops)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    return [loop @ turn for loop in loops]


def lattice_of(region):
    """LatticeCounts of a PlaneRegion, one interval an edge, or None."""
    corner = [np.abs(t) > CORNER for t in region.turns]
    runs = runs_of(_framed(region.loops), corner)
    if runs is None:
        return None
    ones = [np.ones(len(loop), int) for loop in region.loops]
    lines = lattice_lines(runs, ones, [np.ones(len(loop)) for loop in runs], [_sums(loop) for loop in runs])
    if lines is None:
        return None
    begins, first = [], 0
    for loop in runs:
        counts = run_counts(loop, lines, first)
        first += len(loop)
        hard = next((i for i, run in enumerate(loop) if run.hard), 0)
        begins.append((hard, _begin(loop, hard, counts)))
    return LatticeCounts(ones, runs, lines, begins)


def lattice_mesh(boundary, lattice):
    """(points (m,2), quads), boundary (Nb,2) first, of LatticeCounts; None where its polygon touches itself."""
    nodes, steps, first = [], [], 0
    for loop, begin in zip(lattice.runs, lattice.begins):
        made = _path(loop, lattice.lines, first, *begin)
        if made is None:
            return None
        nodes.append(made[0])
        steps.append(made[1])
        first += len(loop)
    nodes = np.concatenate(nodes)
    nodes = nodes - nodes.min(axis=0)
    inside = inside_of(nodes, np.concatenate(steps))
    ids = numbered(nodes, inside)
    if ids is None or len(nodes) != len(boundary):
        return None
    i, j = np.nonzero(inside)
    quads = np.stack([ids[i, j], ids[i + 1, j], ids[i + 1, j + 1], ids[i, j + 1]], -1)
    points = np.zeros((ids.max() + 1, 2))
    points[:len(boundary)] = boundary
    return harmonic(points, quads, np.arange(len(points)) < len(boundary)), quads


def _sums(loop):
    """[(rows of runs, sum of their intervals)] between hard starts."""
    starts = [i for i, run in enumerate(loop) if run.hard] or [0]
    parts = []
    for a, b in zip(starts, starts[1:] + [starts[0] + len(loop)]):
        rows = [i % len(loop) for i in range(a, b)]
        parts.append((rows, sum(len(loop[i].segments) for i in rows)))
    return parts


def _path(loop, lines, first, run, row):
    """(lattice places (N,2) of the loop's points in their order, steps (N,2) from each to the next).

    The number `run` begins at the loop's point `row`.
    """
    counts = run_counts(loop, lines, first)
    if (counts < 1).any():
        return None
    own = lines[first:first + len(loop)]
    order = [(run + i) % len(loop) for i in range(len(loop))]
    heading = np.repeat([loop[i].heading for i in order], counts[order])
    steps = np.array([[1, 0], [0, 1], [-1, 0], [0, -1]])[heading]
    here, before = own[run], own[run - 1]
    start = np.array([before, here] if loop[run].heading % 2 == 0 else [here, before])
    places = start + np.concatenate([[[0, 0]], np.cumsum(steps, axis=0)[:-1]])
    return np.roll(places, row, axis=0), np.roll(steps, row, axis=0)


def _begin(loop, run, counts):
    """The loop's point at which a run begins: given at a corner, else where all runs fit best."""
    if loop[run].hard:
        return int(loop[run].segments[0])
    order, total = [(run + i) % len(loop) for i in range(len(loop))], int(counts.sum())
    starts = np.concatenate([[0], np.cumsum(counts[order])[:-1]])
    off = np.array([loop[i].segments[0] for i in order]) - starts
    off = off[0] + (off - off[0] + total // 2) % total - total // 2
    return int(np.rint(off.mean())) % total


def pillowed(points, quads, loops):
    """(points, quads) with a ring of quads along each of the loops (of rows of points, in order).

    A loop's points stay; the quads there get points of their own, a third of the way inwards.
    """
    points, quads = np.asarray(points), np.asarray(quads)
    for loop in loops:
        inner = len(points) + np.arange(len(loop))
        name = np.arange(len(points))
        name[loop] = inner
        towards = np.zeros((len(points), 2))
        count = np.zeros(len(points))
        for a, b in ((0, 1), (1, 2), (2, 3), (3, 0), (1, 0), (2, 1), (3, 2), (0, 3)):
            np.add.at(towards, quads[:, a], points[quads[:, b]])
            np.add.at(count, quads[:, a], 1.0)
        middle = towards[loop] / count[loop][:, None]
        points = np.concatenate([points, points[loop] + (middle - points[loop]) / 2])
        ring = np.stack([loop, np.roll(loop, -1), np.roll(inner, -1), inner], -1)
        quads = np.concatenate([name[quads], ring])
    return points, quads


def lattice_template(outline, counts, boundary, rings=()):
    """A template's mesh, with a ring along the loops that are named: "outer", "holes"."""
    if "holes" in rings and len(outline.turn) == 1:
        return None
    lattice = counts if isinstance(counts, LatticeCounts) else lattice_of(region_of(outline, counts, boundary))
    made = None if lattice is None else lattice_mesh(boundary, lattice)
    if made is None:
        return None
    starts = np.cumsum([0] + [int(np.sum(c)) for c in counts])
    rows = [np.arange(a, b) for a, b in zip(starts, starts[1:])]
    return pillowed(*made, ([rows[0]] if "outer" in rings else []) + (rows[1:] if "holes" in rings else []))

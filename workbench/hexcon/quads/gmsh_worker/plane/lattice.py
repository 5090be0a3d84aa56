# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quads of a square lattice for regions whose outline runs mostly along two directions, with holes of any shape.

The directions are those of the plane, or round a centre and along its radii. Corners, rounded corners and round holes
are corners of the lattice polygon. A *pillow*, one ring of quads along a loop, takes its corners off the boundary:
round a hole that is an o-grid.
"""
from dataclasses import dataclass

import numpy as np

from ..outline import CORNER, LARGEST, even, with_total
from ..submap import STEPS, harmonic_mesh, inside_of, numbered
from .charts import charts_of
from .headings import runs_of
from .lattice_counts import across, lattice_lines, run_counts

LONGEST = 2.2   # times as long as wide are elements to be, where holes make them narrow
FINE = 16       # points of an edge by which an outline without divisions is looked at


@dataclass(frozen=True)
class Stretch:
    """Runs of a chart's loop that are one loop of the region: loop and numbers of the runs in order, from the one that
    begins at `row` of the region's points on, of which `first` to `first + count - 1` are the loop's."""

    loop: int
    runs: list
    first: int
    count: int
    row: int


class LatticeCounts(list):
    """Interval counts per loop and edge, with the lattice that they are of.

    runs       list of lists of Run;  lines: (runs,) lattice line of each, loop after loop
    stretches  list of Stretch
    """

    def __init__(self, counts, runs, lines, stretches):
        super().__init__(counts)
        self.runs, self.stretches = runs, stretches
        self.lines = np.split(lines, np.cumsum([len(loop) for loop in runs])[:-1])


def lattice_plans(outline):
    """list of LatticeCounts of an Outline without divisions, one for each chart in which there is a lattice."""
    loops = outline.place(even([np.full(len(d), FINE) for d in outline.desired]))
    corner = [np.repeat(np.abs(t) > CORNER, FINE) & (np.arange(FINE * len(t)) % FINE == 0) for t in outline.turn]
    desired, least = np.concatenate(outline.desired), np.concatenate(outline.least)
    weights = np.repeat(np.maximum(desired, least), FINE) / FINE
    straight = np.concatenate([_straight(loop) for loop in loops])
    found = []
    for chart in charts_of(loops, corner):
        runs = runs_of(chart)
        if runs is None:
            continue
        flat = [run for loop in runs for run in loop]
        parts = [_parts_of(run) for run in flat]
        few = [np.array([max(1, int(np.ceil(least[e] * share - 1e-9))) for e, share in own], int) for own in parts]
        worth = _worth(flat, weights, outline.size)
        fewest = [max(1, f.sum(), np.ceil(w.sum() / LARGEST - 1e-9)) for f, w in zip(few, worth)]
        lines = lattice_lines(runs, worth, fewest)
        if lines is not None:       # once more, no longer than the divisions across allow
            room = LONGEST * across(runs, lines)
            lines = lattice_lines(runs, [np.maximum(w, run.length / r) for w, run, r in zip(worth, flat, room)], fewest)
        plan = None if lines is None else _shared_out(outline, runs, lines, parts, few, desired, straight)
        if plan is not None:
            found.append(plan)
    return found


def _worth(flat, weights, size):
    return [run.length / size if run.is_cut else weights[run.source] for run in flat]


def _straight(loop):
    """(edges,) bool, of a loop with FINE points an edge."""
    chains = np.append(loop, loop[:1], axis=0)
    length = np.linalg.norm(np.diff(chains, axis=0), axis=1).reshape(-1, FINE).sum(axis=1)
    return np.linalg.norm(chains[FINE::FINE] - chains[:-1:FINE], axis=1) > (1.0 - 1e-9) * length


def _parts_of(run):
    """[(edge, what part of it)] in order; none on a cut."""
    if run.is_cut:
        return []
    edge = run.source // FINE
    first = np.flatnonzero(np.r_[True, edge[1:] != edge[:-1]])
    return [(int(edge[a]), (b - a) / FINE) for a, b in zip(first, np.append(first[1:], len(edge)))]


def _shared_out(outline, runs, lines, parts, least, desired, straight):
    """LatticeCounts: the intervals of each run given to its edges, or None."""
    totals = np.concatenate([run_counts(loop, own) for loop, own in
                             zip(runs, np.split(lines, np.cumsum([len(loop) for loop in runs])[:-1]))])
    counts, made = np.zeros(len(desired), int), []
    for own, few, total in zip(parts, least, totals):
        wanted = np.maximum([desired[e] * share for e, share in own], few) if own else np.empty(0)
        given = _given(wanted, few, int(total), straight[[e for e, _ in own]]) if own else np.empty(0, int)
        if given is None:
            return None
        made.append(given)
        for (e, _), n in zip(own, given):
            counts[e] += n
    edges = np.cumsum([0] + [len(d) for d in outline.desired])
    rows = np.concatenate([[0], np.cumsum(counts)])
    stretches = []
    for loop, numbers, flat in _stretches(runs):
        edge = parts[flat[0]][0][0]
        k = int(np.searchsorted(edges, edge, side="right")) - 1
        first, count = int(rows[edges[k]]), int(rows[edges[k + 1]] - rows[edges[k]])
        start = runs[loop][numbers[0]].source[0] % FINE
        begin = int(rows[edge]) + _before(start, edge, [parts[i] for i in flat], [made[i] for i in flat])
        stretches.append(Stretch(loop, numbers, first, count, first + (begin - first) % count))
    return LatticeCounts([counts[a:b] for a, b in zip(edges, edges[1:])], runs, lines, stretches)


def _given(wanted, least, total, straight):
    """Intervals of a run's parts with the given sum: curved ones have what they want, if straight ones do the rest."""
    counts = np.maximum(np.rint(wanted).astype(int), least)
    rest = total - int(counts[~straight].sum())
    if not straight.any() or rest < least[straight].sum():
        return with_total(wanted, least, total)
    counts[straight] = with_total(wanted[straight], least[straight], rest)
    return counts


def _before(start, edge, parts, made):
    """Intervals that an edge has before its point `start` of FINE, at which a run begins: those of the run that is last
    to have a part of it; of an edge that is a whole loop its part of all."""
    if start == 0:
        return 0
    if all(e == edge for own in parts for e, _ in own):
        return int(np.rint(start / FINE * sum(int(given.sum()) for given in made)))
    last = [given[-1] for own, given in zip(parts, made) if own[-1][0] == edge]
    return int(last[-1]) if last else 0


def _stretches(runs):
    """[(loop, numbers of its runs from a hard start on, their numbers in all)]: whole loops, or parts between cuts."""
    found, first = [], 0
    for k, loop in enumerate(runs):
        n = len(loop)
        cuts = [i for i, run in enumerate(loop) if run.is_cut]
        if cuts:
            groups = [[i % n for i in range(a + 1, b)] for a, b in ((cuts[0], cuts[1]), (cuts[1], cuts[0] + n))]
        else:
            hard = next((i for i, run in enumerate(loop) if run.hard), 0)
            groups = [[(hard + i) % n for i in range(n)]]
        found += [(k, group, [first + i for i in group]) for group in groups]
        first += n
    return found


def lattices_of(region):
    """list of LatticeCounts of a PlaneRegion, one interval an edge."""
    corner = [np.abs(t) > CORNER for t in region.turns]
    sizes = np.array([len(loop) for loop in region.loops])
    starts = np.cumsum(sizes) - sizes
    ones = [np.ones(n, int) for n in sizes]
    size = float(np.linalg.norm(region.boundary[region.after] - region.boundary, axis=1).mean())
    found = []
    for chart in charts_of(region.loops, corner):
        runs = runs_of(chart)
        if runs is None:
            continue
        flat = [run for loop in runs for run in loop]
        groups = _stretches(runs)
        fixed = [part for _, _, members in groups for part in _sums(flat, members)]
        lines = lattice_lines(runs, _worth(flat, np.ones(sizes.sum()), size), np.ones(len(flat)), fixed)
        if lines is None:
            continue
        stretches = []
        for loop, numbers, members in groups:
            k = int(np.searchsorted(starts, flat[members[0]].source[0], side="right")) - 1
            row = _row([flat[i] for i in members], _counts_in(runs, lines, members), int(starts[k]), int(sizes[k]))
            stretches.append(Stretch(loop, numbers, int(starts[k]), int(sizes[k]), row))
        found.append(LatticeCounts(ones, runs, lines, stretches))
    return found


def _counts_in(runs, lines, members):
    own = np.split(lines, np.cumsum([len(loop) for loop in runs])[:-1])
    return np.concatenate([run_counts(loop, line) for loop, line in zip(runs, own)])[members]


def _sums(flat, members):
    """[(numbers of runs, sum of their intervals)] between hard starts of a stretch."""
    starts = [i for i, member in enumerate(members) if flat[member].hard] or [0]
    ends = [*starts[1:], len(members)]
    return [(members[a:b], sum(len(flat[i].segments) for i in members[a:b])) for a, b in zip(starts, ends)]


def _row(runs, counts, first, count):
    """The region's point at which the first of the runs begins: given at a corner, else where all runs fit best."""
    if runs[0].hard:
        return int(runs[0].source[0])
    off = np.array([run.source[0] - first for run in runs]) - np.concatenate([[0], np.cumsum(counts)[:-1]])
    off = off[0] + (off - off[0] + count // 2) % count - count // 2
    return first + int(np.rint(off.mean())) % count


def lattice_mesh(boundary, lattice):
    """(points (m,2), quads), boundary (Nb,2) first, of LatticeCounts; None where its polygon touches itself."""
    places, rows, steps = [], [], []
    for k in range(len(lattice.runs)):
        made = _path(lattice, k, len(boundary))
        if made is None:
            return None
        for whole, part in zip((places, rows, steps), made):
            whole.append(part)
    places, rows = np.concatenate(places), np.concatenate(rows)
    places = places - places.min(axis=0)
    if len(np.unique(rows[rows < len(boundary)])) != len(boundary):
        return None
    inside = inside_of(places, np.concatenate(steps))
    ids = numbered(places, rows, inside)
    return None if ids is None else harmonic_mesh(ids, inside, boundary)


def _path(lattice, loop, count):
    """(lattice places (n,2) along a loop of the chart, the mesh's point at each, steps (n,2) from each to the next).

    Points on a cut are new ones, `count` and after: both sides of it have the same.
    """
    runs, lines = lattice.runs[loop], lattice.lines[loop]
    counts = run_counts(runs, lines)
    if (counts < 1).any():
        return None
    steps = STEPS[np.repeat([run.heading for run in runs], counts)]
    start = np.array([lines[-1], lines[0]] if runs[0].heading % 2 == 0 else [lines[0], lines[-1]])
    places = start + np.concatenate([[[0, 0]], np.cumsum(steps, axis=0)[:-1]])
    at = np.concatenate([[0], np.cumsum(counts)])
    rows = np.full(len(places), -1)
    for stretch in (s for s in lattice.stretches if s.loop == loop):
        own = np.concatenate([np.arange(at[i], at[i + 1]) for i in stretch.runs])
        numbers = stretch.first + (stretch.row - stretch.first + np.arange(len(own))) % stretch.count
        if len(own) != stretch.count:
            return None
        rows[own] = numbers
        after = at[(stretch.runs[-1] + 1) % len(runs)]
        if runs[(stretch.runs[-1] + 1) % len(runs)].is_cut:     # which begins where the stretch did
            rows[after] = numbers[0]
    down = None
    for i in (i for i, run in enumerate(runs) if run.is_cut):
        inner = count + np.arange(counts[i] - 1)
        rows[at[i] + 1:at[i + 1]] = inner if down is None else inner[::-1]
        down = i
    return places, rows, steps


def pillowed(points, quads, loops):
    """(points, quads) with a ring of quads along each of the loops (of rows of points, in order).

    A loop's points stay; the quads there get points of their own, half the way inwards.
    """
    points, quads = np.asarray(points), np.asarray(quads)
    for loop in loops:
        inner = len(points) + np.arange(len(loop))
        name = np.arange(len(points))
        name[loop] = inner
        towards, count = np.zeros((len(points), 2)), np.zeros(len(points))
        for a, b in ((0, 1), (1, 2), (2, 3), (3, 0), (1, 0), (2, 1), (3, 2), (0, 3)):
            np.add.at(towards, quads[:, a], points[quads[:, b]])
            np.add.at(count, quads[:, a], 1.0)
        middle = towards[loop] / count[loop][:, None]
        points = np.concatenate([points, (points[loop] + middle) / 2])
        ring = np.stack([loop, np.roll(loop, -1), np.roll(inner, -1), inner], -1)
        quads = np.concatenate([name[quads], ring])
    return points, quads


def lattice_template(outline, lattice, boundary, rings=()):
    """A template's mesh of LatticeCounts, with a ring along the loops that are named: "outer", "holes"."""
    if "holes" in rings and len(outline.turn) == 1:
        return None
    made = lattice_mesh(boundary, lattice)
    if made is None:
        return None
    starts = np.cumsum([0] + [int(np.sum(c)) for c in lattice])
    rows = [np.arange(a, b) for a, b in zip(starts, starts[1:])]
    return pillowed(*made, ([rows[0]] if "outer" in rings else []) + (rows[1:] if "holes" in rings else []))

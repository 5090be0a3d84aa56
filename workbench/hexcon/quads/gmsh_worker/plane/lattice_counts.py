# SPDX-License-Identifier: LGPL-2.1-or-later
"""Intervals of an outline's runs in a square lattice, by an integer program.

Each run along x lies on one line of the lattice across, and so does each along y: their numbers are the unknowns. A run
has as many intervals as the lines of the runs before and after it are apart, so every loop closes. The lines keep the
order that the runs have in the plane, which keeps holes where they are and the polygon from touching itself.
"""
import numpy as np

from ..program import Program

MOST_RUNS = 160
NEAR = 0.02         # of the region's width: lines as near as that may come in any order
EDGE_COST, GAP_COST = 1.0, 0.7      # of one interval more or fewer than wanted, along runs and between them
NODES = 200         # of the search


def lattice_lines(runs, worth, least, fixed=()):
    """(runs,) int: the lattice line of each run (y of one along x, x of one along y), None where there is none.

    runs    list of lists of Run
    worth   list per run, loop after loop, of (k,) intervals that each of its segments is worth
    least   (runs,) fewest intervals
    fixed   [(numbers of runs, sum of their intervals)]: parts of loops divided already
    """
    flat = [run for loop in runs for run in loop]
    if len(flat) > MOST_RUNS:
        return None
    program, counts = Program(), _count_terms(runs)
    for _ in flat:
        program.column(-np.inf, np.inf)
    size = sum(run.length.sum() for run in flat) / max(sum(w.sum() for w in worth), 1e-300)
    for i, terms in enumerate(counts):
        program.row(terms, float(least[i]), np.inf)
        if not flat[i].is_cut:
            _wanted_between(program, flat[i], worth[i], _stops(flat, i, terms))
    for members, total in fixed:
        program.row(_sum([counts[i] for i in members]), total, total)
    for i, j in _glued(runs):
        program.row({i: 1.0, j: -1.0}, 0, 0)
    for axis in (0, 1):
        _order(program, [(i, run) for i, run in enumerate(flat) if run.heading % 2 == axis], size)
        program.row({next(i for i, run in enumerate(flat) if run.heading % 2 == axis): 1.0}, 0, 0)
    return program.solved(len(flat), node_limit=NODES)


def run_counts(loop, lines):
    """(runs,) intervals of the runs of one loop, from its own lines."""
    sign = np.array([1 if run.heading < 2 else -1 for run in loop])
    return sign * (np.roll(lines, -1) - np.roll(lines, 1))


def _count_terms(runs):
    """Intervals of each run as a difference of the lines before and after it."""
    found, first = [], 0
    for loop in runs:
        for i, run in enumerate(loop):
            sign = 1.0 if run.heading < 2 else -1.0
            found.append({first + (i + 1) % len(loop): sign, first + (i - 1) % len(loop): -sign})
        first += len(loop)
    return found


def _glued(runs):
    """Pairs of runs before and after a cut, which are one: [(number, number)]."""
    pairs, first = [], 0
    for loop in runs:
        cuts = [i for i, run in enumerate(loop) if run.is_cut]
        if cuts:
            a, b = cuts
            ends = [((a - 1) % len(loop), (b + 1) % len(loop)), ((a + 1) % len(loop), (b - 1) % len(loop))]
            pairs += [(first + i, first + j) for i, j in ends if i != j]
        first += len(loop)
    return pairs


def _sum(parts):
    total = {}
    for terms in parts:
        for line, value in terms.items():
            total[line] = total.get(line, 0.0) + value
    return total


def _wanted_between(program, run, worth, stops):
    """Intervals between a run's ends and the holes that it sees, each by what its segments there are worth."""
    middle = run.ends.mean(axis=1)
    for (a, i), (b, j) in zip(stops, stops[1:]):
        if i != j and b > a:
            first, last = stops[0][0] == a, stops[-1][0] == b
            own = worth[((middle >= a) | first) & ((middle < b) | last)].sum()
            program.near({j: 1.0, i: -1.0}, max(float(own), 1.0), EDGE_COST)


def across(runs, lines):
    """(runs,) least size of the elements beside each run, across it: infinite where it faces no other."""
    flat = [run for loop in runs for run in loop]
    least = np.full(len(flat), np.inf)
    for axis in (0, 1):
        own = sorted(((i, run) for i, run in enumerate(flat) if run.heading % 2 == axis), key=lambda one: one[1].place)
        for a, (i, low) in enumerate(own):
            for j, high in own[a + 1:]:
                beside = min(low.high, high.high) > max(low.low, high.low)
                if beside and _sees(low, high) and not _hidden(own, low, high):
                    size = (high.place - low.place) / max(int(lines[j] - lines[i]), 1)
                    least[[i, j]] = np.minimum(least[[i, j]], size)
    return least


def _stops(flat, number, terms):
    """[(place along the run, line)] of a run's ends and of the holes that it sees."""
    run = flat[number]
    low, high = sorted(terms, key=terms.get)
    stops = [(run.low, low), (run.high, high)]
    across = [(k, other) for k, other in enumerate(flat) if other.heading % 2 == run.heading % 2]
    for _, other in across:
        pair = (run, other) if run.place < other.place else (other, run)
        if other.loop == run.loop or not _sees(*pair) or _hidden(across, *pair):
            continue
        if run.low < other.low and other.high < run.high:
            near = [j for j, side in enumerate(flat) if side.loop == other.loop and side.heading % 2 != run.heading % 2]
            stops.append((other.low, min(near, key=lambda j: abs(flat[j].place - other.low))))
            stops.append((other.high, min(near, key=lambda j: abs(flat[j].place - other.high))))
    return sorted(stops)


def _order(program, lines, size):
    """Rows for lines of one direction: [(number, Run)]."""
    lines = sorted(lines, key=lambda one: one[1].place)
    width = max(run.place for _, run in lines) - min(run.place for _, run in lines)
    for a, (i, low) in enumerate(lines):
        for j, high in lines[a + 1:]:
            shared = min(low.high, high.high) - max(low.low, high.low)
            apart = high.place - low.place
            if shared > 1e-3 * min(low.high - low.low, high.high - high.low):
                program.row({j: 1.0, i: -1.0}, 1, np.inf)
                if _sees(low, high) and not _hidden(lines, low, high):
                    program.near({j: 1.0, i: -1.0}, apart / size, GAP_COST)
            elif apart > NEAR * width:
                program.row({j: 1.0, i: -1.0}, 0, np.inf)


def _sees(low, high):
    """Whether the region lies above `low` and below `high`: it is left of each run."""
    return (low.heading, high.heading) in ((0, 2), (3, 1))


def _hidden(lines, low, high):
    """Whether a third run stands between over half of what the two share."""
    left, right = max(low.low, high.low), min(low.high, high.high)
    return any(low.place < run.place < high.place and min(run.high, right) - max(run.low, left) > 0.5 * (right - left)
               for _, run in lines)

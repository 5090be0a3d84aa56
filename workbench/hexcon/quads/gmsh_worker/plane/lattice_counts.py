# SPDX-License-Identifier: LGPL-2.1-or-later
"""Intervals of an outline's runs in a square lattice, by an integer program.

Each run along x lies on one line of the lattice across, and so does each along y: their numbers are the unknowns. A run
has as many intervals as the lines of the runs before and after it are apart, so every loop closes. The lines keep the
order that the runs have in the plane, which keeps holes where they are and the polygon from touching itself.
"""
import numpy as np
from scipy.optimize import Bounds, LinearConstraint, milp
from scipy.sparse import coo_matrix

MOST_RUNS = 160
NEAR = 0.02         # of the region's width: lines as near as that may come in any order
EDGE_COST, GAP_COST = 1.0, 0.7      # of one interval more or fewer than wanted, along runs and between them
NODES = 200         # of the search


class _Program:
    """Rows of an integer program: n lines, and slacks."""

    def __init__(self, lines):
        self.lines, self.cost, self.rows, self.low, self.high = lines, [], [], [], []

    def row(self, terms, low, high):
        self.rows.append(terms)
        self.low.append(low)
        self.high.append(high)

    def near(self, terms, wanted, cost):
        """The sum of terms is wanted to be near a number: its distance costs."""
        slack = self.lines + len(self.cost)
        self.cost.append(cost)
        self.row({**terms, slack: -1.0}, -np.inf, wanted)
        self.row({**terms, slack: 1.0}, wanted, np.inf)

    def solved(self):
        """(lines,) int, None where there is no solution."""
        size = self.lines + len(self.cost)
        entries = [(i, j, v) for i, terms in enumerate(self.rows) for j, v in terms.items()]
        row, column, value = (np.array(x) for x in zip(*entries))
        matrix = coo_matrix((value, (row, column)), shape=(len(self.rows), size)).tocsr()
        whole = np.arange(size) < self.lines
        bounds = Bounds(np.where(whole, -np.inf, 0.0), np.full(size, np.inf))
        rule = LinearConstraint(matrix, np.array(self.low), np.array(self.high))
        for presolve in (True, False):      # HiGHS 1.2 takes some feasible programs for infeasible in its presolve
            found = milp(np.r_[np.zeros(self.lines), self.cost], integrality=whole.astype(int), bounds=bounds,
                         constraints=rule, options={"node_limit": NODES, "presolve": presolve})
            if found.x is not None:
                return np.rint(found.x[:self.lines]).astype(int)
        return None


def lattice_lines(runs, weights, least, fixed=None):
    """(runs,) int: the lattice line of each run (y of one along x, x of one along y), None where there is none.

    runs     list of lists of Run;  least: list per loop of (runs,) fewest intervals
    weights  list per loop of (N,) intervals that each segment is worth
    fixed    None, or list per loop of [(rows of runs, sum of their intervals)]: parts of loops divided already
    """
    flat = [run for loop in runs for run in loop]
    if len(flat) > MOST_RUNS:
        return None
    program, first = _Program(len(flat)), 0
    worth = [weights[run.loop][run.segments] for run in flat]
    size = sum((run.ends[:, 1] - run.ends[:, 0]).sum() for run in flat) / max(sum(w.sum() for w in worth), 1e-300)
    for k, loop in enumerate(runs):
        counts = [_count_terms(loop, first, i) for i in range(len(loop))]
        for i, terms in enumerate(counts):
            program.row(terms, float(least[k][i]), np.inf)
            _wanted_between(program, flat[first + i], worth[first + i], _stops(flat, first + i, terms))
        for rows, total in ([] if fixed is None else fixed[k]):
            program.row(_sum([counts[i] for i in rows]), total, total)
        first += len(loop)
    for axis in (0, 1):
        _order(program, [(i, run) for i, run in enumerate(flat) if run.heading % 2 == axis], size)
        anchor = next(i for i, run in enumerate(flat) if run.heading % 2 == axis)
        program.row({anchor: 1.0}, 0, 0)
    return program.solved()


def run_counts(loop, lines, first):
    """(runs,) intervals of the runs of one loop, whose lines start at `first`."""
    own = lines[first:first + len(loop)]
    sign = np.array([1 if run.heading < 2 else -1 for run in loop])
    return sign * (np.roll(own, -1) - np.roll(own, 1))


def _wanted_between(program, run, worth, stops):
    """Intervals between a run's ends and the holes that it sees, each by what its segments there are worth."""
    middle = run.ends.mean(axis=1)
    for (a, i), (b, j) in zip(stops, stops[1:]):
        if i != j and b > a:
            first, last = stops[0][0] == a, stops[-1][0] == b
            own = worth[((middle >= a) | first) & ((middle < b) | last)].sum()
            wanted = max(float(own), 1.0)
            program.near({j: 1.0, i: -1.0}, wanted, EDGE_COST / np.sqrt(wanted))


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


def _count_terms(loop, first, i):
    """Intervals of a run as a difference of the lines before and after it."""
    before, after = first + (i - 1) % len(loop), first + (i + 1) % len(loop)
    sign = 1.0 if loop[i].heading < 2 else -1.0
    return {after: sign, before: -sign}


def _sum(parts):
    total = {}
    for terms in parts:
        for line, value in terms.items():
            total[line] = total.get(line, 0.0) + value
    return total


def _order(program, lines, size):
    """Rows for lines of one direction: [(number, Run)]."""
    lines = sorted(lines, key=lambda one: one[1].place)
    width = max(run.place for _, run in lines) - min(run.place for _, run in lines)
    for a, (i, low) in enumerate(lines):
        for j, high in [line for line in lines[a + 1:]]:
            shared = min(low.high, high.high) - max(low.low, high.low)
            apart = high.place - low.place
            beside = shared > 1e-3 * min(low.high - low.low, high.high - high.low)
            if beside:
                program.row({j: 1.0, i: -1.0}, 1, np.inf)
                if _sees(low, high) and not _hidden(lines, low, high):
                    gap = apart / size
                    program.near({j: 1.0, i: -1.0}, gap, GAP_COST / np.sqrt(max(gap, 1.0)))
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

# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many intervals each piece of an arrangement gets: an integer program for all of them together.

Near length / size, enough for what a piece turns, even round every loop; and where it costs little as the plane
mesher's structures want it: equal on opposite sides, equal on both rims of a ring.
"""
import numpy as np
from scipy.optimize import Bounds, LinearConstraint, milp
from scipy.sparse import lil_matrix

from .fault import NotLayered

ROUND, LEAST_ROUND = np.radians(30.0), 8    # turn of an interval of a full circle; fewest intervals of a small one
OPEN = np.radians(45.0)                     # of an arc
SECONDS, GAP = 10.0, 0.02                   # limits of the program: time, and how far from the best


def ideal_counts(pieces, sizes):
    """((n,) float wanted numbers, (n,) int least ones) of pieces. sizes (n,): wanted lengths of intervals."""
    length = np.array([np.linalg.norm(np.diff(p.line, axis=0), axis=1).sum() for p in pieces])
    turning = np.array([_turning(p.line) for p in pieces])
    least = np.maximum(np.ceil(turning / OPEN - 0.05), 1).astype(int)
    for k, piece in enumerate(pieces):
        if piece.closed:
            fine = int(np.ceil(turning[k] / ROUND - 0.05))
            least[k] = max(3, min(fine, max(LEAST_ROUND, int(length[k] / sizes[k]))))
    return np.maximum(length / sizes, least), least


def _turning(line):
    d = np.diff(line, axis=0)
    if len(d) < 2:
        return 0.0
    d = d / np.maximum(np.linalg.norm(d, axis=1, keepdims=True), 1e-300)
    return float(np.arccos(np.clip((d[1:] * d[:-1]).sum(1), -1, 1)).sum() * len(d) / (len(d) - 1))


def divide(ideal, least, rows, held=()):
    """(n,) int numbers of intervals.

    rows: of (terms: {piece: coefficient}, multiple, weight): the sum of terms is to be a multiple, or 0 where that is
          0; weight: what one off costs, beside 1 / sqrt(n) for one off n by length; None: it must hold
    held: those whose number is their ideal one
    Raises NotLayered where the hard ones cannot hold.
    """
    program = _Program(ideal, least, held)
    for row in rows:
        program.add(*row)
    found = program.solved()
    if found is None:
        raise NotLayered("no numbers of intervals fit together")
    return found


class _Program:
    """Columns: a number per piece, how far each is from its ideal, then what rows need."""

    def __init__(self, ideal, least, held):
        n = len(ideal)
        self._n = n
        self._cost, self._whole = [0.0] * n, [1] * n
        self._low, self._high = list(map(float, least)), list(np.maximum(4.0 * ideal + 8, least + 8))
        for k in held:
            self._high[k] = self._low[k]
        self._rows = []
        for k in range(n):
            off = self._column(1.0 / max(ideal[k], 1.0) ** 0.5)
            self._between({k: 1, off: -1}, -np.inf, ideal[k])
            self._between({k: 1, off: 1}, ideal[k], np.inf)

    def _column(self, cost, whole=0, high=1e5):
        self._cost.append(cost)
        self._whole.append(whole)
        self._low.append(0.0 if not whole else -high)
        self._high.append(high)
        return len(self._cost) - 1

    def _between(self, terms, low, high):
        self._rows.append((terms, low, high))

    def add(self, terms, multiple, weight):
        terms = dict(terms)
        if multiple:
            terms[self._column(0.0, 1)] = -multiple
        if weight is None:
            self._between(terms, 0, 0)
            return
        off = self._column(weight)
        self._between({**terms, off: -1}, -np.inf, 0)
        self._between({**terms, off: 1}, 0, np.inf)

    def solved(self):
        matrix = lil_matrix((len(self._rows), len(self._cost)))
        for i, (terms, _, _) in enumerate(self._rows):
            for j, value in terms.items():
                matrix[i, j] = value
        low, high = (np.array([row[k] for row in self._rows], float) for k in (1, 2))
        for presolve in (True, False):      # HiGHS 1.2 takes some feasible programs for infeasible in its presolve
            found = milp(np.array(self._cost), integrality=np.array(self._whole),
                         bounds=Bounds(np.array(self._low), np.array(self._high)),
                         constraints=LinearConstraint(matrix.tocsr(), low, high),
                         options={"time_limit": SECONDS, "mip_rel_gap": GAP, "presolve": presolve})
            if found.x is not None:
                return np.rint(found.x[:self._n]).astype(int)
        return None

# SPDX-License-Identifier: LGPL-2.1-or-later
"""An integer program of numbers of intervals, put together row by row."""
import numpy as np
from scipy.optimize import Bounds, LinearConstraint, milp
from scipy.sparse import coo_matrix


class Program:
    """Columns of whole or other numbers between bounds, and rows that bind sums of them. far: the most of a slack."""

    def __init__(self, far=np.inf):
        self._far = far
        self._cost, self._whole, self._low, self._high, self._rows = [], [], [], [], []

    def column(self, low, high, cost=0.0, whole=True):
        """Number of a new column."""
        for kept, value in ((self._cost, cost), (self._whole, whole), (self._low, low), (self._high, high)):
            kept.append(value)
        return len(self._cost) - 1

    def row(self, terms, low, high):
        """The sum of terms {column: coefficient} is between two numbers."""
        self._rows.append((terms, low, high))

    def near(self, terms, wanted, cost):
        """The sum of terms is wanted to be a number: what it is off costs, of a large one less."""
        slack = self.column(0.0, self._far, cost / np.sqrt(max(wanted, 1.0)), whole=False)
        self.row({**terms, slack: -1.0}, -np.inf, wanted)
        self.row({**terms, slack: 1.0}, wanted, np.inf)

    def solved(self, count, **options):
        """(count,) int values of the first columns, None where there is no solution. options: of HiGHS"""
        entries = [(i, j, value) for i, (terms, _, _) in enumerate(self._rows) for j, value in terms.items()]
        row, column, value = (np.array(x) for x in zip(*entries))
        matrix = coo_matrix((value, (row, column)), shape=(len(self._rows), len(self._cost))).tocsr()
        low, high = (np.array([row[k] for row in self._rows], float) for k in (1, 2))
        for presolve in (True, False):      # HiGHS 1.2 takes some feasible programs for infeasible in its presolve
            found = milp(np.array(self._cost), integrality=np.array(self._whole, int),
                         bounds=Bounds(np.array(self._low), np.array(self._high)),
                         constraints=LinearConstraint(matrix, low, high), options={**options, "presolve": presolve})
            if found.x is not None:
                return np.rint(found.x[:count]).astype(int)
        return None

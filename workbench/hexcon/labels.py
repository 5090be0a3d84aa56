# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the numbers that a file or a program gives to nodes and elements to rows: by their count, whatever their size."""
import numpy as np


class Labels:
    """Numbers of rows, labels (n,) int in any order, sorted once. Where a number stands twice the last row counts."""

    def __init__(self, labels):
        labels = np.asarray(labels, np.int64)
        self._order = np.argsort(labels, kind="stable")
        self._ranked = labels[self._order]

    def rows_of(self, wanted):
        """Row of each wanted number, int of any shape. Raises ValueError naming a number that is not there."""
        wanted = np.asarray(wanted, np.int64)
        place, there = self._places(wanted)
        if not there.all():
            raise ValueError(f"number {wanted[~there].flat[0]} is named, but not defined")
        return self._order[place]

    def known(self, wanted):
        """Rows of those of the wanted numbers (k,) that are there."""
        place, there = self._places(np.asarray(wanted, np.int64))
        return self._order[place[there]]

    def _places(self, wanted):
        place = np.searchsorted(self._ranked, wanted, side="right") - 1
        there = place >= 0
        there[there] = self._ranked[place[there]] == wanted[there]
        return place, there


def rows_of(labels, wanted):
    """Labels(labels).rows_of(wanted), for numbers that are asked for once. Cost: one sort of n."""
    return Labels(labels).rows_of(wanted)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the numbers that a file or a program gives to nodes and elements to rows: by their count, whatever their size."""
import numpy as np


def rows_of(labels, wanted):
    """Row of each wanted number among labels, an array of wanted's shape; where a label stands twice the last row counts.

    labels (n,) int, in any order;  wanted  int, any shape. Raises ValueError naming a number that is not there.
    Cost: one sort of n.
    """
    labels, wanted = np.asarray(labels, np.int64), np.asarray(wanted, np.int64)
    order = np.argsort(labels, kind="stable")
    ranked = labels[order]
    place = np.searchsorted(ranked, wanted, side="right") - 1
    lost = place < 0
    lost[~lost] = ranked[place[~lost]] != wanted[~lost]
    if lost.any():
        raise ValueError(f"number {wanted[lost].flat[0]} is named, but not defined")
    return order[place]

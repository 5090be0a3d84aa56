# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scaled Jacobians of a mesh in figures: the worst of them, and how they are spread."""
import numpy as np


def worst(scaled_jacobian, count):
    """Rows of the count lowest, the lowest first; of equals the first row first."""
    values = np.asarray(scaled_jacobian)
    count = min(max(int(count), 0), len(values))
    if not count:
        return np.zeros(0, np.int64)
    limit = np.partition(values, count - 1)[count - 1]
    rows = np.flatnonzero(values <= limit)  # few: sorting all would be ten times the work
    return rows[np.argsort(values[rows], kind="stable")][:count]


def spread(scaled_jacobian, bins=25):
    """(counts (b,), limits (b+1,)): how many lie between limits of equal distance 1 / bins.

    The limits run from 0 to 1, or from further down in steps of the same width where hexes are
    inverted, so that 0 always is a limit.
    """
    values = np.clip(scaled_jacobian, -1.0, 1.0)
    below = int(np.ceil(bins * max(0.0, -float(values.min(initial=0.0))) - 1e-9))
    limits = np.arange(-below, bins + 1) / bins
    return np.histogram(values, limits)[0], limits

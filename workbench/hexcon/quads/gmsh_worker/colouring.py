# SPDX-License-Identifier: LGPL-2.1-or-later
"""Can the points of a quad surface be black and white, so that every edge joins the two? Is every shell of it even?"""
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components


def two_colourable(quads):
    """Always so on a sphere; with handles if every closed path of edges is even. quads (n,4). O(n).

    Two copies of the points, every edge from one copy to the other: a point is joined to its own copy by odd paths.
    """
    count = int(quads.max()) + 1
    a, b = np.stack([quads, np.roll(quads, -1, axis=1)], axis=-1).reshape(-1, 2).T
    ends = np.concatenate([a, b]), np.concatenate([b, a]) + count
    graph = coo_matrix((np.ones(len(ends[0]), bool), ends), shape=(2 * count, 2 * count))
    part = connected_components(graph, directed=False)[1]
    return bool((part[:count] != part[count:])[np.unique(quads)].all())


def shells_are_even(quads):
    """Whether every connected part of the surface, a cavity's too, has an even number of quads. quads (n,4). O(n)."""
    count = int(quads.max()) + 1
    ends = np.concatenate([quads[:, 0]] * 3), quads[:, 1:].T.ravel()
    graph = coo_matrix((np.ones(len(ends[0]), bool), ends), shape=(count, count))
    part = connected_components(graph, directed=False)[1]
    return not (np.bincount(part[quads[:, 0]]) % 2).any()

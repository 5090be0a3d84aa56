# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far nodes of levels are from over their places in the plane: as those are whose places are known, and smooth.

Neighbours in a level and above one another are coupled, as heat flows through layers as thick as the levels are apart.
So what stands under the foot of a tapered boss follows it.
"""
import numpy as np
from scipy.sparse import coo_matrix, diags
from scipy.sparse.csgraph import connected_components
from scipy.sparse.linalg import splu

WEAK, STRONG = 0.05, 4.0    # couplings of nodes above one another, at least and at most, beside those in a level


def shifts(sheets, stacks, known, size, near):
    """{level: (n,2) shifts of its nodes}.

    sheets: {level: places.Sheet}; stacks: of (nodes of a region, levels upwards); known: {level: (n,2), NaN where they
    are not known}; near: less is none. One sparse factorisation.
    """
    levels = list(sheets)
    start = dict(zip(levels, np.cumsum([0] + [len(sheets[level].ids) for level in levels])))
    given = np.concatenate([known[level] for level in levels])
    made = np.nan_to_num(given)
    if np.abs(made).max() > near:
        free = np.isnan(given[:, 0])
        _solve(made, free, _couplings(sheets, stacks, start, len(given), size))
    return {level: made[start[level]:start[level] + len(sheets[level].ids)] for level in levels}


def _couplings(sheets, stacks, start, count, size):
    """(count,count) sparse, symmetric."""
    a, b, weight = [], [], []
    for level, sheet in sheets.items():
        pairs = np.stack([sheet.quads.ravel(), np.roll(sheet.quads, -1, axis=1).ravel()], 1)
        pairs = np.unique(np.sort(pairs, axis=1), axis=0) + start[level]
        a, b, weight = [*a, pairs[:, 0]], [*b, pairs[:, 1]], [*weight, np.ones(len(pairs))]
    for nodes, stack in stacks:
        for low, high in zip(stack[:-1], stack[1:]):
            below, above = (np.searchsorted(sheets[level].ids, nodes) for level in (low, high))
            gap = max(float((sheets[high].heights[above] - sheets[low].heights[below]).mean()), 1e-3 * size)
            a, b = [*a, below + start[low]], [*b, above + start[high]]
            weight.append(np.full(len(nodes), np.clip((size / gap) ** 2, WEAK, STRONG)))
    a, b, weight = (np.concatenate(x) for x in (a, b, weight))
    return coo_matrix((np.r_[weight, weight], (np.r_[a, b], np.r_[b, a])), shape=(count, count)).tocsr()


def _solve(values, free, couplings):
    """Sets the free rows of values to weighted means of their neighbours'; parts with none known stay."""
    part = connected_components(couplings, directed=False)[1]
    free = np.flatnonzero(free & np.isin(part, part[~free]))
    if not len(free):
        return
    laplacian = (diags(np.asarray(couplings.sum(axis=1)).ravel()) - couplings).tocsr()[free]
    rest = np.ones(len(values), bool)
    rest[free] = False
    values[free] = splu(laplacian[:, free].tocsc()).solve(-(laplacian[:, np.flatnonzero(rest)] @ values[rest]))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which cells of a tensor grid are split into eight, level by level, so that neighbours differ by one level at most."""
import numpy as np

AROUND = np.stack(np.meshgrid(*[[-1, 0, 1]] * 3, indexing="ij"), axis=-1).reshape(-1, 3)


def padded(planes, outside=4):
    """Planes with at least so many cells outside of the solid at each end where planes_of puts one, an even number of
    cells in all: so splits inside never reach the border, on whatever level."""
    out = []
    for p in planes:
        low, high = p[1] - p[0], p[-1] - p[-2]
        more = outside + (len(p) - 1) % 2
        out.append(np.concatenate([p[0] - low * np.arange(outside - 1, 0, -1), p, p[-1] + high * np.arange(1, more)]))
    return out


def balanced_levels(shape, wanted, most):
    """(levels, dropped): for each level the blocks (n, 3) of 2 x 2 x 2 cells that are split; levels left out.

    shape   cells of the grid along each axis; level k has 2^k times as many
    wanted  for each level the cells (m, 3) that are to be split, in numbers of that level
    most    hexes in all, about: the finest levels are left out until there are fewer
    A block of level k > 0 is a cell of level k - 1: all its neighbours, also over edges and corners, are split there.
    """
    for count in range(len(wanted), 0, -1):
        levels = _closed(np.asarray(shape), wanted[:count])
        if np.prod(np.asarray(shape, float)) + sum(map(_cost, levels)) <= most:
            return [one for one in levels if len(one)], len(wanted) - count
    return [], len(wanted)


def _closed(shape, wanted):
    levels, more = [], np.zeros((0, 3), int)
    for level in range(len(wanted) - 1, -1, -1):
        cells = np.vstack([np.asarray(wanted[level], int).reshape(-1, 3), more])
        inside = ((cells >= 0) & (cells < shape * 2 ** level)).all(axis=1)
        blocks = np.unique(cells[inside] // 2, axis=0)
        levels.insert(0, blocks)
        more = np.unique((blocks[:, None] + AROUND).reshape(-1, 3), axis=0)
    return levels


def _cost(blocks):
    """Hexes that a level adds, about: seven for each of its cells, three for each of those round them."""
    around = len(np.unique((blocks[:, None] + AROUND).reshape(-1, 3), axis=0)) - len(blocks)
    return 7 * 8 * len(blocks) + 3 * 3 * around


def cells_round(blocks, shape, axes):
    """Cells (n, 3) of blocks, and of the ring round them along `axes`; those outside of 0 ... shape left out."""
    reach = np.where(np.isin(np.arange(3), axes), 1, 0)
    offsets = np.stack(np.meshgrid(*[np.arange(-r, 2 + r) for r in reach], indexing="ij"), axis=-1).reshape(-1, 3)
    cells = np.unique((2 * blocks[:, None] + offsets).reshape(-1, 3), axis=0)
    return cells[((cells >= 0) & (cells < shape)).all(axis=1)]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hexes of a tensor grid that is refined locally.

After Malone, Sakurai and Benzley, Two-Refinement by Pillowing for Structured Hexahedral Meshes (22nd International
Meshing Roundtable, 2013): where cells are to be split in two along an axis, each pair of layers gets a pillow just
inside, which makes four layers of it. Across the axis the pairs reach a cell farther than the cells to be split: there
the pillows close, and that ring of cells is the transition. One axis after the other, one level after the other. The
grid's planes stay where they are, and no template is needed: any set of blocks will do.
"""
import numpy as np
from scipy.sparse import coo_matrix

import hexcon_native as hn

from .captured import EDGES
from .grid_levels import cells_round
from .hex_neighbours import FACES
from .pillow_groups import pillow_groups
from .tensor_grid import grid_hexes, places

SWEEPS = 3          # over the points of transitions: edges' other ends averaged
POOR = 0.3          # scaled Jacobian below which a transition's hex is mended by optimisation
RINGS = 2           # of hexes round a poor one that move along


def refined_grid(planes, levels):
    """(points (P, 3), hexes (H, 8)) of the grid with these planes, in the planes' coordinates.

    planes: three ascending arrays; levels: for each level the blocks (n, 3) of two cells each way that are split, as
    balanced_levels makes them. The grid's own points come first, the last axis fastest, and keep their places. Every
    face is shared as a whole; no hex is folded (checked; else ValueError). Linear, but for sorting.
    """
    shape = np.array([len(p) - 1 for p in planes])
    points, hexes = grid_hexes([np.arange(n + 1.0) for n in shape])
    exact = np.ones(len(points), bool)
    cell = np.stack(np.unravel_index(np.arange(len(hexes)), shape), axis=1)
    for level, blocks in enumerate(levels):
        points, hexes, cell = _split(points, hexes, cell, blocks, shape * 2 ** level, level)
        exact = np.append(exact, np.zeros(len(points) - len(exact), bool))
        exact[hexes[cell[:, 0] >= 0]] = True
    if levels:
        points = _smoothed(points, hexes, exact, shape)
    points = places(planes, points)
    return (_mended(points, hexes, exact) if levels else points), hexes


def _split(points, hexes, cell, blocks, shape, level):
    """(points, hexes, cells) after the blocks' cells have been split along all axes; cells in numbers of the next
    level, -1 where a hex is none."""
    ancestor = _codes(cell, shape)
    for axis in range(3):
        across = [k for k in range(3) if k != axis]
        chosen = np.isin(ancestor, _codes(cells_round(blocks, shape, across), shape))
        touched = np.zeros(len(points), bool)
        touched[hexes[chosen]] = True
        near = np.flatnonzero(touched[hexes].any(axis=1))
        layer = np.unravel_index(np.maximum(ancestor[near], 0), shape)[axis]
        group = np.where(chosen[near], layer // 2, -1)
        ends = _outer_sides(points, hexes[near], group, axis, shape[axis], 2 ** level)
        points, part, parent = pillow_groups(points, hexes[near], group, 0.5, ends)
        hexes[near] = part[:len(near)]
        hexes = np.vstack([hexes, part[len(near):]])
        ancestor = np.append(ancestor, ancestor[near[parent[len(near):]]])
    split = np.isin(ancestor, _codes(cells_round(blocks, shape, []), shape))
    cell = np.full((len(hexes), 3), -1)
    cell[split] = np.floor(points[hexes[split]].mean(axis=1) * 2 ** (level + 1)).astype(int)
    return points, hexes, cell


def _outer_sides(points, hexes, group, axis, count, scale):
    """Rows of sides of hexes in a group on the grid's border across an axis, where a whole pair of layers ends."""
    at = scale * points[hexes[:, FACES]][:, :, :, axis]
    ends = (at == 0).all(axis=2) | ((at == count).all(axis=2) & (count % 2 == 0))
    return np.flatnonzero(ends & (group >= 0)[:, None])


def _codes(cells, shape):
    """One number for each cell (n, 3) of a grid of that shape; -1 for those that are none."""
    return np.where(cells[:, 0] < 0, -1, (cells[:, 0] * shape[1] + cells[:, 1]) * shape[2] + cells[:, 2])


def _smoothed(points, hexes, exact, shape):
    """Points of transitions at the mean of their neighbours, those on the grid's border along it."""
    points = points.copy()
    pairs = np.unique(np.sort(hexes[~exact[hexes].all(axis=1)][:, EDGES].reshape(-1, 2), axis=1), axis=0)
    pairs = np.vstack([pairs, pairs[:, ::-1]])
    pairs = pairs[~exact[pairs[:, 0]]]
    free, row = np.unique(pairs[:, 0], return_inverse=True)
    mean = coo_matrix((1 / np.bincount(row)[row], (row, pairs[:, 1])), shape=(len(free), len(points))).tocsr()
    held = (points[free] == 0) | (points[free] == shape)
    for _ in range(SWEEPS):
        points[free] = np.where(held, points[free], mean @ points)
    return points


def _mended(points, hexes, exact):
    """Points with the poorest hexes of transitions improved, and none folded."""
    near = hn.quality(points, hexes).scaled_jacobian < POOR
    near &= ~exact[hexes].all(axis=1)
    if near.any():
        touched = np.zeros(len(points), bool)
        for _ in range(RINGS):
            touched[hexes[near]] = True
            near = touched[hexes].any(axis=1)
        held = exact | (points == points.min(axis=0)).any(axis=1) | (points == points.max(axis=0)).any(axis=1)
        held[hexes[~near]] = True
        used, packed = np.unique(hexes[near], return_inverse=True)
        points = points.copy()
        points[used] = hn.optimize(points[used], packed.reshape(-1, 8), held[used], target=POOR, threads=1)
    least = hn.quality(points, hexes).min
    if least <= 0:
        raise ValueError(f"a refined grid with a folded hex: least scaled Jacobian {least:.3g}")
    return points

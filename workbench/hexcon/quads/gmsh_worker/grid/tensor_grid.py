# SPDX-License-Identifier: LGPL-2.1-or-later
"""A tensor grid: its points and cells, and places in numbers of cells."""
import numpy as np


def grid_hexes(planes):
    """(points (P, 3), hexes (H, 8)): all cells between three ascending arrays of planes, the last axis fastest."""
    shape = [len(p) for p in planes]
    points = np.stack(np.meshgrid(*planes, indexing="ij"), -1).reshape(-1, 3)
    i, j, k = np.meshgrid(*[np.arange(n - 1) for n in shape], indexing="ij")
    first = ((i * shape[1] + j) * shape[2] + k).ravel()
    x, y = shape[1] * shape[2], shape[2]
    return points, first[:, None] + np.array([0, x, x + y, y, 1, x + 1, x + y + 1, y + 1])


def indices(planes, points):
    """(n, 3) places in numbers of cells: 2.5 is the middle between planes 2 and 3."""
    return np.stack([np.interp(points[:, k], planes[k], np.arange(len(planes[k]))) for k in range(3)], axis=1)


def places(planes, index):
    """(n, 3) points that are there in numbers of cells: what `indices` undoes."""
    return np.stack([np.interp(index[:, k], np.arange(len(planes[k])), planes[k]) for k in range(3)], axis=1)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the examples start from: the surface of a box of cubes, and its hexes."""
import numpy as np


def box(*cells):
    """(points (P, 3), hexes (H, 8) in VTK order, quads (n, 4) outward) of so many cubes along x, y and z."""
    shape = np.array(cells) + 1
    points = np.stack(np.meshgrid(*map(np.arange, shape), indexing="ij"), axis=-1).reshape(-1, 3).astype(float)
    ids = np.arange(len(points)).reshape(shape)
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    hexes = np.stack([ids[x:x + cells[0], y:y + cells[1], z:z + cells[2]].ravel() for x, y, z in corners], axis=1)
    sides = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
    faces = hexes[:, sides].reshape(-1, 4)
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    return points, hexes, faces[first[count == 1]]


def box_surface(*cells):
    """(points, quads) of the surface alone: points inside are dropped."""
    points, _, quads = box(*cells)
    used, renumbered = np.unique(quads, return_inverse=True)
    return points[used], renumbered.reshape(quads.shape)

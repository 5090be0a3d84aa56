# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces and edges of tetrahedra, and what lies on the surface."""
import numpy as np

FACES = np.array([[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]])             # outward; face i is opposite corner i
EDGES = np.array([[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]])


def turned(triples):
    """Triples (N,3) rotated so that the smallest number comes first: equal if they are one oriented triangle."""
    first = np.argmin(triples, axis=1)
    return triples[np.arange(len(triples))[:, None], (first[:, None] + np.arange(3)) % 3]


def boundary(tetrahedra):
    """(M,4) bool: which faces of (M,4) tetrahedra belong to one alone. Cost O(M log M)."""
    faces = np.sort(tetrahedra[:, FACES].reshape(-1, 3), axis=1)
    _, number, count = np.unique(faces, axis=0, return_inverse=True, return_counts=True)
    return (count[number.reshape(-1)] == 1).reshape(-1, 4)


def keys(pairs, count):
    """One int64 for each pair (..., 2) of point numbers below `count`, whatever the order in it."""
    low, high = np.sort(np.asarray(pairs, np.int64), axis=-1)[..., 0], np.max(pairs, axis=-1)
    return low * count + high

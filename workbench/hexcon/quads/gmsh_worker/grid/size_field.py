# SPDX-License-Identifier: LGPL-2.1-or-later
"""How large elements may be, by place."""
import numpy as np
from scipy.spatial import cKDTree

GROWTH = 0.6        # of the size, for each unit of distance
BINS = 4            # a doubling of sizes: sources of nearly the same size are asked for together


class SizeField:
    """position -> size: the least of `size`, of sources that grow with distance, and of functions.

    size       largest anywhere
    points (n, 3), sizes (n,)   sources: elements as small as that there, larger by GROWTH for each unit of distance
    functions  each takes points (m, 3) and returns sizes (m,), as a user gives them
    A call costs O(log n) a point for each of a few classes of sizes; it is 2^(1 / BINS) below the exact least at most.
    """

    def __init__(self, size, points=(), sizes=(), functions=()):
        self.size, self.functions = float(size), tuple(functions)
        points, sizes = np.asarray(points, float).reshape(-1, 3), np.asarray(sizes, float).reshape(-1)
        if len(points) != len(sizes):
            raise ValueError(f"{len(points)} points have {len(sizes)} sizes; one each is needed")
        if not (self.size > 0 and (sizes > 0).all() and np.isfinite(sizes).all() and np.isfinite(points).all()):
            raise ValueError("sizes must be positive and finite, and points finite")
        low = sizes < self.size
        self.points, self.sizes = points[low], sizes[low]
        kind = np.floor(BINS * np.log2(self.sizes)).astype(int)
        self._classes = [(cKDTree(self.points[kind == k]), self.sizes[kind == k].min()) for k in np.unique(kind)]

    def __call__(self, points):
        """(m,) sizes at points (m, 3). Raises ValueError where a function gives none that is positive."""
        points = np.asarray(points, float).reshape(-1, 3)
        found = np.full(len(points), self.size)
        for tree, least in self._classes:
            distance, _ = tree.query(points, distance_upper_bound=(self.size - least) / GROWTH)
            found = np.minimum(found, least + GROWTH * distance)
        for function in self.functions:
            given = np.asarray(function(points), float).reshape(-1)
            if given.shape != found.shape or not (given > 0).all():
                raise ValueError("a size must be a positive number at every place")
            found = np.minimum(found, given)
        return found

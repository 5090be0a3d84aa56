# SPDX-License-Identifier: LGPL-2.1-or-later
"""How large elements may be, by place: the one object through which sizes reach the surface methods."""
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial import cKDTree

GROWTH = 0.6        # of the size, for each unit of distance
BINS = 4            # a doubling of sizes: sources of nearly the same size are asked for together


@dataclass(frozen=True)
class Place:
    """A box, low (3,) to high (3,), and what is within a radius of it, where elements have a size."""

    low: np.ndarray
    high: np.ndarray
    radius: float
    size: float

    def __call__(self, points):
        """(m,) sizes at points (m, 3)."""
        distance = np.linalg.norm(np.maximum(0.0, np.maximum(self.low - points, points - self.high)), axis=1)
        return self.size + GROWTH * np.maximum(0.0, distance - self.radius)


class SizeField:
    """position -> size: the least of `size`, and of sources and places, where it grows with the distance from them.

    size       largest anywhere
    points (n, 3), sizes (n,)   sources: elements as small as that there, larger by GROWTH for each unit of distance
    places     Places, measured exactly
    names      what wants smaller elements, in words;  name_of (n,): which of them each source is of, -1 of none
    A call costs O(log n) a point for each of a few classes of sizes; it is 2^(1 / BINS) below the exact least at most.
    """

    def __init__(self, size, points=(), sizes=(), places=(), names=(), name_of=None):
        self.size, self.names = float(size), tuple(names)
        self.places = tuple(place for place in places if place.size < size)
        points, sizes = np.asarray(points, float).reshape(-1, 3), np.asarray(sizes, float).reshape(-1)
        if len(points) != len(sizes):
            raise ValueError(f"{len(points)} points have {len(sizes)} sizes; one each is needed")
        if not (self.size > 0 and (sizes > 0).all() and np.isfinite(sizes).all() and np.isfinite(points).all()):
            raise ValueError("sizes must be positive and finite, and points finite")
        low = sizes < self.size
        self.points, self.sizes = points[low], sizes[low]
        self.name_of = np.full(len(self.points), -1) if name_of is None else np.asarray(name_of, int)[low]
        kind = np.floor(BINS * np.log2(self.sizes)).astype(int)
        self._classes = [(cKDTree(self.points[kind == k]), self.sizes[kind == k].min()) for k in np.unique(kind)]
        self._nearest = None

    @property
    def even(self):
        """Whether elements are to be of one size everywhere."""
        return not len(self.points) and not self.places

    @property
    def least(self):
        """The smallest size anywhere."""
        return min([float(self.sizes.min(initial=self.size)), *(place.size for place in self.places)])

    def __call__(self, points):
        """(m,) sizes at points (m, 3)."""
        points = np.asarray(points, float).reshape(-1, 3)
        found = np.full(len(points), self.size)
        for tree, least in self._classes:
            distance, _ = tree.query(points, distance_upper_bound=(self.size - least) / GROWTH)
            found = np.minimum(found, least + GROWTH * distance)
        return np.minimum(found, self._of_places(points))

    def for_gmsh(self, _dim, _tag, x, y, z, *_more):
        """The size at one place, as gmsh's setSizeCallback asks for it. That of the nearest source counts, which is
        enough where sources lie close together, as on edges and faces, and takes one look-up."""
        point = np.array([[x, y, z]])
        size = min(self.size, float(self._of_places(point)[0]))
        if len(self.points):
            if self._nearest is None:
                self._nearest = cKDTree(self.points), _graded(self.points, self.sizes, self.size)
            tree, sizes = self._nearest
            distance, near = tree.query(point[0])
            size = min(size, float(sizes[near] + GROWTH * distance))
        return size

    def scaled(self, factor):
        """The field with all sizes multiplied, though not how fast they grow."""
        places = [replace(place, size=factor * place.size) for place in self.places]
        return SizeField(factor * self.size, self.points, factor * self.sizes, places, self.names, self.name_of)

    def joined(self, other):
        """The least of both; its largest size is this one's."""
        return SizeField(self.size, np.vstack([self.points, other.points]), np.append(self.sizes, other.sizes),
                         (*self.places, *other.places), (*self.names, *other.names),
                         np.append(self.name_of, np.where(other.name_of < 0, -1, other.name_of + len(self.names))))

    def smallest_names(self, most):
        """At most so many names of what wants smaller elements, those with the smallest sources first."""
        least = {}
        for k, size in zip(self.name_of.tolist(), self.sizes.tolist()):
            if k >= 0:
                least[k] = min(size, least.get(k, np.inf))
        return [self.names[k] for k in sorted(least, key=lambda k: (least[k], k))[:most]]

    def _of_places(self, points):
        return np.min([place(points) for place in self.places], axis=0) if self.places else np.full(len(points), np.inf)


def _graded(points, sizes, size):
    """Sizes lowered until none exceeds another's by more than GROWTH times their distance."""
    tree, sizes = cKDTree(points), sizes.copy()
    for k in np.argsort(sizes):
        near = np.array(tree.query_ball_point(points[k], (size - sizes[k]) / GROWTH), int)
        sizes[near] = np.minimum(sizes[near], sizes[k] + GROWTH * np.linalg.norm(points[near] - points[k], axis=1))
    return sizes

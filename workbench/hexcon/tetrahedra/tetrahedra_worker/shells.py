# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which triangles of a surface hang together."""
import numpy as np


def shells_of(points, triangles):
    """Rows of the triangles of each connected shell; that of the largest volume, the outer one, first, as gmsh
    wants it before the cavities. Cost O(T log T), nearly.
    """
    label = _least_connected(triangles, len(points))
    _, shell = np.unique(label[triangles[:, 0]], return_inverse=True)
    volumes = np.bincount(shell, np.linalg.det(points[triangles] - points.mean(axis=0)))
    return [np.flatnonzero(shell == k) for k in np.argsort(-volumes)]


def _least_connected(triangles, count):
    """(count,) the least number of a point that hangs together with each: least labels spread, and are looked up at
    the points that they name, which doubles the way they go."""
    label = np.arange(count)
    while True:
        new = label.copy()
        np.minimum.at(new, triangles.ravel(), np.repeat(label[triangles].min(axis=1), 3))
        new = np.minimum(new, new[new])
        if (new == label).all():
            return label
        label = new

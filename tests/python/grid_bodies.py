# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangulated bodies and box grids for the tests of the overlay grid."""
import numpy as np


def tensor_grid(*planes):
    """(points, hexes in VTK order) of a grid with these planes across x, y, z."""
    nx, ny, nz = (len(p) for p in planes)
    points = np.stack([a.ravel() for a in np.meshgrid(*planes, indexing="ij")], axis=1)
    i, j, k = (a.ravel() for a in np.meshgrid(*(np.arange(n - 1) for n in (nx, ny, nz)), indexing="ij"))
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    return points, np.stack([((i + a) * ny + j + b) * nz + k + c for a, b, c in corners], axis=1)


def box(low, high):
    low, high = np.asarray(low, float), np.asarray(high, float)
    points = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]) * (high - low) + low
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return points, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def ball(centre, radius, around=24):
    """Latitudes and longitudes."""
    v, u = np.meshgrid(np.linspace(0, np.pi, around // 2 + 1)[1:-1], np.arange(around) * 2 * np.pi / around,
                       indexing="ij")
    ring = np.stack([np.sin(v) * np.cos(u), np.sin(v) * np.sin(u), np.cos(v)], axis=2).reshape(-1, 3)
    points = np.vstack([ring, [[0, 0, 1], [0, 0, -1]]]) * radius + centre
    rows = around // 2 - 1
    triangles, north, south = [], rows * around, rows * around + 1
    for j in range(around):
        k = (j + 1) % around
        triangles.append((north, j, k))
        triangles.append((south, (rows - 1) * around + k, (rows - 1) * around + j))
        for i in range(rows - 1):
            a, b, c, d = i * around + j, (i + 1) * around + j, (i + 1) * around + k, i * around + k
            triangles += [(a, b, c), (a, c, d)]
    return points, np.array(triangles)


def torus(major, minor, around=32):
    u, v = np.meshgrid(*[np.arange(around) * 2 * np.pi / around] * 2, indexing="ij")
    r = major + minor * np.cos(v)
    points = np.stack([r * np.cos(u), r * np.sin(u), minor * np.sin(v)], axis=2).reshape(-1, 3)
    i, j = (a.ravel() for a in np.meshgrid(*[np.arange(around)] * 2, indexing="ij"))
    k, m = (i + 1) % around, (j + 1) % around
    a, b, c, d = i * around + j, k * around + j, k * around + m, i * around + m
    return points, np.vstack([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def together(*bodies):
    """One triangulation of several: the second and later ones are turned over, as cavities are."""
    points = np.vstack([p for p, _ in bodies])
    offsets = np.cumsum([0] + [len(p) for p, _ in bodies])
    return points, np.vstack([(t if k == 0 else t[:, ::-1]) + offsets[k] for k, (_, t) in enumerate(bodies)])


def turned(points, seed):
    """Points under a random rotation."""
    q, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    return points @ q.T


def volume(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return (a * np.cross(b, c)).sum() / 6

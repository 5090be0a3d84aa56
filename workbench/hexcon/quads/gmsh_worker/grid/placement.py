# SPDX-License-Identifier: LGPL-2.1-or-later
"""First places of a captured mesh's points: on their curves in order, on their patches, even in between."""
import numpy as np
from scipy.sparse import coo_matrix

import hexcon_native as hn

from .captured import EDGES

STRUCTURED = 0.95   # least scaled Jacobian from which nothing is gained by moving points
ROUNDS = 6          # of evening on the surface; the inside, which is cheaper, gets four times as many
EVEN = 0.5          # how far points of curves go from their nearest place to even spacing


def placed(mesh, features, sliding):
    """(P,3) first places. mesh: a CapturedMesh; sliding: its Sliding. Linear.

    Where the grid's own places are as good as a STRUCTURED mesh's, they stay: blocky parts.
    """
    points = sliding.project(mesh.points)
    if hn.quality(points, mesh.hexes).min >= STRUCTURED:
        return points
    points = mesh.points.copy()
    for c, chain in enumerate(sliding.chains):
        points[chain] = _along(features.curves[c], points[chain])
    points = sliding.project(points)
    rows = sliding.on_patch()
    ring = mesh.quads[:, [[0, 1], [1, 2], [2, 3], [3, 0]]].reshape(-1, 2)
    surface = _averaging(ring, len(points))[rows]
    for _ in range(ROUNDS):
        points[rows] = 0.5 * points[rows] + 0.5 * (surface @ points)
        points = sliding.project(points)
    return evened_inside(mesh, points)


def evened_inside(mesh, points):
    """(P,3) points with those inside in the middle of their neighbours, about."""
    points, inner = points.copy(), np.ones(len(points), bool)
    inner[mesh.quads] = False
    volume = _averaging(mesh.hexes[:, EDGES].reshape(-1, 2), len(points))[inner]
    for _ in range(4 * ROUNDS):
        points[inner] = volume @ points
    return points


def _along(curve, points):
    """Places on a curve, ascending, for a chain of points whose first and last are its ends (one, if it is closed)."""
    s, _ = curve.lengths_of(points)
    first = 0.0
    if curve.closed or curve.start == curve.end:
        inner = slice(None) if curve.closed else slice(1, -1)
        step = np.diff(s[inner])
        step -= curve.length * np.round(step / curve.length)
        if curve.closed:
            first = s[0]
            s = np.concatenate([[0.0], np.cumsum(step)])
        elif len(s) > 2:
            s[inner] = s[1] + np.concatenate([[0.0], np.cumsum(step)])
    s[0], s[-1] = 0.0, curve.length
    s = _ascending(s).clip(0.0, curve.length)
    s = (1.0 - EVEN) * s + EVEN * np.linspace(0.0, curve.length, len(s))
    out = curve.at(s + first)
    out[-1] = out[0] if curve.closed else out[-1]
    return out


def _ascending(s):
    """The nearest ascending sequence: pool adjacent violators (Barlow et al., 1972)."""
    blocks = []
    for value in s:
        blocks.append([value, 1])
        while len(blocks) > 1 and blocks[-2][0] > blocks[-1][0]:
            v, n = blocks.pop()
            blocks[-1] = [(blocks[-1][0] * blocks[-1][1] + v * n) / (blocks[-1][1] + n), blocks[-1][1] + n]
    return np.concatenate([np.full(n, v) for v, n in blocks])


def _averaging(edges, n):
    """(n, n) matrix that puts each point in the middle of its neighbours."""
    pairs = np.unique(np.vstack([edges, edges[:, ::-1]]), axis=0)
    count = np.bincount(pairs[:, 0], minlength=n)
    return coo_matrix((1.0 / count[pairs[:, 0]], pairs.T), shape=(n, n)).tocsr()

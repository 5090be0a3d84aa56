# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far two bilinear patches are from each other, by minimisation: no proof, but another method."""
import numpy as np
from scipy.optimize import least_squares


def places(corners, u, v):
    """Of a patch with corners (4, 3), at parameters (n,): (n, 3)."""
    u, v = np.asarray(u)[..., None], np.asarray(v)[..., None]
    a, b, c, d = corners
    return (1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c + (1 - u) * v * d


def shared_distance(corners, other, ids, other_ids, place):
    """From what two quads share, a point or edges, to a place."""
    common = [i for i in range(4) if ids[i] in other_ids]
    far = np.inf
    for i in common:
        far = min(far, np.linalg.norm(place - corners[i]))
        j = (i + 1) % 4
        if j in common and (list(other_ids).index(ids[i]) - list(other_ids).index(ids[j])) % 2:
            edge = corners[j] - corners[i]
            t = np.clip(np.dot(place - corners[i], edge) / np.dot(edge, edge), 0, 1)
            far = min(far, np.linalg.norm(place - corners[i] - t * edge))
    return far


def distance(corners, other, ids=(0, 1, 2, 3), other_ids=(4, 5, 6, 7), clear=0.05, starts=10, grid=7):
    """The least distance found of places of the one, no nearer than `clear` to what both share, from
    the other."""
    u, v = (axis.ravel() for axis in np.meshgrid(np.linspace(0, 1, grid), np.linspace(0, 1, grid)))
    ours, theirs = places(corners, u, v), places(other, u, v)
    keep = np.array([shared_distance(corners, other, ids, other_ids, place) >= clear for place in ours])
    if not keep.any():
        return np.inf
    apart = np.linalg.norm(ours[keep][:, None] - theirs[None], axis=2)
    best = np.inf
    for flat in np.argsort(apart, axis=None)[:: max(1, apart.size // (40 * starts))][:starts]:
        i, j = np.unravel_index(flat, apart.shape)
        start = [u[keep][i], v[keep][i], u[j], v[j]]

        def gap(x):
            return places(corners, x[0], x[1]) - places(other, x[2], x[3])

        found = least_squares(gap, np.clip(start, 1e-6, 1 - 1e-6), bounds=(0, 1), xtol=1e-15, ftol=1e-15, gtol=1e-15,
                              max_nfev=300)
        if shared_distance(corners, other, ids, other_ids, places(corners, found.x[0], found.x[1])) >= clear:
            best = min(best, np.linalg.norm(gap(found.x)))
    return best

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Does a surface enclose something; do tetrahedra fill it? Nothing here trusts gmsh."""
from fractions import Fraction

import numpy as np

from hexcon.errors import FaultCode, ToolError

from .topology import FACES, turned


def check_surface(points, triangles):
    """Raise ToolError BAD_TRIANGLES unless the triangles close, look outward and use every point. O(T log T)."""
    if points.ndim != 2 or points.shape[1:] != (3,) or triangles.ndim != 2 or triangles.shape[1:] != (3,):
        _refuse(f"points must be (P, 3) and triangles (T, 3), not {points.shape} and {triangles.shape}")
    if not len(triangles):
        _refuse("there are no triangles")
    if not np.issubdtype(triangles.dtype, np.integer) or triangles.min() < 0 or triangles.max() >= len(points):
        _refuse(f"triangles must hold whole numbers from 0 to {len(points) - 1}")
    if not np.isfinite(points).all():
        _refuse("a point is not finite", np.flatnonzero(~np.isfinite(points).all(axis=1)))
    unused = np.flatnonzero(np.bincount(triangles.ravel(), minlength=len(points)) == 0)
    if len(unused):
        _refuse(f"{len(unused)} points belong to no triangle", unused)
    _check_closed(triangles, len(points))
    corners = points[triangles] - points.mean(axis=0)
    if not np.linalg.det(corners).sum() > 0.0:
        _refuse("the triangles do not look outward: the volume they enclose is not positive")


def _check_closed(triangles, count):
    """Each directed edge once, and its reverse once."""
    ends = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).astype(np.int64)
    forward, backward = (ends @ np.array(weights) for weights in ((count, 1), (1, count)))
    values, inverse, number = np.unique(forward, return_inverse=True, return_counts=True)
    bad = (number[inverse.reshape(forward.shape)] > 1) | ~np.isin(backward, values) | (ends[..., 0] == ends[..., 1])
    if bad.any():
        rows = np.flatnonzero(bad.any(axis=1))
        _refuse(f"the surface is not closed, or not oriented alike: {int(bad.sum())} sides of {len(rows)} triangles "
                "have no single neighbour running the other way", rows)


def _refuse(message, elements=()):
    raise ToolError(message, FaultCode.BAD_TRIANGLES, elements)


def fault_of(points, tetrahedra, surface_points, triangles):
    """None if the tetrahedra fill the surface and keep it bit for bit; else what is wrong, in words.

    points (Q,3), tetrahedra (M,4), surface_points (P,3) float64, triangles (T,3). O(M log M).
    """
    count = len(surface_points)
    if not len(tetrahedra):
        return "no tetrahedra were made"
    if points[:count].tobytes() != surface_points.tobytes():
        return "points of the surface were moved, removed or renumbered"
    if tetrahedra.min() < 0 or tetrahedra.max() >= len(points):
        return "a tetrahedron has a point that does not exist"
    faces = tetrahedra[:, FACES].reshape(-1, 3)
    _, number, times = np.unique(np.sort(faces, axis=1), axis=0, return_inverse=True, return_counts=True)
    if times.max() > 2:
        return "a face belongs to more than two tetrahedra"
    outer = np.unique(turned(faces[times[number.reshape(-1)] == 1]), axis=0)
    given = np.unique(turned(triangles), axis=0)
    if outer.shape != given.shape or (outer != given).any():
        return "the boundary of the tetrahedra is not the given triangles"
    bad = int(np.count_nonzero(~positive(points, tetrahedra)))
    return f"{bad} tetrahedra are flat or inside out" if bad else None


def positive(points, tetrahedra):
    """(M,) bool, without rounding: det(b - a, c - a, d - a) > 0. Exact arithmetic only where it is close."""
    corners = points[tetrahedra]
    edges = corners[:, 1:] - corners[:, :1]
    volumes = np.linalg.det(edges)
    slack = 1e-14 * np.abs(corners).max(axis=(1, 2)) * np.linalg.norm(edges, axis=2).max(axis=1) ** 2
    result = volumes > slack
    for k in np.flatnonzero(np.abs(volumes) <= slack):
        result[k] = _exact_volume(corners[k]) > 0
    return result


def _exact_volume(corners):
    """det(b - a, c - a, d - a) of (4,3) floats as a Fraction."""
    a, *others = [[Fraction(float(x)) for x in corner] for corner in corners]
    (p, q, r), (s, t, u), (v, w, x) = [[y - z for y, z in zip(other, a)] for other in others]
    return p * (t * x - u * w) - q * (s * x - u * v) + r * (s * w - t * v)

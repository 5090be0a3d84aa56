# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of a solid each point of a mesh's boundary lies on: a corner, a curve, a patch of faces, or nothing."""
from dataclasses import dataclass

import numpy as np
from gmsh_worker.grid.sliding import FREE, STAYS
from gmsh_worker.grid.tessellation import Nearest
from scipy.spatial import cKDTree

NEAR = 0.01     # of the boundary edges about a point: as near as that is meant to lie on it


@dataclass
class Landing:
    """carrier_of_point (P,): rows of the FeatureCarriers, FREE inside, STAYS at corners and for strays
    corner_point, corner   points that lie at corners, and which
    dimension (P,)         0 at a corner, 1 on a curve, 2 on a patch, 3 inside or on nothing
    off, allowed (P,)      how far points were off what they lie on, and might have been; 0 inside
    strays                 points of the boundary that lie on nothing
    faces (n,)             CAD face of each boundary quad
    boundary_count         points of the boundary;  notes: what else is to be said
    """

    carrier_of_point: np.ndarray
    corner_point: np.ndarray
    corner: np.ndarray
    dimension: np.ndarray
    off: np.ndarray
    allowed: np.ndarray
    strays: np.ndarray
    faces: np.ndarray
    boundary_count: int
    notes: list


def landed(features, on, points, quads, tolerance):
    """Landing of a mesh.

    features: Features; on: their FeatureCarriers; points (P,3); quads (n,4) its boundary; tolerance: how far points
    may be off, 0: NEAR of the edges about them
    Corners come first, each for the nearest point, then curves, then patches: a point near a curve is meant to
    lie on it. Linear in the points, but for sorting and the pieces of the features near each.
    """
    allowed = _allowed(points, quads, tolerance)
    dimension, off = np.full(len(points), 3), np.zeros(len(points))
    carrier = np.full(len(points), FREE)
    left = np.unique(quads)
    boundary_count = len(left)
    corner_point, corner = _at_corners(features, points, left, allowed)
    carrier[corner_point], dimension[corner_point] = STAYS, 0
    off[corner_point] = np.linalg.norm(points[corner_point] - features.corners[corner], axis=1)
    left = np.setdiff1d(left, corner_point)
    gap = np.full(len(points), np.inf)
    for c, curve in enumerate(features.curves):
        rows = _near_curve(curve, points, left, allowed)
        if not len(rows):
            continue
        found = np.linalg.norm(curve.project(points[rows])[0] - points[rows], axis=1)
        better = (found <= allowed[rows]) & (found < gap[rows])
        rows = rows[better]
        carrier[rows], dimension[rows], gap[rows] = c, 1, found[better]
    left = left[dimension[left] == 3]
    patch, found = _nearest_patch(features, points[left], allowed[left])
    carrier[left], gap[left], dimension[left] = on.curves + patch, found, 2
    strays = left[~(found <= allowed[left])]
    carrier[strays], dimension[strays] = STAYS, 3
    off = np.where(np.isfinite(gap), gap, off)
    faces, notes = _faces(features, points, quads)
    missing = len(features.corners) - len(corner)
    if missing:
        notes.append(f"{missing} of {len(features.corners)} corners of the solid are no points of the mesh")
    return Landing(carrier, corner_point, corner, dimension, off, allowed, strays, faces, boundary_count, notes)


def _allowed(points, quads, tolerance):
    """(P,) how far each point may be off."""
    if tolerance > 0.0:
        return np.full(len(points), tolerance)
    ends = np.stack([quads, np.roll(quads, -1, axis=1)], axis=-1).reshape(-1, 2)
    length = np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1)
    count = np.bincount(ends.ravel(), minlength=len(points))
    return NEAR * np.bincount(ends.ravel(), np.repeat(length, 2), minlength=len(points)) / np.maximum(count, 1)


def _at_corners(features, points, rows, allowed):
    """(points, corners): each corner with the nearest point, where that is near enough."""
    if not len(features.corners):
        return np.zeros(0, int), np.zeros(0, int)
    gap, at = cKDTree(points[rows]).query(features.corners)
    near = np.flatnonzero(gap <= allowed[rows[at]])
    near = near[np.argsort(gap[near], kind="stable")]
    chosen, first = np.unique(rows[at[near]], return_index=True)
    return chosen, near[first]


def _near_curve(curve, points, rows, allowed):
    """Points among `rows` that may be near enough to a curve: near a sample of it."""
    if not len(rows):
        return rows
    spacing = np.linalg.norm(np.diff(curve.samples, axis=0), axis=1).max(initial=0.0)
    gap, _ = cKDTree(curve.samples).query(points[rows], distance_upper_bound=spacing + allowed[rows].max())
    return rows[gap <= spacing + allowed[rows]]


def _nearest_patch(features, points, allowed):
    """(patch of each point, distance from it): that of the nearest triangle, or where that is too far the nearest of
    all: triangles cut corners off round faces."""
    if not len(points):
        return np.zeros(0, int), np.zeros(0)
    shape = features.cad.tessellation
    patch = features.patch_of_face[shape.face[Nearest(shape.points, shape.triangles)(points)[1]]]
    gap = np.full(len(points), np.inf)
    for p in np.unique(patch):
        rows = np.flatnonzero(patch == p)
        gap[rows] = np.linalg.norm(features.patches[p].project(points[rows])[0] - points[rows], axis=1)
    far = np.flatnonzero(~(gap <= allowed))
    for p, one in enumerate(features.patches if len(far) else ()):
        found = np.linalg.norm(one.project(points[far])[0] - points[far], axis=1)
        better = found < gap[far]
        patch[far[better]], gap[far[better]] = p, found[better]
    return patch, gap


def _faces(features, points, quads):
    """((n,) CAD face of each quad, by its middle; notes)."""
    shape = features.cad.tessellation
    faces = shape.face[Nearest(shape.points, shape.triangles)(points[quads].mean(axis=1))[1]]
    lost = sorted(set(features.cad.solid.faces) - set(faces.tolist()))
    shown = ", ".join(f"Face{f}" for f in lost[:20])
    return faces, [f"no quads lie on {shown}{' ...' if len(lost) > 20 else ''}"] if lost else []

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places of a solid that a mesh must tell apart: across walls and slots, between curves, along short ones."""
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

REACH = 1.5         # of the size: what is farther apart needs no care
STEP = 1 / 3        # of the size: between samples
OPPOSITE = -0.5     # of the cosine: normals of two sides of a wall or a slot
STRAIGHT = 0.8      # of the cosine: the way across is along the normals
SLANT = 0.5         # of the cosine: the way from a curve is across it
NEAREST = 40        # samples looked at for each


@dataclass(frozen=True)
class Gaps:
    """Pairs of places a (n, 3), b (n, 3); kind (n,): rows of KINDS."""

    a: np.ndarray
    b: np.ndarray
    kind: np.ndarray

    def __len__(self):
        return len(self.a)

    @property
    def width(self):
        return np.linalg.norm(self.a - self.b, axis=1)

    def turned(self, frame):
        """The same in the coordinates of a frame (3, 3) of rows."""
        return Gaps(self.a @ frame.T, self.b @ frame.T, self.kind)


KINDS = ("wall", "slot", "curves", "curve and face", "short curve", "hole")


def gaps_of(features, h):
    """Gaps of a solid that are narrower than REACH h.

    features: a Features (its curves, corners, triangles and patches are read); lengths as in the solid. Walls and
    slots: samples of the surface that look at each other; curves: without a common corner; curve and face: of a patch
    that the curve does not touch; short curve: its ends; hole: opposite points of a closed curve.
    Cost: O(S log S) for S samples, some nine for each h^2 of the surface.
    """
    curves = Samples.of_curves(features, h)
    surface = Samples.of_surface(features, h)
    parts = [_between_sides(surface, h, inward, kind) for inward, kind in ((True, 0), (False, 1))]
    parts.append(_between_curves(features, curves, h))
    parts.append(_curves_to_faces(features, curves, surface, h))
    parts.append(_along_curves(features, h))
    a, b, kind = (np.concatenate(column) for column in zip(*parts))
    near = np.linalg.norm(a - b, axis=1) < REACH * h
    return Gaps(a[near], b[near], kind[near])


class Samples:
    """points (n, 3), owner (n,): curves or patches; normals (n, 3) of a surface, tangents of curves; area (n,): what
    each of a surface stands for."""

    def __init__(self, points, owner, normals, area=None):
        self.points, self.owner, self.normals, self.area = points, owner, normals, area
        self.tree = cKDTree(points) if len(points) else None

    @classmethod
    def of_curves(cls, features, h):
        points, owner, tangents = [np.zeros((0, 3))], [np.zeros(0, int)], [np.zeros((0, 3))]
        for k, curve in enumerate(features.curves):
            count = max(4, int(np.ceil(curve.length / (STEP * h))))
            at, step = (np.arange(count) + 0.5) / count * curve.length, 0.1 / count * curve.length
            points.append(curve.sampled(at))
            owner.append(np.full(count, k))
            along = curve.sampled(at + step) - curve.sampled(at - step)
            tangents.append(along / np.maximum(np.linalg.norm(along, axis=1), 1e-300)[:, None])
        return cls(np.vstack(points), np.concatenate(owner), np.vstack(tangents))

    @classmethod
    def of_surface(cls, features, h):
        """Points of a lattice in each triangle, at most STEP h apart, and its middle."""
        corners = features.points[features.triangles]
        longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
        parts = np.clip(np.ceil(longest / (STEP * h)), 1, 200).astype(int)
        points, which, share = [], [], []
        for n in np.unique(parts):
            rows = np.flatnonzero(parts == n)
            i, j = (x.ravel() for x in np.meshgrid(np.arange(n), np.arange(n), indexing="ij"))
            u, v = (i + 1 / 3) / n, (j + 1 / 3) / n
            u, v = u[u + v < 1], v[u + v < 1]
            weights = np.stack([1 - u - v, u, v], axis=1)
            points.append(np.einsum("sk,tkc->tsc", weights, corners[rows]).reshape(-1, 3))
            which.append(np.repeat(rows, len(weights)))
            share.append(np.full(len(which[-1]), 1.0 / len(weights)))
        which = np.concatenate(which)
        normals = features.normals[which]
        area = np.concatenate(share) * np.linalg.norm(normals, axis=1) / 2.0
        normals = normals / np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
        patch = np.asarray(features.patch_of_face)[features.triangle_face[which]]
        return cls(np.vstack(points), patch, normals, area)

    def near(self, points, h):
        """(rows of points, samples) closer than REACH h, the nearest ones."""
        if self.tree is None or not len(points):
            return np.zeros(0, int), np.zeros(0, int)
        distance, found = self.tree.query(points, min(NEAREST, len(self.points)), distance_upper_bound=REACH * h)
        found = found.reshape(len(points), -1)
        rows, columns = np.nonzero(np.isfinite(distance.reshape(found.shape)))
        return rows, found[rows, columns]


def _nearest_of(rows, gap):
    """Of pairs with these rows the index of the one with the least gap for each row that has any."""
    order = np.lexsort((gap, rows))
    first = np.ones(len(order), bool)
    first[1:] = rows[order[1:]] != rows[order[:-1]]
    return order[first]


def _between_sides(surface, h, inward, kind):
    """Samples and the nearest ones that they look at through the solid, or through what is outside."""
    side = surface.points + (-1 if inward else 1) * 0.4 * REACH * h * surface.normals
    rows, other = surface.near(side, h)
    way = surface.points[other] - surface.points[rows]
    gap = np.linalg.norm(way, axis=1)
    along = (way * surface.normals[rows]).sum(axis=1) * (-1 if inward else 1)
    keep = (along > STRAIGHT * gap) & (gap > 0)
    keep &= (surface.normals[rows] * surface.normals[other]).sum(axis=1) < OPPOSITE
    rows, other, gap = rows[keep], other[keep], gap[keep]
    best = _nearest_of(rows, gap)
    return surface.points[rows[best]], surface.points[other[best]], np.full(len(best), kind)


def _between_curves(features, curves, h):
    ends = np.array([(c.start, c.end) for c in features.curves], int).reshape(-1, 2)
    rows, other = curves.near(curves.points, h)
    a, b = ends[curves.owner[rows]], ends[curves.owner[other]]
    meet = ((a[:, :, None] == b[:, None, :]) & (a[:, :, None] >= 0)).any(axis=(1, 2))
    way = curves.points[other] - curves.points[rows]
    gap = np.linalg.norm(way, axis=1)
    keep = ~meet & (curves.owner[rows] != curves.owner[other])
    for side in (rows, other):          # not round a corner: straight across from both
        keep &= np.abs((way * curves.normals[side]).sum(axis=1)) < SLANT * gap
    rows, other = rows[keep], other[keep]
    best = _nearest_of(rows, np.linalg.norm(curves.points[rows] - curves.points[other], axis=1))
    return curves.points[rows[best]], curves.points[other[best]], np.full(len(best), 2)


def _curves_to_faces(features, curves, surface, h):
    """Samples of curves, and the nearest of patches that neither the curve nor its corners touch."""
    touched = np.zeros((len(features.curves), len(features.patches)), bool)
    for k, curve in enumerate(features.curves):
        for corner in (curve.start, curve.end):
            if corner >= 0:
                touched[k, list(features.corner_patches[corner])] = True
        touched[k, [curve.left, curve.right]] = True
    rows, other = surface.near(curves.points, h)
    way = surface.points[other] - curves.points[rows]
    gap = np.linalg.norm(way, axis=1)
    keep = ~touched[curves.owner[rows], surface.owner[other]]
    keep &= np.abs((way * surface.normals[other]).sum(axis=1)) > STRAIGHT * gap
    keep &= np.abs((way * curves.normals[rows]).sum(axis=1)) < SLANT * gap
    rows, other = rows[keep], other[keep]
    best = _nearest_of(rows, np.linalg.norm(curves.points[rows] - surface.points[other], axis=1))
    return curves.points[rows[best]], surface.points[other[best]], np.full(len(best), 3)


def _along_curves(features, h):
    """Ends of short curves, opposite points of closed ones."""
    a, b, kind = [np.zeros((0, 3))], [np.zeros((0, 3))], [np.zeros(0, int)]
    for curve in features.curves:
        at = np.array([0.0, 0.5 * curve.length])
        if curve.closed:
            at = np.arange(8) / 8 * curve.length
            a.append(curve.sampled(at[:4]))
            b.append(curve.sampled(at[4:]))
            kind.append(np.full(4, 5))
        elif curve.length < REACH * h:
            a.append(curve.sampled(at[:1]))
            b.append(curve.sampled([curve.length]))
            kind.append(np.full(1, 4))
    return np.vstack(a), np.vstack(b), np.concatenate(kind)

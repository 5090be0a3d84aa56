# SPDX-License-Identifier: LGPL-2.1-or-later
"""Proofs that no valid mesh exists whatever the free points do, in exact arithmetic.

At any place in a hex the Jacobian is affine in the position of one corner. So where at most one
of the points it depends on is free, it is a number, or a half-space for that point. A number that
is not positive, or half-spaces of one point that have nothing in common, forbid every valid mesh.
"""
from fractions import Fraction

import numpy as np
from mesh_checker import CORNERS
from scipy.optimize import linprog

# A grid over a hex, its corners included, of fractions that doubles hold: (125, 3).
PLACES = np.stack(np.meshgrid(*[[0, 0.25, 0.5, 0.75, 1]] * 3, indexing="ij"), axis=3).reshape(-1, 3)


def _slopes():
    """Derivatives of the eight trilinear functions at PLACES: (125, 3, 8)."""
    weights = np.where(CORNERS[None], PLACES[:, None], 1 - PLACES[:, None])
    sign = np.where(CORNERS, 1.0, -1.0)
    return np.stack([sign[:, axis] * np.delete(weights, axis, 2).prod(axis=2)
                     for axis in range(3)], axis=1)


SLOPES = _slopes()


def _cross(a, b):
    return np.stack([a[..., 1] * b[..., 2] - a[..., 2] * b[..., 1],
                     a[..., 2] * b[..., 0] - a[..., 0] * b[..., 2],
                     a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]], axis=-1)


def _half_spaces(slopes, corners, lone):
    """Jacobians (k,) as normal . p + offset, p the corner `lone`, whose place is not used:
    (normal (k, 3), offset (k,)). slopes (k, 3, 8), corners (k, 8, 3): floats or fractions."""
    k = np.arange(len(slopes))
    own = slopes[k, :, lone]
    others = slopes.copy()
    others[k, :, lone] = 0
    r, s, t = (others[:, :, :, None] * corners[:, None]).sum(axis=2).transpose(1, 0, 2)
    normal = sum(own[:, [axis]] * _cross(a, b) for axis, (a, b) in enumerate([(s, t), (t, r),
                                                                              (r, s)]))
    return normal, (r * _cross(s, t)).sum(axis=1)


def _exactly(array):
    return np.array([Fraction(value) for value in np.ravel(array)]).reshape(np.shape(array))


def _rows(hexes, fixed):
    """(hex, place, free corner or -1) wherever at most one point is free: three (n,) arrays."""
    involved = (SLOPES != 0).any(axis=1)[None] & ~fixed[hexes][:, None]    # (H, 125, 8)
    count = involved.sum(axis=2)
    hex_, place = np.nonzero(count <= 1)
    return hex_, place, np.where(count[hex_, place] == 1, involved[hex_, place].argmax(axis=1), -1)


def _null_vector(columns):
    """Of fractions (k, 3): the multiples (k,) whose sum of rows is 0, if they are unique up to a
    factor; else None."""
    rows, pivots = columns.T.copy(), []
    for k in range(len(columns)):
        row = next((i for i in range(len(pivots), 3) if rows[i, k] != 0), None)
        if row is None:
            continue
        at = len(pivots)
        rows[[at, row]] = rows[[row, at]]
        rows[at] = rows[at] / rows[at, k]
        for i in range(3):
            if i != at:
                rows[i] = rows[i] - rows[i, k] * rows[at]
        pivots.append(k)
        if len(pivots) == 3:
            break
    if len(pivots) != len(columns) - 1:
        return None
    free = next(k for k in range(len(columns)) if k not in pivots)
    multiples = np.array([Fraction(0)] * len(columns))
    multiples[free] = Fraction(1)
    multiples[pivots] = -rows[:len(pivots), free]
    return multiples


def _refuted(normal, offset):
    """Whether multiples of these half-spaces, none negative, add up to 0 > something."""
    multiples = _null_vector(normal)
    return multiples is not None and (multiples >= 0).all() and (multiples * offset).sum() <= 0


def _empty(normal, offset, exact):
    """Whether half-spaces have nothing in common: `exact` gives some of them in fractions."""
    length = np.maximum(np.linalg.norm(normal, axis=1), 1e-300)
    # Maximise the distance d <= 1 to all planes.
    found = linprog([0, 0, 0, -1],
                    np.column_stack([-normal / length[:, None], np.ones(len(length))]),
                    offset / length, bounds=[(None, None)] * 3 + [(None, 1)], method="highs")
    if found.status != 0 or found.x[3] > 1e-6:
        return False
    tight = np.argsort(found.ineqlin.marginals)[:4]
    return any(_refuted(*exact(np.sort(tight[:count]))) for count in (2, 3, 4))


def impossible_reason(points, hexes, fixed):
    """Why no places of the free points make every Jacobian positive; None: not proved.

    points (P, 3), rows of free points are not used; hexes (H, 8) VTK order; fixed (P,) bool.
    """
    points, hexes, fixed = np.asarray(points, float), np.asarray(hexes), np.asarray(fixed, bool)
    hex_, place, lone = _rows(hexes, fixed)
    near = points - points[fixed].mean(axis=0)
    near = near / np.abs(near[fixed]).max()

    def exact(rows):
        return _half_spaces(_exactly(SLOPES[place[rows]]), _exactly(points[hexes[hex_[rows]]]),
                            lone[rows])
    normal, offset = _half_spaces(SLOPES[place], near[hexes[hex_]], lone)
    # Nothing free: corner -1 is the last one, and does not matter where its slopes are zero.
    settled = np.flatnonzero((lone < 0) & (offset + (normal * near[hexes[hex_, -1]]).sum(axis=1)
                                           < 1e-9))
    for row in settled:
        normals, offsets = exact(np.array([row]))
        last = _exactly(points[hexes[hex_[row], -1]])
        if offsets[0] + (normals[0] * last).sum() <= 0:
            return f"hex {hex_[row]} at {PLACES[place[row]]}: fixed points alone make it negative"
    owner = np.where(lone < 0, -1, hexes[hex_, lone])
    for point in np.unique(owner[lone >= 0]):
        rows = np.flatnonzero(owner == point)
        if _empty(normal[rows], offset[rows], lambda tight, rows=rows: exact(rows[tight])):
            return f"point {point}: {len(rows)} half-spaces of it alone have nothing in common"
    return None

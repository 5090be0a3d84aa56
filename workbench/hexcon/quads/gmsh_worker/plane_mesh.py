# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small tools for plane meshes with a fixed outline."""
import numpy as np


def harmonic(values, quads, fixed, tolerance=1e-10, rounds=2000):
    """(m,k) values with the free rows set to the mean of their edge neighbours (conjugate gradients).

    fixed (m,) bool. Cost about sqrt(m) products with the graph Laplacian.
    """
    a, b = quads.ravel(), np.roll(quads, -1, axis=1).ravel()
    low, high = np.minimum(a, b), np.maximum(a, b)
    pairs = np.unique(low * np.int64(len(values)) + high)
    low, high = pairs // len(values), pairs % len(values)
    free = ~fixed
    degree = np.bincount(low, minlength=len(values)) + np.bincount(high, minlength=len(values))

    def laplace(x):
        y = degree[:, None] * x
        for k in range(x.shape[1]):
            y[:, k] -= np.bincount(low, x[high, k], minlength=len(x))
            y[:, k] -= np.bincount(high, x[low, k], minlength=len(x))
        y[fixed] = 0.0
        return y

    x = np.array(values, float)
    r = -laplace(x)
    p, rr = r.copy(), float((r * r).sum())
    stop = tolerance ** 2 * max(rr, 1e-300)
    for _ in range(rounds):
        if rr <= stop or not free.any():
            break
        ap = laplace(p)
        alpha = rr / max(float((p * ap).sum()), 1e-300)
        x += alpha * p
        r -= alpha * ap
        rr, before = float((r * r).sum()), rr
        p = r + rr / before * p
    return x


def image(points, quads, outline):
    """(m,k) image of a mesh whose first points go to `outline` (Nb,k): the best affine map of the outline, plus a
    harmonic correction of what it leaves."""
    total = len(outline)
    fixed = np.arange(len(points)) < total
    centre = points[:total].mean(axis=0)
    with_one = np.c_[points - centre, np.ones(len(points))]
    matrix = np.linalg.lstsq(with_one[:total], outline, rcond=1e-9)[0]
    made = with_one @ matrix
    residual = np.zeros_like(made)
    residual[fixed] = outline - made[fixed]
    if np.abs(residual).max() > 1e-10 * np.abs(outline - outline.mean(axis=0)).max():
        made += harmonic(residual, quads, fixed)
    made[fixed] = outline
    return made


def coons(bottom, right, top, left):
    """Transfinite interpolation. bottom, top (n+1,d) left to right; left, right (m+1,d) upwards -> (m+1,n+1,d)."""
    u = np.linspace(0.0, 1.0, len(bottom))[None, :, None]
    v = np.linspace(0.0, 1.0, len(left))[:, None, None]
    grid = (1 - v) * bottom[None] + v * top[None] + (1 - u) * left[:, None] + u * right[:, None]
    grid -= (1 - u) * (1 - v) * bottom[0] + u * (1 - v) * bottom[-1] + (1 - u) * v * top[0] + u * v * top[-1]
    grid[0], grid[-1], grid[:, 0], grid[:, -1] = bottom, top, left, right
    return grid


def grid_quads(ids):
    """(k,4) quads of an (m+1,n+1) array of point numbers, counter-clockwise if it is seen as rows upwards."""
    return np.stack([ids[:-1, :-1], ids[:-1, 1:], ids[1:, 1:], ids[1:, :-1]], -1).reshape(-1, 4)


class Builder:
    """Collects interior points and quads after `boundary` (Nb,2) fixed points."""

    def __init__(self, boundary):
        self.points = [np.asarray(boundary, float)]
        self.count = len(boundary)
        self.quads = []

    def add(self, points):
        """Append points (k,2); returns their numbers (k,)."""
        points = np.asarray(points, float).reshape(-1, 2)
        self.points.append(points)
        self.count += len(points)
        return np.arange(self.count - len(points), self.count)

    def block(self, bottom, right, top, left):
        """Structured block between four chains of point numbers (as in coons)."""
        p = np.concatenate(self.points)
        grid = coons(p[bottom], p[right], p[top], p[left])
        ids = np.empty(grid.shape[:2], int)
        ids[0], ids[-1], ids[:, 0], ids[:, -1] = bottom, top, left, right
        ids[1:-1, 1:-1] = self.add(grid[1:-1, 1:-1]).reshape(ids[1:-1, 1:-1].shape)
        self.quads.append(grid_quads(ids))

    def result(self):
        """(points (m,2), quads (n,4))."""
        return np.concatenate(self.points), np.concatenate(self.quads)

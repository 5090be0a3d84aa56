# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small tools for plane meshes with a fixed outline."""
import numpy as np
from scipy.sparse import coo_matrix, diags
from scipy.sparse.linalg import splu


def polygon_area(p):
    """Of a closed polygon (n,2), counter-clockwise; its first point may come again at the end."""
    q = np.roll(p, -1, axis=0)
    return float((p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]).sum() / 2)


def laplacian(quads, count):
    """(count,count) sparse graph Laplacian of the edges of quads."""
    a, b = quads.ravel(), np.roll(quads, -1, axis=1).ravel()
    adjacent = coo_matrix((np.ones(2 * len(a)), (np.r_[a, b], np.r_[b, a])), shape=(count, count)).tocsr()
    adjacent.data[:] = 1.0      # an inner edge came twice
    return diags(np.asarray(adjacent.sum(axis=1)).ravel()) - adjacent


def harmonic(values, quads, fixed):
    """(m,k) values with the free rows set to the mean of their edge neighbours. fixed (m,) bool.

    One sparse factorisation of the graph Laplacian: about m log m in the plane.
    """
    x = np.array(values, float)
    free = np.flatnonzero(~fixed)
    if len(free):
        rows = laplacian(quads, len(values)).tocsr()[free]
        x[free] = splu(rows[:, free].tocsc()).solve(-(rows[:, np.flatnonzero(fixed)] @ x[fixed]))
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

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Swept hex meshes made by formula, certified as made, and their points thrown about."""
import numpy as np
from mesh_checker import EDGES, FACES
from surfaces import annulus, grid, o_grid, upright


def extruded(cap, levels, place):
    """Layers of a cap: (points, hexes, fixed). place(t, xy) -> xyz, t in levels, from 0 to 1."""
    flat, quads = cap
    points = np.vstack([place(t, flat) for t in np.linspace(0, 1, levels + 1)])
    first = len(flat) * np.arange(levels)[:, None, None]
    hexes = np.concatenate([quads + first, quads + first + len(flat)], axis=2).reshape(-1, 8)
    return points, hexes, on_boundary(hexes)


def boundary_quads(hexes):
    """(n, 4): faces of one hex only, seen from outside."""
    sides = hexes[:, FACES].reshape(-1, 4)
    _, first, count = np.unique(np.sort(sides, axis=1), axis=0,
                                return_index=True, return_counts=True)
    return sides[first[count == 1]]


def on_boundary(hexes):
    """(P,) bool, P the largest id + 1."""
    fixed = np.zeros(hexes.max() + 1, bool)
    fixed[boundary_quads(hexes)] = True
    return fixed


def scramble(points, hexes, fixed, amount, seed):
    """Points (P, 3) with every free one moved by up to `amount` times the mean length of its
    edges, evenly in that ball; the fixed ones (bool, (P,)) stay bit for bit."""
    rng = np.random.default_rng(seed)
    ends = np.unique(np.sort(hexes[:, EDGES].reshape(-1, 2), axis=1), axis=0)
    length = np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1)
    total = np.bincount(ends.ravel(), np.repeat(length, 2), len(points))
    mean = total / np.maximum(np.bincount(ends.ravel(), minlength=len(points)), 1)
    move = rng.normal(size=points.shape)
    move /= np.linalg.norm(move, axis=1)[:, None]
    move *= (amount * mean * rng.uniform(0, 1, len(points)) ** (1 / 3))[:, None]
    return np.where(fixed[:, None], points, points + move)


# ------------------------------------------------------------------------------------------ shapes

def _turned(xy, angle):
    c, s = np.cos(angle), np.sin(angle)
    return xy @ [[c, s], [-s, c]]


def graded_box(n):
    """n * n * n, every direction finer towards one end, 1 to 6."""
    def graded(t):
        return (6 ** t - 1) / 5
    return extruded(grid(n, n), n, lambda t, xy: upright(2 * graded(t), graded(xy / n) * [1, 1.5]))


def twisted_prism(n):
    """n * n * 2 n, turned by 100 degrees over 3 widths of height."""
    return extruded(grid(n, n), 2 * n,
                    lambda t, xy: upright(3 * t, _turned(xy / n - 0.5, np.radians(100) * t)))


def pipe_sector(n):
    """n in the wall, 4 n along 110 degrees, 3 n in height, the bore wider at one end."""
    def place(t, xy):
        radius, angle = 1 + 0.3 * t + 0.5 * xy[:, 1] / n, np.radians(110) * (1 - xy[:, 0] / (4 * n))
        return upright(2 * t, np.column_stack([radius * np.cos(angle), radius * np.sin(angle)]))
    return extruded(grid(4 * n, n), 3 * n, place)


def cylinder(n):
    """An o-grid of n * n and 2 n rings, 3 n layers, leaning."""
    return extruded(o_grid(n, 2 * n), 3 * n, lambda t, xy: upright(2 * t, xy / n + [0.5 * t, 0]))


def bent_bar(n):
    """n * n * 5 n, bent by 150 degrees."""
    def place(t, xy):
        x, y = (xy / n - 0.5).T
        angle = np.radians(150) * t
        return np.column_stack([(1.6 + x) * np.cos(angle), y, (1.6 + x) * np.sin(angle)])
    return extruded(grid(n, n), 5 * n, place)


def tapered_plate(n):
    """A square plate with a round hole, thinner at one side: 8 n around, 2 n wide, n thick."""
    def place(t, xy):
        radius = np.linalg.norm(xy, axis=1, keepdims=True)
        square = xy / np.abs(xy).max(axis=1, keepdims=True)
        xy = np.where(radius > 0, (2 - radius) * 0.4 * xy / radius + (radius - 1) * square, xy)
        return upright(0, xy) + np.outer(t * (0.6 - 0.2 * xy[:, 0]), [0, 0, 1])
    return extruded(annulus(8 * n, 2 * n), n, place)


# Builder and its hexes for n = 1.
SHAPES = {graded_box: 1, twisted_prism: 2, pipe_sector: 12, cylinder: 27, bent_bar: 5,
          tapered_plate: 16}


def swept_meshes(size):
    """Yields (name, (points (P, 3), hexes (H, 8), fixed (P,) bool)), about `size` hexes each."""
    for build, unit in SHAPES.items():
        yield build.__name__, build(max(2, round((size / unit) ** (1 / 3))))

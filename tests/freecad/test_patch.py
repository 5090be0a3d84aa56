# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patch test: a linear displacement on the boundary of a distorted swept mesh gives one stress.

The solid is a prism on an irregular cap of quads, tapered, sheared and bent from ring to ring, so
that no hex is a parallelepiped: what finds elements, and meshes, that only work on bricks.
"""
import numpy as np
import pytest
from test_calculix_deck import patch_error

import hexcon_native as hn


def irregular_cap(sides, cuts, rng):
    """(points (P,2), quads) of an n-gon: one block of cuts x cuts quads to each corner, no two
    quads alike, the rim included."""
    angle = 2 * np.pi * np.arange(2 * sides) / (2 * sides)
    ring = np.column_stack([np.cos(angle), np.sin(angle)])
    ring[1::2] = (ring[::2] + np.roll(ring[::2], -1, axis=0)) / 2  # middles of the sides
    s, t = np.meshgrid(*[np.arange(cuts + 1) / cuts] * 2, indexing="ij")
    grid = np.arange((cuts + 1) ** 2).reshape(cuts + 1, cuts + 1)
    block = np.stack([grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]], -1)
    points, quads = [], []
    for k in range(sides):
        before, corner, after = ring[[2 * k - 1, 2 * k, (2 * k + 1) % (2 * sides)]]
        points.append((s * (1 - t))[..., None] * before + (s * t)[..., None] * corner
                      + ((1 - s) * t)[..., None] * after)
        quads.append(block.reshape(-1, 4) + k * grid.size)
    points = np.concatenate(points).reshape(-1, 2)
    _, first, same = np.unique(points.round(9), axis=0, return_index=True, return_inverse=True)
    points = points[first] + rng.uniform(-0.15, 0.15, (len(first), 2)) / cuts
    return points, same.reshape(-1)[np.concatenate(quads)]


def swept_surface(cap, quads, rings):
    """(points, quads) of the surface over a cap, outward: lifted, tapered, sheared and bent."""
    edges = np.stack([quads, np.roll(quads, -1, axis=1)], -1).reshape(-1, 2)
    backwards = {tuple(e) for e in edges[:, ::-1].tolist()}
    rim = np.array([e for e in edges.tolist() if tuple(e) not in backwards])
    count, levels = len(cap), []
    for h in np.arange(rings + 1) / rings:
        flat = cap * (1 - 0.35 * h) * (1 + 0.1 * h * cap[:, :1])
        levels.append(np.column_stack([flat + (0.5 * h + 0.3 * h ** 2, -0.3 * h),
                                       1.6 * h + 0.15 * h * cap[:, 0] - 0.1 * h * cap[:, 1]]))
    walls = [np.column_stack([rim + k * count, rim[:, ::-1] + (k + 1) * count])
             for k in range(rings)]
    quads = np.concatenate([quads[:, ::-1], *walls, quads + rings * count])
    used, packed = np.unique(quads, return_inverse=True)
    return np.concatenate(levels)[used], packed.reshape(-1, 4)


def skewness(mesh):
    """(H,) how far each hex is from a parallelepiped, in parts of its size."""
    p = mesh.points[mesh.hexes]
    a, b, c = (p[:, k] - p[:, 0] for k in (1, 3, 4))
    brick = p[:, :1] + np.stack([0 * a, a, a + b, b, c, a + c, a + b + c, b + c], axis=1)
    size = np.linalg.norm(np.ptp(p, axis=1), axis=1)
    return np.linalg.norm(p - brick, axis=2).max(axis=1) / size


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("sides,cuts,rings", [(3, 2, 3), (5, 2, 4), (4, 3, 3)])
def test_patch(sides, cuts, rings, order):
    cap, quads = irregular_cap(sides, cuts, np.random.default_rng(sides))
    mesh = hn.mesh(*swept_surface(cap, quads, rings), "swept")
    assert mesh.certificate.certified and len(mesh.hexes) == len(quads) * rings
    assert skewness(mesh).min() > 0.02
    stress, nodal, displacement = patch_error(mesh, order)
    print(f"patch C3D{8 if order == 1 else 20}, {sides} sides: {len(mesh.hexes)} hexes, scaled "
          f"Jacobian {mesh.quality.min:.3f}, skewness {skewness(mesh).min():.3f} to "
          f"{skewness(mesh).max():.3f}: stress {stress:.1e}, at nodes {nodal:.1e}, "
          f"displacement {displacement:.1e}")
    assert stress < 1e-4 and nodal < 1e-4 and displacement < 1e-4

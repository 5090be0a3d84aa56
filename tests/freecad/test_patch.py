# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patch test: a linear displacement on the boundary of a distorted swept mesh gives one stress.

The solid is a prism on a random cap of quads, tapered, sheared and bent from ring to ring, so that
no hex is a parallelepiped: what finds elements, and meshes, that only work on bricks.
"""
import pathlib
import sys

import numpy as np
import pytest
from test_calculix_deck import patch_error

import hexcon_native as hn

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))
from surfaces import prism, random_cap, relaxed  # noqa: E402


def leaning(t, xy):
    """A cap at t of 0 .. 1: lifted, tilted, tapered, sheared and bent."""
    flat = xy * (1 - 0.35 * t) * (1 + 0.05 * t * xy[:, :1]) + (1.5 * t + 0.9 * t ** 2, -0.9 * t)
    return np.column_stack([flat, 4 * t + 0.15 * t * xy[:, 0] - 0.1 * t * xy[:, 1]])


def skewness(mesh):
    """(H,) how far each hex is from a parallelepiped, in parts of its size."""
    p = mesh.points[mesh.hexes]
    a, b, c = (p[:, k] - p[:, 0] for k in (1, 3, 4))
    brick = p[:, :1] + np.stack([0 * a, a, a + b, b, c, a + c, a + b + c, b + c], axis=1)
    size = np.linalg.norm(np.ptp(p, axis=1), axis=1)
    return np.linalg.norm(p - brick, axis=2).max(axis=1) / size


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("seed,size,rings,holes", [(1, 3, 3, 0), (2, 4, 4, 0), (3, 5, 2, 1)])
def test_patch(seed, size, rings, holes, order):
    cap = relaxed(random_cap(np.random.default_rng(seed), size, holes))
    mesh = hn.mesh(*prism(cap, np.linspace(0, 1, rings + 1), leaning), "swept")
    assert mesh.certificate.certified and len(mesh.hexes) == len(cap[1]) * rings
    skew = skewness(mesh)
    assert skew.min() > 0.01
    stress, nodal, displacement = patch_error(mesh, order)
    print(f"patch C3D{8 if order == 1 else 20}, cap {seed}: {len(mesh.hexes)} hexes, scaled "
          f"Jacobian min {mesh.quality.min:.3f}, skewness {skew.min():.3f} to {skew.max():.3f}: "
          f"stress {stress:.1e}, at nodes {nodal:.1e}, displacement {displacement:.1e}")
    assert stress < 1e-4 and nodal < 1e-4 and displacement < 1e-4

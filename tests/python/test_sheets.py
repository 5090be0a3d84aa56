# SPDX-License-Identifier: LGPL-2.1-or-later
"""Method sheets: natural meshes by taking one dual loop after the other away."""
import mesh_checker
import numpy as np
import pytest
from surfaces import box, permuted, schneiders_pyramid

import hexcon_native as hn

SHAPES = [(1, 1, 1), (2, 1, 1), (1, 3, 1), (2, 2, 1), (2, 2, 2), (1, 1, 9), (5, 1, 3), (3, 4, 5), (7, 2, 9),
          (4, 4, 1), (6, 6, 6), (2, 11, 2), (8, 3, 3), (10, 10, 2), (1, 12, 12), (5, 7, 3), (9, 9, 4),
          (15, 2, 6), (3, 3, 14), (12, 11, 10)]


def certified(surface, hexes=None, small=400):
    """The mesh, proved by the core and, where it is small, by the independent checker."""
    mesh = hn.mesh(*surface, "sheets")
    assert mesh.method == "sheets" and mesh.certificate.certified and not mesh.topological
    assert hexes is None or len(mesh.hexes) == hexes
    if len(mesh.hexes) <= small:
        assert mesh_checker.faults(mesh.points, mesh.hexes, surface[1], surface[0]) == []
    return mesh


@pytest.mark.parametrize("shape", SHAPES)
def test_a_box_is_its_grid(shape):
    rng = np.random.default_rng(sum(shape))
    points, quads = box(*shape)
    mesh = certified(permuted((points, quads), rng), np.prod(shape))
    assert mesh.quality.min > 1 - 1e-9
    assert mesh.report["sheets"] == sum(shape) - 3 and mesh.report["core quads"] == 0
    graded = np.cumsum(rng.uniform(0.5, 2, 60))[points.astype(int) + [0, 13, 26]]
    assert certified(permuted((graded, quads), rng), np.prod(shape)).quality.min > 1 - 1e-9


def test_a_core_is_told():
    points, quads = schneiders_pyramid()
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(points, quads, "sheets")
    assert fault.value.code == hn.ErrorCode.NO_SHEETS
    assert "of 16 quads" in str(fault.value) and "a core of 8" in str(fault.value)
    assert 0 < len(fault.value.elements) <= 8

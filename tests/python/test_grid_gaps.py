# SPDX-License-Identifier: LGPL-2.1-or-later
"""Narrow places of solids, and grids split there. Needs gmsh importable, as the worker does."""
import numpy as np
import pytest

import hexcon_native as hn
from hexcon.quads.gmsh_worker.grid.captured import NotCaptured
from hexcon.quads.gmsh_worker.grid.cells_to_split import for_gaps
from hexcon.quads.gmsh_worker.grid.gaps import KINDS, gaps_of
from hexcon.quads.gmsh_worker.grid.overlay import Work, _captured as captured, overlay
from hexcon.quads.gmsh_worker.grid.placement import placed
from hexcon.quads.gmsh_worker.grid.planes import planes_of
from hexcon.quads.gmsh_worker.grid.sheet_plan import sheeted
from hexcon.quads.gmsh_worker.grid.sliding import Sliding
from hexcon.quads.gmsh_worker.size_field import SizeField


def block(occ):
    occ.addBox(0, 0, 0, 6, 5, 4)


def hollowed(occ):
    """A wall of 0.3 at x = 0, a slot of 0.4 at the other end."""
    occ.cut([(3, occ.addBox(0, 0, 0, 8, 5, 4))], [(3, occ.addBox(0.3, 1, 1, 3, 3, 3)),
                                                  (3, occ.addBox(7, 1, -1, 0.4, 5, 6))])


def stepped(occ):
    """A step 0.25 high and a hole of radius 0.3."""
    occ.cut([(3, occ.addBox(0, 0, 0, 6, 5, 4))], [(3, occ.addBox(3, -1, 3.75, 4, 7, 1)),
                                                  (3, occ.addCylinder(1.5, 2.5, -1, 0, 0, 6, 0.3))])


def slanted(occ):
    """A wall of 0.5 that no plane of the grid fits."""
    wall = occ.addBox(-3, -0.25, 0, 6, 0.5, 3)
    occ.rotate([(3, wall)], 0, 0, 0, 0, 0, 1, 0.4)
    occ.fuse([(3, wall)], [(3, occ.addBox(-4, -4, -2, 8, 8, 2))])


def narrowest(gaps):
    return {name: round(float(gaps.width[gaps.kind == k].min()), 2) for k, name in enumerate(KINDS)
            if (gaps.kind == k).any()}


def test_kinds_of_gaps(features):
    assert len(gaps_of(features(block, 1.0), 1.0)) == 0
    found = narrowest(gaps_of(features(hollowed, 1.0), 1.0))
    assert found["wall"] == 0.3 and found["slot"] == 0.4
    found = narrowest(gaps_of(features(stepped, 1.0), 1.0))
    assert found["hole"] == pytest.approx(0.6, abs=0.02) and found["short curve"] == 0.25 and "slot" in found
    found = narrowest(gaps_of(features(slanted, 1.0), 1.0))
    assert found["wall"] == pytest.approx(0.5, abs=0.05) and found["short curve"] == 0.5


def test_gaps_do_not_depend_on_the_place(features):
    """Between both sides of a gap are the solid's own points."""
    shape = features(slanted, 1.0)
    gaps = gaps_of(shape, 1.0)
    low, high = shape.points.min(axis=0) - 1e-9, shape.points.max(axis=0) + 1e-9
    for p in (gaps.a, gaps.b):
        assert ((p >= low) & (p <= high)).all()


def test_planes_on_walls_need_no_splits(features):
    shape = features(hollowed, 1.0)
    planes = planes_of(shape, np.eye(3), 1.0)
    wanted, left = for_gaps(planes, gaps_of(shape, 1.0), 1.0)
    assert sum(map(len, wanted)) == 0 and len(left) == 0


@pytest.mark.parametrize("sizes", [None, SizeField(1.0, [[0, 0, 0]], [0.4])])
def test_without_narrow_places_no_grid_is_made_for_them(features, sizes):
    """It would be the grid of the try before, whatever sizes are wanted."""
    with pytest.raises(NotCaptured, match="nothing narrower"):
        overlay(features(block, 1.0), 1.0, Work(), levels=1, sizes=sizes)


def test_a_thin_wall_across_the_grid_is_captured(features):
    """Which no grid of these cells holds; split twice they do, and nothing stays folded."""
    shape = features(slanted, 1.2)
    mesh, most = captured(shape, 1.2, Work(), lambda stage, fraction: None, 2)
    assert len(most.curves) == len(shape.curves)
    assert set(mesh.patch.tolist()) == set(range(len(shape.patches)))
    mesh, sliding = (joined := sheeted(mesh, most, inside=False)[0]), Sliding(joined, most)
    points = sliding.relax(placed(mesh, most, sliding), threads=1)
    assert hn.quality(points, mesh.hexes).min > 0.2

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Dual loops as curves and pairs as bars: what is drawn is what the core counts."""
import pathlib
import sys

import numpy as np
import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from hex_grids import block, cylinder  # noqa: E402

import hexcon  # noqa: E402
import hexcon_native as hn  # noqa: E402
from hexcon.errors import ToolError  # noqa: E402
from hexcon.inspection.dual_loops import LoopedSurface  # noqa: E402
from hexcon.inspection.pairs import bars_of_pairs  # noqa: E402
from hexcon.pictures.pair_colours import colours_of_pairs  # noqa: E402
from hexcon.quads.surface import QuadSurface, edge_partners, edges_of, given  # noqa: E402


def surface_of(name):
    if name in hexcon.example_names():
        return hexcon.example(name)
    mesh = block(4, 3, 2) if name == "block" else cylinder(6, 4, 2.0, 5.0)
    return given(mesh.points, mesh.quads, [])


@pytest.fixture(params=["block", "cylinder", "schneiders", "octahedron", "eppstein-22"])
def looped(request):
    return LoopedSurface(surface_of(request.param))


def test_loops_are_the_cores(looped):
    report = hn.check_surface(looped.surface.points, looped.surface.quads)
    assert sorted(map(len, looped.loops)) == sorted(report.loops.lengths)
    assert len(looped.crossings) == report.loops.self_crossings.sum()
    passed = np.bincount(np.concatenate([loop.quads for loop in looped.loops]))
    assert (passed == 2).all()  # every quad by two passages


def test_curves_follow_their_quads(looped):
    surface = looped.surface
    middles = surface.points[edges_of(surface.quads)].mean(axis=1).reshape(-1, 4, 3)
    for loop in looped.loops:
        assert np.array_equal(loop.curve[0], loop.curve[-1]) and len(loop.curve) == len(loop) + 1
        for quad, start, end in zip(loop.quads, loop.curve, loop.curve[1:]):
            ways = [(middles[quad, k], middles[quad, k - 2]) for k in range(4)]
            assert any(np.allclose(start, one) and np.allclose(end, two) for one, two in ways)
        assert set(loop.crossings) == {q for q in loop.quads.tolist() if (loop.quads == q).sum() == 2}


def test_pairs(looped):
    surface, pairs = looped.surface, looped.pairs
    bars = bars_of_pairs(surface.points, surface.quads, pairs)
    ends = surface.points[surface.quads].mean(axis=1)[pairs]
    assert np.allclose(bars[:, [0, 2]], ends)
    middles = surface.points[edges_of(surface.quads)].mean(axis=1)
    other = edge_partners(surface.quads) // 4
    for (one, two), bar in zip(pairs.tolist(), bars):
        shared = [middles[e] for e in range(4 * one, 4 * one + 4) if other[e] == two]
        assert any(np.allclose(bar[1], middle) for middle in shared)
    colours = colours_of_pairs(surface.quads, pairs)
    assert np.array_equal(colours[pairs[:, 0]], colours[pairs[:, 1]])


def test_a_loop_that_is_not_there(looped):
    assert looped.loop(0) is looped.loops[0]
    for row in (-1, len(looped.loops)):
        with pytest.raises(ToolError, match="loops 0 to"):
            looped.loop(row)


def test_an_open_surface_is_refused():
    surface = surface_of("block")
    with pytest.raises(hexcon.HexconError, match="closed"):
        LoopedSurface(QuadSurface(surface.points, surface.quads[1:], surface.face_of_quad[1:], "given"))

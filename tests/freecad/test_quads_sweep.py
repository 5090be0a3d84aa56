# SPDX-License-Identifier: LGPL-2.1-or-later
"""Method `sweep` on solids made in FreeCAD."""
import os
import sys

import numpy as np
import pytest

sys.path[:0] = [os.path.dirname(os.path.abspath(__file__))]

import quads_solids  # noqa: E402
from quads_checks import assert_closed_even_outward, assert_on_faces, scaled_jacobian, swept, vertices_kept  # noqa: E402

from hexcon.errors import FaultCode, ToolError  # noqa: E402
from hexcon.quads import surface_from_solid  # noqa: E402

CASES = [(name, size) for table in (quads_solids.BRIEF, quads_solids.MORE)
         for name, (_, sizes, _) in table.items() for size in sizes]
ALL = {**quads_solids.BRIEF, **quads_solids.MORE}


@pytest.mark.parametrize("name,size", CASES)
def test_sweep(name, size):
    maker, _, least = ALL[name]
    shape = maker()
    surface = surface_from_solid(shape, size, "sweep")
    assert surface.method == "sweep"
    assert_closed_even_outward(surface, shape)
    assert_on_faces(surface, shape)
    assert vertices_kept(surface, shape)
    _assert_counts(surface)
    lower, upper, _, _ = swept(surface)
    for cap in (lower, upper):
        quality = scaled_jacobian(surface.points, surface.quads[surface.face_of_quad == cap])
        print(f"{name} {size} Face{cap}: {len(quality)} quads, {quality.min():.3f} to mean {quality.mean():.3f}")
        assert quality.min() >= least


def _assert_counts(surface):
    """Caps of equal count; the walls are the cap outline times the rings; the caps are isomorphic."""
    lower, upper, cap_quads, rings = swept(surface)
    of = surface.face_of_quad
    assert (of == lower).sum() == (of == upper).sum() == cap_quads
    walls = len(of) - 2 * cap_quads
    edges = surface.quads[of == lower]
    sides = np.stack([edges, np.roll(edges, -1, axis=1)], -1).reshape(-1, 2)
    inner = {tuple(e) for e in sides}
    outline = [e for e in inner if e[::-1] not in inner]
    assert walls == len(outline) * rings
    valence = [np.sort(np.unique(surface.quads[of == cap], return_counts=True)[1]) for cap in (lower, upper)]
    assert np.array_equal(*valence)


@pytest.mark.parametrize("maker,instead", [(quads_solids.filleted_box, "layered"),
                                           (quads_solids.two_way_bracket, "boxed"),
                                           (lambda: quads_solids.Part.makeSphere(5), "blocks")])
def test_not_sweepable(maker, instead):
    with pytest.raises(ToolError) as caught:
        surface_from_solid(maker(), 2.0, "sweep")
    assert caught.value.code is FaultCode.NOT_SWEEPABLE
    surface = surface_from_solid(maker(), 2.0, "auto")
    assert surface.method == instead
    assert any("not swept" in note for note in surface.notes)
    assert_closed_even_outward(surface)


def test_scale_does_not_matter():
    """A metre-sized and a micrometre-sized cylinder give the mesh of the unit one."""
    counts = [len(surface_from_solid(quads_solids.Part.makeCylinder(5 * s, 12 * s), 2.0 * s, "sweep").quads)
              for s in (0.01, 1.0, 1000.0)]
    assert counts[0] == counts[1] == counts[2]


def test_moved_and_turned():
    shape = quads_solids.shaft_segment()
    shape.Placement = quads_solids.FreeCAD.Placement(
        quads_solids.Vector(100, -50, 20), quads_solids.FreeCAD.Rotation(quads_solids.Vector(1, 2, 3), 77))
    surface = surface_from_solid(shape, 2.0, "sweep")
    assert_closed_even_outward(surface, shape)
    assert_on_faces(surface, shape)


def test_same_twice():
    shape = quads_solids.two_hole_plate()
    first, second = (surface_from_solid(shape, 3.0, "sweep") for _ in range(2))
    assert np.array_equal(first.points, second.points) and np.array_equal(first.quads, second.quads)

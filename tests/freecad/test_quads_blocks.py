# SPDX-License-Identifier: LGPL-2.1-or-later
"""Method `blocks` on solids made in FreeCAD: the surface, and the core's hexes where it fills it as one sweep."""
import os
import sys

import numpy as np
import pytest

sys.path[:0] = [os.path.dirname(os.path.abspath(__file__))]

import block_solids  # noqa: E402
from quads_checks import assert_closed_even_outward, assert_on_faces, scaled_jacobian, vertices_kept  # noqa: E402
from quads_solids import Part  # noqa: E402

import hexcon_native as hn  # noqa: E402
from hexcon.errors import FaultCode, ToolError  # noqa: E402
from hexcon.quads import surface_from_solid  # noqa: E402


def cases(table):
    return [(name, size) for name, (_, sizes, _) in table.items() for size in sizes]


def natural(shape, size, least):
    """The surface of a shape, checked for all that every surface of blocks promises."""
    surface = surface_from_solid(shape, size, "blocks")
    assert surface.method == "blocks"
    assert_closed_even_outward(surface)
    assert_on_faces(surface, shape, most=200)
    assert not np.any(hn.check_surface(surface.points, surface.quads).loops.self_crossings)
    quality = scaled_jacobian(surface.points, surface.quads)
    spacing = (shape.Area / len(surface.quads)) ** 0.5 / size
    print(f"{len(quality)} quads, scaled Jacobian {quality.min():.3f} to mean {quality.mean():.3f}, "
          f"mean size {spacing:.2f} of the wanted one")
    assert quality.min() >= least
    assert 0.5 < spacing < 2.0
    return surface


def irregular(surface):
    """The valences other than four, sorted."""
    valence = np.bincount(surface.quads.ravel())
    return sorted(valence[valence != 4].tolist())


@pytest.mark.parametrize("name,size", cases(block_solids.CORNERED))
def test_corners(name, size):
    """One block at each corner: three quads there, and as many at a face's centre as it has corners."""
    maker, _, least = block_solids.CORNERED[name]
    shape = maker()
    surface = natural(shape, size, least)
    assert vertices_kept(surface, shape)
    edges = [sum(abs(e.Length) > 1e-9 for e in face.Edges) for face in shape.Faces]
    assert irregular(surface) == sorted([3] * len(shape.Vertexes) + [n for n in edges if n != 4])


@pytest.mark.parametrize("name,size", cases(block_solids.ROUND))
def test_round(name, size):
    """As of a cube: eight points with three quads, and no other that is irregular."""
    maker, _, least = block_solids.ROUND[name]
    assert irregular(natural(maker(), size, least)) == [3] * 8


@pytest.mark.parametrize("seed", range(10))
def test_random_polytopes(seed):
    shape, size = block_solids.random_polytope(seed)
    angles = block_solids.corner_angles(shape)
    if angles.min() < 10 or angles.max() > 168:
        with pytest.raises(ToolError, match="has a corner of") as caught:
            surface_from_solid(shape, size, "blocks")
        assert caught.value.code is FaultCode.NOT_BLOCKS
        return
    surface = natural(shape, size, 0.15)
    assert vertices_kept(surface, shape)
    assert irregular(surface) == sorted([3] * len(shape.Vertexes)
                                        + [len(f.Edges) for f in shape.Faces if len(f.Edges) != 4])


def test_numbers_of_quads():
    """A box of a x b x c intervals, a dodecahedron of s x s at each corner, a ball of k x k on six sides."""
    assert len(surface_from_solid(Part.makeBox(10, 7, 5), 1.0, "blocks").quads) == 2 * (70 + 50 + 35)
    dodecahedron = block_solids.dodecahedron()
    size = dodecahedron.Edges[0].Length / 4
    assert len(surface_from_solid(dodecahedron, size, "blocks").quads) == 20 * 3 * 2 * 2
    assert len(surface_from_solid(Part.makeSphere(5), 5 * (4 * np.pi / 6) ** 0.5 / 6, "blocks").quads) == 6 * 6 * 6


def test_long_edges_have_more_quads():
    """Every direction of a box has its own number, every face of a cut one its own layers."""
    surface = surface_from_solid(Part.makeBox(40, 10, 5), 2.5, "blocks")
    assert len(surface.quads) == 2 * (16 * 4 + 16 * 2 + 4 * 2)


@pytest.mark.parametrize("name", block_solids.REFUSED)
def test_refused(name):
    maker, words = block_solids.REFUSED[name]
    with pytest.raises(ToolError, match=words) as caught:
        surface_from_solid(maker(), 1.5, "blocks")
    assert caught.value.code is FaultCode.NOT_BLOCKS


@pytest.mark.parametrize("name,method", [("cylinder", "sweep"), ("box", "sweep"), ("ball", "blocks"),
                                         ("dodecahedron", "blocks"), ("lens", "blocks")])
def test_auto(name, method):
    maker, sizes, _ = {**block_solids.CORNERED, **block_solids.ROUND}[name]
    surface = surface_from_solid(maker(), sizes[0], "auto")
    assert surface.method == method
    assert (method == "sweep") == (not any("not swept" in note for note in surface.notes))


@pytest.mark.parametrize("name,size", [("box", 2), ("wedge", 2), ("cylinder", 2), ("cone frustum", 2), ("capsule", 2),
                                       ("hexagonal prism", 2), ("domed cylinder", 1.5)])
def test_swept_by_the_core(name, size):
    maker, _, _ = {**block_solids.CORNERED, **block_solids.ROUND}[name]
    surface = surface_from_solid(maker(), size, "blocks")
    mesh = hn.mesh(surface.points, surface.quads, "swept")
    quality = hn.quality(mesh.points, mesh.hexes)
    print(f"{len(surface.quads)} quads, {len(mesh.hexes)} hexes, {quality.min:.3f} to mean {quality.mean:.3f}")
    assert mesh.certificate.certified and quality.min > 0.25
    assert len(mesh.hexes) < 4 * len(surface.quads)

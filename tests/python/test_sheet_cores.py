# SPDX-License-Identifier: LGPL-2.1-or-later
"""Method sheets where loops cross themselves: layers as far as they go, and the core they leave filled."""
import mesh_checker
import numpy as np
import pytest
from blossom_surfaces import blossom_surface
from surfaces import box, permuted, schneiders_pyramid

import hexcon
import hexcon_native as hn
from hexcon.tetrahedra import tetrahedralise


def split(surface):
    """Every quad split in four: twice as many loops, which cross themselves where they did."""
    points, quads = surface
    places, names, small = list(points), {}, []

    def middle(*ids):
        name = tuple(sorted(ids))
        if name not in names:
            names[name] = len(places)
            places.append(points[list(ids)].mean(axis=0))
        return names[name]

    for quad in quads.tolist():
        center = middle(*quad)
        small += [[quad[i], middle(quad[i], quad[(i + 1) % 4]), center, middle(quad[i - 1], quad[i])]
                  for i in range(4)]
    return np.array(places), np.array(small)


def with_core(surface, **options):
    """A certified mesh of layers and a core, by the core's own proof and by the independent checker."""
    mesh = hn.mesh(*surface, "sheets", pillow="never", **options)
    report = mesh.report
    assert mesh.method == "sheets" and mesh.certificate.certified and not mesh.topological
    assert mesh_checker.faults(mesh.points, mesh.hexes, surface[1], surface[0]) == []
    assert report["core quads"] + report["quads removed"] == len(surface[1])
    assert 0 < report["core quads"] <= 0.9 * len(surface[1])
    assert 0 < report["core hexes"] < len(mesh.hexes) and report["sheets"] >= 1
    assert f"a core of {report['core quads']:.0f} quads filled with" in "".join(report["log"])
    return mesh


def test_a_small_core_is_from_the_table():
    surface = permuted(schneiders_pyramid(), np.random.default_rng(1))
    mesh = with_core(surface)
    assert mesh.report["core quads"] == 8 and mesh.report["core hexes"] == 40 and len(mesh.hexes) == 44
    assert "small fillings" in "".join(mesh.report["log"]) and mesh.quality.min > 0.15


def test_a_larger_one_is_cells():
    """About a point in the middle; 36 hexes a quad of the core, where cells alone take 40 a quad of the surface."""
    mesh = with_core(permuted(split(schneiders_pyramid()), np.random.default_rng(2)))
    assert mesh.report["core quads"] == 32 and mesh.quality.min > 0.1
    assert len(mesh.hexes) == 32 + 32 * 40


def test_a_layer_over_all_lets_any_loop_go(tmp_path):
    """Where the surface is flat at a loop, a layer has no room before one covers everything."""
    surface = blossom_surface("cut_8", 70, tmp_path)
    mesh = with_core(surface, tetrahedralise=tetrahedralise)
    assert mesh.quality.min >= 0.1 and mesh.quality.mean > 0.5
    assert len(mesh.hexes) <= 38 * len(surface[1])


def test_a_core_can_be_refused():
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(*schneiders_pyramid(), "sheets", pillow="never", core=False)
    assert fault.value.code == hn.ErrorCode.NO_SHEETS
    assert "of 16 quads" in str(fault.value) and "a core of 8" in str(fault.value)
    assert 0 < len(fault.value.elements) <= 8
    assert len(hn.mesh(*box(2, 2, 2), "sheets", pillow="never", core=False).hexes) == 8


def test_no_loop_that_can_go_is_told_at_once():
    """The one loop of the quadrilateral octahedron crosses itself."""
    octahedron = hexcon.example("octahedron")
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(octahedron.points, octahedron.quads, "sheets", pillow="never")
    assert fault.value.code == hn.ErrorCode.NO_SHEETS


def test_the_result_does_not_depend_on_threads():
    surface = split(schneiders_pyramid())
    first, second = (hn.mesh(*surface, "sheets", pillow="never", threads=threads) for threads in (1, 2))
    assert first.points.tobytes() == second.points.tobytes()
    assert first.hexes.tobytes() == second.hexes.tobytes()


def test_order_and_cancelling():
    assert hn.mesh(*schneiders_pyramid(), "sheets", pillow="never", order=2).hexes.shape == (44, 20)
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(*schneiders_pyramid(), "sheets", pillow="never", progress=lambda stage, part: "untangling" not in stage)
    assert fault.value.code == hn.ErrorCode.CANCELLED


def test_auto_takes_what_needs_fewest_hexes(tmp_path):
    """Rotated edges before a core, a core before cells: none is tried when one before it is good."""
    surface = blossom_surface("box", 60, tmp_path)
    mesh = hexcon.mesh_surface(*surface)
    assert mesh.method == "shelling" and mesh.certificate.certified
    assert any(line.startswith("shelling: ") for line in mesh.report["log"])
    assert not any(line.startswith(("sheets and a core", "cells")) for line in mesh.report["log"])
    assert len(mesh.hexes) < len(hexcon.mesh_surface(*surface, "sheets", pillow="never").hexes)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The last step of the methods for solvers: a sheet of hexes under the whole surface, where it helps."""
import re
from types import SimpleNamespace

import numpy as np
import pytest
from cell_surfaces import projected, round_hull, shaken, sphere, twisted_prism
from mesh_checker import FACES, faults
from surfaces import box, permuted, schneiders_pyramid

import hexcon_native as hn
from hexcon.cli import main
from hexcon.files import read_mesh, write
from hexcon.inspection.stages import stages_of
from hexcon.pillows import CHOICES, pillow_of


def surfaces():
    """(surface, method) by which it can be filled; each is another kind of boundary."""
    rng = np.random.default_rng(17)
    yield "box", box(2, 3, 1), "swept"
    yield "twisted", twisted_prism(2, 3, 0.9, 0.3), "swept"
    yield "ball", sphere(3), "sheets"
    yield "shaken", shaken(rng, sphere(3), 0.1), "sheets"
    yield "projected", projected(rng, sphere(2)), "swept"
    yield "pyramid", schneiders_pyramid(), "smallest"
    yield "pyramid in shells", schneiders_pyramid(), "shelling"
    yield "hull", round_hull(rng, 8), "diced"


SURFACES = {name: (surface, method) for name, surface, method in surfaces()}


def standing(mesh):
    return mesh.quality.min, mesh.quality.mean


@pytest.mark.parametrize("name", SURFACES)
def test_a_sheet_more(name):
    """One hex more for each quad, a valid mesh all the same; the first points are the surface's, bit for bit."""
    (points, quads), method = SURFACES[name]
    plain = hn.mesh(points, quads, method, pillow="never", allow_uncertified=True)
    mesh = hn.mesh(points, quads, method, pillow=1, allow_uncertified=True)
    assert plain.report["pillows"] == 0 and mesh.report["pillows"] == 1
    assert len(mesh.hexes) == len(plain.hexes) + len(quads)
    assert np.array_equal(mesh.points[:len(points)], points)
    assert mesh.quality.min <= mesh.report["pillow bound"] + 1e-3
    found = faults(mesh.points, mesh.hexes, quads, points)
    assert found == [] if mesh.certificate.certified else found != []
    stages = dict(stages_of(mesh))
    assert list(stages)[0] == "pillows" and stages["pillows"] == slice(0, len(quads))
    on_surface = (mesh.hexes < len(points)).sum(axis=1)
    assert (on_surface[:len(quads)] == 4).all() and not on_surface[len(quads):].any()


@pytest.mark.parametrize("name", SURFACES)
def test_automatic_is_never_worse(name):
    """The same mesh, or one that is clearly better, at the worst or in the mean."""
    (points, quads), method = SURFACES[name]
    plain = hn.mesh(points, quads, method, pillow="never", allow_uncertified=True)
    mesh = hn.mesh(points, quads, method, allow_uncertified=True)
    if not mesh.report["pillows"]:
        assert np.array_equal(mesh.points, plain.points) and np.array_equal(mesh.hexes, plain.hexes)
        return
    assert faults(mesh.points, mesh.hexes, quads, points) == [] or not plain.certificate.certified
    (worst, mean), (before, mean_before) = standing(mesh), standing(plain)
    assert worst >= before or not plain.certificate.certified
    assert worst > 1.2 * max(before, 0) or mean > mean_before + 0.04


def test_what_is_good_stays_as_it_is():
    for surface in (box(2, 2, 2), twisted_prism(2, 2, 0.6, 0.0)):
        mesh = hn.mesh(*surface)
        assert mesh.report["pillows"] == 0 and mesh.quality.min > 0.5
        assert not any("pillow" in line for line in mesh.report["log"])


def test_a_ball_gets_one():
    """Its hexes have corners of nearly 180 degrees where a cube's edges were."""
    points, quads = sphere(4)
    plain, mesh = hn.mesh(points, quads, pillow="never"), hn.mesh(points, quads)
    assert plain.quality.min < 0.3 and mesh.quality.min > 0.7 and mesh.quality.mean > plain.quality.mean + 0.2
    assert len(mesh.hexes) == len(plain.hexes) + len(quads)


def test_it_mends_what_no_placement_can():
    """A hex with three quads about a corner that goes in: whatever the inner points, it has no room."""
    points, quads = box(2, 2, 2)
    corner = np.flatnonzero((points == 2).all(axis=1))[0]
    points[corner] = 1.62  # under the plane through the three points beside it
    with pytest.raises(hn.HexconError) as raised:
        hn.mesh(points, quads, "swept", pillow="never")
    assert raised.value.code is hn.ErrorCode.NOT_CERTIFIED
    mesh = hn.mesh(points, quads, "swept")
    assert mesh.certificate.certified and mesh.report["pillows"] == 1
    assert faults(mesh.points, mesh.hexes, quads, points) == []


def test_corners_that_no_pillow_helps_are_named():
    """Two edges of a quad nearly in line: that bounds every hex on it."""
    points, quads = box(2, 2, 2)
    corner = int(np.flatnonzero((points == 0).all(axis=1))[0])
    points[corner] = [0.45, 0.45, 0.0]
    mesh = hn.mesh(points, quads, "swept")
    told = [line for line in mesh.report["log"] if line.startswith("no pillow: ")]
    assert mesh.report["pillows"] == 0 and len(told) == 1
    named = int(re.search(r"point (\d+)", told[0])[1])
    around = quads[(quads == corner).any(axis=1)]
    assert named in around
    assert f"{mesh.report['pillow bound']:.4f}" in told[0]


@pytest.mark.parametrize("name", ("shaken", "hull"))
def test_numbering_and_threads_do_not_matter(name):
    (points, quads), method = SURFACES[name]
    mesh = hn.mesh(points, quads, method, pillow=1, threads=1)
    again = hn.mesh(points, quads, method, pillow=1, threads=3)
    assert np.array_equal(mesh.points, again.points) and np.array_equal(mesh.hexes, again.hexes)
    rng = np.random.default_rng(5)
    other = hn.mesh(*permuted((points, quads), rng), method, pillow=1)
    inside = mesh.points[len(points):]
    assert np.array_equal(inside, other.points[len(points):])


def test_with_layers_and_second_order():
    points, quads = box(1, 1, 1)
    plain = hn.mesh(points, quads, "cells", layers=1, pillow="never")
    mesh = hn.mesh(points, quads, "cells", layers=1, order=2, pillow=2)
    assert mesh.hexes.shape == (len(plain.hexes) + 2 * len(quads), 20) and mesh.certificate.certified


@pytest.mark.parametrize("pillow", (0, -1, 17, "some", "1", 1.0, True, None))
def test_other_pillows_are_refused(pillow):
    with pytest.raises(hn.HexconError) as raised:
        hn.check_options(pillow=pillow)
    assert raised.value.code is hn.ErrorCode.BAD_ARGUMENT and "pillow" in str(raised.value)


def test_words_of_the_header():
    with open("hexcon_native/include/hexcon.h", encoding="utf-8") as stream:
        found = dict(re.findall(r"HEXCON_PILLOW_(\w+) = (-?\d+)", stream.read()))
    found = {name.lower(): int(number) for name, number in found.items()}
    assert found == {**hn.PILLOWS, "most": hn.tables.MOST_PILLOWS}
    for choice in CHOICES:
        hn.check_options(pillow=pillow_of(choice))


# ------------------------------------------------------------------------------------- repairs of given meshes

def dented(n):
    """(points, hexes, number of boundary points): a grid of cubes whose corners are pushed in, under the plane through
    the three points beside: the eight hexes there cannot be positive, whatever the inner points."""
    points, quads = box(n, n, n)
    mesh = hn.mesh(points, quads, "swept", pillow="never")
    at_corner = ((mesh.points == 0) | (mesh.points == n)).all(axis=1)
    dented = mesh.points.copy()
    dented[at_corner] += 0.39 * np.sign(n / 2 - mesh.points[at_corner])
    return dented, mesh.hexes, len(points)


def test_inverted_hexes_at_the_boundary_are_mended():
    points, hexes, on_boundary = dented(3)
    before = hn.certify(points, hexes, boundary_of(hexes))
    moved = hn.optimize(points, hexes, mean_passes=2)
    left = hn.certify(moved, hexes, boundary_of(hexes))
    assert len(before.nonpositive) == len(left.nonpositive) == 8
    found = hn.repair(points, hexes)
    assert found.pillows == 1 and len(found.hexes) == len(hexes) + len(boundary_of(hexes))
    assert np.array_equal(found.points[:on_boundary], points[:on_boundary])
    assert faults(found.points, found.hexes, boundary_of(hexes), points[:on_boundary]) == []


def boundary_of(hexes):
    """Faces of one hex only, outward."""
    sides = hexes[:, FACES].reshape(-1, 4)
    _, first, count = np.unique(np.sort(sides, axis=1), axis=0, return_index=True, return_counts=True)
    return sides[np.sort(first[count == 1])]


def test_a_repair_needs_no_pillow_where_moving_does():
    mesh = hn.mesh(*box(3, 3, 3))
    points = mesh.points.copy()
    points[56:] += np.random.default_rng(2).uniform(-0.8, 0.8, points[56:].shape)
    found = hn.repair(points, mesh.hexes)
    assert found.pillows == 0 and np.array_equal(found.hexes, mesh.hexes)
    assert hn.certify(found.points, found.hexes, mesh.quads).certified
    assert hn.repair(points, mesh.hexes, pillow=2).hexes[:27].shape == (27, 8)
    assert "2 pillows" in repr(hn.repair(points, mesh.hexes, pillow=2))


def test_a_repair_that_may_not_lay_any():
    points, hexes, _ = dented(3)
    found = hn.repair(points, hexes, pillow="never", threads=1)
    assert found.pillows == 0 and np.array_equal(found.points, hn.optimize(points, hexes, mean_passes=2))
    with pytest.raises(hn.HexconError) as raised:
        hn.repair(points, hexes, progress=lambda stage, part: False)
    assert raised.value.code is hn.ErrorCode.CANCELLED
    with pytest.raises(hn.HexconError) as raised:
        hn.repair(points, hexes[:, [0, 0, 2, 3, 4, 5, 6, 7]])
    assert raised.value.code is hn.ErrorCode.REPEATED_VERTEX


def test_repair_on_the_command_line(tmp_path, capsys):
    points, hexes, _ = dented(2)
    quads = boundary_of(hexes)
    bad, good = tmp_path / "bad.vtu", tmp_path / "good.inp"
    write(SimpleNamespace(points=points, hexes=hexes, quads=quads, order=1,
                          face_of_quad=np.ones(len(quads), np.int64)), bad)
    assert main(["check", str(bad)]) == 3
    assert main(["repair", str(bad), "-o", str(good)]) == 0
    told = capsys.readouterr().out
    assert f"{len(hexes) + len(quads)} hexes for {len(hexes)}, 1 pillows" in told
    read = read_mesh(good)
    assert len(read.hexes) == len(hexes) + len(quads) and (read.face_of_quad == 1).all()
    assert main(["mesh", "example:schneiders", "--pillow", "1", "-o", str(tmp_path / "m.vtu")]) == 0
    assert main(["mesh", "example:schneiders", "--pillow", "17", "-o", str(tmp_path / "m.vtu")]) != 0

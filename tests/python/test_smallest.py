# SPDX-License-Identifier: LGPL-2.1-or-later
"""Method smallest: every class of quadrangulations with few quads, as its canonical polyhedron."""
import pathlib
import sys
import time

import mesh_checker
import numpy as np
import paper_surfaces
import pytest
from polyhedra import canonical_polyhedron
from quadrangulations import all_quadrangulations, double_wheel
from surfaces import schneiders_pyramid

import hexcon_native as hn

CORE = pathlib.Path(hn.__file__).resolve().parent
sys.path.insert(0, str(CORE / "tools"))
import make_small_fillings as maker  # noqa: E402  (found by the line above)

TABLE = maker.read_table(CORE.parent / "resources" / "fillings" / "smallest.txt")
CLASSES = all_quadrangulations(16)
SMALL = [(n, i) for n in range(6, 13, 2) for i in range(len(CLASSES[n]))]
SAMPLE = [(14, i) for i in range(0, 58, 6)] + [(16, i) for i in range(0, 451, 30)]


def shuffled(points, quads, rng, mirror):
    """The same surface, or its mirror image, with points and quads in another order."""
    order = rng.permutation(len(points))
    moved = np.empty_like(points)
    moved[order] = points * ([1, 1, -1] if mirror else [1, 1, 1])
    quads = order[quads][:, ::-1] if mirror else order[quads]
    turn = rng.integers(4, size=len(quads))[:, None]
    quads = np.take_along_axis(quads, (turn + np.arange(4)) % 4, axis=1)
    return moved, quads[rng.permutation(len(quads))]


def check(points, quads):
    """Fill it, and compare with the table and the independent judge."""
    record = TABLE.get(maker.canonical(quads)[0])
    if record is None:
        with pytest.raises(hn.HexconError) as fault:
            hn.mesh(points, quads, "smallest", pillow="never")
        assert fault.value.code == hn.ErrorCode.NO_SMALL_FILLING
        return
    started = time.process_time()
    mesh = hn.mesh(points, quads, "smallest", pillow="never", allow_uncertified=True, threads=1)
    assert time.process_time() - started < 30
    faults = mesh_checker.faults(mesh.points, mesh.hexes, mesh.quads, points)
    assert mesh.method == "smallest" and len(mesh.hexes) == len(record.hexes)
    assert np.array_equal(mesh.quads, quads)
    assert mesh.certificate.proper and mesh.certificate.conforming and mesh.certificate.boundary_exact
    if record.certified:
        assert mesh.certificate.certified and not faults
    else:
        assert all("not positive" in fault for fault in faults)
        assert mesh.certificate.certified == (not faults)


@pytest.mark.parametrize(("n", "index"), SMALL + SAMPLE)
def test_canonical_polyhedra(n, index):
    rng = np.random.default_rng(index)
    quads = CLASSES[n][index]
    check(*shuffled(canonical_polyhedron(quads), quads, rng, mirror=index % 2 == 1))


def test_table_covers_the_small_classes():
    """All that is known so far; more may come, none may go."""
    for n, least, certified in ((6, 1, 1), (8, 1, 1), (10, 3, 2), (12, 11, 7), (14, 56, 41), (16, 427, 150)):
        records = [record for record in TABLE.values() if maker.quad_count(record.code) == n]
        assert len(records) >= least and sum(record.certified for record in records) >= certified
    codes = {maker.canonical(quads)[0] for n in range(6, 17, 2) for quads in CLASSES[n]}
    assert set(TABLE) <= codes


def test_table_says_what_is_certified():
    for record in list(TABLE.values())[::7]:
        proof = hn.certify(record.points, record.hexes, maker.quads_of(record.code))
        assert proof.proper and proof.conforming and proof.boundary_exact
        assert proof.certified == record.certified
        assert maker.Record.read(record.line()).line() == record.line()


def hexes_of(points, quads):
    mesh = hn.mesh(points, quads, "smallest", pillow="never", threads=1)
    assert not mesh_checker.faults(mesh.points, mesh.hexes, mesh.quads, points)
    return len(mesh.hexes)


def test_known_records_are_met():
    cube = canonical_polyhedron(double_wheel(3)), double_wheel(3)
    assert hexes_of(*cube) == 1
    assert hexes_of(*paper_surfaces.quadrilateral_octahedron()) <= 40


@pytest.mark.parametrize("seed", range(4))
def test_schneiders_pyramid_with_its_flat_sides(seed):
    """No hex may have two quads of one side: half of the symmetries of the class put them so."""
    surface = shuffled(*schneiders_pyramid(), np.random.default_rng(seed), mirror=seed % 2 == 1)
    assert hexes_of(*surface) <= 36


def test_points_moved_off_the_canonical_place():
    """Other shapes of a class: stretched, sheared, its points moved."""
    rng = np.random.default_rng(3)
    quads = double_wheel(4)
    points = canonical_polyhedron(quads)
    for _ in range(5):
        moved = points + rng.uniform(-0.12, 0.12, points.shape)
        assert hexes_of(moved @ (np.eye(3) + rng.uniform(-0.4, 0.4, (3, 3))), quads) == 40


def test_inward_quads_are_turned():
    points, quads = paper_surfaces.quadrilateral_octahedron()
    mesh = hn.mesh(points, quads[:, ::-1], "smallest", pillow="never")
    assert mesh.certificate.certified and mesh.report["turned outward"] == 1


def test_second_order():
    points, quads = paper_surfaces.quadrilateral_octahedron()
    assert hn.mesh(points, quads, "smallest", pillow="never", order=2).hexes.shape == (40, 20)


def code_and_elements(points, quads):
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(points, quads, "smallest", pillow="never")
    return fault.value.code, fault.value.elements, str(fault.value)


def test_what_is_not_small_or_not_three_connected():
    quads = double_wheel(9)
    code, elements, words = code_and_elements(canonical_polyhedron(quads), quads)
    assert code == hn.ErrorCode.NO_SMALL_FILLING and len(elements) == 0 and "16" in words
    points = np.array([[0, 0, 1], [0, 0, -1], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]], float)
    melon = np.array([[0, 2, 1, 3], [0, 3, 1, 4], [0, 4, 1, 5], [0, 5, 1, 2]])
    code, elements, _ = code_and_elements(points, melon)
    assert code == hn.ErrorCode.NO_SMALL_FILLING and len(elements) == 2
    assert len(np.intersect1d(*melon[list(elements)])) == 3     # two quads that share two edges


def test_a_damaged_line_is_noticed_by_the_maker():
    record = next(record for record in TABLE.values() if len(record.hexes) > 30)
    target = maker.Target(record.code)
    damaged = record.hexes.copy()
    damaged[3, 2] = damaged[7, 5]
    filling = maker.Filling(record.points, damaged)
    with pytest.raises((RuntimeError, hn.HexconError)):
        maker.as_record(target, filling)

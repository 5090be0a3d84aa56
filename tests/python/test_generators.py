# SPDX-License-Identifier: LGPL-2.1-or-later
"""The generators of quad surfaces for cells: quadrangulations, polyhedra, small surfaces, gmsh's."""
import numpy as np
import pytest
from blossom_surfaces import blossom_surface
from paper_surfaces import eppsteins_cubes, paper_surfaces, quadrilateral_octahedron
from polyhedra import canonical_polyhedron, random_polyhedron
from quad_figures import (
    convexity,
    corner_angles,
    edge_lengths,
    face_doublets,
    flat_corners,
    hidden_corners,
    planarity,
    tangency,
)
from quadrangulations import (
    all_quadrangulations,
    canonical_code,
    double_wheel,
    is_polyhedral,
    is_simple,
    random_quadrangulation,
    random_simple_quadrangulation,
    sphere_points,
)
from scipy.spatial.distance import pdist

import hexcon_native as hn


def _renumbered(rng, quads, mirrored):
    quads = rng.permutation(quads.max() + 1)[quads][rng.permutation(len(quads))]
    return quads[:, ::-1] if mirrored else quads


def _checked(points, quads):
    """The report of a sphere that is even, two-coloured and outward."""
    report = hn.check_surface(points, quads)
    assert report.even and report.bipartite and report.oriented
    assert (report.genus, report.components) == (0, 1)
    return report


@pytest.fixture(scope="module")
def small():
    return all_quadrangulations(14)


def test_all_small_quadrangulations(small):
    counts = {n: len(found) for n, found in small.items()}
    assert counts == {6: 1, 7: 0, 8: 1, 9: 1, 10: 3, 11: 3, 12: 11, 13: 18, 14: 58}
    for n, found in small.items():
        for quads in found:
            assert quads.shape == (n, 4) and is_polyhedral(quads)


def test_canonical_code_sees_through_numbers_and_mirrors(small):
    rng = np.random.default_rng(1)
    for quads in small[14]:
        for mirrored in (False, True):
            assert canonical_code(_renumbered(rng, quads, mirrored)) == canonical_code(quads)


def test_not_polyhedral():
    two_faced = np.array([[0, 1, 2, 3], [3, 2, 1, 0]])
    doublet = np.array([[0, 1, 2, 3], [0, 3, 2, 4], [0, 4, 2, 1]])
    assert is_polyhedral(double_wheel(3)) and not is_polyhedral(two_faced) and not is_polyhedral(doublet)


@pytest.mark.parametrize("n", (6, 8, 9, 10, 24, 80, 400))
@pytest.mark.parametrize("evenness", (0.0, 1.0))
def test_random_quadrangulation(n, evenness):
    quads = random_quadrangulation(np.random.default_rng(n), n, evenness)
    assert quads.shape == (n, 4) and is_polyhedral(quads)
    assert np.array_equal(np.unique(quads), np.arange(n + 2))
    again = random_quadrangulation(np.random.default_rng(n), n, evenness)
    assert np.array_equal(quads, again)


def test_random_quadrangulations_reach_every_small_one(small):
    rng = np.random.default_rng(1)
    found = {canonical_code(random_quadrangulation(rng, 12)) for _ in range(400)}
    assert found == {canonical_code(quads) for quads in small[12]}


def test_evenness_spreads_the_degrees():
    wild, even = (np.bincount(random_quadrangulation(np.random.default_rng(3), 200, evenness).ravel())
                  for evenness in (0.0, 2.0))
    assert even.max() <= 6 < wild.max()


def test_no_quadrangulation_of_7():
    with pytest.raises(ValueError):
        random_quadrangulation(np.random.default_rng(1), 7)


@pytest.mark.parametrize("n", (2, 3, 4, 5, 6, 7, 20, 60, 400))
def test_random_simple_quadrangulation(n):
    quads = random_simple_quadrangulation(np.random.default_rng(n), n)
    assert quads.shape == (n, 4) and is_simple(quads)
    assert np.array_equal(np.unique(quads), np.arange(n + 2))
    degrees = np.bincount(quads.ravel())
    assert degrees.min() == 2 and (n < 20 or 0.3 < (degrees == 2).mean() < 0.6)
    again = random_simple_quadrangulation(np.random.default_rng(n), n)
    assert np.array_equal(quads, again)
    if n > 20:
        other = random_simple_quadrangulation(np.random.default_rng(n + 1), n)
        assert not np.array_equal(quads, other) and canonical_code(quads) != canonical_code(other)


def test_random_simple_quadrangulations_reach_every_small_one():
    """So many there are of 3 to 7 quads, up to mirror images (OEIS A113201)."""
    rng = np.random.default_rng(1)
    for n, count in ((3, 1), (4, 2), (5, 3), (6, 9), (7, 18)):
        found = {canonical_code(random_simple_quadrangulation(rng, n)) for _ in range(60 * count)}
        assert len(found) == count


def test_random_simple_quadrangulations_have_separating_cycles():
    """Not face doublets only: two points opposite in two quads whose other points have more neighbours than two."""
    rng, found = np.random.default_rng(2), 0
    for _ in range(20):
        quads = random_simple_quadrangulation(rng, 200)
        others = (np.bincount(quads.ravel()) > 2)[quads]
        diagonals = np.vstack([quads[others[:, [1, 3]].all(axis=1)][:, [0, 2]],
                               quads[others[:, [0, 2]].all(axis=1)][:, [1, 3]]])
        found += len(np.unique(np.sort(diagonals, axis=1), axis=0)) < len(diagonals)
    assert found > 10


@pytest.mark.parametrize("n", (6, 8, 9, 10, 60))
def test_least_degree_and_three_connected(n):
    loose, three, connected = (random_simple_quadrangulation(np.random.default_rng(n), n, **options)
                               for options in ({}, {"least_degree": 3}, {"three_connected": True}))
    assert not is_polyhedral(loose) and is_polyhedral(connected) and is_simple(three)
    assert np.bincount(three.ravel()).min() == 3 and three.shape == (n, 4)
    assert is_polyhedral(three) == (n < 60)    # the smallest that is not has 11 quads or more
    for quads, options in ((7, {"least_degree": 3}), (7, {"three_connected": True}), (1, {})):
        with pytest.raises(ValueError):
            random_simple_quadrangulation(np.random.default_rng(n), quads, **options)


def test_evenness_of_simple_ones():
    wild, even = (np.bincount(random_simple_quadrangulation(np.random.default_rng(3), 200, 2, evenness).ravel())
                  for evenness in (0.0, 3.0))
    assert (wild == 2).sum() > 3 * (even == 2).sum() > 0 and even.max() < wild.max()


def test_not_simple():
    twice = np.array([[0, 1, 2, 3], [0, 3, 2, 4], [0, 4, 2, 1]])
    assert is_simple(twice) and is_simple(double_wheel(3))
    assert not is_simple(np.array([[0, 1, 2, 1], [0, 1, 2, 1]]))
    assert not is_simple(np.array([[0, 1, 2, 3], [3, 2, 1, 0], [0, 1, 4, 5], [5, 4, 1, 0]]))


@pytest.mark.parametrize("n", (3, 4, 12, 60, 400))
def test_sphere_points(n):
    for seed in range(5):
        quads = random_simple_quadrangulation(np.random.default_rng([n, seed]), n)
        points = sphere_points(quads)
        assert points.shape == (n + 2, 3) and np.allclose(np.linalg.norm(points, axis=1), 1)
        assert pdist(points).min() > 1e-10
        report = hn.check_surface(points, quads)
        assert (report.genus, report.components) == (0, 1) and report.oriented and report.bipartite


def _is_canonical(points, quads):
    assert planarity(points, quads) < 1e-9 and tangency(points, quads) < 1e-9
    assert convexity(points, quads) > 1e-6 and len(flat_corners(points, quads)) == 0
    report = _checked(points, quads)
    assert report.convex and report.star_center is not None


def test_canonical_cube_and_trapezohedron():
    points = canonical_polyhedron(double_wheel(3))
    assert np.allclose(np.linalg.norm(points, axis=1), 1.5 ** 0.5)
    assert np.allclose(edge_lengths(points, double_wheel(3)), 2 ** 0.5)
    kites = corner_angles(canonical_polyhedron(double_wheel(4)), double_wheel(4))
    assert np.allclose(kites, kites[0])


def test_canonical_prism_and_tetrahedron():
    prism = canonical_polyhedron([[0, 2, 1], [3, 4, 5], [0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]])
    tetrahedron = canonical_polyhedron([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
    assert np.allclose(np.linalg.norm(prism, axis=1), np.linalg.norm(prism[0]))
    assert np.allclose(np.linalg.norm(tetrahedron, axis=1), 3 ** 0.5)


def test_every_small_polyhedron(small):
    for n in (6, 8, 10, 12, 14):
        for quads in small[n]:
            _is_canonical(canonical_polyhedron(quads), quads)


@pytest.mark.parametrize("n", (20, 60, 200))
@pytest.mark.parametrize("evenness", (0.0, 2.0))
def test_random_polyhedron(n, evenness):
    _is_canonical(*random_polyhedron(np.random.default_rng([n, 5]), n, evenness))


def test_touching_points_are_centred():
    points, quads = random_polyhedron(np.random.default_rng(7), 30)
    ends = points[quads], points[np.roll(quads, -1, axis=1)]
    along = ends[1] - ends[0]
    part = -(ends[0] * along).sum(axis=2) / (along * along).sum(axis=2)
    touching = ends[0] + part[:, :, None] * along
    assert np.all((part > 0) & (part < 1)) and np.allclose(np.linalg.norm(touching, axis=2), 1)
    assert np.abs(touching.mean(axis=(0, 1))).max() < 1e-12


def test_paper_surfaces():
    found = {name: (points, quads) for name, points, quads in paper_surfaces()}
    assert len(found) == 54
    for name, (points, quads) in found.items():
        sound = len(flat_corners(points, quads)) == 0
        assert (_checked(points, quads).star_center is not None) == sound, name
        assert sound == ("_ob_" not in name and "_m_" not in name and "_ib_" not in name)
        assert planarity(points, quads) < 1e-12
        assert not sound or len(face_doublets(quads)) == 0
    assert len(found["schneiders_pyramid"][1]) == 16 and len(quadrilateral_octahedron()[1]) == 8


def test_eppsteins_cubes():
    counts = {}
    for name, points, quads in eppsteins_cubes():
        counts[len(quads)] = counts.get(len(quads), 0) + 1
        assert np.isclose(hn.check_surface(points, quads).volume, 1)
        flat = {"ob": 1, "m": 1, "ib": 2}.get(name.split("_")[3], 0) * name.split("_")[2].count("2")
        assert len(flat_corners(points, quads)) == flat, name
        doublets = name.split("_")[3] in ("ob", "ib") and _both_sides_bare(name.split("_")[2])
        assert len(face_doublets(quads)) == doublets, name
    assert counts == {16: 6, 18: 24, 20: 20, 22: 2}


def _both_sides_bare(sides):
    """How many black uprights have two quads on both sides."""
    return (sides[3] + sides[0] == "22") + (sides[1] + sides[2] == "22")


def test_figures_tell_folded_quads():
    points = canonical_polyhedron(double_wheel(3))
    assert len(hidden_corners(points, double_wheel(3))) == 0
    assert len(hidden_corners(points, double_wheel(3)[:, ::-1])) == 24


def test_blossom_surface(tmp_path):
    points, quads = blossom_surface("hexagonal_prism", 60, tmp_path)
    assert _checked(points, quads).star_center is not None and 40 < len(quads) < 90
    assert len(flat_corners(points, quads)) == len(hidden_corners(points, quads)) == 0

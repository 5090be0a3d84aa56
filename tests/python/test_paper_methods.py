# SPDX-License-Identifier: LGPL-2.1-or-later
"""The methods of Carbonera and Shepherd (2006) on spheres: counts, topology, volumes, faults."""
import numpy as np
import pytest
from blossom_surfaces import BODIES, surface_of_size
from cell_surfaces import PLAIN
from paper_meshes import (
    ON_GIVEN,
    ON_PAIRED,
    can_pair_across_single_edges,
    faults,
    neighbours,
    paired_surface,
    raised,
    self_crossings,
    volumes,
)
from paper_surfaces import eppsteins_cube, paper_surfaces, quadrilateral_octahedron
from polyhedra import random_polyhedron
from quad_figures import flat_corners
from quadrangulations import is_polyhedral, random_simple_quadrangulation, sphere_points
from surfaces import box, canonical, permuted, schneiders_pyramid

import hexcon_native as hn

METHODS = sorted(ON_GIVEN)
SOLIDS = ("box", "cylinder", "frustum", "hexagonal_prism", "triangular_prism", "ball", "half_ball", "lens",
          "chamfered", "cut_8")
assert set(METHODS) == hn.TOPOLOGICAL_METHODS - {"pillowed"} and set(SOLIDS) < set(BODIES)


def certified(mesh):
    """Whether the core's certificate says all but that Jacobians are positive."""
    proved = mesh.certificate
    return proved.conforming and proved.boundary_exact and proved.euler == (2 if mesh.method == "four-split" else 1)


# ----------------------------------------------------------------------------------------- counts

def test_counts_of_the_paper():
    """Section 6; for the alternative layers, the sums of its section 5 (its footnotes differ from them by 4 n)."""
    expected = {"schneiders_pyramid": (schneiders_pyramid(), 1216, 2080, 58 * 16, 112 * 16),
                "quadrilateral_octahedron": (quadrilateral_octahedron(), 608, 1040, 58 * 8, 112 * 8)}
    for name, points, quads in paper_surfaces():
        if len(quads) == 16 and name.startswith("cube"):
            expected[name] = ((points, quads), 1216, 2080, 58 * 16, 112 * 16)
    assert len(expected) == 8
    for (points, quads), *counts in expected.values():
        meshes = [hn.mesh(points, quads, method) for method in ("pyramid", "geode", "pyramid-alt", "geode-alt")]
        assert [len(mesh.hexes) for mesh in meshes] == counts
        assert all(certified(mesh) for mesh in meshes)


def test_figures_of_the_report():
    points, quads = schneiders_pyramid()
    for method, (first, second, last) in {"pyramid": (144, 288, 768), "geode-alt": (48, 96, 1632),
                                          "four-split": (144, 288, 0)}.items():
        mesh = hn.mesh(points, quads, method)
        told = mesh.report
        assert (told["pairs"], told["hexes of paired transition"], told["split layers"]) == (8, 16, 2)
        assert (told["hexes of split layer 1"], told["hexes of split layer 2"]) == (first, second)
        assert told["hexes of closure"] == last and told["hexes"] == len(mesh.hexes)
        assert any("topological" in line for line in told["log"])
        assert mesh.topological and mesh.method == method and not mesh.certificate.certified


SMALL, MIDDLE = (6, 8, 10, 12, 14, 16, 18, 20), (20, 30, 40, 60)


def _sizes(rng, count, part, choice):
    """Even numbers of quads: one of 400 in the first part, one of 100, and others as chosen."""
    return [400 if part == 0 else 200, 100, *rng.choice(choice, count - 2).tolist()]


def _assert_exact(points, quads, seed, check_all):
    """All counts; the whole of the topology of one method, which takes turns."""
    for k, method in enumerate(METHODS):
        whole = check_all or seed % len(METHODS) == k
        mesh = hn.mesh(points, quads, method, certify=whole, allow_topological=True)
        assert len(mesh.hexes) == ON_GIVEN[method] * len(quads)
        if whole:
            assert certified(mesh) and not mesh.certificate.certified
        if whole and len(quads) <= 12:
            assert faults(points, mesh) == []


@pytest.mark.parametrize("part", range(5))
def test_polyhedral_quadrangulations(part):
    """250 of them, 3-connected, 6 to 400 quads."""
    rng = np.random.default_rng([1, part])
    for seed, n in enumerate(_sizes(rng, 50, part, SMALL)):
        quads = random_simple_quadrangulation(rng, n, three_connected=True)
        _assert_exact(sphere_points(quads), quads, seed, n <= 6)


@pytest.mark.parametrize("part", range(5))
def test_simple_quadrangulations(part):
    """125 of them, of which some are not 3-connected: cycles of four edges separate points."""
    rng, found = np.random.default_rng([2, part]), 0
    for seed, n in enumerate(_sizes(rng, 25, part, MIDDLE)):
        quads = random_simple_quadrangulation(rng, n, least_degree=3)
        found += not is_polyhedral(quads)
        _assert_exact(sphere_points(quads), quads, seed, False)
    assert found > 1


@pytest.mark.parametrize("part", range(5))
def test_face_doublets(part):
    """125 quadrangulations with points of two neighbours: the counts are exact wherever the quads can be paired across
    single edges. Where they cannot, each pair that shares two edges leaves four quads in place of six."""
    rng, exact, others = np.random.default_rng([3, part]), 0, 0
    for seed, n in enumerate(_sizes(rng, 25, part, SMALL)):
        quads = random_simple_quadrangulation(rng, n, evenness=(0, 1)[seed % 2])
        points = sphere_points(quads)
        if can_pair_across_single_edges(quads):
            _assert_exact(points, quads, seed, False)
            exact += 1
        else:
            _assert_fewer(points, quads, seed)
            others += 1
    assert exact > 5 and others > 5


def _assert_fewer(points, quads, seed):
    split = hn.mesh(points, quads, "four-split", allow_topological=True)
    paired = len(paired_surface(split, len(quads)))
    short = 3 * len(quads) - paired
    assert 0 < short and short % 2 == 0
    method = METHODS[seed % len(METHODS)]
    mesh = hn.mesh(points, quads, method, allow_topological=True)
    for made in (split, mesh):
        assert len(made.hexes) == len(quads) + ON_PAIRED[made.method] * paired < ON_GIVEN[made.method] * len(quads)
        assert certified(made) and (len(quads) > 20 or faults(points, made) == [])


@pytest.mark.parametrize("n", (4, 6, 8, 30))
def test_bipyramids(n):
    """K_{2, n}: all neighbours share two edges, so that every pair leaves four quads."""
    angle = 2 * np.pi * np.arange(n) / n
    points = np.vstack([[0, 0, 1], [0, 0, -1], np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])])
    quads = np.array([[0, 2 + k, 1, 2 + (k + 1) % n] for k in range(n)])
    assert not can_pair_across_single_edges(quads) and set(neighbours(quads).values()) == {2}
    for method in METHODS:
        mesh = hn.mesh(points, quads, method, allow_topological=True)
        assert len(mesh.hexes) == n + ON_PAIRED[method] * 2 * n
        assert certified(mesh) and faults(points, mesh) == []


@pytest.mark.parametrize("method", METHODS)
def test_two_quads(method):
    points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0.5], [0, 1, 0]])
    quads = [[0, 1, 2, 3], [3, 2, 1, 0]]
    assert hn.check_surface(points, quads).even
    assert raised("SELF_INTERSECTING", points, quads, method) == [0, 1]  # one patch twice
    assert raised("UNFILLABLE_QUAD", points, quads, method, allow_topological=True) == [0, 1]


def test_solids_of_gmsh(tmp_path_factory):
    """Recombined triangles of ten CAD bodies."""
    folder = str(tmp_path_factory.mktemp("solids"))
    for k, name in enumerate(SOLIDS):
        points, quads = surface_of_size(name, 0.5, "blossom", folder)
        assert len(quads) > 40
        for method in METHODS:
            whole = method == METHODS[k % len(METHODS)]
            mesh = hn.mesh(points, quads, method, certify=whole)
            assert len(mesh.hexes) == ON_GIVEN[method] * len(quads), name
            assert not whole or (certified(mesh) and faults(points, mesh) == [])


# ---------------------------------------------------------------------------------------- geometry

def _star_shaped_surfaces():
    for name, points, quads in paper_surfaces():
        if len(flat_corners(points, quads)) == 0:
            yield name, points, quads
    for name, build in PLAIN.items():
        points, quads = build(np.random.default_rng([5, *name.encode()]))
        if len(quads) % 2 == 0 and len(quads) < 400:
            yield name, points, quads
    for n in (6, 12, 30, 60, 90):
        yield f"polyhedron_{n}", *random_polyhedron(np.random.default_rng([6, n]), n, evenness=1.0)


@pytest.mark.parametrize("method", METHODS)
def test_volumes_and_points(method):
    """Wherever one point sees the whole surface and no corner is flat, no hex is turned inside out as a whole, and no
    two points coincide."""
    tried = 0
    for name, points, quads in _star_shaped_surfaces():
        report = hn.check_surface(points, quads)
        if report.star_center is None or len(flat_corners(points, quads)):
            continue
        tried += 1
        mesh = hn.mesh(points, quads, method, certify=False, allow_topological=True)
        volume = volumes(mesh)
        assert volume.min() > 0, name
        if method != "four-split":
            assert np.isclose(volume.sum(), report.volume, rtol=1e-9), name
        assert len(np.unique(mesh.points, axis=0)) == len(mesh.points), name
        assert mesh.points[:len(points)].tobytes() == np.asarray(points, float).tobytes()
    assert tried > 35


def test_no_point_sees_all():
    """Then hexes may overlap, but the topology is what it always is."""
    points, quads = box(4, 4, 1)
    points[:, 2] += 0.9 * (points[:, 0] - 2) ** 2
    points, quads = permuted((points, quads), np.random.default_rng(3))
    assert hn.check_surface(points, quads).star_center is None
    mesh = hn.mesh(points, quads, "pyramid")
    assert any("may overlap" in line for line in mesh.report["log"])
    assert certified(mesh) and len(mesh.hexes) == 76 * len(quads) and faults(points, mesh) == []


# ---------------------------------------------------------------------------- the paired transition

def test_pairs_leave_no_loop_that_crosses_itself():
    """Each of these surfaces has some before; six quads a pair, whose points are those of the surface and four more."""
    rng = np.random.default_rng(4)
    before = 0
    surfaces = [random_polyhedron(rng, int(n)) for n in (8, 20, 60, 120)]
    surfaces += [(points, quads) for _, points, quads in paper_surfaces()]
    for points, quads in surfaces:
        before += len(self_crossings(quads)) > 0
        mesh = hn.mesh(points, quads, "four-split", certify=False)
        paired = paired_surface(mesh, len(quads))
        assert len(paired) == 3 * len(quads) and self_crossings(paired) == []
        assert len(np.unique(paired)) == len(points) + 2 * len(quads)
    assert before > 40


def test_first_hexes_are_the_pairs():
    """Two hexes a pair: each has one quad of it, and they share two faces."""
    points, quads = canonical(random_polyhedron(np.random.default_rng(5), 40))
    mesh = hn.mesh(points, quads, "pyramid")
    pairs = hn.pairing(quads)
    first = mesh.hexes[:len(quads)]
    for k, hexes in enumerate(first.reshape(-1, 2, 8)):
        on = [{q for q, quad in enumerate(quads) if set(quad) <= set(row)} for row in hexes]
        assert [len(found) for found in on] == [1, 1] and on[0] | on[1] == set(pairs[k].tolist())
        assert len(np.intersect1d(*hexes)) == 6
    assert {tuple(pair) for pair in mesh.certificate.doublets.tolist()} >= {(2 * k, 2 * k + 1) for k in range(20)}


# --------------------------------------------------------------------------------------- behaviour

@pytest.mark.parametrize("method", METHODS)
def test_repeatable(method):
    points, quads = random_polyhedron(np.random.default_rng(8), 30)
    made = [hn.mesh(points, quads, method, threads=threads, certify=False) for threads in (0, 1, 2, 1)]
    for other in made[1:]:
        for name in ("points", "hexes", "quads"):
            assert getattr(other, name).tobytes() == getattr(made[0], name).tobytes()


@pytest.mark.parametrize("method", METHODS)
def test_inward_surfaces_are_turned(method):
    points, quads = schneiders_pyramid()
    mesh = hn.mesh(points, quads[:, ::-1], method)
    assert mesh.report["turned outward"] == 1 and certified(mesh)
    assert len(mesh.hexes) == ON_GIVEN[method] * 16 and volumes(mesh).min() > 0
    assert faults(points, mesh) == []
    # The same quads in the same order, each the other way round.
    assert np.array_equal(np.sort(mesh.quads[:16], axis=1), np.sort(quads, axis=1))
    assert hn.check_surface(points, mesh.quads[:16]).oriented


def test_nothing_is_proved_if_not_asked():
    points, quads = box(2, 2, 2)
    mesh = hn.mesh(points, quads, "pyramid", certify=False)
    assert mesh.certificate is None and mesh.quality is None and "quality" not in mesh.report
    assert len(mesh.hexes) == 76 * 24 and mesh.topological
    proved = hn.mesh(points, quads, "pyramid")
    assert proved.hexes.tobytes() == mesh.hexes.tobytes() and proved.points.tobytes() == mesh.points.tobytes()
    assert len(proved.quality.scaled_jacobian) == len(mesh.hexes) and proved.quality.min < 0.01
    swept = hn.mesh(points, quads, "swept", certify=False)
    assert swept.certificate is None and not swept.topological


def test_second_order():
    points, quads = quadrilateral_octahedron()
    mesh = hn.mesh(points, quads, "pyramid", order=2)
    assert mesh.hexes.shape == (608, 20) and mesh.order == 2
    assert np.array_equal(mesh.hexes[:, :8], hn.mesh(points, quads, "pyramid").hexes)


def test_faults_of_surfaces():
    points, quads = box(1, 1, 1)
    twice = np.vstack([points, points + 5]), np.vstack([quads, quads + 8])
    odd = eppsteins_cube(["3", "3", "4", "4"])
    assert len(odd[1]) % 2
    for method in METHODS:
        assert raised("SEVERAL_COMPONENTS", *twice, method) == [0, 6]
        raised("ODD", *odd, method)
        raised("NOT_CLOSED", points, quads[1:], method)


@pytest.mark.parametrize("method", METHODS)
def test_cancelled(method):
    """By every call of progress; the last time, there are no more."""
    points, quads = schneiders_pyramid()
    stages = []
    hn.mesh(points, quads, method, progress=lambda stage, part: stages.append((stage, part)) or True)
    assert {"pairing", "split layers"} < {stage for stage, _ in stages}
    assert all(0 <= part <= 1 for _, part in stages)
    for patience in range(len(stages)):
        calls = []
        raised("CANCELLED", points, quads, method, progress=lambda *told: calls.append(told) or len(calls) <= patience)
        assert len(calls) == patience + 1

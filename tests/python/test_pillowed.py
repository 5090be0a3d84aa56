# SPDX-License-Identifier: LGPL-2.1-or-later
"""Method pillowed: the paper's section 5.3, no doublets of hexes or of faces, far below its 5396 n."""
import numpy as np
import pytest
from blossom_surfaces import blossom_surface
from mesh_checker import FACES, boundary_faults, conformity_faults, euler, improper_pairs
from paper_surfaces import eppsteins_cube, quadrilateral_octahedron
from polyhedra import random_polyhedron
from quadrangulations import random_simple_quadrangulation, sphere_points
from surfaces import schneiders_pyramid

import hexcon_native as hn

HEXES_A_QUAD = 139


def face_doublets(hexes):
    """Pairs of faces, of any hexes, that share two edges or more."""
    faces = np.unique(np.sort(hexes[:, FACES].reshape(-1, 4), axis=1), axis=0, return_index=True)[1]
    quads = hexes[:, FACES].reshape(-1, 4)[faces]
    edges = np.sort(np.stack([quads, np.roll(quads, -1, axis=1)], axis=2), axis=2).reshape(-1, 2)
    _, number = np.unique(edges, axis=0, return_inverse=True)
    # Two edges of a face meet at a point: a doublet has two of its paths of two edges in common.
    number = number.reshape(-1, 4)
    paths = np.sort(np.stack([number, np.roll(number, 1, axis=1)], axis=2), axis=2).reshape(-1, 2)
    return int((np.unique(paths, axis=0, return_counts=True)[1] > 1).sum())


def check_proper(points, quads):
    mesh = hn.mesh(points, quads, "pillowed")
    hexes = mesh.hexes.astype(np.int64)
    assert len(hexes) == HEXES_A_QUAD * len(quads)
    assert conformity_faults(hexes) == boundary_faults(hexes, quads) == improper_pairs(hexes) == []
    assert euler(hexes) == 1 and face_doublets(hexes) == 0
    proved = mesh.certificate
    assert proved.conforming and proved.proper and proved.boundary_exact and not len(proved.doublets)
    assert mesh.topological and mesh.points[:len(points)].tobytes() == np.asarray(points, float).tobytes()
    assert len(np.unique(mesh.points, axis=0)) == len(mesh.points)


@pytest.mark.parametrize("surface", [
    schneiders_pyramid(), quadrilateral_octahedron(), eppsteins_cube(("4", "3", "3", "3")),
    eppsteins_cube(("4", "4", "4", "3"), "black")], ids=["schneiders", "octahedron", "eppstein 20", "eppstein 22"])
def test_surfaces_of_the_literature(surface):
    check_proper(*surface)


@pytest.mark.parametrize("n", [8, 10, 12, 16, 24])
def test_random_polyhedra(n):
    rng = np.random.default_rng(n)
    for _ in range(2):
        check_proper(*random_polyhedron(rng, n))


def test_larger_surfaces_by_the_certificate(tmp_path):
    rng = np.random.default_rng(5)
    surfaces = [random_polyhedron(rng, n) for n in (60, 100)]
    surfaces += [blossom_surface(body, 150, tmp_path) for body in ("ball", "cylinder", "chamfered")]
    for points, quads in surfaces:
        mesh = hn.mesh(points, quads, "pillowed")
        proved = mesh.certificate
        assert len(mesh.hexes) == HEXES_A_QUAD * len(quads)
        assert proved.conforming and proved.proper and proved.boundary_exact and proved.euler == 1


def test_what_the_surface_itself_forbids():
    """Where the surface's quads meet improperly, so do their hexes, and only there is more needed than topology."""
    rng = np.random.default_rng(7)
    for n in (8, 12, 20):
        quads = random_simple_quadrangulation(rng, n)
        mesh = hn.mesh(sphere_points(quads), quads, "pillowed", allow_topological=True)
        proved = mesh.certificate
        assert proved.conforming and proved.boundary_exact and proved.euler == 1


def test_optimisation_certifies_schneiders_pyramid():
    """Its topology allows positive Jacobians everywhere: a geometry of the paper's construction."""
    points, quads = schneiders_pyramid()
    mesh = hn.mesh(points, quads, "pillowed")
    fixed = np.arange(len(mesh.points)) < len(points)
    better = hn.optimize(mesh.points, mesh.hexes, fixed, rounds=4, target=0.01)
    assert hn.certify(better, mesh.hexes, quads).certified


def test_figures_of_the_report():
    told = hn.mesh(*schneiders_pyramid(), "pillowed").report
    assert told["hexes of pillows"] == 27 * 16
    assert sum(v for k, v in told.items() if k.startswith("hexes of")) == told["hexes"] == HEXES_A_QUAD * 16


@pytest.mark.parametrize("surface", [schneiders_pyramid(), eppsteins_cube(("4", "4", "4", "3"), "black")])
def test_fewest_pairs_make_fewer_hexes(surface):
    points, quads = surface
    mesh = hn.mesh(points, quads, "pillowed", pairing="fewest")
    hexes = mesh.hexes.astype(np.int64)
    assert mesh.report["pairs"] == len(hn.pairing(quads, fewest=True)) < len(quads) / 2
    assert len(hexes) < HEXES_A_QUAD * len(quads)
    assert conformity_faults(hexes) == boundary_faults(hexes, quads) == improper_pairs(hexes) == []

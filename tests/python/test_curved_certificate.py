# SPDX-License-Identifier: LGPL-2.1-or-later
"""hn.certify of hexes with 20 nodes: against an exact judge that shares no code, and case by case."""
import re
import subprocess
import sys
from pathlib import Path

import curved_judge
import gmsh_judge
import numpy as np
import pytest
from mesh_checker import CORNERS

import hexcon_native as hn
from hexcon.femmesh.node_orders import HEX20

ROOT = Path(__file__).parents[2]

NO_QUADS = np.empty((0, 4), int)
CUBE = np.array([[0, 1, 2, 3, 4, 5, 6, 7]])
SIDES = np.array([(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)])


def cube():
    return hn.raise_order(CORNERS.astype(float), CUBE)


def test_no_disagreement_with_an_exact_judge():
    """Hexes little and much bent, nearly flat, with double roots; a larger run is in docs/measured.md."""
    nodes = curved_judge.random_hexes(np.random.default_rng(5), 4000)
    wanted = curved_judge.signs(nodes)
    certificate = hn.certify(nodes.reshape(-1, 3), np.arange(20 * len(nodes)).reshape(-1, 20), NO_QUADS)
    positive = np.ones(len(nodes), bool)
    positive[certificate.nonpositive] = False
    told = ~np.isnan(certificate.witnesses[:, 0])
    assert (wanted[positive] >= 0).all() and (wanted[certificate.nonpositive[told]] <= 0).all()
    assert 0.2 < positive.mean() < 0.8 and (wanted == 0).sum() + certificate.undecided < 20
    for hexahedron, place in list(zip(certificate.nonpositive[told], certificate.witnesses[told]))[::40]:
        assert curved_judge.value(nodes[hexahedron], place) <= 0


def test_where_corners_alone_would_do_another_hex():
    """An edge that bows through the hex folds it, though its corners are a cube's."""
    points, hexes = cube()
    assert hn.certify(points, hexes, SIDES).certified
    points[hexes[0, 8]] += (0.0, 0.6, 0.6)
    found = hn.certify(points, hexes, SIDES)
    assert not found.certified and found.nonpositive.tolist() == [0] and found.conforming and found.proper
    assert hn.certify(points, hexes[:, :8], SIDES).certified
    assert curved_judge.value(points[hexes[0]], found.witnesses[0]) <= 0


def test_quads_with_middle_nodes_must_be_those_of_the_hexes():
    points, hexes = cube()
    middle = {frozenset(hexes[0, list(ends)].tolist()): hexes[0, 8 + e] for e, ends in enumerate(curved_judge.ENDS)}
    quads = np.array([[*side, *(middle[frozenset((side[k], side[(k + 1) % 4]))] for k in range(4))]
                      for side in SIDES.tolist()])
    assert hn.certify(points, hexes, quads).certified
    quads[2, 5] = quads[2, 4]
    found = hn.certify(points, hexes, quads)
    assert not found.boundary_exact and not found.certified


@pytest.mark.parametrize("twin", [False, True])
def test_neighbours_share_middle_nodes(twin):
    points = np.array([(x, y, z) for x in range(3) for y in (0, 1) for z in (0, 1)], float)
    hexes = np.array([[0, 4, 6, 2, 1, 5, 7, 3], [4, 8, 10, 6, 5, 9, 11, 7]])
    points, hexes = hn.raise_order(points, hexes)
    if twin:
        shared = np.intersect1d(hexes[0, 8:], hexes[1, 8:])[0]
        points = np.vstack([points, points[shared]])
        hexes[1][hexes[1] == shared] = len(points) - 1
    found = hn.certify(points, hexes, hexes[:, SIDES].reshape(-1, 4)[[0, 1, 2, 4, 5, 6, 7, 8, 9, 10]])
    assert found.proper is not twin and found.certified is not twin
    assert set(found.improper) == ({0, 1} if twin else set())


def test_the_mesh_of_order_2_is_proved_with_its_own_nodes():
    points, quads = CORNERS.astype(float), SIDES
    mesh = hn.mesh(points, quads, order=2)
    assert mesh.certificate.certified and mesh.hexes.shape == (1, 20)


def test_as_gmsh_finds(tmp_path):
    """gmsh bounds the least Jacobian by Bernstein coefficients as well, without a bound on its rounding."""
    nodes = curved_judge.random_hexes(np.random.default_rng(9), 1500)
    np.save(tmp_path / "nodes.npy", nodes.astype(float))
    subprocess.run([sys.executable, gmsh_judge.__file__, str(tmp_path / "nodes.npy"), str(tmp_path / "least.npy")],
                   check=True, timeout=120)
    least = np.load(tmp_path / "least.npy")
    certificate = hn.certify(nodes.reshape(-1, 3), np.arange(20 * len(nodes)).reshape(-1, 20), NO_QUADS)
    positive = np.ones(len(nodes), bool)
    positive[certificate.nonpositive] = False
    sure = np.abs(least) > 1e-9
    assert (positive[sure] == (least[sure] > 0)).all() and 0.2 < positive.mean() < 0.8
    assert not positive[~sure & (curved_judge.signs(nodes) < 0)].any()      # where gmsh has 1e-17 for zero


def test_table_of_node_orders():
    """The page's rows are the code's, and gmsh's follows from the ends of its edges."""
    page = (ROOT / "docs" / "methods.md").read_text(encoding="utf-8")
    for name, words in (("VTK", "VTK_QUADRATIC"), ("CalculiX, Abaqus", "CalculiX and Abaqus"), ("Exodus II", "Exodus"),
                        ("gmsh, files of .msh", "gmsh, element"), ("FreeCAD (SMESH)", "FreeCAD"), ("UNV 116", "UNV"),
                        ("Nastran CHEXA", "Nastran")):
        row = next(line for line in page.splitlines() if line.startswith("|") and words in line)
        assert [int(n) for n in re.findall(r"\d+", row.split("|", 2)[2])] == HEX20[name]
        assert sorted(HEX20[name]) == list(range(20))
    assert HEX20["gmsh, files of .msh"] == gmsh_judge.TO_GMSH


def hexes_on_grid(xs, ys, zs, cells):
    """(points, hexes (H,20)) of boxes of a grid by their indices, straight."""
    shape = len(xs), len(ys), len(zs)
    points = np.stack(np.meshgrid(xs, ys, zs, indexing="ij"), axis=-1).reshape(-1, 3)
    corners = np.array([np.ravel_multi_index((np.array(cell) + CORNERS.astype(int)).T, shape) for cell in cells])
    used, place = np.unique(corners, return_inverse=True)
    return hn.raise_order(points[used], place.reshape(-1, 8))


def boundary_of(hexes):
    sides = hexes[:, SIDES].reshape(-1, 4)
    _, first, count = np.unique(np.sort(sides, axis=1), axis=0, return_index=True, return_counts=True)
    return sides[first[count == 1]]


GAP = 0.125


def bulged(by):
    """A U whose two ends bulge towards each other across GAP: each by twice `by` in the middle of its face."""
    points, hexes = hexes_on_grid([0, 1, 1 + GAP, 2 + GAP], [0, 1, 2], [0, 1],
                                  [(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 1, 0), (2, 1, 0)])
    for x, sign in ((1, 1), (1 + GAP, -1)):
        middles = [(1.5, 0), (1.5, 1), (1, 0.5), (2, 0.5)]
        rim = (points[:, 0] == x) & (points[:, None, 1:] == middles).all(axis=2).any(axis=1)
        assert rim.sum() == 4
        points[rim, 0] += sign * by
    return points, hexes


@pytest.mark.parametrize("part, embedded", [(0.9, True), (0.999, True), (1.0, None), (1.001, False), (1.5, False)])
def test_curved_faces_far_apart_in_the_mesh_must_not_meet(part, embedded):
    """Straight ones do not in any case, and every Jacobian is positive."""
    points, hexes = bulged(part * GAP / 4)
    quads = boundary_of(hexes)
    found = hn.certify(points, hexes, quads)
    assert not len(found.nonpositive) and hn.certify(points[:hexes[:, :8].max() + 1], hexes[:, :8], quads).certified
    assert found.embedded is embedded and found.certified is (embedded is True)

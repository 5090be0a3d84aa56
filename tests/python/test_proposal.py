# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hexes that come with a surface: taken, placed, improved and proved like any others."""
import mesh_checker
import numpy as np
import pytest
from crossing_meshes import bent, block, boundary_of, branched_ring, wound_ring
from paper_meshes import raised

import hexcon_native as hn


def split(mesh, rng=None):
    """(surface points, quads, inner points, hexes): the surface's points first; in any order, given a rng."""
    points, hexes = mesh
    quads = boundary_of(mesh)
    on = np.isin(np.arange(len(points)), quads)
    if rng is None:
        order = np.concatenate([np.flatnonzero(on), np.flatnonzero(~on)])
    else:
        order = np.concatenate([rng.permutation(np.flatnonzero(on)), rng.permutation(np.flatnonzero(~on))])
        hexes, quads = hexes[rng.permutation(len(hexes))], quads[rng.permutation(len(quads))]
    number = np.argsort(order)
    return points[order[:on.sum()]], number[quads], points[order[on.sum():]], number[hexes]


MESHES = {"block": block(3, 4, 2), "bent bar": bent(2.0, 9), "ring": wound_ring(1, 16), "edge": branched_ring(1, 8),
          "one hex": block(1, 1, 1)}


@pytest.mark.parametrize("name", MESHES)
def test_good_places_stay(name):
    points, quads, inner, hexes = split(MESHES[name], np.random.default_rng(1))
    mesh = hn.mesh(points, quads, "proposal", hexes=(inner, hexes))
    assert mesh.method == "proposal" and mesh.certificate.certified
    assert mesh.points.tobytes() == np.vstack([points, inner]).tobytes()
    assert np.array_equal(mesh.hexes, hexes) and np.array_equal(mesh.quads, quads)


@pytest.mark.parametrize("name", MESHES)
def test_places_are_found(name):
    points, quads, inner, hexes = split(MESHES[name])
    mesh = hn.mesh(points, quads, "proposal", hexes=hexes)
    assert mesh.certificate.certified and np.array_equal(mesh.hexes, hexes)
    assert len(mesh.points) == len(points) + len(inner)
    assert mesh_checker.faults(mesh.points, mesh.hexes, quads, points) == []
    assert mesh.quality.min >= 0.9 * hn.quality(np.vstack([points, inner]), hexes).min


def test_bad_places_are_mended():
    rng = np.random.default_rng(3)
    points, quads, inner, hexes = split(block(6, 6, 6))
    mesh = hn.mesh(points, quads, "proposal", hexes=(inner + rng.uniform(-2, 2, inner.shape), hexes))
    assert mesh.report["inverted as proposed"] > 50
    assert mesh.certificate.certified and mesh.quality.min > 0.9


def test_auto_tries_it_first_and_turns_to_others():
    points, quads, inner, hexes = split(wound_ring(1, 16))
    mesh = hn.mesh(points, quads, hexes=(inner, hexes))
    assert mesh.method == "proposal" and mesh.report["log"][0].startswith("proposal: ")
    wrong = hexes.copy()
    wrong[0, [0, 1]] = wrong[0, [1, 0]]
    mesh = hn.mesh(points, quads, hexes=(inner, wrong))
    assert mesh.method != "proposal" and mesh.certificate.certified
    assert mesh.report["log"][0].startswith("proposal: the proposed hexes are no conforming mesh")


def test_the_same_whatever_the_numbering():
    points, quads, inner, hexes = split(block(4, 3, 3))
    far = inner + np.random.default_rng(2).uniform(-1, 1, inner.shape)
    wanted = hn.mesh(points, quads, "proposal", hexes=(far, hexes))
    number = np.random.default_rng(4).permutation(len(points))
    moved = np.empty_like(points)
    moved[number] = points
    both = np.concatenate([number, len(points) + np.arange(len(inner))])
    mesh = hn.mesh(moved, number[quads], "proposal", hexes=(far, both[hexes]))
    assert mesh.points[both].tobytes() == wanted.points.tobytes() and np.array_equal(mesh.hexes, both[wanted.hexes])


def test_second_order_and_inward_quads():
    points, quads, inner, hexes = split(block(2, 2, 2))
    mesh = hn.mesh(points, quads[:, ::-1], "proposal", hexes=(inner, hexes), order=2)
    assert mesh.certificate.certified and mesh.hexes.shape[1] == 20 and mesh.report["turned outward"]


def test_faults():
    points, quads, inner, hexes = split(block(3, 3, 3))
    both = (inner, hexes)
    assert raised("BAD_ARGUMENT", points, quads, "proposal") == []
    raised("BAD_ARGUMENT", points, quads, "swept", hexes=both)
    raised("BAD_ARGUMENT", points, quads, "proposal", hexes=(inner, hexes, hexes))
    raised("WRONG_SHAPE", points, quads, "proposal", hexes=hexes[:, :7])
    raised("EMPTY", points, quads, "proposal", hexes=np.empty((0, 8), int))
    assert raised("INDEX_OUT_OF_RANGE", points, quads, "proposal", hexes=(inner[:-1], hexes)) != []
    repeated = hexes.copy()
    repeated[5, 0] = repeated[5, 1]
    assert raised("REPEATED_VERTEX", points, quads, "proposal", hexes=(inner, repeated)) == [5]
    assert raised("NOT_FINITE", points, quads, "proposal", hexes=(inner * np.nan, hexes)) == list(range(len(inner)))
    assert raised("BAD_PROPOSAL", points, quads, "proposal", hexes=(np.vstack([inner, inner[:1]]), hexes)) == [len(inner)]
    raised("BAD_PROPOSAL", points, quads, "proposal", hexes=(inner, hexes[1:]))           # another boundary
    raised("BAD_PROPOSAL", points, quads, "proposal", hexes=(inner, np.vstack([hexes, hexes[:1]])))
    inside_out = hexes[:, [4, 5, 6, 7, 0, 1, 2, 3]]
    raised("BAD_PROPOSAL", points, quads, "proposal", hexes=(inner, inside_out))


def test_cancelled_and_out_of_time():
    points, quads, inner, hexes = split(block(12, 12, 12))
    far = inner + np.random.default_rng(2).uniform(-3, 3, inner.shape)
    raised("CANCELLED", points, quads, "proposal", hexes=(far, hexes), progress=lambda stage, part: False)

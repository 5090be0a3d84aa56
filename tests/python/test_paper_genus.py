# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's methods under surfaces with holes: where they go, and the proof where they do not."""
import collections
import itertools

import numpy as np
import pytest
from mesh_checker import euler
from paper_meshes import (
    crossed_edges,
    dual_loops,
    families,
    faults,
    layer_counts,
    paired_quads,
    paired_surface,
    raised,
    self_crossings,
    sides,
)
from surfaces import annulus, canonical, permuted, picture, prism, upright

import hexcon
import hexcon_native as hn

CLOSED = sorted(hn.TOPOLOGICAL_METHODS - {"four-split"})


def torus(m, n, twist=0):
    """m rings of n quads; `twist` quads the further the ring, the last meets the first so much shifted."""
    i, j = (a.ravel() for a in np.mgrid[0:m, 0:n])
    u, v = 2 * np.pi * i / m, 2 * np.pi * (j + twist * i / m) / n
    points = np.column_stack([(3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)])

    def point(i, j):
        return i % m * n + (j + twist * (i // m)) % n
    return points, np.column_stack([point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)])


def bodies_with_holes():
    """(name, genus, points, quads)"""
    yield "tube", 1, *prism(annulus(8, 2), np.arange(3.0), upright)
    yield "two holes", 2, *prism(picture("#####", "#.#.#", "#####"), np.arange(3.0), upright)
    yield "three holes", 3, *prism(picture("#######", "#.#.#.#", "#######"), np.arange(2.0), upright)


def assert_sound(points, quads, mesh, genus):
    """Conforming, and its boundary is the surface twice: as given, and within."""
    assert mesh.certificate.conforming and mesh.certificate.boundary_exact
    assert faults(points, mesh, of_sphere=False) == []
    assert euler(mesh.hexes) == mesh.certificate.euler == 2 - 2 * genus
    assert np.array_equal(np.sort(mesh.quads[:len(quads)], axis=1), np.sort(quads, axis=1))


def is_bipartite(quads):
    return sides(quads, _edges(quads)) is not None


def _edges(quads):
    return {tuple(sorted((int(quad[k - 1]), int(quad[k])))) for quad in quads for k in range(4)}


def closed_path(quads, path):
    """The path's edges (low, high)."""
    edges = [tuple(sorted(pair)) for pair in zip(path, path[1:] + path[:1])]
    assert len(path) > 2 and set(edges) <= _edges(quads)
    return edges


def assert_crossed_oddly(quads, path):
    """By some family of the loops."""
    loops = dual_loops(quads)
    family_of_loop, edges = families(loops), closed_path(quads, path)
    crossings = [sum(edge in crossed_edges(quads, loops, family_of_loop, family) for edge in edges)
                 for family in range(max(family_of_loop) + 1)]
    assert any(count % 2 for count in crossings), crossings


TORI = [(m, n, twist) for m, n in itertools.product((3, 4, 5, 6), repeat=2) if m * n % 2 == 0
        for twist in range(3) if n != 3 or twist == 0]


@pytest.mark.parametrize("m, n, twist", TORI)
def test_tori_without_pairs(m, n, twist):
    """All loops run along the rings or across them: there are sides if and only if m, n and the twist are even."""
    points, quads = permuted(torus(m, n, twist), np.random.default_rng([m, n, twist]))
    assert self_crossings(quads) == []
    if m % 2 or n % 2 or twist % 2:
        assert_crossed_oddly(quads, raised("NO_SIDES", points, quads, "four-split", pairing="none"))
        return
    mesh = hn.mesh(points, quads, "four-split", pairing="none")
    assert_sound(points, quads, mesh, 1)
    assert len(mesh.quads) == 5 * len(quads) and len(mesh.hexes) == sum(layer_counts(quads)) == 9 * len(quads)
    assert mesh.report["split layers"] == 2


@pytest.mark.parametrize("m, n, twist", TORI)
def test_tori_with_all_paired(m, n, twist):
    """Inner loops always have sides; outer ones cross each edge outside the pairs once, and the way over a pair an odd
    number of times: they have sides if and only if the points can be coloured black and white."""
    points, quads = permuted(torus(m, n, twist), np.random.default_rng([m, n, twist, 1]))
    if not is_bipartite(quads):
        assert len(closed_path(quads, raised("NO_SIDES", points, quads, "four-split"))) % 2 == 1
        return
    mesh = hn.mesh(points, quads, "four-split")
    assert_sound(points, quads, mesh, 1)
    assert len(mesh.quads) == 13 * len(quads) and len(mesh.hexes) == 28 * len(quads)
    assert self_crossings(paired_surface(mesh, len(quads))) == []


def test_both_outcomes_occur():
    """For all pairs and for none, independently."""
    outcomes = {(is_bipartite(torus(*sizes)[1]), all(k % 2 == 0 for k in sizes)) for sizes in TORI}
    assert outcomes == {(True, True), (True, False), (False, False)}


def test_some_pairs_on_tori():
    """The paired surface has points of its own, but faults are told in the caller's."""
    outcomes = collections.Counter()
    for m, n, twist in TORI:
        points, quads = torus(m, n, twist)
        pairs = hn.pairing(quads)
        for some in (pairs[:1], pairs[::2], pairs[1:], pairs):
            paired, _ = paired_quads(quads, some.tolist())
            assert self_crossings(paired) == []
            try:
                mesh = hn.mesh(points, quads, "four-split", pairing=some)
            except hn.HexconError as fault:
                outcomes[fault.code.name] += 1
                closed_path(quads, fault.elements)
            else:
                outcomes["OK"] += 1
                assert_sound(points, quads, mesh, 1)
                assert len(mesh.quads) == len(quads) + 4 * len(paired)
    assert set(outcomes) == {"OK", "NO_SIDES"} and min(outcomes.values()) > 5


@pytest.mark.parametrize("name, genus, points, quads", bodies_with_holes())
def test_bodies_with_holes(name, genus, points, quads):
    points, quads = canonical((points, quads))      # which side of a family is the left one depends on the numbering
    assert hn.check_surface(points, quads).genus == genus
    for pairing in ("all", "none"):
        mesh = hn.mesh(points, quads, "four-split", pairing=pairing)
        assert_sound(points, quads, mesh, genus)
        if pairing == "all":
            assert len(mesh.hexes) == 28 * len(quads) and len(mesh.quads) == 13 * len(quads)
        else:
            assert len(mesh.hexes) == sum(layer_counts(quads)) and len(mesh.quads) == 5 * len(quads)
    inner = mesh.quads[len(quads):]
    used, inner = np.unique(inner, return_inverse=True)
    shell = hn.check_surface(mesh.points[used], inner.reshape(-1, 4)[:, ::-1])
    assert shell.genus == genus and shell.components == 1 and shell.even


def _holed(body):
    return torus(6, 4) if body == "torus" else next(b[2:] for b in bodies_with_holes() if b[0] == body)


@pytest.mark.parametrize("body, genus", [("torus", 1), ("three holes", 3)])
@pytest.mark.parametrize("method, per_pair", [("geode", 2 + 54), ("geode-alt", 2 + 18), ("pillowed", None)])
def test_geodes_close_around_tetrahedra(body, genus, method, per_pair):
    """The paper's last words: layers, 26 hexes on every four-split quad, 4 in every tetrahedron between them."""
    points, quads = _holed(body)
    mesh = hexcon.mesh_surface(points, quads, method)
    split, tetrahedra = mesh.report["four-split quads"], mesh.report["tetrahedra"]
    assert split == 3 * len(quads) and tetrahedra > 0
    assert mesh.report["hexes of closure"] == 26 * split + 4 * tetrahedra
    if per_pair:
        assert len(mesh.hexes) == per_pair * len(quads) / 2 + 26 * split + 4 * tetrahedra
    assert mesh.certificate.conforming and mesh.certificate.boundary_exact
    assert mesh.certificate.proper == (method == "pillowed")
    assert faults(points, mesh, of_sphere=False) == []
    assert euler(mesh.hexes) == mesh.certificate.euler == 1 - genus
    assert np.array_equal(np.sort(mesh.quads, axis=1), np.sort(quads, axis=1))


def test_geodes_in_a_ball_that_no_point_sees():
    """A "C": tetrahedra between the Geodes; without a mesher for them, the paper's star, which is right in its topology."""
    points, quads = prism(picture("###", "#..", "#..", "#..", "###"), np.arange(2.0), upright)
    assert hn.check_surface(points, quads).star_center is None
    free, star = hexcon.mesh_surface(points, quads, "geode"), hn.mesh(points, quads, "geode")
    assert len(star.hexes) == 130 * len(quads) and star.report["tetrahedra"] == 6 * len(quads)
    assert len(free.hexes) == (28 + 78) * len(quads) + 4 * free.report["tetrahedra"] != len(star.hexes)
    for mesh in (free, star):
        assert mesh.certificate.conforming and mesh.certificate.boundary_exact and euler(mesh.hexes) == 1


def _no_tetrahedra(points, triangles):
    return None


@pytest.mark.parametrize("method", CLOSED)
def test_no_closure_of_bodies_with_holes(method):
    """Pyramids meet in one point, which no hole allows; Geodes want tetrahedra."""
    for points, quads in (torus(4, 4), torus(3, 4), *(body[2:] for body in bodies_with_holes())):
        for pairing in ("all", "none"):
            with pytest.raises(hn.HexconError) as fault:
                hn.mesh(points, quads, method, pairing=pairing)
            assert fault.value.code == hn.ErrorCode.NOT_A_BALL
            assert "four-split" in str(fault.value) and "genus" in str(fault.value)
    points, quads = torus(4, 4)
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(points, quads, method, tetrahedralise=_no_tetrahedra)
    assert fault.value.code == hn.ErrorCode.NOT_A_BALL
    assert ("no tetrahedra were found" in str(fault.value)) == ("pyramid" not in method)

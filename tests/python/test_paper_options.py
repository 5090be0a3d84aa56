# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pairings of the paper's methods: none, given ones, and what is refused."""
import itertools

import numpy as np
import pytest
from cell_surfaces import zonohedron
from paper_meshes import (
    ALTERNATIVE,
    ON_GIVEN,
    dual_loops,
    families,
    faults,
    layer_counts,
    neighbours,
    paired_quads,
    paired_surface,
    raised,
    self_crossings,
    volumes,
)
from polyhedra import random_polyhedron
from surfaces import box, canonical, diced_hull, o_grid, permuted, prism, schneiders_pyramid, upright, used_only

import hexcon_native as hn

METHODS = sorted(ON_GIVEN)
CLOSURES = {"four-split": 0, "pyramid": 16, "pyramid-alt": 16, "geode": 34, "geode-alt": 34}


def assert_sound(points, mesh):
    assert mesh.certificate.conforming and mesh.certificate.boundary_exact
    assert faults(points, mesh) == []


# ------------------------------------------------------------------------------------- no pairing

def box_counts(sides, order, whole):
    """Hexes of the three layers on a box, loops about each axis in turn: `whole` 1, or 0 for alternative layers."""
    done, found = [], []
    for axis in order:
        count = 0
        for normal in range(3):    # the two faces with that normal
            a, b = (k for k in range(3) if k != normal)
            parts = 2 * sides[a] * sides[b] * 2 ** sum(k != normal for k in done)
            if normal != axis:
                count += (1 + 2 * whole) * parts
            elif sides[axis] % 2:    # one to the left, one to the right
                count += whole * parts + parts // 2
            else:                    # both to the right
                count += whole * parts
        done.append(axis)
        found.append(count)
    return found


@pytest.mark.parametrize("sides", ((1, 1, 1), (2, 2, 2), (1, 2, 1), (3, 1, 2), (3, 2, 4)))
@pytest.mark.parametrize("method", METHODS)
def test_boxes_without_pairs(sides, method):
    """Three families, one about each axis: by hand, whichever comes first."""
    points, quads = box(*sides)
    mesh = hn.mesh(points, quads, method, pairing="none")
    whole = 0 if method in ALTERNATIVE else 1
    told = [mesh.report[f"hexes of split layer {k}"] for k in (1, 2, 3)]
    assert told in [box_counts(sides, order, whole) for order in itertools.permutations(range(3))]
    assert len(mesh.hexes) == sum(told) + CLOSURES[method] * len(quads)
    assert (mesh.report["pairs"], mesh.report["hexes of paired transition"], mesh.report["split layers"]) == (0, 0, 3)
    assert_sound(points, mesh)
    assert volumes(mesh).min() > 0


def surfaces_of_simple_loops():
    """(name, points, quads) whose loops do not cross themselves."""
    rng = np.random.default_rng(1)
    found = 0
    while found < 6:
        points, quads = random_polyhedron(rng, 12 if found < 3 else 16)
        if not self_crossings(quads):
            found += 1
            yield f"polyhedron {found}", points, quads
    yield "cylinder", *prism(o_grid(2, 2), np.arange(3.0), upright)
    yield "renumbered", *permuted(prism(o_grid(3, 1), np.arange(4.0), upright), rng)
    yield "octahedron", *diced_hull(np.vstack([np.eye(3), -np.eye(3)]))
    yield "icosahedron", *diced_hull(_icosahedron())
    split = hn.mesh(*schneiders_pyramid(), "four-split", certify=False)
    yield "paired pyramid", *used_only(split.points, paired_surface(split, 16))


def _icosahedron():
    golden = (1 + 5 ** 0.5) / 2
    return np.array([np.roll([0, a, b * golden], turn) for turn in range(3) for a in (1, -1) for b in (1, -1)])


def test_surfaces_without_pairs():
    """Layers as they follow from loops, families and sides, worked out again from the quads."""
    most = set()
    for k, (name, points, quads) in enumerate(surfaces_of_simple_loops()):
        loops = dual_loops(quads)
        assert sorted(map(len, loops)) == sorted(map(len, hn.loops(quads))), name
        points, quads = canonical((points, quads))
        loops = dual_loops(quads)
        most.add(max(families(loops)) + 1)
        for method in (METHODS[k % 5], METHODS[(k + 2) % 5]):
            mesh = hn.mesh(points, quads, method, pairing="none", allow_topological=True)
            expected = layer_counts(quads, method in ALTERNATIVE)
            told = [mesh.report.get(f"hexes of split layer {layer + 1}") for layer in range(len(expected))]
            assert told == expected, name
            assert len(mesh.hexes) == sum(expected) + CLOSURES[method] * len(quads)
            assert_sound(points, mesh)
    assert {2, 3, 4, 5} <= most


@pytest.mark.parametrize("count", (4, 9, 10, 12))
def test_every_two_loops_cross(count):
    """A zonohedron: a layer for each of its zones; beyond nine, the last ones are told of together."""
    points, quads = zonohedron(np.random.default_rng(3), count)
    expected = layer_counts(quads)
    assert len(expected) == count
    mesh = hn.mesh(points, quads, "four-split", pairing="none")
    told, apart = mesh.report, count if count < 10 else 8
    assert told["split layers"] == count and f"hexes of split layer {apart + 1}" not in told
    assert [told[f"hexes of split layer {k + 1}"] for k in range(apart)] == expected[:apart]
    assert told.get("hexes of further split layers", 0) == sum(expected[apart:])
    assert_sound(points, mesh)


@pytest.mark.parametrize("method", METHODS)
def test_loops_that_cross_themselves(method):
    rng = np.random.default_rng(2)
    for n in (8, 20, 40):
        points, quads = random_polyhedron(rng, n)
        wrong = self_crossings(quads)
        assert wrong and raised("SELF_CROSSING", points, quads, method, pairing="none") == wrong
    points, quads = schneiders_pyramid()
    assert raised("SELF_CROSSING", points, quads, method, pairing="none") == self_crossings(quads) != []


# --------------------------------------------------------------------------------- given pairings

def random_pairing(rng, quads):
    """A perfect pairing, another one for every state of rng: that of the quads in another order."""
    order = rng.permutation(len(quads))
    return order[hn.pairing(quads[order])]


def test_given_pairings():
    rng, seen = np.random.default_rng(3), set()
    for k in range(15):
        points, quads = random_polyhedron(rng, int(rng.choice([8, 12, 20, 30])))
        pairs = random_pairing(rng, quads)
        assert {tuple(sorted(pair)) for pair in pairs.tolist()} <= set(neighbours(quads))
        method = METHODS[k % 5]
        mesh = hn.mesh(points, quads, method, pairing=pairs if k % 2 else pairs[::-1, ::-1].tolist())
        assert len(mesh.hexes) == ON_GIVEN[method] * len(quads)
        assert_sound(points, mesh)
        seen.add(mesh.hexes.tobytes() == hn.mesh(points, quads, method, certify=False).hexes.tobytes())
    assert False in seen


def test_given_pairs_are_the_first_hexes():
    """In the order of their first quads, whatever order they are given in."""
    points, quads = canonical(random_polyhedron(np.random.default_rng(4), 20))
    pairs = random_pairing(np.random.default_rng(5), quads)
    mesh = hn.mesh(points, quads, "pyramid", pairing=pairs)
    for pair, hexes in zip(sorted(sorted(pair) for pair in pairs.tolist()), mesh.hexes[:20].reshape(10, 2, 8)):
        assert [set(quads[q]) <= set(row) for q, row in zip(pair, hexes)] == [True, True]


def single_edge_pairs(quads):
    return [pair for pair, shared in neighbours(quads).items() if shared == 1]


def test_one_pair():
    """Two quads of a box paired: a cell of six for them, and new loops, whichever they are; some cross themselves."""
    points, quads = canonical(box(2, 3, 2))
    meshed = 0
    for k, pair in enumerate(single_edge_pairs(quads)[::2]):
        method = METHODS[k % 5]
        paired, source = paired_quads(quads, [pair])
        wrong = source[self_crossings(paired)].tolist()
        if wrong:
            assert raised("SELF_CROSSING", points, quads, method, pairing=[pair]) == wrong
            continue
        mesh = hn.mesh(points, quads, method, pairing=[pair])
        layers = layer_counts(paired, method in ALTERNATIVE)
        assert len(mesh.hexes) == 2 + sum(layers) + CLOSURES[method] * len(paired)
        assert mesh.report["pairs"] == 1 and mesh.report["split layers"] == len(layers)
        assert_sound(points, mesh)
        meshed += 1
    assert 3 < meshed < 25


def test_no_given_pairs_are_no_pairs():
    points, quads = box(2, 1, 2)
    empty = hn.mesh(points, quads, "pyramid", pairing=np.zeros((0, 2), int))
    assert empty.hexes.tobytes() == hn.mesh(points, quads, "pyramid", pairing="none").hexes.tobytes()


def test_pairs_take_crossings_away():
    """Pair what crosses itself, one quad after the other: the quads still named are the caller's, and none is in a
    pair, until all is well."""
    rng, meshed, refused = np.random.default_rng(6), 0, 0
    for _ in range(20):
        points, quads = random_polyhedron(rng, int(rng.choice([8, 12, 20])))
        around = single_edge_pairs(quads)
        pairs = []
        while True:
            taken = {q for pair in pairs for q in pair}
            try:
                mesh = hn.mesh(points, quads, "pyramid-alt", pairing=np.array(pairs, int).reshape(-1, 2))
            except hn.HexconError as fault:
                assert fault.code == hn.ErrorCode.SELF_CROSSING
                wrong = fault.elements
                refused += 1
            else:
                assert_sound(points, mesh)
                meshed += 1
                break
            assert wrong == sorted(set(wrong)) and not taken & set(wrong)
            assert all(0 <= q < len(quads) for q in wrong)
            paired, source = paired_quads(quads, pairs)
            assert wrong == source[self_crossings(paired)].tolist()
            free = [pair for pair in around if not taken & set(pair) and set(pair) & set(wrong)]
            if not free:
                break
            pairs.append(free[int(rng.integers(len(free)))])
    assert meshed > 1 and refused > 20


# ---------------------------------------------------------------------------------------- refusals

def test_bad_pairs():
    points, quads = box(2, 2, 2)
    good = single_edge_pairs(quads)
    far = next((a, b) for a in range(24) for b in range(24) if a < b and (a, b) not in neighbours(quads))
    one = good[0]
    two = next(pair for pair in good[1:] if set(pair) & set(one))
    for pairs, wrong in (([far], far), ([one, far], far), ([(3, 3)], (3, 3)), ([one, one], one), ([one, two], two),
                         ([(0, 24)], (0, 24)), ([one, (999, 1)], (999, 1))):
        assert tuple(raised("BAD_PAIRING", points, quads, "pyramid", pairing=pairs)) == tuple(wrong)
    raised("INDEX_OUT_OF_RANGE", points, quads, "pyramid", pairing=[(-1, 0)])
    raised("WRONG_SHAPE", points, quads, "pyramid", pairing=[(0, 1, 2)])
    raised("WRONG_TYPE", points, quads, "pyramid", pairing=[(0.5, 1.0)])


def test_bad_options():
    points, quads = box(2, 2, 2)
    for method in ("auto", "swept", "cells"):
        for pairing in ("none", [(0, 1)], np.zeros((0, 2), int)):
            raised("BAD_ARGUMENT", points, quads, method, pairing=pairing)
    raised("BAD_ARGUMENT", points, quads, "pyramid", pairing="some")
    raised("BAD_ARGUMENT", points, quads, "pyramids")
    for method in METHODS:
        raised("BAD_ARGUMENT", points, quads, method, layers=1)
        raised("BAD_ARGUMENT", points, quads, method, order=3)


def test_check_options():
    for method in METHODS:
        for pairing in ("all", "none", [(0, 1)]):
            hn.check_options(method, pairing=pairing)
    for options in ({"method": "cells", "pairing": "none"}, {"method": "pyramid", "pairing": "some"},
                    {"pairing": [(0, 1)]}, {"method": "geode", "layers": 2}, {"method": "Geode"}):
        with pytest.raises(hn.HexconError) as fault:
            hn.check_options(**options)
        assert fault.value.code == hn.ErrorCode.BAD_ARGUMENT
    hn.check_options("cells", pairing="all")

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof that a surface crosses and touches itself nowhere, and what is refused without it."""
import crossing_meshes
import numpy as np
import patch_judge
import pytest
from crossing_meshes import block, boundary_of, surface_of
from embedded_surfaces import anywhere, convex_surfaces, stacked_surfaces, star_surfaces, thin_walls
from paper_surfaces import paper_surfaces
from surfaces import box, permuted

import hexcon
import hexcon_native as hn

OVERLAPPING, APART = dict(crossing_meshes.overlapping()), dict(crossing_meshes.apart())
SCALES = (1e-6, 1.0, 1e9)


def scaled(points, scale, turn=None):
    return (points if turn is None else points @ turn) * scale


def some_turn(seed=5):
    return np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))[0]


# ----------------------------------------------------------------------------------------- meshes

@pytest.mark.parametrize("name", OVERLAPPING)
def test_what_covers_space_twice_is_not_certified(name):
    points, hexes = OVERLAPPING[name]
    quads = boundary_of((points, hexes))
    for scale in SCALES:
        found = hn.certify(scaled(points, scale), hexes, quads)
        assert found.conforming and found.boundary_exact and not len(found.nonpositive)
        assert found.embedded is False and not found.certified
        assert len(found.crossings) and found.embedding_reason
        assert (found.crossings[:, 0] < found.crossings[:, 1]).all() and found.crossings.max() < len(quads)


@pytest.mark.parametrize("name", [n for n in OVERLAPPING if "touch" not in n and "common" not in n
                                  and "part of" not in n and n not in ("corner on a face", "corner on an edge")
                                  and "apart" not in n and "1e-12" not in n and "as high" not in n])
def test_turned_and_moved_it_is_still_found(name):
    """Proper crossings; touching does not survive the rounding of a turn."""
    points, hexes = OVERLAPPING[name]
    quads, far = boundary_of((points, hexes)), np.array([3.0, -5.0, 7.0])
    turn = some_turn()
    turn[:, 0] *= np.sign(np.linalg.det(turn))
    for scale in SCALES:
        found = hn.certify(scaled(points + far, scale, turn), hexes, quads)
        assert not len(found.nonpositive) and not found.certified
        assert found.embedded is False or "twice" in name or "fills" in name or "coincident" in name


@pytest.mark.parametrize("name", APART)
def test_relatives_that_do_not_are_certified(name):
    points, hexes = APART[name]
    for scale in SCALES:
        found = hn.certify(scaled(points, scale), hexes, boundary_of((points, hexes)))
        assert found.embedded is True and found.certified, found.embedding_reason


def test_points_that_stand_twice_are_counted():
    points, hexes = OVERLAPPING["blocks with a common face"]
    found = hn.certify(points, hexes, boundary_of((points, hexes)))
    assert found.embedding_reason.startswith("9 points stand twice")


def test_without_an_exact_boundary_nothing_is_said():
    points, hexes = block(2, 2, 2)
    found = hn.certify(points, hexes, boundary_of((points, hexes))[1:])
    assert found.embedded is None and "not the boundary" in found.embedding_reason and not found.certified


# -------------------------------------------------------------------------------------- surfaces

def all_embedded(surfaces, seed):
    rng = np.random.default_rng(seed)
    wrong = []
    for i, surface in enumerate(surfaces):
        points, quads = permuted(surface if i % 2 else anywhere(surface, rng), rng)
        report = hn.check_surface(points, quads)
        if report.embedded is not True:
            wrong.append((i, report.embedded, report.embedding_reason, report.crossings[:3].tolist()))
    return wrong


def test_no_false_alarm_on_stars():
    assert all_embedded(star_surfaces(700), 1) == []


def test_no_false_alarm_on_thin_walls():
    assert all_embedded(thin_walls(500), 2) == []


def test_no_false_alarm_on_convex_bodies():
    assert all_embedded(convex_surfaces(500), 3) == []


def test_no_false_alarm_on_stacks():
    """Not turned: what is 1e-9 high in 1 is as high as the rounding of a turn is fine."""
    wrong = []
    for i, (points, quads) in enumerate(stacked_surfaces(300)):
        report = hn.check_surface(points, quads)
        if report.embedded is not True:
            wrong.append((i, report.embedded, report.embedding_reason))
    assert wrong == []


def test_the_surfaces_of_the_literature_are_embedded():
    for name, points, quads in paper_surfaces():
        assert hn.check_surface(points, quads).embedded is True, name


# ------------------------------------------------------------------------- pairs, by another method

def random_pair(rng):
    """Two quads that share nothing, a point, an edge, two edges, opposite points, or points that are opposite in one
    of them, often in touching places."""
    kind = int(rng.integers(0, 4))
    if kind == 0:
        points = rng.normal(size=(8, 3))
    elif kind == 1:
        points = rng.integers(0, 4, (8, 3)).astype(float)
    elif kind == 2:
        sheet = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]) + 0.2 * rng.normal(size=(4, 3))
        points = np.vstack([sheet, sheet + [0, 0, 10.0 ** -rng.integers(1, 9)]])
    else:
        points = rng.integers(-1, 2, (8, 3)) + 1e-5 * rng.normal(size=(8, 3)) * (rng.random((8, 3)) < 0.3)
    other = ([4, 5, 6, 7], [1, 5, 6, 7], [1, 0, 6, 7], [2, 1, 0, 7], [0, 5, 2, 7], [0, 2, 6, 7])[int(rng.integers(0, 6))]
    return points, np.array([[0, 1, 2, 3], other])


def spans_area(points, quad):
    return np.linalg.norm(np.cross(points[quad[2]] - points[quad[0]], points[quad[3]] - points[quad[1]])) > 1e-3


def test_pairs_agree_with_minimisation():
    """Where minimisation finds a common place the proof must not say there is none, and where it
    finds the two clearly apart, and they share nothing, the proof must not say that they meet."""
    rng, counts = np.random.default_rng(11), {True: 0, False: 0, None: 0}
    while min(counts[True], counts[False]) < 20:
        points, quads = random_pair(rng)
        used, numbers = np.unique(quads, return_inverse=True)
        points, quads = points[used], numbers.reshape(2, 4).astype(np.int32)
        if len(np.unique(points, axis=0)) < len(points) or not all(spans_area(points, q) for q in quads):
            continue
        embedded, crossings = embedding_of(points, quads)
        if any(a == b for a, b in crossings):
            continue
        counts[embedded] += 1
        if embedded is None:
            continue
        gap = min(patch_judge.distance(points[a], points[b], a, b, starts=2) for a, b in (quads, quads[::-1]))
        if embedded:
            assert gap > 1e-11, (points.tolist(), quads.tolist())
        elif not set(quads[0]) & set(quads[1]):
            assert gap < 1e-6, (points.tolist(), quads.tolist())
    assert counts[None] < 0.05 * sum(counts.values())  # patches that are tangent in a place, on small integers


def embedding_of(points, quads):
    """Of quads that need not be a closed surface."""
    found = hn._core.embedding(np.ascontiguousarray(points), np.ascontiguousarray(quads), None)
    return hn._EMBEDDED[found["embedded"]], np.frombuffer(found["pairs"], np.int32).reshape(-1, 2).tolist()


@pytest.mark.parametrize("rise, expected", [(0.25, False), (0.25 + 1e-9, True), (0.25 - 1e-9, False)])
def test_a_corner_on_a_warped_patch(rise, expected):
    """The patch z = x y has its middle at 1/4; the other quad stands there on a corner."""
    points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0],
                       [.5, .5, rise], [1, .25, 2 + rise], [.5, .5, 4], [0, .75, 2]])
    embedded, crossings = embedding_of(points, np.array([[0, 1, 2, 3], [4, 5, 6, 7]], np.int32))
    assert embedded is expected and (crossings == [] if expected else crossings == [[0, 1]])


def test_ovals_within_two_patches_are_found():
    """Saddles 2 x^2 - y^2 and x^2 - 2 y^2 + 1 meet on a circle that comes near no side of either."""
    def saddle(along, across, lift):
        # rotated by 45 degrees a x^2 - b y^2 is bilinear in p = sqrt(a) x + sqrt(b) y and q = sqrt(a) x - sqrt(b) y
        corners = [(p, q) for p, q in ((-5, -5), (5, -5), (5, 5), (-5, 5))]
        return [[(p + q) / 2 / np.sqrt(along), (p - q) / 2 / np.sqrt(across), p * q + lift] for p, q in corners]

    points = np.array(saddle(2, 1, 0.0) + saddle(1, 2, 1.0))
    assert embedding_of(points, np.array([[0, 1, 2, 3], [4, 5, 6, 7]], np.int32))[0] is False


def test_a_folded_quad_is_a_pair_with_itself():
    points = np.array([[0, 0, 0], [4, 0, 0], [1, 1, 0], [0, 4, 0.0]])
    assert embedding_of(points, np.array([[0, 1, 2, 3]], np.int32)) == (False, [[0, 0]])
    points[2] = (3, 3, 0)
    assert embedding_of(points, np.array([[0, 1, 2, 3]], np.int32)) == (True, [])


# --------------------------------------------------------------------------------------- refusals

METHODS = ("auto", "swept", "sheets", "diced", "smallest", "shelling", "cells", "pyramid", "geode-alt", "pillowed")


@pytest.mark.parametrize("method", METHODS)
def test_every_method_refuses_it_before_anything_is_tried(method):
    points, quads = surface_of(OVERLAPPING["bar bent by 450 degrees"])
    stages = []
    with pytest.raises(hn.HexconError) as caught:
        hn.mesh(points, quads, method, progress=lambda stage, fraction: stages.append(stage))
    assert caught.value.code == hn.ErrorCode.SELF_INTERSECTING
    pairs = np.reshape(caught.value.elements, (-1, 2))
    assert len(pairs) and (pairs[:, 0] < pairs[:, 1]).all() and pairs.max() < len(quads)
    assert set(stages) <= {"embedding"}


def test_topology_may_go_on_and_says_so():
    points, quads = surface_of(OVERLAPPING["arms -0.1 apart"])
    made = hn.mesh(points, quads, "pyramid-alt", allow_topological=True)
    assert len(made.hexes) == 58 * len(quads)
    assert made.certificate.embedded is False and not made.certificate.certified
    with pytest.raises(hn.HexconError) as caught:
        hn.mesh(points, quads, "cells", allow_topological=True)
    assert caught.value.code == hn.ErrorCode.SELF_INTERSECTING


def test_a_corner_pushed_through_the_opposite_side_is_refused():
    points, quads = box(3, 3, 3)
    pushed = points.copy()
    pushed[np.flatnonzero((points == (1, 1, 3)).all(axis=1))] = (1.2, 1.3, -0.5)
    with pytest.raises(hn.HexconError) as caught:
        hn.mesh(pushed, quads)
    assert caught.value.code == hn.ErrorCode.SELF_INTERSECTING


def test_the_verdict_does_not_depend_on_the_numbering():
    rng = np.random.default_rng(3)
    points, quads = surface_of(OVERLAPPING["thick spring"])
    report = hn.check_surface(points, quads)
    place = {tuple(np.sort(points[q], axis=0).ravel()) for q in quads[np.unique(report.crossings)]}
    for _ in range(5):
        other = permuted((points, quads), rng)
        found = hn.check_surface(*other)
        assert found.embedded is False and place & {
            tuple(np.sort(other[0][q], axis=0).ravel()) for q in other[1][np.unique(found.crossings)]}

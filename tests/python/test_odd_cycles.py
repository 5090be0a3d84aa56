# SPDX-License-Identifier: LGPL-2.1-or-later
"""Erickson's condition: which surfaces have a hex mesh at all, and the odd path where one has none."""
import itertools

import mesh_checker
import numpy as np
import pytest
from cocycles import is_fillable, split_quads
from surfaces import annulus, box, permuted, prism, upright

import hexcon_native as hn
from hexcon.tetrahedra import tetrahedralise

Code = hn.ErrorCode


# -------------------------------------------------------------------------------------- surfaces

def tube(core, m, n, radius, turns=0, shift=0):
    """m rings of n quads round a closed curve core(t), t in 0 .. 1; its frame turns `turns` times more than one that
    points away from the axis; the last ring meets the first shifted by so many quads."""
    i, j = (a.ravel() for a in np.mgrid[:m, :n])
    t = i / m
    step = 1e-4
    middle, along = core(t), core(t + step) - core(t - step)
    along /= np.linalg.norm(along, axis=1)[:, None]
    out = middle * [1, 1, 0]
    out -= (out * along).sum(axis=1)[:, None] * along
    out /= np.linalg.norm(out, axis=1)[:, None]
    angle = (2 * np.pi * (j + shift * t) / n + 2 * np.pi * turns * t)[:, None]
    points = middle + radius * (np.cos(angle) * out + np.sin(angle) * np.cross(along, out))

    def point(i, j):
        return i % m * n + (j + shift * (i // m)) % n
    quads = np.column_stack([point(i, j), point(i, j + 1), point(i + 1, j + 1), point(i + 1, j)])
    return points, quads


def circle(t):
    angle = 2 * np.pi * t
    return 3 * np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])


def trefoil(t):
    angle = 2 * np.pi * t
    ring = 3 + 1.2 * np.cos(3 * angle)
    return np.column_stack([ring * np.cos(2 * angle), ring * np.sin(2 * angle), 1.2 * np.sin(3 * angle)])


def hollow(outer, inner):
    """The body between two surfaces."""
    return (np.vstack([outer[0], inner[0]]), np.vstack([outer[1], inner[1][:, ::-1] + len(outer[0])]))


def big_box(half):
    points, quads = box(2, 2, 2)
    return (points - 1) * half, quads


# ---------------------------------------------------------------------------------------- judges

def by_tetrahedra(points, quads):
    return is_fillable(quads, tetrahedralise(points, split_quads(quads), coarsening=1.0)[1])


def linking_number(a, b):
    """Gauss's integral over two closed polygons, by the solid angles of pairs of edges."""
    p, q = a[:, None], np.roll(a, -1, axis=0)[:, None]
    r, s = b[None], np.roll(b, -1, axis=0)[None]
    corners = [r - p, s - p, s - q, r - q]
    corners = [c / np.linalg.norm(c, axis=2)[:, :, None] for c in corners]
    total = 0.0
    for i, j, k in ((0, 1, 2), (0, 2, 3)):
        x, y, z = corners[i], corners[j], corners[k]
        base = 1 + (x * y).sum(axis=2) + (y * z).sum(axis=2) + (z * x).sum(axis=2)
        total += 2 * np.arctan2((x * np.cross(y, z)).sum(axis=2), base).sum()
    assert abs(total / (4 * np.pi) - round(total / (4 * np.pi))) < 1e-6
    return round(total / (4 * np.pi))


def told(points, quads):
    """What the core says, under any numbering, and after a rotation."""
    rng = np.random.default_rng(len(quads))
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    points, quads = permuted((points, quads), rng)
    answers = {hn.check_surface(p, quads).fillable for p in (points, points @ (turn * np.sign(np.linalg.det(turn))))}
    assert len(answers) == 1
    return answers.pop()


def assert_odd_path(quads, path):
    """A closed path of edges, each point once."""
    edges = {tuple(sorted(edge)) for quad in quads.tolist() for edge in zip(quad, quad[1:] + quad[:1])}
    assert len(path) % 2 == 1 and len(set(path)) == len(path)
    assert {tuple(sorted(step)) for step in zip(path, path[1:] + path[:1])} <= edges


def refusal(points, quads, method="auto"):
    with pytest.raises(hn.HexconError) as caught:
        hn.mesh(points, quads, method)
    return caught.value


# ------------------------------------------------------------------------------------------ tori

TORI = [(m, n, shift) for m, n in itertools.product((5, 6, 11, 14), (3, 4, 7, 8)) for shift in (0, 1, 2)]


@pytest.mark.parametrize("m, n, shift", TORI)
def test_tori(m, n, shift):
    """Only the meridian bounds inside, whatever the longitude."""
    points, quads = tube(circle, m, n, 1.0, shift=shift)
    report = hn.check_surface(points, quads)
    assert report.genus == 1 and report.oriented
    assert report.bipartite == (n % 2 == 0 and (m + shift) % 2 == 0)
    assert report.fillable == told(points, quads) == (n % 2 == 0)     # then the number of quads is even as well
    if n % 2 == 1 and m % 2 == 0:
        fault = refusal(points, quads)
        assert fault.code == Code.NO_HEX_MESH and f"{len(fault.elements)} edges" in str(fault)
        assert_odd_path(quads, fault.elements)
        around = np.exp(1j * np.arctan2(points[fault.elements, 1], points[fault.elements, 0]))
        assert abs(np.angle(np.roll(around, -1) / around).sum()) < 1e-9    # it does not go round the axis
        assert len(fault.elements) == n


def test_all_methods_refuse_but_four_split():
    points, quads = tube(circle, 6, 3, 1.0)
    for method in hn.METHOD_CHOICES:
        if method != "four-split":
            assert refusal(points, quads, method).code == Code.NO_HEX_MESH
    # it fills no body, and fails for its own reason
    assert refusal(points, quads, "four-split").code == Code.NO_SIDES


def test_other_faults_come_first():
    assert refusal(*tube(circle, 5, 3, 1.0)).code == Code.ODD
    outer, inner = tube(circle, 6, 3, 1.0), tube(circle, 6, 3, 0.5)
    apart = np.vstack([outer[0], inner[0] + [0, 0, 9]]), np.vstack([outer[1], inner[1] + len(outer[0])])
    assert refusal(*apart).code == Code.SEVERAL_COMPONENTS


def test_odd_longitude_is_another_matter():
    """It bounds nothing inside. A sweep along it does not mind, nor do layers; others do, but not the surface."""
    points, quads = tube(circle, 5, 4, 1.0)
    report = hn.check_surface(points, quads)
    assert report.fillable is True and not report.bipartite
    for method, row in hn.METHOD_TABLE.items():
        if not row.odd_colours:
            assert refusal(points, quads, method).code != Code.NO_HEX_MESH
    mesh = hn.mesh(points, quads)
    assert mesh.method == "swept" and len(mesh.hexes) == 5
    assert mesh_checker.faults(mesh.points, mesh.hexes, quads, points) == []


@pytest.mark.parametrize("sectors, rings", [(5, 2), (7, 1), (9, 4)])
def test_odd_longitude_swept(sectors, rings):
    surface = prism(annulus(sectors, 2), np.arange(rings + 1.0), upright)
    report = hn.check_surface(*surface)
    assert report.fillable is True and not report.bipartite and report.genus == 1
    mesh = hn.mesh(*surface)
    assert mesh.method == "swept" and len(mesh.hexes) == 2 * sectors * rings
    assert mesh_checker.faults(mesh.points, mesh.hexes, surface[1], surface[0]) == []


# ----------------------------------------------------------------------------- knots and cavities

@pytest.mark.parametrize("m, n, turns", [(40, 4, 0), (40, 3, 0), (41, 4, 1), (41, 6, 0), (60, 5, 2)])
def test_knotted_tube(m, n, turns):
    """A solid tube round a knot is a torus like any other: the meridian bounds."""
    points, quads = tube(trefoil, m, n, 0.45, turns)
    assert told(points, quads) == (n % 2 == 0 and m * n % 2 == 0)


@pytest.mark.parametrize("core", [circle, trefoil])
@pytest.mark.parametrize("m, n, turns", [(40, 4, 0), (40, 5, 0), (40, 5, 1), (41, 4, 0), (41, 6, 1), (40, 3, 2)])
def test_cavity_of_a_tube(core, m, n, turns):
    """Outside, the longitude bounds that does not link the core: so many meridians against one along the frame."""
    inner = tube(core, m, n, 0.3, turns)
    frame = inner[0][::n]
    links = linking_number(core(np.arange(m) / m), frame)
    points, quads = hollow(big_box(7.0), inner)
    report = hn.check_surface(points, quads)
    assert (report.components, report.cavities, report.genus, report.oriented) == (2, 1, 1, True)
    assert told(points, quads) == (m * n % 2 == 0 and (m + links * n) % 2 == 0)
    if len(quads) % 2 == 0 and not report.fillable:
        fault = refusal(points, quads)
        assert fault.code == Code.NO_HEX_MESH
        assert_odd_path(quads, fault.elements)


def test_frames_link_the_knot():
    """The cases above see odd and even linking numbers."""
    links = {turns: linking_number(trefoil(np.arange(60) / 60), tube(trefoil, 60, 4, 0.3, turns)[0][::4])
             for turns in (0, 1, 2)}
    assert abs(links[1] - links[0]) == 1 and abs(links[2] - links[0]) == 2


@pytest.mark.parametrize("outer, inner", [((8, 6), (6, 4)), ((8, 5), (6, 3)), ((7, 6), (5, 4)), ((8, 5), (6, 4)),
                                          ((7, 6), (6, 4)), ((8, 6), (5, 4)), ((7, 4), (6, 3)), ((7, 8), (6, 7))])
def test_hollow_torus(outer, inner):
    """Between two tori, meridians bound together, and longitudes."""
    points, quads = hollow(tube(circle, *outer, 1.0), tube(circle, *inner, 0.25))
    even = (np.array(outer) + inner) % 2 == 0
    assert told(points, quads) == (len(quads) % 2 == 0 and even.all())
    if len(quads) % 2 == 0 and not even.all():
        fault = refusal(points, quads)
        assert fault.code == Code.NO_HEX_MESH and "2 closed paths" in str(fault)
        assert len(fault.elements) % 2 == 1


# --------------------------------------------------------------------------- against tetrahedra

@pytest.mark.parametrize("case", [(circle, 10, 3, 1.0, 0, 0), (circle, 11, 4, 1.0, 0, 1), (trefoil, 40, 4, 0.45, 1, 0),
                                  (trefoil, 40, 3, 0.45, 0, 0)])
def test_tubes_by_tetrahedra(case):
    surface = tube(*case)
    assert told(*surface) == by_tetrahedra(*surface)


@pytest.mark.parametrize("case", [(circle, 12, 4, 0.6, 0, 0), (circle, 11, 4, 0.6, 0, 0), (trefoil, 40, 5, 0.3, 1, 0)])
def test_cavities_by_tetrahedra(case):
    surface = hollow(big_box(7.0), tube(*case))
    assert told(*surface) == by_tetrahedra(*surface)


def linked(first, second):
    """Two tubes through each other in one block: Hopf's link."""
    points, quads = tube(circle, *second)
    through = points[:, [0, 2, 1]] * [1, -1, 1] + [3, 0, 0]     # turned about x
    return hollow(hollow(big_box(9.0), tube(circle, *first)), (through, quads))


def joined(first, second):
    """Two tori side by side with a bar between: genus 2."""
    (left, left_quads), (right, right_quads) = tube(circle, *first, 1.0), tube(circle, *second, 1.0)
    right = right * [-1, -1, 1] + [10, 0, 0]                    # turned about z: the frames start towards each other
    here, there = left_quads[-1], right_quads[-1] + len(left)
    points = np.vstack([left, right])
    turn = min(range(4), key=lambda k: np.linalg.norm(points[here] - points[np.roll(there[::-1], k)], axis=1).sum())
    there = np.roll(there[::-1], turn)
    after = np.roll(np.arange(4), -1)
    bar = np.column_stack([here, here[after], there[after], there])
    return points, np.vstack([left_quads[:-1], right_quads[:-1] + len(left), bar])


@pytest.mark.parametrize("first, second", itertools.product([(10, 4), (11, 4), (10, 3), (11, 3)], repeat=2))
def test_genus_two(first, second):
    """Both meridians bound, and the bar is even."""
    points, quads = joined(first, second)
    report = hn.check_surface(points, quads)
    assert report.genus == 2 and report.oriented
    even = (first[0] * first[1] + second[0] * second[1]) % 2 == 0
    assert told(points, quads) == (even and first[1] % 2 == 0 and second[1] % 2 == 0)
    if even and not report.fillable:
        assert_odd_path(quads, refusal(points, quads).elements)


@pytest.mark.parametrize("first, second", [((10, 4), (11, 4)), ((10, 3), (11, 4)), ((11, 3), (11, 3))])
def test_genus_two_by_tetrahedra(first, second):
    surface = joined(first, second)
    assert told(*surface) == by_tetrahedra(*surface)


@pytest.mark.parametrize("first, second", [((12, 4, 0.5), (10, 6, 0.5)), ((12, 5, 0.5), (11, 4, 0.5)),
                                           ((12, 5, 0.5), (12, 5, 0.5)), ((12, 5, 0.5, 1), (11, 4, 0.5, 0)),
                                           ((11, 4, 0.5), (12, 4, 0.5))])
def test_linked_cavities(first, second):
    """A longitude bounds together with a meridian of the other tube."""
    surface = linked(first, second)
    turns = [tuple(case[3:]) or (0,) for case in (first, second)]
    (m, n, *_), (k, l, *_) = first, second  # noqa: E741
    expected = (m * n + k * l) % 2 == 0 and (m + turns[0][0] * n + l) % 2 == 0 and (k + turns[1][0] * l + n) % 2 == 0
    assert told(*surface) == expected == by_tetrahedra(*surface)


# ----------------------------------------------------------------------------- honesty and cost

@pytest.mark.parametrize("n, radius", [(4, 1.3), (4, 1.5), (6, 1.3)])
def test_a_surface_that_crosses_itself_is_left_open(n, radius):
    """A tube pulled through itself bounds no body: these linking numbers are those of no surface. Nothing is claimed,
    and methods go on to their own faults."""
    points, quads = tube(trefoil, 41, n, radius)
    report = hn.check_surface(points, quads)
    assert report.fillable is None and report.as_dict()["fillable"] is None
    assert refusal(points, quads, "cells").code != Code.NO_HEX_MESH


@pytest.mark.parametrize("scale, shift", [(1e-40, 0.0), (1e40, 0.0), (1.0, 1e6)])
def test_scale_and_place_do_not_matter(scale, shift):
    for m, n in ((11, 4), (10, 5)):
        points, quads = tube(circle, m, n, 1.0)
        assert hn.check_surface(points * scale + shift, quads).fillable == (n == 4)


@pytest.mark.parametrize("odd", [None, 17])
def test_many_cavities(odd):
    """Thirty tubes in one block, of which one may be at fault: the path is on it."""
    tubes = []
    for k in range(30):
        points, quads = tube(circle, 16, 4 + k % 3 * 2, 0.5, shift=k % 2 * 2)
        if k == odd:
            points, quads = tube(circle, 15, 4, 0.5)
        tubes.append((points + [9 * (k % 6) - 22.5, 9 * (k // 6) - 18, 0], quads))
    points, quads = big_box(30.0)
    where = []
    for inner in tubes:
        where.append(len(points))
        points, quads = hollow((points, quads), inner)
    report = hn.check_surface(points, quads)
    assert report.genus == report.cavities == 30 and report.bipartite == report.fillable == (odd is None)
    if odd is not None:
        path = refusal(points, quads).elements
        assert_odd_path(quads, path)
        assert len(path) == 15 and all(0 <= v - where[odd] < len(tubes[odd][0]) for v in path)

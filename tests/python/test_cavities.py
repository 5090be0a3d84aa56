# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies with cavities: how shells are told apart and turned, and how such a body is filled."""
import itertools

import mesh_checker
import numpy as np
import pytest
from cell_surfaces import round_hull
from surfaces import box, diced, diced_hull, permuted, tetrahedron

import hexcon
import hexcon_native as hn
from hexcon.quads.surface import given

Code = hn.ErrorCode


def shell(surface, scale=1.0, place=(0, 0, 0)):
    points, quads = surface
    return points * scale + place, quads


def cube(n, half, place=(0, 0, 0)):
    points, quads = box(n, n, n)
    return shell((points - n / 2, quads), 2 * half / n, place)


def inward(surface):
    return surface[0], surface[1][:, ::-1]


def together(*surfaces):
    starts = np.cumsum([0] + [len(points) for points, _ in surfaces])
    return (np.vstack([points for points, _ in surfaces]),
            np.vstack([quads + start for (_, quads), start in zip(surfaces, starts)]))


def hollow_ball(seed=1):
    """Diced hulls, one of 60 and one of 20 points; not about one centre."""
    rng = np.random.default_rng(seed)
    return together(shell(round_hull(rng, 60), 2.0), inward(shell(round_hull(rng, 20), 0.7, (0.3, 0.2, 0.1))))


def refusal(surface, method="auto"):
    with pytest.raises(hn.HexconError) as caught:
        hexcon.mesh_surface(*surface, method)
    return caught.value


def as_sets(quads):
    """Quads with the smallest id first, in the order of their corners."""
    first = np.argmin(quads, axis=1)[:, None]
    return {tuple(row) for row in np.take_along_axis(quads, (first + np.arange(4)) % 4, axis=1).tolist()}


# ----------------------------------------------------------------------------------------- shells

@pytest.mark.parametrize("turned", list(itertools.product((False, True), repeat=3)))
def test_shells_are_turned(turned):
    """A box with two cavities: however its shells face, they come to face out of the solid."""
    shells = [cube(2, 3.0), inward(cube(1, 0.5, (-1.5, 0, 0))), inward(cube(3, 0.7, (1.3, 0.2, 0)))]
    right = together(*shells)
    points, quads = together(*(inward(s) if turn else s for s, turn in zip(shells, turned)))
    report = hn.check_surface(points, quads)
    assert (report.components, report.cavities, report.genus, report.euler) == (3, 2, 0, 6)
    assert report.oriented == (not any(turned)) and report.even and report.bipartite and report.fillable is True
    assert report.volume == pytest.approx(6 ** 3 - 1 - 1.4 ** 3)
    assert report.star_center is None and not report.convex
    oriented, bodies, cavities = hn.orient(points, quads)
    assert as_sets(oriented) == as_sets(right[1]) and (bodies, cavities) == (1, 2)
    layers = hn.mesh(points, quads, "four-split")
    assert as_sets(layers.quads[:len(quads)]) == as_sets(right[1])
    assert layers.report["turned outward"] == any(turned)


def test_shells_in_any_order():
    surface = hollow_ball()
    volume = hn.check_surface(*surface).volume
    for seed in range(4):
        points, quads = permuted(surface, np.random.default_rng(seed))
        report = hn.check_surface(points * 1e-3 + 50.0, quads)
        assert report.cavities == 1 and report.oriented and report.volume == pytest.approx(volume * 1e-9, rel=1e-6)


def test_a_torus_with_a_cavity_is_no_ball():
    """Their Euler characteristics add up to a sphere's."""
    angle = 2 * np.pi * np.arange(16) / 16
    ring, around = (a.ravel() for a in np.meshgrid(angle, angle[::2], indexing="ij"))
    points = np.column_stack([(3 + np.cos(around)) * np.cos(ring), (3 + np.cos(around)) * np.sin(ring), np.sin(around)])
    i, j = (a.ravel() for a in np.mgrid[:16, :8])
    quads = np.column_stack([8 * i + j, 8 * ((i + 1) % 16) + j, 8 * ((i + 1) % 16) + (j + 1) % 8, 8 * i + (j + 1) % 8])
    points, quads = together((points, quads), inward(cube(2, 0.3, (3, 0, 0))))
    assert len(points) == len(quads) + 2
    assert hn.check_surface(points, quads).genus == 1
    for method in hn.METHODS:
        if method in METHODS_FOR_BALLS:
            assert refusal((points, quads), method).code == Code.NOT_A_BALL


def test_many_cavities():
    cubes = [inward(cube(1, 0.3, place)) for place in itertools.product(range(10), repeat=3)]
    report = hn.check_surface(*together(cube(2, 6.0, (4.5, 4.5, 4.5)), *cubes))
    assert report.cavities == 1000 and report.oriented and report.volume == pytest.approx(12 ** 3 - 1000 * 0.216)


# ---------------------------------------------------------------------------------------- refusals

def test_several_bodies():
    """Side by side, one in a cavity of another, and both: one quad of each outer shell."""
    apart = together(cube(1, 1.0), cube(1, 1.0, (5, 0, 0)))
    nested = together(cube(2, 3.0), inward(cube(1, 2.0)), cube(1, 1.0))
    both = together(nested, cube(1, 1.0, (9, 0, 0)))
    for surface, bodies, listed in ((apart, 2, [0, 6]), (nested, 2, [0, 30]), (both, 3, [0, 30, 36])):
        for method in ("auto", "diced", "swept", "pyramid"):
            fault = refusal(surface, method)
            assert fault.code == Code.SEVERAL_COMPONENTS and list(fault.elements) == listed
            assert f"{bodies} separate bodies" in str(fault)
        report = hn.check_surface(*surface)
        assert report.components - report.cavities == bodies and report.oriented and report.fillable is True


def odd_shell():
    """5 x 3 quads on a torus."""
    i, j = (a.ravel() for a in np.mgrid[:5, :3])
    u, v = 2 * np.pi * i / 5, 2 * np.pi * j / 3
    points = np.column_stack([(3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)])
    return points, np.column_stack([3 * i + j, 3 * ((i + 1) % 5) + j, 3 * ((i + 1) % 5) + (j + 1) % 3, 3 * i + (j + 1) % 3])


def test_odd_shells():
    """Even together, odd each: theory may allow a mesh, HexCon makes none, and says which shells are odd."""
    surface = together(odd_shell(), inward(shell(odd_shell(), 0.05, (3, 0, 0))))
    report = hn.check_surface(*surface)
    assert report.cavities == 1 and not report.even
    for method in ("auto", "diced", "four-split"):
        fault = refusal(surface, method)
        assert fault.code == Code.ODD and list(fault.elements) == [0, 15] and "2 of the surface's 2 shells" in str(fault)
    fault = refusal(together(cube(2, 9.0), inward(odd_shell())))
    assert fault.code == Code.ODD and "39 quads" in str(fault)


METHODS_FOR_BALLS = hn.methods_that(lambda method: not method.cavities)
assert set(METHODS_FOR_BALLS) >= {"swept", "sheets", "smallest", "shelling", "pyramid", "pyramid-alt"}


@pytest.mark.parametrize("method", METHODS_FOR_BALLS)
def test_methods_for_balls_refuse(method):
    """Even where both shells could be swept alone."""
    for surface in (together(cube(2, 2.0), inward(cube(2, 1.0))), hollow_ball()):
        fault = refusal(surface, method)
        assert fault.code == Code.NOT_A_BALL and "cavities" in str(fault)


# ----------------------------------------------------------------------------------------- filling

def assert_filled(mesh, surface, euler):
    points, quads = surface
    assert mesh.method == "diced" and mesh.certificate.certified and mesh.certificate.euler == euler
    assert mesh_checker.faults(mesh.points, mesh.hexes, quads, points) == []
    assert mesh.quality.min > 0.05


@pytest.mark.parametrize("seed", [1, 2])
def test_hollow_ball(seed):
    surface = permuted(hollow_ball(seed), np.random.default_rng(seed))
    assert_filled(hexcon.mesh_surface(*surface), surface, 2)


def test_shells_read_in_their_own_ways():
    """Coarse quads outside, triangles of two cavities inside; corners come first in some quads, centres in others."""
    rng = np.random.default_rng(3)
    surface = together(cube(4, 3.0), inward(shell(tetrahedron(), 1.6, (-2, -0.5, -0.5))),
                       inward(shell(diced_hull(np.vstack([np.eye(3), -np.eye(3)])), 0.9, (1.4, 0, 0))))
    surface = permuted(surface, rng)
    mesh = hexcon.mesh_surface(*surface, "diced")
    assert_filled(mesh, surface, 3)
    assert mesh.report["coarse quads"] == 24 and mesh.report["coarse triangles"] == 12


def test_geodes_on_both_sides():
    """All coarse faces are quads."""
    surface = together(cube(6, 3.0), inward(cube(4, 1.0)))
    mesh = hexcon.mesh_surface(*surface)
    assert_filled(mesh, surface, 2)
    assert mesh.report["geodes"] == 6 * 9 + 6 * 4 or mesh.report["pyramids"] == 6 * 9 + 6 * 4


def test_not_diced_lists_the_quads_of_the_shell_at_fault():
    surface = together(cube(2, 3.0), inward(cube(3, 1.0)))
    fault = refusal(surface, "diced")
    assert fault.code == Code.NOT_DICED and fault.elements and min(fault.elements) >= 24


# ---------------------------------------------------------------------------------- plain surfaces

def test_given_surfaces_of_mixed_sense():
    points, quads = together(cube(2, 3.0), cube(1, 1.0))
    mixed = quads.copy()
    mixed[::3] = mixed[::3, ::-1]
    surface = given(points, mixed, [])
    assert as_sets(surface.quads) == as_sets(together(cube(2, 3.0), inward(cube(1, 1.0)))[1])
    assert any("turned" in note for note in surface.notes)


def test_orient():
    """Bodies and cavities are counted; quads in any sense are turned, their corners reversed, the others kept."""
    assert hn.orient(*together(cube(1, 1.0), cube(1, 1.0, (5, 0, 0))))[1:] == (2, 0)
    assert hn.orient(*together(cube(2, 3.0), cube(1, 2.0), cube(1, 1.0)))[1:] == (2, 1)
    points, quads = together(cube(3, 3.0), inward(hollow_ball(seed=4)), inward(cube(2, 9.0, (30, 0, 0))))
    right, bodies, cavities = hn.orient(points, quads)
    assert (bodies, cavities) == (2, 1) or bodies + cavities == hn.check_surface(points, quads).components
    rng = np.random.default_rng(5)
    for _ in range(10):
        turned = rng.random(len(quads)) < rng.random()
        mixed = np.where(turned[:, None], right[:, ::-1], right)
        again, *counts = hn.orient(points, mixed)
        assert np.array_equal(again, right) and counts == [bodies, cavities]
    given_quads = quads.copy()
    assert np.array_equal(hn.orient(points, quads)[0], right) and np.array_equal(quads, given_quads)


def test_orient_refuses():
    for points, quads, code in (
            (*diced(np.eye(3), [[0, 1, 2]]), Code.NOT_CLOSED), (*moebius_torus(), Code.NOT_ORIENTABLE),
            (np.zeros((0, 3)), np.zeros((0, 4), int), Code.EMPTY)):
        with pytest.raises(hn.HexconError) as caught:
            hn.orient(points, quads)
        assert caught.value.code == code
        if code != Code.EMPTY:
            with pytest.raises(hn.HexconError) as caught:
                given(points, quads, [])
            assert caught.value.code == code


def moebius_torus():
    """A Klein bottle of 5 x 4 quads."""
    i, j = (a.ravel() for a in np.mgrid[:5, :4])

    def at(a, b):
        return 4 * (a % 5) + np.where(a < 5, b % 4, -b % 4)
    quads = np.column_stack([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
    return np.random.default_rng(0).random((20, 3)), quads

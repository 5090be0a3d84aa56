# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plane part of the sweep: counts, lattice polygons, smoothing. Needs gmsh importable, as the worker does."""
import pathlib

import numpy as np
import pytest

from hexcon.quads.gmsh_worker import cad, smooth
from hexcon.quads.gmsh_worker.boundary import orient, outline_of
from hexcon.quads.gmsh_worker.cap import mesh_cap
from hexcon.quads.gmsh_worker.link import Link
from hexcon.quads.gmsh_worker.outline import Outline, balanced, least_count, with_total
from hexcon.quads.gmsh_worker.plane_mesh import coons, harmonic
from hexcon.quads.gmsh_worker.recognise import candidates
from hexcon.quads.gmsh_worker.size_field import SizeField

pytestmark = pytest.mark.usefixtures("gmsh_running")
BRACKET = pathlib.Path(__file__).parents[2] / "resources" / "examples" / "bracket.step"


def polygon(corners, size, holes=()):
    """Outline of straight edges; corners counter-clockwise, holes clockwise."""
    loops = [np.asarray(c, float) for c in (corners, *holes)]
    sides = [np.roll(p, -1, axis=0) - p for p in loops]
    out = [np.arctan2(s[:, 1], s[:, 0]) for s in sides]
    turn = [(o - np.roll(o, 1) + np.pi) % (2 * np.pi) - np.pi for o in out]

    def place(shares):
        return [np.concatenate([a + part[:, None] * s for a, s, part in zip(p, side, parts)])
                for p, side, parts in zip(loops, sides, shares)]
    return Outline([np.linalg.norm(s, axis=1) / size for s in sides], [np.ones(len(s), int) for s in sides],
                   turn, out, place, place, size)


CASES = {
    "square": ([(0, 0), (6, 0), (6, 6), (0, 6)], (), "mapped", 36, 0.999),
    "kite": ([(0, 0), (6, 1), (7, 7), (1, 5)], (), "lattice", 36, 0.8),
    "L": ([(0, 0), (8, 0), (8, 3), (3, 3), (3, 9), (0, 9)], (), "mapped", 42, 0.999),
    "U": ([(0, 0), (9, 0), (9, 8), (7, 8), (7, 2), (2, 2), (2, 8), (0, 8)], (), "mapped", 42, 0.999),
    "frame": ([(0, 0), (8, 0), (8, 8), (0, 8)], [[(3, 3), (3, 6), (6, 6), (6, 3)]], "mapped", 55, 0.999),
    "triangle": ([(0, 0), (6, 0), (3, 5.2)], (), "midpoint", 27, 0.85),
    "cross with a slant": ([(0, 0), (9, 0), (11, 4), (6, 6), (5, 11), (0, 9), (3, 5)], (), None, None, 0.3),
}


@pytest.mark.parametrize("name", CASES)
def test_caps(name):
    corners, holes, road, quads, least = CASES[name]
    outline = polygon(corners, 1.0, holes)
    cap = mesh_cap(outline, Link(), name)
    low, mean = cap.quality()
    print(f"{name}: {cap.name}, {len(cap.quads)} quads, {low:.3f} to mean {mean:.3f}")
    assert low >= least
    assert road is None or (cap.name, len(cap.quads)) == (road, quads)
    boundary = np.concatenate(outline.place(cap.shares))
    assert np.array_equal(cap.points[:len(boundary)], boundary)
    assert _area(cap.points, cap.quads) == pytest.approx(sum(_loop_area(p) for p in (corners, *holes)))


@pytest.mark.parametrize("size", (4.0, 5.0, 7.0, 10.0, 14.0))
def test_the_bracket_is_even_and_good_at_every_size(size):
    """Three holes in an L with a fillet: o-grids in a lattice whose lines are dense beside holes and nowhere thin."""
    solid = cad.load(str(BRACKET))
    sweep, *planes = orient(solid, candidates(solid)[0])
    outline = outline_of(solid, sweep, *planes, SizeField(size))
    mesh = mesh_cap(outline, Link(), "cap")
    low, mean = mesh.quality()
    edges = np.linalg.norm(np.roll(mesh.points[mesh.quads], -1, axis=1) - mesh.points[mesh.quads], axis=2)
    print(f"{size}: {mesh.name}, {len(mesh.quads)} quads, {low:.3f} to mean {mean:.3f}", edges.min(), edges.max())
    assert mesh.name == "lattice, o-grid holes" and low > 0.8 and mean > 0.94
    assert (edges.max(axis=1) / edges.min(axis=1)).max() < 3.6
    assert edges.min() > 0.4 * min(size, 10 * np.pi / 12) and edges.max() < 1.7 * size
    assert len(mesh.quads) < 250


@pytest.mark.parametrize("size", (3.0, 4.0, 6.0))
def test_a_taper_keeps_the_size_at_its_wide_end(size):
    """Sides of 25 and 4: what both have is no compromise that leaves the wide one with one interval."""
    mesh = mesh_cap(polygon([(0, 0), (50, 10.5), (50, 14.5), (0, 25)], size), Link(), "cap")
    edges = np.linalg.norm(np.roll(mesh.points[mesh.quads], -1, axis=1) - mesh.points[mesh.quads], axis=2)
    assert edges.max() < 2.0 * size and mesh.quality()[0] > 0.8


@pytest.mark.parametrize("size", (10.0,))
def test_a_flange_is_a_lattice_round_its_centre(size):
    outline = round_outline([(0, 0, 50)], [(0, 0, 20)] + [(36 * np.cos(a), 36 * np.sin(a), 5)
                                                       for a in np.arange(6) * np.pi / 3 + 0.2], size)
    mesh = mesh_cap(outline, Link(), "flange")
    low, mean = mesh.quality()
    print(f"{mesh.name}, {len(mesh.quads)} quads, {low:.3f} to mean {mean:.3f}")
    assert mesh.name.startswith("lattice") and low > 0.65 and mean > 0.9


def round_outline(outer, holes, size):
    """Outline of circles (x, y, radius), each one edge from its point at angle 0."""
    circles = [(*c, sense) for cs, sense in ((outer, 1), (holes, -1)) for c in cs]

    def place(shares):
        return [np.stack([x + r * np.cos(2 * np.pi * s), y + g * r * np.sin(2 * np.pi * s)], -1)
                for (x, y, r, g), (s,) in zip(circles, shares)]
    return Outline([np.array([2 * np.pi * r / size]) for _, _, r, _ in circles], [np.array([12])] * len(circles),
                   [np.zeros(1)] * len(circles), [np.array([g * np.pi / 2]) for *_, g in circles], place, place, size)


def _area(points, quads):
    p = points[quads]
    a, b = p[:, 2] - p[:, 0], p[:, 3] - p[:, 1]
    return (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum() / 2


def _loop_area(p):
    p = np.asarray(p, float)
    q = np.roll(p, -1, axis=0)
    return (p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]).sum() / 2


def _grid(n):
    points = np.stack(np.meshgrid(np.arange(n + 1.0), np.arange(n + 1.0), indexing="ij"), -1).reshape(-1, 2)
    ids = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)
    quads = np.stack([ids[:-1, :-1], ids[1:, :-1], ids[1:, 1:], ids[:-1, 1:]], -1).reshape(-1, 4)
    return points, quads, (points.min(axis=1) == 0) | (points.max(axis=1) == n)


def test_smoothing_untangles():
    points, quads, fixed = _grid(12)
    shaken = points.copy()
    shaken[~fixed] += np.random.default_rng(1).uniform(-0.9, 0.9, (int((~fixed).sum()), 2))
    assert smooth.scaled_jacobian(shaken, quads).min() < 0
    after = smooth.optimise(shaken, quads, fixed)
    assert smooth.scaled_jacobian(after, quads).min() > 0.99
    assert np.array_equal(after[fixed], points[fixed])


def test_smoothing_never_spoils():
    """A star of four quads about a point that cannot become better stays."""
    points, quads, fixed = _grid(4)
    assert smooth.scaled_jacobian(smooth.optimise(points, quads, fixed), quads).min() >= 1.0 - 1e-12


@pytest.mark.parametrize("eps,square", ((0.0, 1), (0.1, 1), (0.1, 2)))
def test_gradient(eps, square):
    points, quads, fixed = _grid(5)
    points[~fixed] += np.random.default_rng(2).uniform(-0.2, 0.2, (16, 2))
    _, gradient = smooth._energy(points, quads, 3, 0.4, square, eps, 1.2)
    for vertex, axis in ((7, 0), (14, 1), (22, 0)):
        values = []
        for step in (1e-6, -1e-6):
            moved = points.copy()
            moved[vertex, axis] += step
            values.append(smooth._energy(moved, quads, 3, 0.4, square, eps, 1.2)[0])
        assert gradient[vertex, axis] == pytest.approx((values[0] - values[1]) / 2e-6, rel=1e-5)


def test_harmonic_is_exact_on_linear_data():
    points, quads, fixed = _grid(9)
    values = (points @ np.array([[2.0], [-3.0]]) + 1.0)
    start = np.where(fixed[:, None], values, 0.0)
    assert np.abs(harmonic(start, quads, fixed) - values).max() < 1e-7


def test_coons_of_a_cylinder_is_on_it():
    a = np.linspace(0, 1.2, 9)
    low = np.stack([np.cos(a), np.sin(a), 0 * a], -1)
    up = low + [0, 0, 2]
    z = np.linspace(0, 2, 6)[:, None]
    left, right = low[:1] + z * [0, 0, 1], low[-1:] + z * [0, 0, 1]
    grid = coons(low, right, up, left)
    assert np.abs(np.hypot(grid[..., 0], grid[..., 1]) - 1.0).max() < 1e-14


def test_counts():
    assert with_total([2.2, 3.9, 1.0], [1, 1, 1], 8).sum() == 8
    assert with_total([2.2, 3.9], [3, 4], 4) is None
    counts = balanced(np.array([4.6, 2.1, 3.2]), np.array([1, 1, 1]), np.array([True, False, False]),
                      np.array([False, True, True]))
    assert counts[0] == counts[1] + counts[2]
    assert least_count(2 * np.pi, True) == 12 and least_count(np.pi / 2, False) == 2 and least_count(0.0, False) == 1

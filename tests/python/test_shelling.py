# SPDX-License-Identifier: LGPL-2.1-or-later
"""Method shelling: a few rotated edges under the surface, and what is inside can be filled by sheets."""
import mesh_checker
import numpy as np
import pytest
from blossom_surfaces import blossom_surface
from cell_surfaces import sphere
from paper_surfaces import quadrilateral_octahedron
from polyhedra import random_polyhedron
from surfaces import box, permuted, turn_edge
from template_files import load_template

import hexcon_native as hn

CELL = 38    # hexes under a rotated edge


def certified(surface, **options):
    """The mesh, proved by the core and by the independent checker; its hexes are those that were counted."""
    mesh = hn.mesh(*surface, "shelling", pillow="never", **options)
    report = mesh.report
    assert mesh.method == "shelling" and mesh.certificate.certified and not mesh.topological
    assert mesh_checker.faults(mesh.points, mesh.hexes, surface[1], surface[0]) == []
    shell = report["shells"] * len(surface[1]) + report["rotations"] * (CELL - 2)
    assert len(mesh.hexes) > shell
    return mesh


def is_proper(quads):
    """Three quads or more at each point, and no two that have two opposite corners in common."""
    diagonals = np.sort(np.concatenate([quads[:, [0, 2]], quads[:, [1, 3]]]), axis=1)
    return np.bincount(quads.ravel()).min() >= 3 and len(np.unique(diagonals, axis=0)) == len(diagonals)


def rotated_ball(count, seed):
    """A cube's 3 x 3 quads on a sphere, with some edges rotated at random where that leaves the surface proper."""
    points, quads = sphere(3)
    rng = np.random.default_rng(seed)
    while count:
        quad = int(rng.integers(len(quads)))
        quads[quad] = np.roll(quads[quad], rng.integers(4))
        made = turn_edge((points, quads), quad)[1]
        if is_proper(made):
            quads, count = made, count - 1
    return relaxed(points, quads), quads


def relaxed(points, quads):
    """The points where each is in the middle of its neighbours, on the sphere."""
    starts, ends = quads.ravel(), np.roll(quads, -1, axis=1).ravel()
    for _ in range(60):
        sums = np.zeros_like(points)
        np.add.at(sums, starts, points[ends])
        points = sums / np.linalg.norm(sums, axis=1)[:, None]
    return points


def test_the_cell():
    """The template is certified, and both its ends are hexagons split in two, each another way."""
    cell = load_template("rotation_38")
    assert hn.certify(cell.points, cell.hexes, cell.quads).certified and len(cell.hexes) == CELL
    assert hn.quality(cell.points, cell.hexes).min > 0.33
    sides = [sorted(cell.labels[i] for i in q) for q in cell.quads]
    for end, split in (("T", (0, 3)), ("B", (1, 4))):
        halves = [[int(label[1]) for label in side] for side in sides if {label[0] for label in side} == {end}]
        assert len(halves) == 2 and set(halves[0]) & set(halves[1]) == set(split)
    assert len(sides) == 10


@pytest.mark.parametrize("seed", range(4))
def test_rotated_edges_are_rotated_back(seed):
    """With no more rotations than it took to spoil the surface."""
    surface = rotated_ball(2, seed)
    mesh = certified(permuted(surface, np.random.default_rng(seed)))
    assert mesh.report["rotations"] <= 3 and mesh.quality.min > 0.1
    assert len(mesh.hexes) <= 6 * len(surface[1])


@pytest.mark.parametrize("solid, count, hexes_a_quad", [("ball", 50, 6), ("box", 50, 6), ("cylinder", 50, 7)])
def test_surfaces_of_gmsh(solid, count, hexes_a_quad, tmp_path):
    surface = blossom_surface(solid, count, tmp_path)
    mesh = certified(surface)
    assert len(mesh.hexes) <= hexes_a_quad * len(surface[1]) and mesh.quality.min > 0.1


@pytest.mark.parametrize("quads", [12, 16, 20])
def test_random_polyhedra(quads):
    mesh = certified(random_polyhedron(np.random.default_rng(quads), quads, 2.0))
    assert mesh.report["hexes per quad"] < 14


def test_a_box_needs_no_shell():
    points, quads = box(2, 3, 4)
    mesh = hn.mesh(points, quads, "shelling", pillow="never")
    assert len(mesh.hexes) == 24 and mesh.report["rotations"] == mesh.report["shells"] == 0
    assert mesh.quality.min > 1 - 1e-9


def test_threads_do_not_matter():
    surface = rotated_ball(1, 7)
    one, two = (hn.mesh(*surface, "shelling", pillow="never", threads=threads) for threads in (1, 2))
    assert one.points.tobytes() == two.points.tobytes() and np.array_equal(one.hexes, two.hexes)


def test_refusals():
    with pytest.raises(hn.HexconError) as fault:   # no edge of an octahedron's eight quads can be rotated
        hn.mesh(*quadrilateral_octahedron(), "shelling", pillow="never")
    assert fault.value.code == hn.ErrorCode.NO_ROTATIONS
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(*rotated_ball(1, 1), "shelling", progress=lambda stage, fraction: stage != "rotating edges")
    assert fault.value.code == hn.ErrorCode.CANCELLED

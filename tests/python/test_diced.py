# SPDX-License-Identifier: LGPL-2.1-or-later
"""Subdivided surfaces, read from their quads alone and filled: certified by the core and by an independent judge."""
import mesh_checker
import numpy as np
import pytest
from blossom_surfaces import blossom_surface
from cell_surfaces import SKEW, cad_file, cut_about_middles, merged_hull, round_hull, sphere
from surfaces import box, diced, diced_hull, grid, prism, upright

import hexcon
import hexcon_native as hn
from hexcon.quads import surface_from_solid

Code = hn.ErrorCode
OCTAHEDRON = np.vstack([np.eye(3), -np.eye(3)])
# gmsh's code for bodies that no point sees whole.
U = """
low = occ.addBox(0, 0, 0, 3, 1, 1)
high = occ.addBox(0, 0, 0, 1, 1, 3)
far = occ.addBox(2, 0, 0, 1, 1, 3)
occ.fuse([(3, low)], [(3, high), (3, far)])
"""
TORUS = "occ.addTorus(0, 0, 0, 2, 0.8)"
TWO_HOLES = """
plate = occ.addBox(0, 0, 0, 4, 2, 0.8)
holes = [(3, occ.addCylinder(x, 1, -1, 0, 0, 3, 0.5)) for x in (1.1, 2.9)]
occ.cut([(3, plate)], holes)
"""


def shuffled(rng, surface):
    """Other numbers for points and quads, other first corners."""
    points, quads = surface
    order = rng.permutation(len(points))
    turned = np.array([np.roll(quad, rng.integers(4)) for quad in np.argsort(order)[quads]])
    return points[order], turned[rng.permutation(len(quads))]


def assert_sound(mesh, surface):
    points, quads = surface
    report = mesh.report
    assert mesh.method == "diced" and mesh.certificate.certified and not mesh.topological
    assert np.array_equal(mesh.quads, quads)
    assert mesh_checker.faults(mesh.points, mesh.hexes[:, :8], quads, points) == []
    assert 3 * report["coarse triangles"] + 4 * report["coarse quads"] == len(quads)
    pillowed = report["pillows"] * len(quads)
    assert len(mesh.hexes) == 4 * report["tetrahedra"] + 36 * report["pyramids"] + 26 * report["geodes"] + pillowed
    assert report["pyramids"] + report["geodes"] == report["coarse quads"]
    assert report["hexes per quad"] == pytest.approx(len(mesh.hexes) / len(quads))


def fault_of(surface, **options):
    with pytest.raises(hn.HexconError) as caught:
        hn.mesh(*surface, "diced", pillow="never", **options)
    return caught.value


def torus(around, along):
    i, j = (a.ravel() for a in np.mgrid[:around, :along])
    u, v = 2 * np.pi * i / around, 2 * np.pi * j / along
    points = np.column_stack([(3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)])
    after, above = (i + 1) % around, (j + 1) % along
    quads = [along * i + j, along * after + j, along * after + above, along * i + above]
    return points, np.column_stack(quads)


def cad_surface(body, size, method, folder):
    surface = surface_from_solid(cad_file(body, f"{folder}/body.brep"), size, method)
    return surface.points, surface.quads


# ------------------------------------------------------------------------------ triangles alone

def test_one_tetrahedron():
    surface = diced_hull(SKEW)
    mesh = hn.mesh(*surface, "diced", pillow="never")
    assert_sound(mesh, surface)
    assert len(mesh.hexes) == 4 and mesh.quality.min > 0.4


@pytest.mark.parametrize("seed", range(6))
def test_diced_hulls_in_any_numbering(seed):
    rng = np.random.default_rng([seed, 5])
    surface = shuffled(rng, round_hull(rng, int(rng.integers(5, 40))))
    mesh = hn.mesh(*surface, "diced", pillow="never")
    assert_sound(mesh, surface)
    assert mesh.report["coarse quads"] == 0
    assert len(mesh.hexes) == 4 * mesh.report["coarse triangles"]     # all to the centre
    assert mesh.quality.min >= min(0.15, 0.6 * mesh.report["surface bound"])


@pytest.mark.parametrize("seed", range(3))
def test_octahedra(seed):
    rng = np.random.default_rng([seed, 6])
    stretched = OCTAHEDRON @ (np.eye(3) + rng.uniform(-0.4, 0.4, (3, 3)))
    surface = shuffled(rng, diced_hull(stretched))
    mesh = hn.mesh(*surface, "diced", pillow="never")
    assert_sound(mesh, surface)
    assert len(mesh.hexes) == 32


def test_gmsh_tetrahedra_where_a_star_is_crowded():
    surface = round_hull(np.random.default_rng(3), 80)
    mesh = hexcon.mesh_surface(*surface, "diced", pillow="never")
    assert_sound(mesh, surface)
    assert len(mesh.hexes) == 4 * mesh.report["tetrahedra"] > 4 * mesh.report["coarse triangles"]
    assert any("tetrahedra: " in line for line in mesh.report["log"])


def test_corners_of_three_quads_are_centres_of_triangles():
    """A box of 2 * 2 * 2 quads is a diced octahedron as well: 32 hexes, not 6 pyramids."""
    surface = box(2, 2, 2)
    mesh = hn.mesh(*surface, "diced", pillow="never")
    assert_sound(mesh, surface)
    assert (mesh.report["coarse triangles"], mesh.report["coarse quads"]) == (8, 0)
    assert len(mesh.hexes) == 32 and mesh.quality.min > 0.5


# -------------------------------------------------------------------------------- with coarse quads

@pytest.mark.parametrize("surface", [box(4, 4, 2), sphere(4), merged_hull(np.random.default_rng(4), 20)],
                         ids=["box", "sphere", "merged hull"])
@pytest.mark.parametrize("mesher", [hn.mesh, hexcon.mesh_surface], ids=["star", "gmsh"])
def test_coarse_quads(surface, mesher):
    surface = shuffled(np.random.default_rng(8), surface)
    mesh = mesher(*surface, "diced")
    assert_sound(mesh, surface)
    assert mesh.report["coarse quads"] > 0
    assert (mesh.report["geodes"] > 0) == (mesh.report["coarse triangles"] == 0)
    assert mesh.quality.min >= 0.08


@pytest.mark.parametrize("method", ["subdivided", "subdivided-triangles"])
@pytest.mark.parametrize("name", ["ball", "hull_14"])
def test_gmsh_surfaces(name, method, tmp_path):
    surface = shuffled(np.random.default_rng(9), blossom_surface(name, 70, tmp_path, method))
    mesh = hexcon.mesh_surface(*surface, "diced", pillow="never")
    assert_sound(mesh, surface)
    assert mesh.report["hexes per quad"] < 30
    assert mesh.quality.min >= min(0.08, 0.5 * mesh.report["surface bound"])


# ------------------------------------------------------------------------ any shape, any genus

@pytest.mark.parametrize("body, genus, method, size", [
    (U, 0, "subdivided-triangles", 0.8), (TORUS, 1, "subdivided-triangles", 1.0),
    (TWO_HOLES, 2, "subdivided-triangles", 0.8)], ids=["U", "torus", "two holes"])
def test_bodies_that_no_point_sees_whole(body, genus, method, size, tmp_path):
    surface = cad_surface(body, size, method, tmp_path)
    facts = hn.check_surface(*surface)
    assert facts.star_center is None and facts.genus == genus
    mesh = hexcon.mesh_surface(*surface, "diced")
    assert_sound(mesh, surface)


def test_a_torus_of_quads():
    surface = torus(12, 8)
    mesh = hexcon.mesh_surface(*surface, "diced", pillow="never")
    assert_sound(mesh, surface)


def test_without_tetrahedra_a_star_is_needed():
    fault = fault_of(torus(16, 8))
    assert fault.code == Code.NOT_STAR_SHAPED and "no mesher" in str(fault)
    fault = fault_of(torus(16, 8), tetrahedralise=lambda points, triangles: None)
    assert fault.code == Code.NOT_STAR_SHAPED and "no tetrahedra were found" in str(fault)


# ------------------------------------------------------------------------------------ what is not

NOT_DICED = {"odd rows": box(3, 3, 2), "one cube": box(1, 1, 1), "torus of odd rows": torus(5, 6),
             "coarse edges with the same ends": torus(8, 4)}


@pytest.mark.parametrize("name", NOT_DICED)
def test_other_surfaces_are_refused(name):
    fault = fault_of(NOT_DICED[name])
    assert fault.code == Code.NOT_DICED and "subdivision" in str(fault)
    assert 0 < len(fault.elements) and set(fault.elements) <= set(range(len(NOT_DICED[name][1])))


def test_a_face_of_five_corners_is_refused_where_nothing_else_fits():
    """Its centre has five quads, its corners three and four."""
    rng = np.random.default_rng(11)
    apex, ring = 5, np.arange(5)
    angle = 2 * np.pi * ring / 5
    points = np.vstack([np.column_stack([np.cos(angle), np.sin(angle), 0 * angle]), [[0, 0, 1], [0.3, 0.1, 2]]])
    faces = [ring[::-1].tolist()] + [[k, (k + 1) % 5, apex] for k in range(5)]
    surface = shuffled(rng, cut_about_middles(points, faces))
    fault = fault_of(surface)
    assert fault.code in (Code.NOT_DICED, Code.ODD)


# ------------------------------------------------------------------------------------------ options

def test_auto_takes_it_after_swept():
    rng = np.random.default_rng(12)
    assert hn.mesh(*round_hull(rng, 12), pillow="never").method == "diced"
    assert hn.mesh(*box(2, 2, 2)).method == "swept"
    assert hn.mesh(*round_hull(rng, 12), layers=1).method == "cells"
    assert hn.mesh(*prism(grid(3, 1), np.arange(3.0), upright)).method == "swept"


def test_order_threads_and_inward_quads():
    points, quads = round_hull(np.random.default_rng(13), 12)
    one, two = (hn.mesh(points, quads, "diced", pillow="never", threads=threads) for threads in (1, 2))
    assert one.points.tobytes() == two.points.tobytes() and np.array_equal(one.hexes, two.hexes)
    assert hn.mesh(points, quads, "diced", pillow="never", order=2).hexes.shape == (len(one.hexes), 20)
    inward = hn.mesh(points, quads[:, ::-1], "diced", pillow="never")
    assert inward.report["turned outward"] == 1 and inward.certificate.certified
    with pytest.raises(hn.HexconError) as caught:
        hn.mesh(points, quads, "diced", pillow="never", layers=1)
    assert caught.value.code == Code.BAD_ARGUMENT


def test_the_log_tells_what_was_tried():
    lines = hn.mesh(*diced(OCTAHEDRON, [[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5],
                                        [4, 3, 5], [0, 4, 5]]), "diced").report["log"]
    assert any(line.startswith("8 coarse triangles and 0 quads, star: 32 hexes") for line in lines)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Method sheets: natural meshes by taking one dual loop after the other away."""
import mesh_checker
import numpy as np
import pytest
import sheet_surfaces
from cell_surfaces import sphere
from sheet_surfaces import boundary, midpoint_subdivision, quads_of, random_polytope, random_sheets
from surfaces import box, diced, grid, o_grid, permuted, picture, prism, upright

import hexcon_native as hn

SHAPES = [(1, 1, 1), (2, 1, 1), (1, 3, 1), (2, 2, 1), (2, 2, 2), (1, 1, 9), (5, 1, 3), (3, 4, 5), (7, 2, 9),
          (4, 4, 1), (6, 6, 6), (2, 11, 2), (8, 3, 3), (10, 10, 2), (1, 12, 12), (5, 7, 3), (9, 9, 4),
          (15, 2, 6), (3, 3, 14), (12, 11, 10)]


def certified(surface, hexes=None, small=400):
    """The mesh, proved by the core and, where it is small, by the independent checker."""
    mesh = hn.mesh(*surface, "sheets", pillow="never")
    assert mesh.method == "sheets" and mesh.certificate.certified and not mesh.topological
    assert hexes is None or len(mesh.hexes) == hexes
    if len(mesh.hexes) <= small:
        assert mesh_checker.faults(mesh.points, mesh.hexes, surface[1], surface[0]) == []
    return mesh


@pytest.mark.parametrize("shape", SHAPES)
def test_a_box_is_its_grid(shape):
    rng = np.random.default_rng(sum(shape))
    points, quads = box(*shape)
    mesh = certified(permuted((points, quads), rng), np.prod(shape))
    assert mesh.quality.min > 1 - 1e-9
    assert mesh.report["sheets"] == sum(shape) - 3 and mesh.report["core quads"] == 0
    graded = np.cumsum(rng.uniform(0.5, 2, 60))[points.astype(int) + [0, 13, 26]]
    assert certified(permuted((graded, quads), rng), np.prod(shape)).quality.min > 1 - 1e-9


def polygon_cap(sides):
    angle = 2 * np.pi * np.arange(sides) / sides
    points = np.vstack([np.column_stack([np.cos(angle), np.sin(angle)]), [0, 0]])
    middles = (points[:sides] + np.roll(points[:sides], -1, axis=0)) / 2
    quads = [[i, sides + 1 + i, sides, sides + 1 + (i - 1) % sides] for i in range(sides)]
    return np.vstack([points, middles]), np.array(quads)


def diced_fan(sides):
    points, _ = polygon_cap(sides)
    return diced(points[:sides + 1], [[i, (i + 1) % sides, sides] for i in range(sides)])


CAPS = {"triangle": polygon_cap(3), "pentagon": polygon_cap(5), "octagon": polygon_cap(8), "fan": diced_fan(5),
        "disc": o_grid(3, 2), "L": picture("##..", "##..", "####"), "U": picture("#..#", "#..#", "####"),
        "T": picture("#####", "..#..", "..#.."), "strip": grid(7, 1)}


@pytest.mark.parametrize("name", CAPS)
@pytest.mark.parametrize("rings", [1, 2, 5])
def test_a_prism_is_its_sweep(name, rings):
    """Also where the caps have closed loops inside, so that sheets end at two loops."""
    rng = np.random.default_rng(rings)
    cap = CAPS[name]
    surface = permuted(prism(cap, np.arange(rings + 1.0), upright), rng)
    mesh = certified(surface, len(cap[1]) * rings)
    swept = hn.mesh(*surface, "swept")
    assert len(swept.hexes) == len(mesh.hexes)
    assert mesh.quality.min > 0.9 * swept.quality.min


@pytest.mark.parametrize("name", ["tetrahedron", "wedge", "chamfered_box", "dodecahedron"])
@pytest.mark.parametrize("s", [1, 2, 3])
def test_a_polytope_is_cut_about_its_middle(name, s):
    polytope = getattr(sheet_surfaces, name)()
    surface = permuted(midpoint_subdivision(polytope, s), np.random.default_rng(s))
    mesh = certified(surface, len(polytope[0]) * s ** 3)
    assert mesh.quality.min >= 0.3


@pytest.mark.parametrize("faces", [5, 7, 9, 12, 16, 24, 40])
@pytest.mark.parametrize("s", [1, 2, 3])
def test_so_is_a_random_one(faces, s):
    """As many hexes; with many faces a corner in the middle may have no room for all of them."""
    polytope = random_polytope(np.random.default_rng(faces), faces)
    mesh = certified(permuted(midpoint_subdivision(polytope, s), np.random.default_rng(s)),
                     len(polytope[0]) * s ** 3)
    assert mesh.quality.min >= 0.5 * mesh.report["surface bound"]


@pytest.mark.parametrize("n", [2, 3, 4, 6])
def test_a_ball_is_no_worse_than_the_cube_in_it(n):
    mesh = certified(permuted(sphere(n), np.random.default_rng(n)))
    assert n ** 3 <= len(mesh.hexes) <= 2 * n ** 3


def test_grids_with_random_sheets_are_found_again():
    """From the surface alone; as few hexes, and certified wherever the mesh it came from can be."""
    certified_count = refused = 0
    for seed in range(60):
        rng = np.random.default_rng(seed)
        points, hexes = random_sheets(rng, int(rng.integers(1, 6)))
        surface = permuted(boundary(points, hexes), rng)
        if hn.check_surface(*surface).embedded is not True:  # sheets that fold the boundary's flat sides
            refused += 1
            continue
        mesh = hn.mesh(*surface, "sheets", pillow="never", allow_uncertified=True)
        proved = mesh.certificate
        assert proved.conforming and proved.proper and proved.boundary_exact
        assert len(mesh.hexes) <= 1.5 * len(hexes)
        certified_count += proved.certified
        if not proved.certified:
            fixed = np.isin(np.arange(len(points)), quads_of(hexes))
            assert hn.quality(hn.optimize(points, hexes, fixed), hexes).min <= 0.02
    assert certified_count >= 45 and refused <= 5


def test_the_result_does_not_depend_on_threads_and_chance():
    surface = midpoint_subdivision(random_polytope(np.random.default_rng(5), 24), 1)
    first, second = (hn.mesh(*surface, "sheets", pillow="never", threads=threads) for threads in (1, 2))
    assert first.points.tobytes() == second.points.tobytes()
    assert first.hexes.tobytes() == second.hexes.tobytes()


def test_order_and_progress():
    seen = []
    mesh = hn.mesh(*box(3, 3, 3), "sheets", order=2, progress=lambda stage, part: seen.append(part) or True)
    assert mesh.hexes.shape == (27, 20) and seen
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(*box(3, 3, 3), "sheets", pillow="never", progress=lambda stage, part: part < 0.5)
    assert fault.value.code == hn.ErrorCode.CANCELLED

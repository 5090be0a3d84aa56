# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which hexes of an overlay grid are taken: rays, fullness, manifolds of the solid's topology."""
import numpy as np
import pytest
from grid_bodies import ball, box, tensor_grid, together, torus, turned, volume
from mesh_checker import boundary_faults, conformity_faults

from hexcon.quads.gmsh_worker.grid.cells import cells
from hexcon.quads.gmsh_worker.grid.fullness import fullness
from hexcon.quads.gmsh_worker.grid.hex_neighbours import HexNeighbours
from hexcon.quads.gmsh_worker.grid.manifold_repair import bad_points, repaired
from hexcon.quads.gmsh_worker.grid.solid_rays import SolidRays

BODIES = {"box": box((-1, -0.8, -0.6), (0.9, 0.7, 1)), "ball": ball((0.03, 0.01, 0.02), 1.0), "torus": torus(1, 0.4),
          "hollow": together(ball((0, 0, 0), 1.0), ball((0.1, 0, 0), 0.5))}


def even(count, low=-1.6, high=1.6):
    return [np.linspace(low, high, count + 1)] * 3


def manifold_faults(hexes, inside, neighbours):
    """What the independent checker says of the taken hexes and their quads."""
    ids, taken = np.unique(hexes[inside], return_inverse=True)
    back = np.full(hexes.max() + 1, -1)
    back[ids] = np.arange(len(ids))
    quads = back[neighbours.sides[neighbours.boundary(inside)]]
    taken = taken.reshape(-1, 8)
    return conformity_faults(taken) + boundary_faults(taken, quads)


@pytest.mark.parametrize("xy", [(0.31, 0.22), (0.5, 0.5), (0, 0.4), (0, 0), (1, 1)])
def test_rays_through_a_box(xy):
    """Also along its walls, edges and diagonals: all or nothing, never a part."""
    rays = SolidRays(*box((0, 0, 0), (1, 1, 2)))
    length = rays.lengths(np.array([xy] * 3), np.array([-1, 0.5, 3]), np.array([5, 0.75, 4]))
    assert length.tolist() in ([2, 0.25, 0], [0, 0, 0])
    if 0 < min(xy) and max(xy) < 1:
        assert length[0] == 2


def test_rays_beside_and_without_a_body():
    rays = SolidRays(*box((0, 0, 0), (1, 1, 1)))
    assert rays.lengths([[5, 5]], np.array([-9.0]), np.array([9.0])) == [0]
    assert rays.lengths(np.zeros((0, 2)), np.zeros(0), np.zeros(0)).shape == (0,)
    none = SolidRays(np.zeros((0, 3)), np.zeros((0, 3), int))
    assert none.lengths([[0, 0]], np.array([-9.0]), np.array([9.0])) == [0]


@pytest.mark.parametrize("seed", range(4))
def test_a_hole_in_the_triangles_makes_no_endless_ray(seed):
    points, triangles = BODIES["ball"]
    rng = np.random.default_rng(seed)
    rays = SolidRays(points, triangles[rng.random(len(triangles)) < 0.95])
    length = rays.lengths(rng.uniform(-1, 1, (500, 2)), np.full(500, -3.0), np.full(500, 3.0))
    assert 0 <= length.min() and length.max() <= 2.0001


def by_solid_angle(points, triangles, at):
    """Whether a point is inside, by the solid angles of the triangles (Van Oosterom and Strackee, 1983)."""
    a, b, c = (points[triangles[:, k]] - at for k in range(3))
    x, y, z = (np.linalg.norm(v, axis=1) for v in (a, b, c))
    top = (a * np.cross(b, c)).sum(axis=1)
    below = x * y * z + (a * b).sum(axis=1) * z + (b * c).sum(axis=1) * x + (c * a).sum(axis=1) * y
    return abs(np.arctan2(top, below).sum()) > np.pi


@pytest.mark.parametrize("name", BODIES)
def test_rays_know_inside_as_solid_angles_do(name):
    points, triangles = BODIES[name]
    points = turned(points, 3)
    at = np.random.default_rng(1).uniform(-1.5, 1.5, (200, 3))
    length = SolidRays(points, triangles).lengths(at[:, :2], at[:, 2] - 1e-9, at[:, 2] + 1e-9)
    assert (length > 1e-9).tolist() == [by_solid_angle(points, triangles, p) for p in at]


@pytest.mark.parametrize("name", BODIES)
def test_fullness_adds_up_to_the_volume(name):
    points, triangles = BODIES[name]
    points = turned(points, 5)
    grid, hexes = tensor_grid(*even(24, -1.7, 1.7))
    full = fullness(grid, hexes, SolidRays(points, triangles))
    assert full.min() >= 0 and full.max() <= 1
    assert full.sum() * (3.4 / 24) ** 3 == pytest.approx(abs(volume(points, triangles)), rel=0.01)


def test_fullness_of_leaning_hexes():
    """A grid whose hexes all lean, any of whose axes is the steep one."""
    grid, hexes = tensor_grid(*even(16, -1.6, 1.6))
    lean = np.array([[1, 0.2, 0.1], [-0.3, 1, 0.2], [0.1, 0.25, 1]])
    rays = SolidRays(*BODIES["ball"])
    for turn in ([0, 1, 2], [1, 2, 0], [2, 0, 1]):
        m = lean[turn]
        full = fullness(1.2 * grid @ m.T, hexes, rays)
        assert full.sum() * abs(np.linalg.det(1.2 * m)) * 0.2 ** 3 == pytest.approx(volume(*BODIES["ball"]), rel=0.02)


@pytest.mark.parametrize("name,wanted", [("box", (1, 2)), ("ball", (1, 2)), ("torus", (1, 0)), ("hollow", (2, 4))])
@pytest.mark.parametrize("seed", range(3))
def test_topology_is_the_bodys(name, wanted, seed):
    points, triangles = BODIES[name]
    grid, hexes = tensor_grid(*even(17 + seed))
    mesh = HexNeighbours(hexes)
    full = fullness(grid, hexes, SolidRays(turned(points, seed), triangles))
    found = list(cells(mesh, full, shells=wanted[0]))
    assert found and wanted == (found[0].shells, found[0].euler)
    for one in found:
        assert manifold_faults(hexes, one.inside, mesh) == []


@pytest.mark.parametrize("low", [0.02, 0.24, 0.27, 0.5])
def test_a_thin_wall_stays_closed(low):
    """A box with walls of 0.3 cells, wherever they lie between the planes."""
    wall = 0.3
    outer = box((low,) * 3, (8 - low,) * 3)
    inner = box((low + wall,) * 3, (8 - low - wall,) * 3)
    grid, hexes = tensor_grid(*[np.arange(-1.0, 10)] * 3)
    mesh = HexNeighbours(hexes)
    full = fullness(grid, hexes, SolidRays(*together(outer, inner)))
    found = [c for c in cells(mesh, full, shells=2) if c.walls]
    assert found and (found[0].shells, found[0].euler) == (2, 4)
    assert 100 < found[0].inside.sum() < 8 ** 3 - 5 ** 3


def test_specks_go_and_pits_are_filled():
    hexes = tensor_grid(*[np.arange(9.0)] * 3)[1]
    mesh = HexNeighbours(hexes)
    full = np.zeros((8, 8, 8))
    full[2:6, 2:6, 2:6] = 1
    full[3, 3, 5] = 0.4              # a pit
    full[6, 4, 4] = 0.6              # a speck
    full[1, 1, 6] = 0.9              # far away
    inside = next(cells(mesh, full.ravel())).inside.reshape(full.shape)
    assert inside[2:6, 2:6, 2:6].all() and inside.sum() == 64


def test_cavities_are_kept_as_many_as_there_are():
    hexes = tensor_grid(*[np.arange(13.0)] * 3)[1]
    mesh = HexNeighbours(hexes)
    full = np.zeros((12, 12, 12))
    full[1:11, 1:11, 1:11] = 1
    full[2:4, 2:4, 2:4] = 0
    full[6:9, 6:9, 6:9] = 0
    for shells, count in ((1, 1000), (2, 973), (3, 965), (4, 965)):
        one = next(cells(mesh, full.ravel(), shells))
        assert (one.inside.sum(), one.shells) == (count, min(shells, 3))


def test_two_hexes_on_an_edge_are_mended_the_cheap_way():
    hexes = tensor_grid(*[np.arange(6.0)] * 3)[1]
    mesh = HexNeighbours(hexes)
    full = np.zeros((5, 5, 5))
    full[1:4, 1:3, 1:3] = 1
    full[1:4, 3, 3] = 1
    full[1:4, 2, 3] = 0.45
    inside = full.ravel() > 0.5
    assert len(bad_points(mesh, inside)) == 4
    assert (repaired(mesh, inside, full.ravel()).reshape(full.shape) == (full > 0.4)).all()


@pytest.mark.parametrize("seed", range(6))
def test_any_set_is_mended_or_given_up(seed):
    """Cells at random, dense or sparse: what is returned is a manifold."""
    rng = np.random.default_rng(seed)
    hexes = tensor_grid(*[np.arange(10.0)] * 3)[1]
    mesh = HexNeighbours(hexes)
    full = rng.random(len(hexes)) * (0.6 + 0.1 * seed)
    inside = (full > 0.5) & ~mesh.on_border[hexes].any(axis=1)
    found = repaired(mesh, inside, full)
    assert found is None or (not len(bad_points(mesh, found)) and manifold_faults(hexes, found, mesh) == [])
    one = next(cells(mesh, full), None)
    assert one is None or manifold_faults(hexes, one.inside, mesh) == []


def test_nothing_inside():
    mesh = HexNeighbours(tensor_grid(*[np.arange(5.0)] * 3)[1])
    assert list(cells(mesh, np.zeros(64))) == []

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sheets put into captured meshes: what stays, what goes along, what is refused."""
import numpy as np
import pytest
from grid_voxels import VoxelModel, captured_faults, euler_of_hexes, hexes_of, random_cubes

from hexcon.quads.gmsh_worker.grid.capture import capture
from hexcon.quads.gmsh_worker.grid.captured import NotCaptured
from hexcon.quads.gmsh_worker.grid.chords import chords
from hexcon.quads.gmsh_worker.grid.sheet_plan import Groups, demands, sheeted
from hexcon.quads.gmsh_worker.grid.sheets import Pinched, insert, round_patch, under_patches
from hexcon.quads.gmsh_worker.grid.skin import Skin

CUBE = {(0, 0, 0)}
ELL = {(0, 0, 0), (1, 0, 0), (0, 1, 0)}
FRAME = {(i, j, 0) for i in range(3) for j in range(3)} - {(1, 1, 0)}


def made(cubes, parts):
    model = VoxelModel(cubes)
    return model, capture(model, *hexes_of(cubes, parts))


def top_of(model, mesh):
    """The patch of a body's top."""
    high = mesh.points[:, 2].max()
    return int(mesh.patch[np.isclose(mesh.points[mesh.quads][:, :, 2], high).all(axis=1)][0])


def test_under_one_patch_of_a_cube():
    """Four hexes, four strips of two quads on the sides; the top's points and quads stay."""
    model, mesh = made(CUBE, 2)
    top = top_of(model, mesh)
    new = under_patches(mesh, [top])
    assert (len(new.hexes), len(new.quads)) == (8 + 4, 24 + 8) and captured_faults(new, model) == []
    assert np.array_equal(new.points[:len(mesh.points)], mesh.points)
    assert np.array_equal(new.quads[:24][mesh.patch == top], mesh.quads[mesh.patch == top])
    assert sorted(np.bincount(new.patch)) == [4, 4, 6, 6, 6, 6]


def test_under_all_of_a_cube_the_surface_stays():
    model, mesh = made(CUBE, 2)
    new = under_patches(mesh, range(6))
    assert (len(new.hexes), len(new.quads)) == (8 + 24, 24) and captured_faults(new, model) == []
    assert np.array_equal(new.quads, mesh.quads) and np.array_equal(new.corner_vertex, mesh.corner_vertex)


def test_round_one_patch_of_a_cube():
    """The sheet behind the top's layer comes out once round the sides."""
    model, mesh = made(CUBE, 2)
    new = round_patch(mesh, top_of(model, mesh))
    assert (len(new.hexes), len(new.quads)) == (8 + 4, 24 + 8) and captured_faults(new, model) == []
    assert np.bincount(new.curve).tolist() == [3 if np.ptp(c.samples[:, 2]) else 2 for c in model.curves]


def test_one_hex_of_a_cube_that_touches_three_patches():
    model, mesh = made(CUBE, 2)
    pulled = np.arange(8) == mesh.under[0]
    new = insert(mesh, pulled, np.zeros(24, bool))
    assert (len(new.hexes), len(new.quads)) == (8 + 3, 24 + 6) and captured_faults(new, model) == []


def test_a_covered_quad_must_be_pulled():
    _, mesh = made(CUBE, 1)
    with pytest.raises(ValueError, match="not pulled"):
        insert(mesh, np.zeros(1, bool), np.ones(6, bool))


def test_two_hexes_that_touch_in_an_edge_or_a_point_are_refused():
    _, mesh = made(CUBE, 2)
    middle = mesh.points[mesh.hexes].mean(axis=1)
    for apart in (2, 3):
        other = np.flatnonzero((~np.isclose(middle, middle[0])).sum(axis=1) == apart)[0]
        pulled = np.isin(np.arange(8), [0, other])
        with pytest.raises(Pinched) as fault:
            insert(mesh, pulled, np.zeros(24, bool))
        assert fault.value.place.shape == (3,)


def test_under_any_two_faces_of_a_cube():
    model, mesh = made(CUBE, 2)
    for pair in ((a, b) for a in range(6) for b in range(a)):
        assert captured_faults(under_patches(mesh, pair), model) == []


def test_random_sheets_keep_mesh_and_features():
    """Any X and Q: either the mesh is what it was, with a sheet more, or it is refused."""
    rng = np.random.default_rng(11)
    put = 0
    for _ in range(12):
        model, mesh = made(random_cubes(rng), 2)
        euler = euler_of_hexes(mesh.hexes)
        for _ in range(6):
            centre = mesh.points[mesh.hexes[rng.integers(len(mesh.hexes))]].mean(axis=0)
            pulled = np.linalg.norm(mesh.points[mesh.hexes].mean(axis=1) - centre, axis=1) < rng.uniform(0.2, 2.5)
            covered = pulled[mesh.under] & np.isin(mesh.patch, rng.integers(len(model.patches), size=rng.integers(4)))
            try:
                new = insert(mesh, pulled, covered)
            except Pinched:
                continue
            assert captured_faults(new, model) == [] and euler_of_hexes(new.hexes) == euler
            mesh = new
            put += 1
            if len(mesh.hexes) > 1500:
                break
    assert put > 30


def test_bodies_of_cubes_need_no_sheet():
    """Planes on planes of the grid: what is right is left alone."""
    for cubes in (CUBE, ELL, FRAME):
        model, mesh = made(cubes, 2)
        assert not demands(mesh, Groups(model)).why
        assert sheeted(mesh, model)[0] is mesh


@pytest.mark.parametrize("inside", [True, False])
def test_planned_sheets_satisfy_what_asked_for_them(inside):
    """Random bodies on hexes that lack one at an edge, so that their surface has a step that no curve wants."""
    rng, planned = np.random.default_rng(3), 0
    for _ in range(10):
        cubes = random_cubes(rng)
        model = VoxelModel(cubes)
        points, hexes = hexes_of(cubes, 3)
        try:
            mesh = capture(model, points, _notched(points, hexes, rng))
        except NotCaptured:
            continue
        new, count = sheeted(mesh, model, inside=inside)
        assert captured_faults(new, model) == []
        left = demands(new, Groups(model, inside=inside)).why
        assert not left["two quads of a hex on one patch"] and not left["one hex at a concave curve"]
        planned += count["groups"] > 0
    assert planned > 5


def _notched(points, hexes, rng):
    """Without one hex that has two quads."""
    skin = Skin(points, hexes)
    return np.delete(hexes, rng.choice(np.flatnonzero(np.bincount(skin.under, minlength=len(hexes)) == 2)), axis=0)


def test_no_chords_are_left():
    """In a notch's corner three quads of one patch meet, and a face inside has two of their edges."""
    rng, found = np.random.default_rng(4), 0
    for _ in range(12):
        model = VoxelModel(cubes := random_cubes(rng))
        points, hexes = hexes_of(cubes, 3)
        try:
            mesh = capture(model, points, _notched(points, hexes, rng))
        except NotCaptured:
            continue
        told = {tuple(one) for one in np.column_stack(chords(mesh)).tolist()}
        assert told == _chords_by_hand(mesh)
        found += len(told)
        new, angles = sheeted(mesh, model)[0], Groups(model).corner_angle
        for _, v, p in np.column_stack(chords(new)).tolist():      # none, but along the floor's plane under a step
            assert angles[int(new.corner_of_vertex[v]), p] > 269.0
    assert found


def _chords_by_hand(mesh):
    """{(hex, vertex, patch)}: of corners of hexes with two edges on one patch that are no quad's corner."""
    sides, corners, out = {}, set(), set()
    for quad, p in zip(mesh.quads.tolist(), mesh.patch.tolist()):
        for k in range(4):
            sides.setdefault(frozenset((quad[k], quad[k - 1])), set()).add(p)
            corners.add((quad[k], frozenset((quad[k - 1], quad[k - 3]))))
    for row, h in enumerate(mesh.hexes.tolist()):
        for a, b, c in ((0, 1, 3), (0, 1, 4), (0, 3, 4), (1, 0, 2), (1, 0, 5), (1, 2, 5), (2, 1, 3), (2, 1, 6),
                        (2, 3, 6), (3, 0, 2), (3, 0, 7), (3, 2, 7), (4, 5, 7), (4, 0, 5), (4, 0, 7), (5, 4, 6),
                        (5, 1, 4), (5, 1, 6), (6, 5, 7), (6, 2, 5), (6, 2, 7), (7, 4, 6), (7, 3, 4), (7, 3, 6)):
            common = sides.get(frozenset((h[a], h[b])), set()) & sides.get(frozenset((h[a], h[c])), set())
            if common and (h[a], frozenset((h[b], h[c]))) not in corners:
                out |= {(row, h[a], p) for p in common}
    return out

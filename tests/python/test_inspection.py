# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opening hex meshes: neighbours, layers, cuts, what is drawn, and the worst. Checked against plain loops."""
import pathlib
import sys
from types import SimpleNamespace

import numpy as np
import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from hex_grids import block, cylinder, distorted  # noqa: E402

import hexcon  # noqa: E402
import hexcon_native as hn  # noqa: E402
from hexcon.errors import FaultCode, ToolError  # noqa: E402
from hexcon.femmesh.hexahedron import FACES  # noqa: E402
from hexcon.inspection.cutting import behind_plane, centres_of  # noqa: E402
from hexcon.inspection.faces import bare_faces, edges_of_quads, neighbours  # noqa: E402
from hexcon.inspection.figures import spread, worst  # noqa: E402
from hexcon.inspection.opening import InspectedMesh, Opening  # noqa: E402
from hexcon.inspection.peeling import layers  # noqa: E402
from hexcon.inspection.tessellation import edges_in_pieces, tessellated  # noqa: E402
from hexcon.judging import words  # noqa: E402
from hexcon.pictures.palette import INVERTED, QUALITY, quality_colours  # noqa: E402

AXES = {"x": 0, "y": 1, "z": 2}


@pytest.fixture(scope="module")
def meshes():
    """Regular and not, plain and with two faces in common between two hexes."""
    surface = hexcon.example("schneiders")
    return {"block": block(5, 4, 3, (5.0, 4.0, 3.0)), "cylinder": cylinder(6, 5, 3.0, 7.0), "one": block(1, 1, 1),
            "pyramid": hn.mesh(surface.points, surface.quads, "pyramid", certify=False)}


def faces_of(hexes):
    """{corners: [(hex, side)]} by a plain loop."""
    found = {}
    for h, corners in enumerate(hexes[:, FACES].tolist()):
        for side, face in enumerate(corners):
            found.setdefault(frozenset(face), []).append((h, side))
    return found


@pytest.mark.parametrize("name", ["block", "cylinder", "one", "pyramid"])
def test_neighbours(meshes, name):
    mesh = meshes[name]
    across = neighbours(mesh.hexes, len(mesh.points))
    for owners in faces_of(mesh.hexes).values():
        assert len(owners) < 3
        for here, (h, side) in enumerate(owners):
            assert across[h, side] == (owners[1 - here][0] if len(owners) == 2 else -1)


def test_no_neighbour_across_a_face_of_three_hexes():
    mesh = block(2, 1, 1)
    hexes = np.vstack([mesh.hexes, mesh.hexes[1:]])
    across = neighbours(hexes, len(mesh.points))
    assert (across[0] == -1).all() and (across[1] >= 0).sum() == 5
    assert neighbours(np.zeros((0, 8), int), 0).shape == (0, 6)


@pytest.mark.parametrize("name", ["block", "cylinder", "pyramid"])
@pytest.mark.parametrize("seed", range(5))
def test_bare_faces_bound_what_is_kept(meshes, name, seed):
    mesh = meshes[name]
    keep = np.random.default_rng(seed).random(len(mesh.hexes)) < (0.05, 0.3, 0.5, 0.9, 1.0)[seed]
    hexes, sides = bare_faces(neighbours(mesh.hexes, len(mesh.points)), keep)
    expected = {owners[0] for owners in faces_of(mesh.hexes).values()
                if sum(keep[h] for h, _ in owners) == 1 for owners in [[o for o in owners if keep[o[0]]]]}
    assert set(zip(hexes.tolist(), sides.tolist())) == expected and len(hexes) == len(expected)


def test_nothing_kept_has_no_faces(meshes):
    mesh = meshes["block"]
    across = neighbours(mesh.hexes, len(mesh.points))
    assert len(bare_faces(across, np.zeros(len(mesh.hexes), bool))[0]) == 0


def test_edges_each_once(meshes):
    quads = meshes["block"].quads
    edges = edges_of_quads(quads, len(meshes["block"].points))
    assert len(edges) == 2 * len(quads)  # closed: each edge in two quads
    assert {frozenset(e) for e in edges.tolist()} == {frozenset((q[k], q[k - 1])) for q in quads.tolist()
                                                       for k in range(4)}


def test_layers_of_a_block_are_its_shells():
    mesh = block(7, 6, 5)
    i = np.arange(len(mesh.hexes))
    a, b, c = i % 7, i // 7 % 6, i // 42
    shell = 1 + np.min([a, 6 - a, b, 5 - b, c, 4 - c], axis=0)
    found = layers(mesh.hexes, neighbours(mesh.hexes, len(mesh.points)), len(mesh.points))
    assert np.array_equal(found, shell)


@pytest.mark.parametrize("name", ["cylinder", "pyramid"])
def test_layers_touch_the_one_before(meshes, name):
    mesh = meshes[name]
    found = layers(mesh.hexes, neighbours(mesh.hexes, len(mesh.points)), len(mesh.points))
    on_boundary = np.unique([list(face) for face, owners in faces_of(mesh.hexes).items() if len(owners) == 1])
    for number in range(1, found.max() + 1):
        outer = on_boundary if number == 1 else mesh.hexes[found == number - 1]
        touches = np.isin(mesh.hexes, outer).any(axis=1)
        assert touches[found == number].all() and not touches[found > number].any()
    assert found.min() == 1


@pytest.mark.parametrize("axis", AXES)
@pytest.mark.parametrize("flip", [False, True])
def test_a_cut_keeps_whole_hexes(axis, flip):
    mesh = InspectedMesh(block(4, 4, 4, (4.0, 4.0, 4.0)))
    assert mesh.reach(axis) == (0.5, 3.5)
    for offset, kept in ((0.4, 0), (0.5, 16), (1.7, 32), (3.5, 64), (9.0, 64)):
        opening = Opening(axis, offset, flip)
        keep = opening.keep(mesh)
        along = mesh.centres[:, AXES[axis]]
        assert np.array_equal(keep, along >= offset if flip else along <= offset)
        assert flip or keep.sum() == kept
        points, quads, hexes = opening.drawn(mesh, keep)
        assert points is mesh.points and keep[hexes].all()


def test_the_middle_is_where_no_offset_is_given():
    mesh = InspectedMesh(block(4, 4, 4))
    assert Opening("y").keep(mesh).sum() == 32
    assert Opening((1, 1, 0)).keep(mesh).sum() == 40  # hexes on the plane stay
    assert Opening((1, 1, 0), flip=True).keep(mesh).sum() == 40


def test_cut_and_peel_together():
    mesh = InspectedMesh(block(6, 6, 6))
    assert mesh.thickness == 3
    assert [Opening(peel=k).keep(mesh).sum() for k in range(4)] == [216, 64, 8, 0]
    assert Opening("z", peel=1).keep(mesh).sum() == 32


def test_hexes_that_stand_apart():
    mesh = InspectedMesh(block(5, 5, 5, (5.0, 5.0, 5.0)))
    keep = np.ones(125, bool)
    points, quads, hexes = Opening(shrink=0.2).drawn(mesh, keep)
    assert len(quads) == 6 * 124  # the shell and its neighbours: all but the one in the middle
    edges = np.linalg.norm(points[quads] - points[np.roll(quads, 1, axis=1)], axis=2)
    assert np.allclose(edges, 0.8)
    assert np.allclose(centres_of(points, quads.reshape(-1, 24))[:, :3], mesh.centres[hexes[::6]])
    assert np.array_equal(mesh.points, InspectedMesh(block(5, 5, 5, (5.0, 5.0, 5.0))).points)


@pytest.mark.parametrize("wrong", [{"axis": "w"}, {"axis": (0, 0, 0)}, {"axis": (1, 2)}, {"axis": 3},
                                   {"axis": ("a", 0, 0)}, {"offset": float("nan")}, {"peel": -1}, {"shrink": 1.0},
                                   {"shrink": -0.1}])
def test_wrong_openings(wrong):
    with pytest.raises(ToolError) as fault:
        Opening(**wrong)
    assert fault.value.code is FaultCode.BAD_OPTION


def test_numbers_of_elements():
    mesh = block(2, 2, 2)
    mesh.hex_ids = np.arange(101, 109)
    found = InspectedMesh(mesh)
    assert found.row_of(103) == 2
    with pytest.raises(ToolError, match="no hex number 3"):
        found.row_of(3)


def test_second_order_hexes_by_their_corners():
    mesh = block(2, 2, 2)
    points, hexes = hn.raise_order(mesh.points, mesh.hexes)
    found = InspectedMesh(SimpleNamespace(points=points, hexes=hexes))
    assert found.hexes.shape == (8, 8) and np.allclose(found.scaled_jacobian, 1.0) and found.curved == 0


def test_curved_hexes_are_judged_as_they_are():
    """One figure everywhere: that of a check of the same mesh, not that of the straight hex between the corners."""
    mesh = block(2, 1, 1)
    points, hexes = hn.raise_order(mesh.points, mesh.hexes)
    points[hexes[0, 8]] += (0.0, 0.0, 0.1)
    found, checked = InspectedMesh(SimpleNamespace(points=points, hexes=hexes)), hn.quality(points, hexes)
    assert np.array_equal(found.scaled_jacobian, checked.scaled_jacobian) and checked.min < 0.9 and found.curved == 1
    told = dict(words.of_opening(found, np.ones(2, bool), 10))
    assert f"{checked.min:.3f}" in told["Scaled Jacobian"] and "1 hexes have curved" in told["Note"]


def test_curved_faces_are_drawn_in_pieces_along_their_edges():
    """The bent edge's pieces lie on its parabola; straight faces stay whole; hexes that stand apart are bent, too."""
    mesh = block(2, 1, 1)
    points, hexes = hn.raise_order(mesh.points, mesh.hexes)
    points[hexes[0, 8]] += (0.0, 0.0, 0.125)
    found = InspectedMesh(SimpleNamespace(points=points, hexes=hexes))
    for shrink, whole in ((0.0, 8), (0.5, 10)):
        drawn, faces, rows = Opening(shrink=shrink).drawn(found, np.ones(2, bool))
        places, quads, face_of_quad, edges = tessellated(drawn, faces)
        assert len(quads) == whole + 2 * 16 and len(edges) >= 2 * 16
        assert set(np.unique(rows[face_of_quad])) == {0, 1}
        ends = drawn[faces[face_of_quad[-1]]]
        low, high = ends.min(axis=0), ends.max(axis=0)
        assert (places[quads[-1]] > low - 1e-12).all() and (places[quads[-1]] < high + 1e-12).all()
    outline, lines = edges_in_pieces(points[hexes[0]])
    first = outline[:5]
    assert np.allclose(first[:, 2], points[hexes[0, 0], 2] + 0.125 * np.array([0, 0.75, 1, 0.75, 0]))
    assert len(lines) == 48


@pytest.mark.parametrize("count", [0, 1, 7, 125, 1000])
def test_the_worst(count):
    values = InspectedMesh(distorted(block(5, 5, 5), 0.08)).scaled_jacobian
    rows = worst(values, count)
    assert np.array_equal(rows, np.argsort(values, kind="stable")[:count])
    assert np.array_equal(worst(np.ones(9), 3), [0, 1, 2])


@pytest.mark.parametrize("low", [0.0, 0.3, -0.001, -0.39, -0.4, -1.0])
def test_spread(low):
    values = np.append(np.linspace(low, 1.0, 50), [low, 1.0])
    counts, limits = spread(values, 25)
    assert counts.sum() == 52 and np.allclose(np.diff(limits), 0.04) and limits[-1] == 1.0
    assert 0.0 in limits and limits[0] <= min(low, 0.0) + 1e-9
    assert limits[0] == 0.0 or counts[0] > 0


def test_colours_of_quality():
    assert np.allclose(quality_colours([0.0, 1.0, -0.001, -1.0]), [QUALITY[0], QUALITY[-1], *[INVERTED[0]] * 2])


def test_behind_plane_takes_what_lies_on_it():
    centres = np.array([(0.0, 0, 0), (0.1 + 0.2, 0, 0), (0.31, 0, 0)])
    assert behind_plane(centres, (0.3, 0, 0), (1, 0, 0)).tolist() == [True, True, False]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Order 2 on solids: the boundary's middle nodes lie on the CAD, and what would fold keeps part of its curvature."""
import os
from dataclasses import replace

import curved_solids
import numpy as np
import pytest
from mesh_checker import boundary_faults

import hexcon
import hexcon_native as hn
from hexcon.calculix.deck import static_deck
from hexcon.curving.raising import raised
from hexcon.femmesh.second_order import RAISED
from hexcon.judging.curved import of_curving
from hexcon.meshing import Strategy
from hexcon.quads import surface_from_solid
from hexcon.quads.fit import Fit, notes_of_curved

EDGES = np.array([(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)])


@pytest.fixture(scope="module")
def solids(tmp_path_factory):
    folder = tmp_path_factory.mktemp("solids")
    return {name: curved_solids.write(name, folder / f"{name}.brep") for name in curved_solids.SOLIDS}


def boundary_middles(mesh):
    """Middle nodes of the boundary's edges."""
    ring = np.sort(np.stack([mesh.quads, np.roll(mesh.quads, -1, axis=1)], -1).reshape(-1, 2), axis=1)
    ends = np.sort(mesh.hexes[:, EDGES].reshape(-1, 2), axis=1)
    wanted = {tuple(row) for row in ring.tolist()}
    return np.unique([m for m, row in zip(mesh.hexes[:, 8:].reshape(-1), ends.tolist()) if tuple(row) in wanted])


def volume(points, hexes):
    """By Gauss points of the 20-node hexes."""
    from curved_judge import _SHAPES as shapes
    places, weights = np.polynomial.legendre.leggauss(4)
    places, weights = (places + 1) / 2, weights / 2
    total, powers = 0.0, np.arange(3)
    for r, wr in zip(places, weights):
        for s, ws in zip(places, weights):
            for t, wt in zip(places, weights):
                value = [x ** powers for x in (r, s, t)]
                slope = [powers * x ** np.maximum(powers - 1, 0) for x in (r, s, t)]
                rows = [np.einsum("nijk,i,j,k->n", shapes, *(slope[m] if m == axis else value[m] for m in range(3)))
                        for axis in range(3)]
                jacobian = np.einsum("an,hnc->hac", np.array(rows), points[hexes])
                total += wr * ws * wt * np.linalg.det(jacobian).sum()
    return total


@pytest.mark.parametrize(("name", "size", "exact"), [("cylinder", 5, 2000 * np.pi), ("ball", 3.5, 4000 * np.pi / 3)])
def test_round_solids(solids, name, size, exact):
    mesh = hexcon.mesh_solid(solids[name], size, order=2)
    flat = hexcon.mesh_solid(solids[name], size)
    told = mesh.report["curved"]
    assert any("chords cut round faces" in note for note in flat.report["surface notes"])
    assert not any("chords cut round faces" in note or "% off" in note for note in mesh.report["surface notes"])
    assert mesh.certificate.certified and hn.certify(mesh.points, mesh.hexes, mesh.quads).certified
    assert boundary_faults(mesh.hexes[:, :8], mesh.quads) == []
    assert told["straight"] == told["reduced_count"] == 0
    middles = boundary_middles(mesh)
    assert told["on_edges"] + told["on_faces"] == len(middles)
    caps = np.isin(mesh.points[middles, 2], (0.0, 20.0)) if name == "cylinder" else np.zeros(len(middles), bool)
    rim = np.abs(np.hypot(*mesh.points[middles, :2].T) - 10) < 1e-9
    assert curved_solids.off(name, mesh.points[middles[~caps]]).max() < 1e-9
    assert name != "cylinder" or (caps & rim).sum() == told["on_edges"] > 0
    corners = mesh.hexes[:, :8]
    assert (mesh.points[corners] == flat.points[flat.hexes]).all()    # bit for bit
    straight = hn.raise_order(flat.points, flat.hexes)
    errors = [abs(volume(*one) - exact) for one in ((mesh.points, mesh.hexes), straight)]
    assert 50 * errors[0] < errors[1]
    later, why = raised(flat, 2)
    assert why is None and (later.points == mesh.points).all() and (later.hexes == mesh.hexes).all()
    assert flat.order == 1 and "curved" not in flat.report and later.certificate.certified
    assert told["volume"] == pytest.approx(volume(mesh.points, mesh.hexes), rel=1e-9)
    assert told["cad_volume"] == pytest.approx(exact, rel=1e-6)


def test_straight_edges_are_told(solids):
    """Of quads alone, and where CAD faces are not known: by the report; of a mesh raised to order 2: by the deck."""
    surface = surface_from_solid(solids["cylinder"], 5)
    mesh = hexcon.mesh_quad_surface(surface, order=2)
    assert of_curving(mesh.report) == [mesh.report["straight edges"]]
    assert "without their solid" in of_curving(mesh.report)[0]
    assert any("chords cut round faces" in note for note in mesh.report["surface notes"])
    unknown = replace(surface, face_of_quad=0 * surface.face_of_quad)
    mesh = Strategy(order=2).of_surface(unknown, solid=solids["cylinder"])
    assert "which face of the solid" in of_curving(mesh.report)[0]
    flat = hexcon.mesh_quad_surface(surface)
    assert of_curving(flat.report) == []
    loads = {"fixed": ("Face1",), "force": {"Face2": (1.0, 0.0, 0.0)}}
    assert RAISED in static_deck(flat, order=2, **loads)
    assert RAISED not in static_deck(flat, **loads)
    flat.solid = "gone.brep"
    assert RAISED + "; its solid could not be used: FILE_IO" in static_deck(flat, order=2, **loads)


def test_notes_of_curved_quads():
    fit = Fit(100.0, 60.0, -0.031, 0.0, 0.1, 0.1, lost_faces=(3,))
    chords, lost = fit.notes(0.01)
    assert notes_of_curved([chords, lost], -1e-5, 0.01) == [lost]
    assert notes_of_curved([chords, lost], -0.02, 0.01) == [
        lost, "the volume is -2.0 % off, more than 1 %, although edges are curved; a smaller size fits better"]


def test_surfaces_without_closed_forms(solids):
    mesh = hexcon.mesh_solid(solids["barrel"], 5, order=2)
    told = mesh.report["curved"]
    assert mesh.certificate.certified and told["straight"] == 0 and told["on_edges"] > 0
    assert abs(told["volume"] / told["cad_volume"] - 1) < 2e-3 and told["chord"] < 0.05


SIDES = np.array([(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)])


def boundary_of(hexes):
    sides = hexes[:, SIDES].reshape(-1, 4)
    _, first, count = np.unique(np.sort(sides, axis=1), axis=0, return_index=True, return_counts=True)
    return sides[first[count == 1]]


def slab(layers, height):
    """(points, hexes of order 2 with straight edges, middles of the bottom's two edges along x, those of bottom and
    top): hexes on each other, with a square of side 2."""
    levels = np.linspace(0.0, height * layers, layers + 1)
    points = np.array([(x, y, z) for z in levels for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))], float)
    points, hexes = hn.raise_order(points, np.arange(8) + 4 * np.arange(layers)[:, None])
    ends = points[hexes[:, 8:]]
    bottom = np.unique(hexes[:, 8:][(ends[:, :, 2] == 0) & (ends[:, :, 0] == 1)])
    held = np.unique(hexes[:, 8:][np.isin(ends[:, :, 2], (0.0, points[:, 2].max()))])
    return points, hexes, bottom, held


def bent_slab(layers, height, sag):
    """What unfolding makes of a bottom that bulges into the slab, as the wall of a hole does."""
    from curving_worker.unfolding import unfolded
    points, hexes, bottom, held = slab(layers, height)
    bend = np.zeros_like(points)
    bend[bottom, 2] = sag
    found = unfolded(points, hexes, boundary_of(hexes), bend, held, lambda *told: None)
    quality = hn.quality(found.points, hexes).scaled_jacobian
    straight = hn.quality(points, hexes).scaled_jacobian
    assert (quality > 0).all() and (quality >= 0.0999 * straight).all()
    corners = np.unique(hexes[:, :8])
    assert (found.points[corners] == points[corners]).all()
    return found, bottom


@pytest.fixture
def worker(monkeypatch):
    monkeypatch.syspath_prepend(os.path.join(os.path.dirname(hexcon.__file__), "curving"))


def test_what_does_not_fold_is_left_alone(worker):
    found, bottom = bent_slab(1, 1.0, 0.3)
    assert (found.factor == 1).all() and found.inner == 0 and (found.points[bottom, 2] == 0.3).all()


def test_inner_edges_bend_before_curvature_is_given_up(worker):
    """Thin layers under a bulge of thrice their thickness: the layers follow it."""
    found, bottom = bent_slab(6, 0.1, 0.3)
    assert (found.factor == 1).all() and found.inner > 0 and (found.points[bottom, 2] == 0.3).all()


def test_what_folds_all_the_same_keeps_part_of_its_curvature(worker):
    """One hex, whose opposite edges stay: a bulge through it is cut down to less than its thickness."""
    found, bottom = bent_slab(1, 0.5, 1.0)
    assert 0.3 < found.factor[0] < 0.5 and found.inner == 0
    assert found.points[bottom, 2] == pytest.approx(found.factor[0])


def block(xs, ys, zs):
    """(points, hexes of order 2) of a grid of boxes."""
    count = len(xs), len(ys), len(zs)
    points = np.stack(np.meshgrid(xs, ys, zs, indexing="ij"), -1).reshape(-1, 3)
    first = np.stack(np.meshgrid(*(np.arange(n - 1) for n in count), indexing="ij"), -1).reshape(-1, 1, 3)
    corners = first + [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    return hn.raise_order(points, np.ravel_multi_index(corners.reshape(-1, 3).T, count).reshape(-1, 8))


def test_inner_corners_move_out_of_the_way(worker):
    """A bulge of the bottom through a layer that is thinner: the layer's inner corners rise over it."""
    from curving_worker.corner_moves import with_moved_corners
    points, hexes = block(np.arange(5.0), np.arange(5.0), [0.0, 0.5, 2.0])
    quads, bend = boundary_of(hexes), np.zeros_like(points)
    bottom = (points[:, 2] == 0) & (points[:, :2] > 0).all(axis=1) & (points[:, :2] < 4).all(axis=1)
    bend[bottom & (points[:, :2] % 1 == 0.5).any(axis=1), 2] = 0.3
    least = 0.1 * hn.quality(points, hexes).scaled_jacobian
    folded = np.flatnonzero(hn.quality(points + bend, hexes).scaled_jacobian < least)
    moved, count = with_moved_corners(points, hexes, quads, bend, folded, least)
    assert len(folded) > 3 and count > 3
    assert (hn.quality(moved + bend, hexes).scaled_jacobian > least).all()
    assert (moved[np.unique(quads)] == points[np.unique(quads)]).all()
    assert hn.certify(moved + bend, hexes, quads).certified


def test_faces_that_cross_keep_less_of_their_curvature(worker):
    """The ends of a U that bulge into each other: no hex folds, but the faces must part."""
    from curving_worker.unfolding import unfolded
    points, hexes = block([0.0, 1.0, 1.125, 2.125], [0.0, 1.0, 2.0], [0.0, 1.0])
    centre = points[hexes[:, :8]].mean(axis=1)
    hexes = hexes[(np.abs(centre[:, 0] - 1.0625) > 0.1) | (centre[:, 1] < 1)]
    used, place = np.unique(hexes, return_inverse=True)
    points, hexes = points[used], place.reshape(-1, 20)
    bend, middles = np.zeros_like(points), [(1.5, 0), (1.5, 1), (2, 0.5)]
    rim = (points[:, None, 1:] == middles).all(axis=2).any(axis=1)
    bend[rim & (points[:, 0] == 1), 0], bend[rim & (points[:, 0] == 1.125), 0] = 0.05, -0.05
    quads, nodes = boundary_of(hexes), np.unique(hexes[:, 8:])
    assert (hn.quality(points + bend, hexes).scaled_jacobian > 0.1).all()
    assert hn.certify(points + bend, hexes, quads).embedded is False
    found = unfolded(points, hexes, quads, bend, nodes, lambda *told: None)
    assert hn.certify(found.points, hexes, quads).certified
    assert (found.factor < 1).sum() == 2 and found.factor.min() == 0.5

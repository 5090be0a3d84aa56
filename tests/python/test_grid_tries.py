# SPDX-License-Identifier: LGPL-2.1-or-later
"""The grid's tries: what is good is kept at once, what stays folded costs little, what has no paths is given up."""
import numpy as np
import pytest

from hexcon.quads import surface_from_solid
from hexcon.quads.gmsh_worker.grid import overlay, routes, sheet_plan, tries
from hexcon.quads.gmsh_worker.grid.captured import NotCaptured
from hexcon.quads.gmsh_worker.grid.spread_patches import spread


class Link:
    """What the worker tells, kept."""

    patience = None

    def __init__(self):
        self.kept = []

    def progress(self, stage, fraction):
        assert 0.0 <= fraction <= 1.0

    def risk(self, name):
        return True

    def keep(self, mesh):
        self.kept.append(mesh)


def blind(occ):
    occ.cut([(3, occ.addBox(0, 0, 0, 6, 6, 4))], [(3, occ.addCylinder(3, 3, 1.5, 0, 0, 3, 1.5))])


def test_a_good_mesh_is_kept_before_better_ones_are_sought(features, monkeypatch):
    """With a bound that no mesh reaches every try is made; the best so far has been kept each time."""
    monkeypatch.setattr(tries, "GOOD", 1.1)
    monkeypatch.setattr(tries, "TRIES", tries.TRIES[:1] + (tries.Try(0.8),))
    solid, link = features(blind, 1.5).cad.solid, Link()
    mesh = tries.grid_surface(solid, 1.5, link, 600.0)
    assert link.kept and np.array_equal(link.kept[-1]["hexes"], mesh["hexes"])
    assert any("least scaled Jacobian" in note for note in mesh["notes"])


def test_folded_hexes_get_few_passes_and_drafts_are_finished_last(features, monkeypatch):
    """Where relaxation leaves all as it was: no polish; drafts are told by folded hexes, and refused in the end."""
    asked = []

    def relax(self, points, curves_held=(True, False), passes=0, **options):
        asked.append(passes)
        return points + 0.0 if passes else np.zeros_like(points)
    monkeypatch.setattr(overlay.Sliding, "relax", relax)
    monkeypatch.setattr(tries, "TRIES", tries.TRIES[1:2])
    solid, link = features(blind, 1.5).cad.solid, Link()
    with pytest.raises(tries.WorkerFault, match="hexes not positive"):
        tries.grid_surface(solid, 1.5, link, 600.0)
    assert not link.kept and overlay.PASSES not in asked


def test_curves_without_room_are_given_up_soon(features, monkeypatch):
    """Two holes half an element apart: rounds that bring nothing are few."""
    def near(occ):
        holes = [(3, occ.addCylinder(x, 3, -1, 0, 0, 4, 1.0)) for x in (1.9, 4.1)]
        occ.cut([(3, occ.addBox(0, 0, 0, 6, 6, 2))], holes)
    rounds, conflicts = [], routes.Routes._conflicts
    monkeypatch.setattr(routes.Routes, "_conflicts", lambda self: rounds.append(self) or conflicts(self))
    found = features(near, 2.0)
    with pytest.raises(NotCaptured):
        overlay.overlay(found, 2.0, overlay.Work())
    times = [sum(one is r for one in rounds) for r in set(rounds)]
    assert times and max(times) <= len(found.curves) + routes.PATIENCE + 1 < routes.ROUNDS


def test_points_of_curves_keep_their_order_and_apart(features):
    """A hole some two elements wide beside a corner."""
    def near_a_corner(occ):
        occ.cut([(3, occ.addBox(0, 0, 0, 6, 6, 3))], [(3, occ.addCylinder(2.2, 2.4, -1, 0, 0, 5, 1.1))])
    found = overlay.overlay(features(near_a_corner, 1.0), 1.0, overlay.Work())
    assert found.good
    for curve, chain in zip(found.features.curves, overlay.Sliding(found.mesh, found.features).chains):
        step = np.diff(curve.lengths_of(found.points[chain])[0])
        step = step - curve.length * np.round(step / curve.length) if curve.closed else step
        turn = 1.0 if not curve.closed or step.sum() > 0.0 else -1.0
        assert (turn * step > 0.1 * curve.length / len(step)).all()


def test_an_edge_much_shorter_than_the_elements_is_a_point(features, tmp_path):
    """A roof whose ridge is a few thousandths of the size."""
    def roof(occ):
        corners = ((0, 0, 0), (8, 0, 0), (8, 8, 0), (0, 8, 0), (3.998, 4, 5), (4.002, 4, 5))
        points = [occ.addPoint(*at) for at in corners]
        lines = {}

        def line(a, b):
            if (b, a) in lines:
                return -lines[b, a]
            return lines.setdefault((a, b), lines.get((a, b)) or occ.addLine(points[a], points[b]))
        faces = [occ.addPlaneSurface([occ.addCurveLoop([line(*pair) for pair in zip(f, f[1:] + f[:1])])])
                 for f in ((3, 2, 1, 0), (0, 1, 5, 4), (1, 2, 5), (2, 3, 4, 5), (3, 0, 4))]
        occ.addVolume([occ.addSurfaceLoop(faces)])
    features(roof, 1.2)
    surface = surface_from_solid(str(tmp_path / "solid.brep"), 1.2, "grid")
    apex = np.abs(surface.points - [4, 4, 5]).max(axis=1) < 0.0021
    assert apex.sum() == 1 and set(surface.face_of_quad) == {1, 2, 3, 4, 5}
    assert any("taken as points: Edge" in note for note in surface.notes)
    edges = surface.points[surface.quads] - surface.points[np.roll(surface.quads, -1, axis=1)]
    assert np.linalg.norm(edges, axis=2).min() > 0.1


def test_what_is_too_narrow_for_the_elements_is_split_there(features):
    """A hole nearer to two faces than an element: no paths at the size, and none much smaller everywhere."""
    def near_a_corner(occ):
        occ.cut([(3, occ.addBox(0, 0, 0, 6, 6, 3))], [(3, occ.addCylinder(1.7, 1.9, -1, 0, 0, 5, 1.1))])
    link = Link()
    mesh = tries.grid_surface(features(near_a_corner, 1.5).cad.solid, 1.5, link, 600.0)
    assert any("no paths that do not meet" in note for note in mesh["notes"])
    assert "split 1 times" in mesh["notes"][0] and len(link.kept) == 1
    assert len(mesh["hexes"]) < 400


def test_a_straight_corner_between_two_curves_gets_two_quads(features, monkeypatch):
    """A box whose front leans back below one half of its upper edge: the top has a corner of 180 degrees there."""
    def leaning(occ):
        corners = [occ.addPoint(2, *at) for at in ((0, 4), (0, 0), (1.5, 0))]
        face = occ.addPlaneSurface([occ.addCurveLoop([occ.addLine(a, b) for a, b in
                                                      zip(corners, corners[1:] + corners[:1])])])
        occ.cut([(3, occ.addBox(0, 0, 0, 4, 4, 4))], [one for one in occ.extrude([(2, face)], 2, 0, 0) if one[0] == 3])
    found = features(leaning, 1.0)
    one = overlay.overlay(found, 1.0, overlay.Work())
    assert one.good and one.quality.min > 0.2
    monkeypatch.setattr(sheet_plan, "STRAIGHT_CORNER", 360.0)
    assert not overlay.overlay(found, 1.0, overlay.Work()).good


def test_folded_quads_of_a_patch_are_spread_out(features):
    """Points of a plane patch with a hole in it, put beyond its border: no quad is folded afterwards; others stay."""
    found = features(blind, 1.0)
    mesh, most = overlay._captured(found, 1.0, overlay.Work(), lambda stage, fraction: None, 0)
    mesh = sheet_plan.sheeted(mesh, most)[0]
    sliding = overlay.Sliding(mesh, most)
    start = overlay.placed(mesh, most, sliding)
    top = next(p for p, patch in enumerate(most.patches) if np.allclose(patch.project([[0, 0, 4]])[0], [0, 0, 4])
               and patch.euler == 0)
    rows = np.flatnonzero(sliding.carrier_of_point == len(most.curves) + top)
    start[rows, 0] += 1.5      # into the hole
    points = spread(mesh, most, sliding, start)
    others = np.setdiff1d(np.arange(len(points)), sliding.on_patch())
    assert np.array_equal(points[others], sliding.project(start)[others]) and np.allclose(points[rows, 2], 4.0)
    quads = points[mesh.quads[mesh.patch == top]][:, :, :2]
    ahead, back = np.roll(quads, -1, axis=1) - quads, np.roll(quads, 1, axis=1) - quads
    assert (np.cross(ahead, back) > 0.0).all()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patches, curves and corners of solids, and points on them. Needs gmsh importable, as the worker does."""
import gmsh
import numpy as np
import pytest

from hexcon.quads.gmsh_worker import cad
from hexcon.quads.gmsh_worker.grid import features as grid_features
from hexcon.quads.gmsh_worker.grid.features import EVERY_EDGE, Features
from hexcon.quads.gmsh_worker.grid.sliding import FeatureCarriers
from hexcon.quads.gmsh_worker.grid.tessellation import Nearest


def box(occ):
    occ.addBox(0, 0, 0, 3, 2, 1)


def drilled(occ):
    occ.cut([(3, occ.addBox(0, 0, 0, 6, 6, 4))], [(3, occ.addCylinder(3, 3, 1, 0, 0, 3, 1.5))])


def hollow(occ):
    occ.cut([(3, occ.addSphere(0, 0, 0, 4))], [(3, occ.addSphere(0.5, 0, 0, 2))])


def cone(occ):
    occ.addCone(0, 0, 0, 0, 0, 3, 2, 0)


def ring(occ):
    occ.addTorus(1, 2, 3, 4, 1)


def rounded(occ):
    solid = occ.addBox(0, 0, 0, 4, 4, 4)
    occ.synchronize()
    occ.fillet([solid], [e for _, e in gmsh.model.getBoundary(gmsh.model.getBoundary([(3, solid)]), False, False)], [1])


def lofted(occ):
    """A bar whose section turns: its sides have no closed form."""
    def section(z, way):
        corners = [occ.addPoint(1.5 * np.cos(a + way), 1.5 * np.sin(a + way), z) for a in np.arange(4) * np.pi / 2]
        return occ.addCurveLoop([occ.addLine(p, q) for p, q in zip(corners, corners[1:] + corners[:1])])
    occ.addThruSections([section(0, 0.0), section(2, 0.3), section(4, 0.8)], makeSolid=True)


# patches, curves, corners, Euler characteristic, shells, rounded angles of curves
EXPECTED = {box: (6, 12, 8, 2, 1, {90}), drilled: (8, 14, 8, 2, 1, {90, 270}), hollow: (2, 0, 0, 4, 2, set()),
            cone: (2, 1, 1, 2, 1, {56}), ring: (1, 0, 0, 0, 1, set()), rounded: (1, 0, 0, 2, 1, set())}


@pytest.mark.parametrize("build", EXPECTED)
def test_counts(features, build):
    found = features(build, 0.5)
    shape = found.cad.tessellation
    assert (len(found.patches), len(found.curves), len(found.corners), found.handles(), shape.shells,
            {round(c.angle) for c in found.curves}) == EXPECTED[build]
    assert abs(shape.volume() / found.cad.solid.exact_volume - 1.0) < 0.02
    arcs = sum(not c.closed for c in found.curves)
    assert sum(p.euler for p in found.patches) == found.handles() - arcs + sum(len(p) - 1 for p in found.corner_patches)


@pytest.mark.parametrize("build", EXPECTED)
def test_projections_are_nearest(features, build):
    found = features(build, 0.5)
    rng = np.random.default_rng(5)
    for patch in found.patches:
        rows = rng.choice(patch.rows[len(patch.rows) // 2:], min(40, len(patch.rows) // 2), replace=False)
        if build is cone:       # not within its tip's reach
            rows = rows[found.points[found.triangles[rows]].mean(1)[:, 2] < 2.5]
        centres = found.points[found.triangles[rows]].mean(1)
        out = found.cad.tessellation.normals_at(rows)
        off = centres + rng.uniform(0.0, 0.1, (len(rows), 1)) * out
        points, normals, faces = patch.project(off)
        assert set(faces) <= set(patch.faces) and np.allclose(np.abs((normals * out).sum(1)), 1, atol=0.05)
        for point, source, face in zip(points, off, faces):
            assert np.linalg.norm(cad.Solid.project(2, face, point)[0] - point) < 1e-7
            nearest = cad.Solid.project(2, face, source)[0]
            assert np.linalg.norm(point - source) <= np.linalg.norm(nearest - source) + 1e-7


def test_every_edge_of_a_rounded_box(features):
    found = features(rounded, 0.5, smooth=EVERY_EDGE)
    assert (len(found.patches), len(found.curves), len(found.corners)) == (26, 48, 24)
    assert {c.kind for c in found.cad.carriers.values()} == {"Plane", "Cylinder", "Sphere"}


def test_curves_have_their_patches_left_and_right(features):
    found = features(drilled, 0.5)
    for curve in found.curves:
        at = 0.5 * curve.length
        p, t = curve.at([at])[0], curve.tangents([at])[0]
        for side, patch in ((1.0, curve.left), (-1.0, curve.right)):
            rows = found.patches[patch].rows
            centres = found.points[found.triangles[rows]].mean(1)
            row = rows[np.argmin(np.linalg.norm(centres - p, axis=1))]
            n = found.normals[row] / np.linalg.norm(found.normals[row])
            assert side * np.cross(n, t) @ (found.points[found.triangles[row]].mean(0) - p) > 0
        ends = found.corners[[curve.start, curve.end]] if not curve.closed else curve.at([0.0, curve.length])
        assert np.abs(curve.samples[[0, -1]] - ends).max() < 1e-9
        s = np.linspace(0.1, 0.8, 7) * curve.length
        again, gap = curve.lengths_of(curve.at(s))
        assert np.allclose(s, again, atol=1e-2 * curve.length) and gap.max() < 0.02


def test_slivers_are_named(features):
    def build(occ):
        occ.fuse([(3, occ.addBox(0, 0, 0, 6, 6, 3))], [(3, occ.addBox(0, 0.1, 3, 6, 5.9, 3))])
    found = features(build, 1.0)
    narrow = found.slivers(1.0)
    assert narrow and not found.slivers(0.1)
    merged = Features(found.cad, soft=narrow)
    assert len(merged.patches) == len(found.patches) - 1


def test_nearest_of_all_triangles():
    """Against every triangle, of very different sizes."""
    rng = np.random.default_rng(3)
    corners = rng.random((300, 1, 3)) + 10.0 ** rng.uniform(-3, -0.5, (300, 1, 1)) * rng.standard_normal((300, 3, 3))
    points, triangles = corners.reshape(-1, 3), np.arange(900).reshape(-1, 3)
    wanted = rng.random((25, 3))
    where, which, gap = Nearest(points, triangles)(wanted)
    weights = np.stack(np.meshgrid(*[np.linspace(0, 1, 17)] * 2), -1).reshape(-1, 2)
    weights = weights[weights.sum(1) <= 1 + 1e-12]
    weights = np.hstack([1 - weights.sum(1, keepdims=True), weights])
    dense = np.einsum("wk,tkm->twm", weights, corners)
    for p, q, t, d in zip(wanted, where, which, gap):
        best = np.linalg.norm(dense - p, axis=2).min()
        assert abs(np.linalg.norm(p - q) - d) < 1e-12 and d <= best + 1e-12
        assert np.linalg.norm(dense[t] - q, axis=1).min() < 0.1


def test_normals_are_asked_of_gmsh_once(features, monkeypatch):
    """However many meshes slide on the solid. Those of closed forms are the triangles' own."""
    asked = []
    ask = grid_features.surface_normals
    monkeypatch.setattr(grid_features, "surface_normals", lambda face, points: asked.append(face) or ask(face, points))
    found = features(lofted, 1.0)
    first, second = (FeatureCarriers(found).relaxed_on()[1] for _ in range(2))
    sides = [f for f, carrier in found.cad.carriers.items() if carrier.kind == "other"]
    assert len(sides) == 4 and sorted(asked) == sides
    assert np.array_equal(first.normals, second.normals)
    cosine = (found.cad.corner_normals(sides[0]) * found.cad.tessellation.normals()[
        found.cad.tessellation.face == sides[0]][:, None]).sum(axis=2)
    assert (cosine > 0.0).all()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Axes and planes of the grid, what a grid's surface must keep, and what is too small. Needs gmsh importable."""
import numpy as np
import pytest

from hexcon.quads.gmsh_worker.grid.axes import axes_of
from hexcon.quads.gmsh_worker.grid.gate import Kept, kept
from hexcon.quads.gmsh_worker.grid.planes import planes_of
from hexcon.quads.gmsh_worker.grid.tensor_grid import grid_hexes
from hexcon.quads.gmsh_worker.grid.too_small import too_small


def step(occ):
    """Faces across x at 0, 3, 8; across y at 0, 4; across z at 0, 2, 5."""
    return occ.fuse([(3, occ.addBox(0, 0, 0, 8, 4, 2))], [(3, occ.addBox(0, 0, 2, 3, 4, 3))])[0]


def test_planes_lie_on_plane_faces(features):
    found = features(step, 1.0)
    frame = axes_of(found)
    assert np.array_equal(frame, np.eye(3))
    for planes, faces in zip(planes_of(found, frame, 1.0), ((0, 3, 8), (0, 4), (0, 2, 5))):
        assert all(np.abs(planes - f).min() < 1e-9 for f in faces)
        assert (np.diff(planes) > 0.5).all() and (np.diff(planes) < 1.5).all()
        assert np.isclose(planes[1], faces[0]) and np.isclose(planes[-2], faces[-1])


def test_axes_of_a_turned_solid(features):
    def build(occ):
        occ.rotate(step(occ), 1, 2, 3, 0.3, -1.0, 0.5, 0.8)
    found = features(build, 1.0)
    frame = axes_of(found)
    assert np.allclose(frame @ frame.T, np.eye(3)) and np.isclose(np.linalg.det(frame), 1.0)
    normals = np.array([c.axis for c in found.cad.carriers.values()])
    assert np.abs(normals @ frame.T).max(axis=1).min() > 1.0 - 1e-9


@pytest.mark.parametrize("radius,size", [(0.5, 1.0), (3.0, 1.0)])
def test_round_holes(features, radius, size):
    """A small hole gets a square of planes, a large one a plane through its middle."""
    def build(occ):
        occ.cut([(3, occ.addBox(0, 0, 0, 9.3, 8.6, 2))], [(3, occ.addCylinder(4.4, 4.1, 0, 0, 0, 2, radius))])
    found = features(build, size)
    planes = planes_of(found, axes_of(found), size)
    for axis, centre in ((0, 4.4), (1, 4.1)):
        wanted = [centre - 0.78 * radius, centre + 0.78 * radius] if radius < 1.6 * size else [centre]
        assert all(np.abs(planes[axis] - w).min() < 1e-9 for w in wanted)


def test_the_grids_hexes():
    planes = [np.array([0.0, 1.0, 3.0]), np.array([-1.0, 0.0]), np.array([2.0, 2.5, 4.0, 5.0])]
    points, hexes = grid_hexes(planes)
    assert points.shape == (24, 3) and hexes.shape == (6, 8)
    p = points[hexes]
    volume = np.einsum("hi,hi->h", p[:, 1] - p[:, 0], np.cross(p[:, 3] - p[:, 0], p[:, 4] - p[:, 0]))
    assert (volume > 0).all() and np.isclose(volume.sum(), 3 * 1 * 3) and np.isclose(p[:, 6].max(), 5.0)


def test_what_is_kept_of_a_cylinder(features):
    """A prism of n sides in a cylinder: volume and area are known, and the edge's distance from the circle."""
    found = features(lambda occ: occ.addCylinder(0, 0, 0, 0, 0, 4, 2), 1.0)
    n, r = 12, 2.0
    angle = 2 * np.pi * np.arange(n) / n
    ring = r * np.stack([np.cos(angle), np.sin(angle), np.zeros(n)], 1)
    points = np.vstack([ring, ring + [0, 0, 4.0], [[0, 0, 0], [0, 0, 4]]])
    walls = [[k, (k + 1) % n, (k + 1) % n + n, k + n] for k in range(n)]
    caps = [[2 * n, k + 2 if k + 2 < n else k + 2 - n, k + 1, k] for k in range(0, n, 2)]
    lids = [[2 * n + 1, k + n, k + 1 + n, (k + 2) % n + n] for k in range(0, n, 2)]

    class Mesh:
        quads = np.array(walls + caps + lids)
    kinds = {f: c.kind for f, c in found.cad.carriers.items()}
    faces = np.array([next(f for f, k in kinds.items() if k == "Cylinder")] * n + [0] * n)
    chains = [np.append(np.arange(n), 0) + (0 if abs(c.samples[0, 2]) < 1e-9 else n) for c in found.curves]
    got = kept(points, Mesh, faces, found, chains, 1.0)
    section = n / 2 * r * r * np.sin(2 * np.pi / n)
    assert np.isclose(got.volume, section / (np.pi * r * r) - 1.0, atol=1e-9)
    side = 2 * n * r * np.sin(np.pi / n) * 4
    assert np.isclose(got.area, (2 * section + side) / (2 * np.pi * r * r + 2 * np.pi * r * 4) - 1.0, atol=1e-9)
    assert np.isclose(got.chord, r * (1 - np.cos(np.pi / n)), atol=1e-3)
    assert len(got.lost) == 2 and not got.faults


def test_faults_are_told():
    good = Kept(0.01, -0.01, 0.1, 3, [])
    assert not good.faults
    assert ["volume" in f for f in Kept(-0.2, 0.0, 0.1, 3, []).faults] == [True]
    assert "curve 3" in Kept(0.0, 0.0, 2.0, 3, []).faults[0]
    assert "short" in Kept(0.0, 0.0, 0.1, 3, [], 1e-3).faults[0]
    assert len(Kept(float("nan"), 0.5, 0.1, 3, []).faults) == 2


def test_small_features_are_named(features):
    def build(occ):
        occ.fuse([(3, occ.addBox(0, 0, 0, 6, 6, 3))], [(3, occ.addBox(0, 0.1, 3, 6, 5.9, 3))])
    found = features(build, 1.0)
    words, faces = too_small(found, 1.0)
    assert "0.1 wide" in words or "0.1 long" in words
    assert "0.4 would" in words or "0.39" in words
    assert faces and set(faces) <= set(found.cad.solid.faces)
    assert too_small(found, 0.1) == ("", [])

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed forms of CAD faces that gmsh has no name for."""
import gmsh
import numpy as np
import pytest

from hexcon.quads.gmsh_worker.grid.carriers import surface_carrier


@pytest.mark.parametrize("build, kind, radius", [
    # a box whose sides are tangent to a cylinder: half of it is left, trimmed in itself
    (lambda occ: occ.fuse([(3, occ.addBox(-10, 0, 0, 20, 5, 10))], [(3, occ.addCylinder(0, 0, 10, 0, 5, 0, 10))]),
     "Cylinder", 10.0)])
def test_surfaces_that_are_trimmed_in_themselves(gmsh_running, build, kind, radius):
    build(gmsh.model.occ)
    gmsh.model.occ.synchronize()
    faces = [face for _, face in gmsh.model.getEntities(2) if gmsh.model.getType(2, face) != "Plane"]
    found = [surface_carrier(face, 30.0) for face in faces]
    assert faces and {(one.kind, round(one.radius, 9)) for one in found} == {(kind, radius)}
    for face, one in zip(faces, found):
        low, high = (np.array(b) for b in gmsh.model.getParametrizationBounds(2, face))
        at = low + np.random.default_rng(1).uniform(size=(20, 2)) * (high - low)
        points = np.array(gmsh.model.getValue(2, face, at.ravel())).reshape(-1, 3)
        assert np.abs(np.hypot(points[:, 0], points[:, 2] - 10.0) - radius).max() < 1e-9
        assert np.abs(one.project(points)[0] - points).max() < 1e-9

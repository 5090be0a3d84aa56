# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every hex in eight, with the boundary on the CAD."""
import gmsh
import numpy as np
import pytest
from mesh_checker import faults

from hexcon.quads.gmsh_worker import cad
from hexcon.quads.gmsh_worker.filler.refined import refined
from hexcon.quads.gmsh_worker.layered.mesh import layered_mesh
from hexcon.quads.gmsh_worker.layered.roles import Shape
from hexcon.quads.gmsh_worker.link import Link


@pytest.fixture
def pipe(gmsh_running):
    gmsh.model.occ.cut([(3, gmsh.model.occ.addCylinder(0, 0, 0, 0, 0, 12, 6))],
                       [(3, gmsh.model.occ.addCylinder(0, 0, 0, 0, 0, 12, 3))])
    gmsh.model.occ.synchronize()
    return Shape(cad.Solid(gmsh.model.getEntities(3)[0][1]), 4.0)


def test_pipe(pipe):
    mesh = layered_mesh(pipe, np.array([0.0, 0.0, 1.0]), 4.0, Link())
    points, hexes, quads, faces = refined(pipe, mesh.points, mesh.hexes, mesh.quads, mesh.faces)
    assert len(hexes) == 8 * len(mesh.hexes) and len(quads) == 4 * len(mesh.quads)
    assert np.array_equal(points[:len(mesh.points)], mesh.points)
    assert not faults(points, hexes, quads, points)
    for face in pipe.solid.faces:
        on = points[np.unique(quads[faces == face])]
        assert np.abs(pipe.carriers[face].project(on)[0] - on).max() < 1e-9
    for edge in (e for e in pipe.solid.edges if len(set(pipe.solid.faces_of[e])) == 2):
        here, there = (set(quads[faces == f].ravel()) for f in pipe.solid.faces_of[edge])
        on = points[sorted(here & there)]
        radius = np.linalg.norm(on[:, :2], axis=1)
        assert np.ptp(radius) < 1e-9 and len(on) % 2 == 0

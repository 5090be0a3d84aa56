# SPDX-License-Identifier: LGPL-2.1-or-later
"""Features that find no room are given up where they may be. Needs gmsh importable, as the worker does."""
import gmsh
import numpy as np
import pytest
from grid_voxels import captured_faults

from hexcon.quads.gmsh_worker import cad
from hexcon.quads.gmsh_worker.grid.capture import capture
from hexcon.quads.gmsh_worker.grid.capture_most import capture_most
from hexcon.quads.gmsh_worker.grid.captured import NotCaptured
from hexcon.quads.gmsh_worker.grid.features import EVERY_EDGE, Cad, Features


@pytest.fixture
def made():
    """Solid of the box 4 x 1 x 4 with what a function makes of it."""
    gmsh.initialize([], False)
    gmsh.option.setNumber("General.Terminal", 0)

    def make(change):
        change(gmsh.model.occ)
        gmsh.model.occ.synchronize()
        return Cad(cad.Solid(gmsh.model.getEntities(3)[0][1]), 1.0)
    yield make
    gmsh.finalize()


def plain(counts, size):
    """(points, hexes) of a box from the origin."""
    points = np.stack(np.meshgrid(*(np.linspace(0, s, c + 1) for s, c in zip(size, counts)), indexing="ij"), -1)
    names = np.arange(np.prod(points.shape[:3])).reshape(points.shape[:3])
    cells = [names[i:i + 2, j:j + 2, k:k + 2] for i, j, k in np.ndindex(*counts)]
    return points.reshape(-1, 3), np.array([[c[0, 0, 0], c[1, 0, 0], c[1, 1, 0], c[0, 1, 0], c[0, 0, 1], c[1, 0, 1],
                                             c[1, 1, 1], c[0, 1, 1]] for c in cells])


def rounded(occ):
    solid = occ.addBox(0, 0, 0, 4, 1, 4)
    occ.synchronize()
    edges = [e for _, e in gmsh.model.getEntities(1)
             if np.allclose(gmsh.model.occ.getCenterOfMass(1, e)[0], 0) and abs(
                 gmsh.model.occ.getCenterOfMass(1, e)[2] - 2) < 1e-6]
    occ.fillet([solid], edges, [0.45])


def test_fillets_without_room_become_part_of_their_neighbours(made):
    """Two hexes: round their end there are four vertices, for two corners, and four ends of smooth lines."""
    features = Features(made(rounded), EVERY_EDGE)
    points, hexes = plain((1, 1, 2), (4, 1, 4))
    with pytest.raises(NotCaptured):
        capture(features, points, hexes)
    mesh, most = capture_most(features, points, hexes, 1.0)
    assert captured_faults(mesh, most) == []
    given_up = [features.edges[e] for e in most.soft]
    assert given_up and all(max(abs(e.least - 180), abs(e.greatest - 180)) < 25 for e in given_up)
    assert len(most.patches) < len(features.patches)


def test_with_room_nothing_is_given_up(made):
    features = Features(made(rounded), EVERY_EDGE)
    mesh, most = capture_most(features, *plain((12, 5, 6), (4, 1, 4)), 0.3)
    assert most is features and captured_faults(mesh, features) == []


def drilled(occ):
    occ.cut([(3, occ.addBox(0, 0, 0, 4, 1, 4))], [(3, occ.addCylinder(2, 0, 2, 0, 1, 0, 1))])


def test_what_is_sharp_and_wide_is_not_given_up(made):
    features = Features(made(drilled), EVERY_EDGE)
    with pytest.raises(NotCaptured) as fault:
        capture_most(features, *plain((2, 1, 2), (4, 1, 4)), 2.0)
    assert fault.value.curves or fault.value.patches

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface method `filled` on .brep files: rooms where pipes and bores meet are diced, the rest is natural."""
import gmsh
import numpy as np
import pytest
from cell_surfaces import cad_file
from mesh_checker import enclosed, faults

import hexcon
from hexcon.errors import FaultCode, ToolError
from hexcon.quads import surface_from_solid
from hexcon.quads.gmsh_worker import cad
from hexcon.quads.gmsh_worker.filler.rooms import Room, rooms_of
from hexcon.quads.gmsh_worker.layered.roles import Shape


def cylinder(x, y, z, dx, dy, dz, radius):
    return f"(3, occ.addCylinder({x}, {y}, {z}, {dx}, {dy}, {dz}, {radius}))"


T_PIECE = (f"occ.cut(occ.fuse([{cylinder(0, -32, 0, 0, 64, 0, 15)}], [{cylinder(0, 0, 0, 34, 0, 0, 11)}])[0], "
           f"[{cylinder(0, -45, 0, 0, 90, 0, 11)}, {cylinder(0, 0, 0, 50, 0, 0, 7)}])")
BORES = (f"occ.cut([(3, occ.addBox(0, 0, 0, 30, 26, 24))], [{cylinder(15, 0, 12, 0, 26, 0, 4)}, "
         f"{cylinder(0, 13, 12, 30, 0, 0, 4)}])")
# two cylinders of radius r that cross: less what they have in common, 16 / 3 r^3
BORED = 30 * 26 * 24 - np.pi * 16 * 56 + 16 / 3 * 64

# name: (solid, size, faces, worst scaled Jacobian, mean, volume, most of it filled)
SOLIDS = {"pipes": (T_PIECE, 2.6, 7, 0.1, 0.65, None, 15), "bores": (BORES, 3.4, 10, 0.1, 0.5, BORED, 20)}


@pytest.mark.parametrize("name", SOLIDS)
def test_solids(tmp_path, name):
    build, size, faces, worst, mean, exact, most = SOLIDS[name]
    mesh = hexcon.mesh_solid(cad_file(build, tmp_path / "solid.brep"), size, surface_method="filled")
    surface = mesh.surface
    assert mesh.method == "proposal" and mesh.certificate.certified
    assert not faults(mesh.points, mesh.hexes, surface.quads, surface.points)
    assert set(surface.face_of_quad) == set(range(1, faces + 1))
    assert mesh.quality.min > worst and mesh.quality.mean > mean
    assert abs(enclosed(surface) / (exact or surface.fit.cad_volume) - 1.0) < 0.01
    told = next(note for note in surface.notes if note.startswith("filled"))
    assert 0 < int(told.split(" % of the volume")[0].split()[-1]) < most


def test_refuses_what_has_nothing_askew(tmp_path):
    with pytest.raises(ToolError) as caught:
        surface_from_solid(cad_file("[(3, occ.addBox(0, 0, 0, 4, 3, 2))]", tmp_path / "solid.brep"), 1.0, "filled")
    assert caught.value.code is FaultCode.NOT_FILLED


def test_points_on_the_sides_of_a_room():
    angle = np.radians(30.0)
    frame = np.array([[np.cos(angle), np.sin(angle), 0], [-np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    room = Room(frame, np.array([0.0, 0.0, 0.0]), np.array([1.0, 2.0, 3.0]))
    local = np.array([(0.0, 1.0, 1.0), (0.5, 2.0, 1.0), (0.5, 1.0, 1.0), (0.0, 2.5, 1.0), (1.0, 2.0, 3.0)])
    assert room.on_sides(local @ frame, 1e-9).tolist() == [True, True, False, False, True]
    assert np.allclose(room.local(local @ frame), local)
    assert np.allclose(sorted(room.local(room.corners()).sum(1)), [0, 1, 2, 3, 3, 4, 5, 6])


def test_a_room_round_what_lies_askew(gmsh_running):
    """As far as three quarters of the size beyond it, but through the solid where little would be left."""
    occ = gmsh.model.occ
    occ.cut([(3, occ.addBox(0, 0, 0, 60, 30, 20))], [(3, occ.addCylinder(12, -9, 8.5, 16, 48, 0, 3))])
    occ.synchronize()
    shape = Shape(cad.Solid(gmsh.model.getEntities(3)[0][1]), 2.0)
    room, = rooms_of(shape, 2.0, wide=False)
    low, high = room.corners().min(0), room.corners().max(0)
    across = 3.0 * np.sqrt(1.0 + (16 / 48) ** 2)        # half of the width in a plane y
    assert np.allclose([low[0], high[0]], [15 - across - 1.5, 25 + across + 1.5], atol=1e-2)
    assert np.allclose([low[2], high[2]], [8.5 - 4.5, 8.5 + 4.5], atol=1e-2)
    assert low[1] < 0.0 and high[1] > 30.0

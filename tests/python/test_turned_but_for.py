# SPDX-License-Identifier: LGPL-2.1-or-later
"""By auto: shafts turned but for a flat, a keyway, a cross hole or a bolt circle, and sectors of turned bodies."""
import numpy as np
import pytest
from cell_surfaces import cad_file
from mesh_checker import enclosed, faults

import hexcon

SHAFT = "occ.fuse([(3, occ.addCylinder(0, 0, 0, 0, 0, 30, 8))], [(3, occ.addCylinder(0, 0, 30, 0, 0, 20, 12))])[0]"
STEPS = np.pi * (64 * 30 + 144 * 20)


def cut(*tools):
    return f"occ.cut({SHAFT}, [{', '.join(tools)}])"


def sector(profile, angle):
    """The solid that a polygon of (radius, height) sweeps about z."""
    return ("([one for one in (lambda p: occ.revolve([(2, occ.addPlaneSurface([occ.addCurveLoop([occ.addLine(a, b) "
            f"for a, b in zip(p, p[1:] + p[:1])])]))], 0, 0, 0, 0, 0, 1, {angle}))([occ.addPoint(r, 0, z) for r, z in "
            f"{profile}]) if one[0] == 3],)")


BOLTS = [f"(3, occ.addCylinder({9.9 * np.cos(a)}, {9.9 * np.sin(a)}, 30, 0, 0, 20, 1))"
         for a in np.pi / 2 * np.arange(4)]
FLAT = 64 * np.arccos(5 / 8) - 5 * np.sqrt(64 - 25)     # of a circle of radius 8, beyond 5 from its middle

# name: (solid, ways that are natural, worst scaled Jacobian, mean, volume)
SOLIDS = {
    "flat": (cut("(3, occ.addBox(5, -20, 5, 20, 40, 15))"), ("layered",), 0.5, 0.8, STEPS - 15 * FLAT),
    "keyway": (cut("(3, occ.addBox(5, -2, 5, 20, 4, 15))"), ("layered",), 0.5, 0.8, None),
    "cross hole": (cut("(3, occ.addCylinder(-20, 0, 12, 40, 0, 0, 2.5))"), ("boxed",), 0.3, 0.75, None),
    "bolt circle": (cut(*BOLTS), ("layered",), 0.3, 0.8, STEPS - np.pi * 4 * 20),
    "sector of a ring": (sector([(8, 0), (20, 0), (20, 6), (14, 6), (14, 20), (8, 20)], 2.0), ("sweep",), 0.8, 0.9,
                         (400 - 64) * 6 + (196 - 64) * 14),
    "sector with its axis": (sector([(0, 0), (12, 0), (12, 8), (7, 8), (7, 30), (0, 30)], 2.0), ("layered",), 0.5, 0.8,
                             144 * 8 + 49 * 22)}


@pytest.mark.parametrize("name", SOLIDS)
def test_natural(tmp_path, name):
    build, ways, worst, mean, exact = SOLIDS[name]
    mesh = hexcon.mesh_solid(cad_file(build, tmp_path / "solid.brep"), 4.0)
    surface = mesh.surface
    assert surface.method in ways and mesh.certificate.certified
    assert not faults(mesh.points, mesh.hexes, surface.quads, surface.points)
    assert not len(surface.fit.lost_faces) and abs(surface.fit.volume) < 0.02
    assert mesh.quality.min > worst and mesh.quality.mean > mean
    assert exact is None or abs(enclosed(surface) / exact - 1.0) < 0.02

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface method `layered` on solids with drafts and tapers: faces a little off the direction are sides."""
import numpy as np
import pytest
from cell_surfaces import cad_file
from mesh_checker import enclosed, faults

import hexcon
from hexcon.errors import FaultCode, ToolError
from hexcon.quads import surface_from_solid


def ruled(*rectangles):
    """Python for gmsh: what lies between two rectangles, each given as (x0, x1, y0, y1, z)."""
    wires = ", ".join("(lambda p: occ.addCurveLoop([occ.addLine(p[i], p[(i + 1) % 4]) for i in range(4)]))"
                      f"([occ.addPoint(x, y, {z}) for x, y in (({a}, {c}), ({b}, {c}), ({b}, {d}), ({a}, {d}))])"
                      for a, b, c, d, z in rectangles)
    return f"occ.addThruSections([{wires}], makeRuled=True)"


def frustum(low, high, half, top, ratio=1.3):
    """A frustum between two rectangles about the z axis, (2 half * ratio) x (2 half) below."""
    return ruled(*((-a * ratio, a * ratio, -a, a, z) for z, a in ((low, half), (high, top))))


def pulled(place, axis):
    """Python for gmsh: a prism along x or y, a triangle of base 8 and height 7 about its middle; place: of x, z."""
    way = {"x": "8, 0, 0", "y": "0, 8, 0"}[axis]
    move = {"x": "-4, 0, 0", "y": "0, -4, 0"}[axis]
    return (f"(lambda p: (occ.translate([(3, p)], {move}), (3, p))[1])(next(t for d, t in occ.extrude([(2, "
            "occ.addPlaneSurface([(lambda p: occ.addCurveLoop([occ.addLine(p[i], p[(i + 1) % 3]) for i in range(3)]))"
            f"([occ.addPoint({place}) for x, z in ((-4, 0), (4, 0), (0, 7))])]))], {way}) if d == 3))")


def frustum_volume(low, high, half, top, ratio=1.3):
    return (high - low) * 4 * ratio * (half * half + half * top + top * top) / 3


def cone_volume(height, low, high):
    return np.pi * height * (low * low + low * high + high * high) / 3


TRAY = f"occ.cut({frustum(0, 8, 10, 9)}, {frustum(3, 8, 6.5, 7.1)})"
PARTED = f"occ.fuse({frustum(0, 4, 9.5, 10)}, {frustum(4, 8, 10, 9.5)})"
STEPPED = f"occ.fuse({frustum(0, 4, 10, 9.6)}, {frustum(4, 9, 6, 5.5)})"
SLOTTED = f"occ.cut({frustum(0, 8, 10, 9)}, [(3, occ.addBox(-20, -3, 4, 40, 6, 10))])"
PLATE = "(3, occ.addBox(0, 0, 0, 16, 12, 2))"
BOSS = (f"occ.cut(occ.fuse([{PLATE}], [(3, occ.addCone(6, 6, 2, 0, 0, 6, 4, 3))])[0], "
        "[(3, occ.addCylinder(6, 6, -1, 0, 0, 12, 1.5))])")
TAPERED = "occ.cut([(3, occ.addBox(0, 0, 0, 16, 12, 5))], [(3, occ.addCone(6, 6, 2, 0, 0, 3, 2, 2.5))])"
FLUSH = f"occ.fuse([{PLATE}], [(3, occ.addCone(16, 6, 2, 0, 0, 6, 4, 3.5))])"

RAMPED = ("occ.cut(occ.fuse([(3, occ.addBox(0, 0, 0, 22, 10, 2))], "
          f"{ruled((4, 18, 4, 6, 2), (9, 13, 4, 6, 7))})[0], [(3, occ.addCylinder(20, 5, -1, 0, 0, 4, 0.8))])")

# name: (solid, size, faces, of those aslant, worst scaled Jacobian, mean, volume or None, tolerance of it)
SOLIDS = {"tray": (TRAY, 2.0, 11, 8, 0.6, 0.9,
                   frustum_volume(0, 8, 10, 9) - frustum_volume(3, 8, 6.5, 7.1), 1e-9),
          "parting line": (PARTED, 2.5, 10, 8, 0.9, 0.97, 2 * frustum_volume(0, 4, 9.5, 10), 1e-9),
          "stepped": (STEPPED, 2.0, 11, 8, 0.9, 0.97,
                      frustum_volume(0, 4, 10, 9.6) + frustum_volume(4, 9, 6, 5.5), 1e-9),
          "slotted": (SLOTTED, 2.5, 10, 4, 0.9, 0.97, None, 1e-9),
          "ramps": (RAMPED, 1.6, 12, 2, 0.35, 0.85, 440 + 5 * 2 * (14 + 4) / 2 - 2 * np.pi * 0.8 ** 2, 0.01),
          "boss": (BOSS, 1.5, 9, 1, 0.6, 0.9, 384 + cone_volume(6, 4, 3) - np.pi * 1.5 ** 2 * 8, 0.02),
          "tapered": (TAPERED, 1.5, 8, 1, 0.7, 0.9, 960 - cone_volume(3, 2, 2.5), 0.02),
          "flush": (FLUSH, 1.5, 9, 1, 0.7, 0.9, None, 0.02)}


@pytest.mark.parametrize("name", SOLIDS)
def test_solids(tmp_path, name):
    build, size, faces, aslant, worst, mean, exact, near = SOLIDS[name]
    mesh = hexcon.mesh_solid(cad_file(build, tmp_path / "solid.brep"), size, surface_method="layered",
                             volume_error=0.05)
    surface = mesh.surface
    assert mesh.certificate.certified and not faults(mesh.points, mesh.hexes, surface.quads, surface.points)
    assert set(surface.face_of_quad) == set(range(1, faces + 1)) and not surface.fit.lost_edges
    assert mesh.quality.min > worst and mesh.quality.mean > mean
    assert abs(enclosed(surface) / (exact or surface.fit.cad_volume) - 1.0) < near
    assert any(f"{aslant} drafted face{'s' * (aslant > 1)} as sides" in note for note in surface.notes)


def test_points_are_on_a_cone_and_its_circles(tmp_path):
    """Of the boss: each quad on it has its points on the cone, in rows that rise from its foot to its top."""
    surface = surface_from_solid(cad_file(BOSS, tmp_path / "solid.brep"), 1.5, "layered", volume_error=0.05)
    x, y, z = surface.points.T
    r = np.hypot(x - 6, y - 6)
    on = np.isclose(r, 4 - (z - 2) / 6, atol=1e-9) & (z > 2 - 1e-9)
    mine = on[surface.quads].all(1)
    assert len(set(surface.face_of_quad[mine])) == 1
    rows, counts = np.unique(np.round(z[np.unique(surface.quads[mine])], 9), return_counts=True)
    assert (rows[0], rows[-1]) == (2, 8) and len(rows) > 3 and len(set(counts)) == 1
    assert mine.sum() == (len(rows) - 1) * counts[0]


def test_sides_that_meet_in_a_point_are_none(tmp_path):
    """A pyramid: refused, with faces at fault."""
    build = f"occ.intersect([{pulled('x, 0, z', 'y')}], [{pulled('0, x, z', 'x')}])"
    with pytest.raises(ToolError) as caught:
        surface_from_solid(cad_file(build, tmp_path / "solid.brep"), 1.5, "layered")
    assert caught.value.code is FaultCode.NOT_LAYERED and "Face" in str(caught.value)

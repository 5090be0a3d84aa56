# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface method `revolved` on .brep files of turned parts: certified hexes, all faces, the volume within 1 %."""
import numpy as np
import pytest
from cell_surfaces import cad_file
from mesh_checker import enclosed, faults

import hexcon
from hexcon.errors import FaultCode, ToolError
from hexcon.quads import surface_from_solid
from hexcon.quads.gmsh_worker.revolved import surface
from hexcon.quads.gmsh_worker.revolved.axis import Axis
from hexcon.quads.gmsh_worker.size_field import SizeField

FULL = 2 * np.pi


def turned(profile, angle=FULL):
    """A body of revolution about z: the polygon of (radius, height) turned."""
    return (f"p = [occ.addPoint(r, 0, z) for r, z in {profile}]\n"
            "loop = occ.addCurveLoop([occ.addLine(a, b) for a, b in zip(p, p[1:] + p[:1])])\n"
            f"made = occ.revolve([(2, occ.addPlaneSurface([loop]))], 0, 0, 0, 0, 0, 1, {angle})\n")


def volume_of(profile):
    """Of the polygon turned by a full turn: the sum of frusta."""
    (r, z), (s, w) = np.array(profile, float).T, np.roll(np.array(profile, float), -1, axis=0).T
    return np.pi / 3 * ((r * r + r * s + s * s) * (w - z)).sum()


SHAFT = [(0, 0), (9, 0), (10, 1), (10, 18), (9, 18), (9, 20), (10, 20), (10, 30), (15, 30), (15, 45), (0, 45)]
PULLEY = [(8, 0), (20, 0), (20, 4), (50, 4), (50, 8), (42, 12), (42, 16), (50, 20), (50, 24), (20, 24), (20, 30),
          (8, 30)]
BORES = [(6, 0), (12, 0), (12, 20), (4, 20), (4, 12), (6, 8)]
DRILLED = [(0, 0), (10, 0), (10, 24), (3, 24), (3, 10), (0, 8)]
HOLLOW = "occ.cut([(3, occ.addSphere(0, 0, 0, 4))], [(3, occ.addSphere(0, 0, 0.4, 2))])"
HALVES = ("gmsh.option.setNumber('Geometry.OCCUnionUnify', 0)\n"
          f"halves = [occ.addCylinder(0, 0, 0, 0, 0, 9, 5, angle={np.pi}) for _ in range(2)]\n"
          f"occ.rotate([(3, halves[1])], 0, 0, 0, 0, 0, 1, {np.pi})\nocc.fuse([(3, halves[0])], [(3, halves[1])])")
TILTED = "occ.rotate([x for x in made if x[0] == 3], 1, 2, 3, 3, 1, 2, 0.8)"

# name: (solid, size, faces, worst scaled Jacobian, mean, volume)
SOLIDS = {"shaft": (turned(SHAFT), 5.0, 10, 0.6, 0.85, volume_of(SHAFT)),
          "pulley": (turned(PULLEY), 8.0, 12, 0.7, 0.9, volume_of(PULLEY)),
          "bores": (turned(BORES), 3.0, 6, 0.65, 0.9, volume_of(BORES)),
          "drilled": (turned(DRILLED), 4.0, 5, 0.5, 0.85, volume_of(DRILLED)),
          "hollow ball": (HOLLOW, 1.2, 2, 0.5, 0.85, 4 / 3 * np.pi * (64 - 8)),
          "torus": ("occ.addTorus(0, 0, 0, 5, 1.2)", 1.3, 1, 0.6, 0.85, 2 * np.pi ** 2 * 5 * 1.44),
          "two halves": (HALVES, 3.0, 6, 0.6, 0.9, np.pi * 25 * 9)}


@pytest.mark.parametrize("name", SOLIDS)
def test_turned_parts(tmp_path, name):
    build, size, faces, worst, mean, volume = SOLIDS[name]
    mesh = hexcon.mesh_solid(cad_file(build, tmp_path / "solid.brep"), size, surface_method="revolved")
    surface = mesh.surface
    assert mesh.certificate.certified and not faults(mesh.points, mesh.hexes, surface.quads, surface.points)
    assert (mesh.method, surface.method) == ("proposal", "revolved")
    assert set(surface.face_of_quad) == set(range(1, faces + 1))
    assert mesh.quality.min > worst and mesh.quality.mean > mean
    assert abs(enclosed(surface) / volume - 1.0) < 0.0101
    assert any(note.startswith("revolved about ") for note in surface.notes)


def test_auto_takes_it_about_any_axis(tmp_path):
    surface = surface_from_solid(cad_file(turned(DRILLED) + TILTED, tmp_path / "solid.brep"), 4.0)
    assert surface.method == "revolved" and len(set(surface.face_of_quad)) == 5
    rings = [note for note in surface.notes if "revolved about (" in note]
    assert len(rings) == 1 and "round" in rings[0]
    again = surface_from_solid(tmp_path / "solid.brep", 4.0, "revolved")
    assert np.array_equal(surface.points, again.points) and np.array_equal(surface.quads, again.quads)


@pytest.mark.parametrize("off,count", [(0.0, 28), (-0.004, 36), (0.004, 24), (-0.0099, 256), (-0.02, 12), (0.02, 12)])
def test_the_number_round_is_finite(off, count):
    """Also where the section's chords alone cut more of the volume than all may."""
    class Rod:
        faces, boundary = [1], {1: [1]}

        def area(self, face):
            return 1.0

        def edge_points(self, edge, shares):
            return np.array([[1.0, 0.0, z] for z in shares])
    axis = Axis.through(np.zeros(3), np.array([0.0, 0.0, 1.0]))
    assert surface._number_round(Rod(), axis, None, SizeField(0.5), off, 4) == count


ROD = "[(3, occ.addCylinder(0, 0, 0, 0, 0, 9, 5))]"
REFUSED = {"box": ("occ.addBox(0, 0, 0, 1, 2, 3)", "no face or edge has an axis"),
           "part of a turn": (turned(PULLEY, 2.0), "across"),
           "cross hole": (f"occ.cut({ROD}, [(3, occ.addCylinder(-9, 0, 5, 18, 0, 0, 1))])", "another axis"),
           "bore beside": (f"occ.cut({ROD}, [(3, occ.addCylinder(1, 0, 0, 0, 0, 9, 2))])", "beside")}


@pytest.mark.parametrize("name", REFUSED)
def test_others_are_refused_with_the_face(tmp_path, name):
    build, words = REFUSED[name]
    with pytest.raises(ToolError, match=words) as caught:
        surface_from_solid(cad_file(build, tmp_path / "solid.brep"), 2.0, "revolved")
    assert caught.value.code is FaultCode.NOT_REVOLVED

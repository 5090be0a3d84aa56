# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blends of layered solids by sheets, on .brep files: certified hexes, points on the blends, every face with quads."""
import pytest
from cell_surfaces import cad_file
from mesh_checker import enclosed, faults

import hexcon

ROUNDED = """{body}
occ.synchronize()
occ.fillet([1], [e for _, e in gmsh.model.getEntities(1) if {wanted}(*gmsh.model.getBoundingBox(1, e))], [{radius}])"""
BOX = "occ.addBox(0, 0, 0, 12, 10, 6)"
BOSS = "occ.fuse([(3, occ.addBox(0, 0, 0, 16, 16, 3))], [(3, occ.addCylinder(8, 8, 1, 0, 0, 9, 3.5))])"
TOP = "(lambda x, y, z, u, v, w: z > 5.9)"
FOOT = "(lambda x, y, z, u, v, w: abs(z - 3) + abs(w - 3) < 0.1 and 1 < u - x < 8)"
FOOT_AND_RIM = "(lambda x, y, z, u, v, w: w - z < 0.1 and z > 2.9 and 1 < u - x < 8)"
EVERY = "(lambda *box: True)"
RIB = ("occ.cut(occ.fuse([(3, occ.addBox(0, 0, 0, 12, 4, 6))], [(3, occ.addCylinder(0, 2, 6, 12, 0, 0, 2))])[0], "
       "[(3, occ.addCylinder(7, 2, -1, 0, 0, 20, 0.8))])")


def rounded(body, wanted, radius):
    return ROUNDED.format(body=body, wanted=wanted, radius=radius)


# name: (solid, CAD faces, those of blends, worst scaled Jacobian, mean)
SOLIDS = {"rim of half the size": (rounded(BOX, TOP, 0.5), 10, 4, 0.6, 0.93),
          "rim of the size": (rounded(BOX, TOP, 1.0), 10, 4, 0.6, 0.93),
          "rim of two sizes": (rounded(BOX, TOP, 2.0), 10, 4, 0.6, 0.93),
          "rim of four sizes": (rounded(BOX, TOP, 4.0), 10, 4, 0.6, 0.9),
          "foot": (rounded(BOSS, FOOT, 2.0), 9, 1, 0.7, 0.93),
          "foot and rim": (rounded(BOSS, FOOT_AND_RIM, 1.5), 10, 2, 0.7, 0.93),
          "every edge": (rounded(BOX, EVERY, 2.0), 26, 16, 0.6, 0.93),
          "hole in a full round": (RIB, 7, 1, 0.6, 0.93)}


@pytest.mark.parametrize("name", SOLIDS)
def test_blends(tmp_path, name):
    build, faces, count, worst, mean = SOLIDS[name]
    mesh = hexcon.mesh_solid(cad_file(build, tmp_path / "solid.brep"), 1.0, surface_method="layered")
    surface = mesh.surface
    assert mesh.certificate.certified and not faults(mesh.points, mesh.hexes, surface.quads, surface.points)
    assert set(surface.face_of_quad) == set(range(1, faces + 1))
    assert mesh.quality.min > worst and mesh.quality.mean > mean
    assert abs(surface.fit.volume) < 0.02 and enclosed(surface) > 0.0
    assert any(f"{count} blend{'s' * (count > 1)} by sheets" in note for note in surface.notes)

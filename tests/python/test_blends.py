# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blends of layered solids by sheets, on .brep files: certified hexes, points on the blends, every face with quads."""
import numpy as np
import pytest
from cell_surfaces import cad_file
from mesh_checker import enclosed, faults

import hexcon

ROUNDED = """{body}
occ.synchronize()
occ.fillet([1], [e for _, e in gmsh.model.getEntities(1) if {wanted}(*gmsh.model.getBoundingBox(1, e))], [{radius}])"""
BOX = "occ.addBox(0, 0, 0, 10, 9, 5)"
BOSS = "occ.fuse([(3, occ.addBox(0, 0, 0, 16, 16, 3))], [(3, occ.addCylinder(8, 8, 1, 0, 0, 9, 3.5))])"
TOP = "(lambda x, y, z, u, v, w: z > 4.9)"
FOOT_AND_RIM = "(lambda x, y, z, u, v, w: w - z < 0.1 and z > 2.9 and 1 < u - x < 8)"
EVERY = "(lambda *box: True)"
RIB = ("occ.cut(occ.fuse([(3, occ.addBox(0, 0, 0, 12, 4, 6))], [(3, occ.addCylinder(0, 2, 6, 12, 0, 0, 2))])[0], "
       "[(3, occ.addCylinder(7, 2, -1, 0, 0, 20, 0.8))])")


def rounded(body, wanted, radius):
    return ROUNDED.format(body=body, wanted=wanted, radius=radius)


# name: (solid, CAD faces, those of blends, worst scaled Jacobian, mean)
SOLIDS = {"rim of half the size": (rounded(BOX, TOP, 0.5), 10, 0, 0.5, 0.9),
          "rim of two sizes": (rounded(BOX, TOP, 2.0), 10, 4, 0.6, 0.93),
          "rim of four sizes": (rounded(BOX, TOP, 4.0), 10, 4, 0.6, 0.9),
           "foot and rim": (rounded(BOSS, FOOT_AND_RIM, 1.5), 10, 2, 0.7, 0.93),
          "every edge": (rounded(BOX, EVERY, 2.0), 26, 16, 0.6, 0.93),
          "hole in a full round": (RIB, 7, 1, 0.6, 0.93)}


def random_rim(seed):
    """(A block turned at random with its upper edges rounded, the radius)."""
    rng = np.random.default_rng(seed)
    (x, y), z, radius = rng.uniform(6, 8, 2), rng.uniform(4, 5), rng.uniform(0.5, 2.5)
    body = rounded(f"occ.addBox(0, 0, 0, {x}, {y}, {z})", f"(lambda *box: box[2] > {z} - 0.1)", radius)
    return f"{body}\nocc.rotate([(3, 1)], 0, 0, 0, {', '.join(map(str, rng.uniform(-1, 1, 4)))})", (x, y, z), radius


@pytest.mark.parametrize("seed", [0])
def test_random_rims(tmp_path, seed):
    """Whatever the size and the turn: certified, every face has quads, the volume is that of the rounded block."""
    build, (x, y, z), radius = random_rim(seed)
    mesh = hexcon.mesh_solid(cad_file(build, tmp_path / "solid.brep"), 1.0, surface_method="layered")
    assert mesh.certificate.certified and not faults(mesh.points, mesh.hexes, mesh.surface.quads, mesh.surface.points)
    assert set(mesh.surface.face_of_quad) == set(range(1, 11)) and mesh.quality.min > 0.4
    quarter = (1 - np.pi / 4) * radius ** 2        # what a fillet takes away across it, beyond the mitres
    mitre = radius ** 3 * (5 / 3 - np.pi / 2)      # of each corner: both fillets take it away
    exact = x * y * z - 2 * (x + y) * quarter + 4 * mitre
    assert abs(enclosed(mesh.surface) / exact - 1.0) < 0.02


@pytest.mark.parametrize("name", SOLIDS)
def test_blends(tmp_path, name):
    build, faces, count, worst, mean = SOLIDS[name]
    mesh = hexcon.mesh_solid(cad_file(build, tmp_path / "solid.brep"), 1.0, surface_method="layered")
    surface = mesh.surface
    assert mesh.certificate.certified and not faults(mesh.points, mesh.hexes, surface.quads, surface.points)
    assert set(surface.face_of_quad) == set(range(1, faces + 1))
    assert mesh.quality.min > worst and mesh.quality.mean > mean
    assert abs(surface.fit.volume) < 0.02 and enclosed(surface) > 0.0
    told = f"{count} blend{'s' * (count > 1)} by sheets" if count else "layers, "
    assert any(told in note for note in surface.notes) and bool(count) == any("by sheets" in n for n in surface.notes)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies with holes through them, whose handles method sheets cuts by layers of hexes."""
import mesh_checker
import numpy as np
import pytest
from cut_surfaces import drilled_cube, knot, plate, random_lattice, torus
from surfaces import annulus, permuted, picture, prism, upright

import hexcon_native as hn


def checked(surface, **options):
    mesh = hn.mesh(*surface, "sheets", pillow="never", core=False, **options)
    assert mesh.certificate.certified and mesh.method == "sheets"
    assert mesh_checker.faults(mesh.points, mesh.hexes, surface[1], surface[0]) == []
    return mesh


BODIES = {"tube": (prism(annulus(12, 2), np.arange(4.0), upright), 1, 72, 0.9),
          "ring": (torus(24, 16), 1, 24 * 32, 0.8), "odd ring": (torus(11, 8), 1, 44, 0.5),
          "knot": (knot(80, 8), 1, 320, 0.5), "knot 5 2": (knot(120, 8, 2, 5), 1, 480, 0.3),
          "two holes": (prism(picture("#####", "#.#.#", "#####"), np.arange(3.0), upright), 2, 26, 0.99),
          "drilled cube": (drilled_cube()[0], 5, 20, 0.99), "finer": (drilled_cube(2)[0], 5, 160, 0.99)}


@pytest.mark.parametrize("name", BODIES)
def test_bodies(name):
    """At most as many hexes as in the mesh that whoever made the surface had in mind."""
    surface, cuts, hexes, worst = BODIES[name]
    mesh = checked(surface)
    assert mesh.report["cuts"] == cuts and mesh.quality.min > worst
    assert len(mesh.hexes) <= hexes


@pytest.mark.parametrize("holes", [1, 2, 5, 12, 30])
@pytest.mark.parametrize("finer", [1, 2])
def test_plates(holes, finer):
    surface, cubes = plate(holes, finer)
    mesh = checked(surface)
    assert mesh.report["cuts"] == holes and len(mesh.hexes) == cubes and mesh.quality.min > 0.99


@pytest.mark.parametrize("seed", range(6))
def test_random_lattices(seed):
    rng = np.random.default_rng(seed)
    surface, cubes = random_lattice(rng)
    genus = 1 - (len(surface[0]) - len(surface[1])) // 2
    mesh = checked(permuted(surface, rng))
    assert mesh.report["cuts"] == genus >= 1
    assert cubes <= len(mesh.hexes) <= 1.5 * cubes


def placed(mesh):
    """Hexes by where their corners are, sorted."""
    corners = mesh.points[mesh.hexes].view("f8,f8,f8")[..., 0]
    return np.sort(np.sort(corners, axis=1).view("V192")[:, 0])


def test_numbers_and_threads_change_nothing():
    surface = drilled_cube(2)[0]
    first = checked(surface, threads=1)
    rng = np.random.default_rng(4)
    for threads in (1, 2):
        other = checked(permuted(surface, rng), threads=threads)
        assert placed(first).tobytes() == placed(other).tobytes()


def test_what_cannot_be_cut():
    """Rows round the tube that are one helix close no disc."""
    points, quads = torus(8, 5)
    last = quads % 5 == 0
    shifted = np.where(last & (np.arange(len(quads)) % 5 == 4)[:, None], (quads + 5) % len(points), quads)
    i, j = np.divmod(np.arange(len(points)), 5)
    u, v = 2 * np.pi * (i + j / 5) / 8, 2 * np.pi * j / 5
    points = np.column_stack([(3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)])
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(points, shifted, "sheets", core=False)
    assert fault.value.code is hn.ErrorCode.NO_SHEETS and "0 go round a handle" in str(fault.value)


def test_auto_takes_it():
    mesh = hn.mesh(*drilled_cube(2)[0])
    assert mesh.method == "sheets" and len(mesh.hexes) == 160

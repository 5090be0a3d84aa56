# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a solid in FreeCAD to a certified hex mesh: hexcon.mesh_solid, judged from outside.

Quality is measured against what cannot be bettered. The caps are those of the mesh itself, found
from its hexes (a grid is a sweep in three ways: of those with the reported counts the one with
the best worst cap quad counts). Where the given surface alone decides a hex corner (all its edges
end on the surface), that is the other bound.
"""
import functools
import pathlib
import sys

import numpy as np
import pytest
import quads_solids
from quads_checks import assert_on_faces
from quads_solids import Part
from random_solids import random_solid
from sweep_checks import corner_bound, sweeps_of, worst_cap_quad

import hexcon

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "python"))
import mesh_checker  # noqa: E402
from surfaces import permuted  # noqa: E402

EXAMPLES = ROOT / "resources" / "examples"
SOLIDS = {name: (maker, sizes) for name, (maker, sizes, _) in quads_solids.BRIEF.items()}
SOLIDS["bracket example"] = (lambda: Part.read(str(EXAMPLES / "bracket.step")), (8, 5, 3))
CASES = [(name, size) for name, (_, sizes) in SOLIDS.items() for size in sizes]
MORE = [(name, size) for name, (_, sizes, _) in quads_solids.MORE.items() for size in sizes]
RANDOM = [(kind, seed) for kind, count in (("frustum", 20), ("prism", 10), ("sheared", 10),
                                           ("plate", 8)) for seed in range(count)]
RANDOM.append(("plate", 117))  # gmsh folds its first cap mesh over: another has to be taken
HEADER = "solid             size quads  cap x rings  hexes  cap SJ   min SJ  ratio   mean   bound"


@functools.cache
def meshed(name, size):
    """(shape, mesh) of one of CASES."""
    shape = SOLIDS[name][0]()
    return shape, hexcon.mesh_solid(shape, size)


@pytest.fixture(scope="module")
def table(tmp_path_factory):
    """A list for rows of figures; the file it goes to is named at the end (pytest -s)."""
    rows = [HEADER]
    yield rows
    path = tmp_path_factory.mktemp("end_to_end") / "table.txt"
    path.write_text("\n".join(rows) + "\n")
    print(f"\n{path.read_text()}(this table: {path})")


def assert_sound(mesh, shape):
    """All that holds for every mesh: proof, boundary, points, CAD faces, counts; returns Caps."""
    assert mesh.certificate.certified and mesh.method == "swept"
    surface = mesh.surface
    assert not mesh_checker.faults(mesh.points, mesh.hexes, surface.quads, surface.points)
    assert np.array_equal(mesh.quads, surface.quads)
    assert_on_faces(mesh, shape)
    counts = int(mesh.report["cap quads"]), int(mesh.report["rings"])
    assert len(mesh.hexes) == counts[0] * counts[1]
    sweeps = [s for s in sweeps_of(mesh) if (len(s.near), s.rings) == counts]
    assert sweeps, "the hexes are no sweep with the reported counts"
    return max(sweeps, key=lambda caps: worst_cap_quad(mesh, caps))


def figures(mesh, caps, name, size, table):
    """(worst cap quad, bound of the surface), and a row of the table."""
    cap, bound, quality = worst_cap_quad(mesh, caps), corner_bound(mesh), mesh.quality
    table.append(f"{name:17} {size:4.3g} {len(mesh.quads):5} {len(caps.near):4} x {caps.rings:<5} "
                 f"{len(mesh.hexes):6}  {cap:.4f}  {quality.min:.4f}  {quality.min / cap:.4f}  "
                 f"{quality.mean:.4f}  {bound:.4f}")
    return cap, bound


@pytest.mark.parametrize("name,size", CASES)
def test_solid(name, size, table):
    shape, mesh = meshed(name, size)
    caps = assert_sound(mesh, shape)
    assert mesh.surface.method == "sweep"
    assert mesh.quality.min >= 0.9 * min(figures(mesh, caps, name, size, table))


def assert_near_the_bounds(shape, name, size, table):
    mesh = hexcon.mesh_solid(shape, size)
    caps = assert_sound(mesh, shape)
    assert mesh.quality.min >= 0.9 * min(figures(mesh, caps, name, size, table))


@pytest.mark.parametrize("name,size", MORE)
def test_other_solid(name, size, table):
    """Bends, springs, lofts and the like: walls that lean make hexes that lean."""
    assert_near_the_bounds(quads_solids.MORE[name][0](), name, size, table)


@pytest.mark.parametrize("kind,seed", RANDOM)
def test_random_solid(kind, seed, table):
    """Steep frusta and strong shears have corners that the surface alone makes oblique."""
    shape, size = random_solid(kind, seed)
    assert_near_the_bounds(shape, f"{kind} {seed}", size, table)


def sorted_centroids(mesh):
    """(H,3), in the order of their projections on a direction that nothing is aligned with."""
    centroids = mesh.points[mesh.hexes].mean(axis=1)
    return centroids[np.argsort(centroids @ (0.4123, 0.7071, 0.5738), kind="stable")]


@pytest.mark.parametrize("name,size", CASES)
def test_numbering_does_not_matter(name, size):
    shape, mesh = meshed(name, size)
    rng = np.random.default_rng(len(mesh.quads))
    surface = permuted((mesh.surface.points, mesh.surface.quads), rng)
    again = hexcon.mesh_surface(*surface)
    assert again.certificate.certified and len(again.hexes) == len(mesh.hexes)
    apart = np.abs(sorted_centroids(again) - sorted_centroids(mesh)).max()
    assert apart < 1e-9 * shape.BoundBox.DiagonalLength
    assert again.quality.min == pytest.approx(mesh.quality.min, abs=1e-9)

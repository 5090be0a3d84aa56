# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface method `layered` on .brep files: certified hexes, exact edges, every face with quads of its own."""
import numpy as np
import pytest
from cell_surfaces import cad_file
from mesh_checker import enclosed, faults

import hexcon
from hexcon.errors import FaultCode, ToolError
from hexcon.quads import surface_from_solid
from hexcon.quads.gmsh_worker.layered.divisions import divide
from hexcon.quads.gmsh_worker.layered.fault import NotLayered

PLATE = "(3, occ.addBox(0, 0, 0, 8, 6, 1))"
BOSS = (f"occ.cut(occ.fuse([{PLATE}], [(3, occ.addCylinder(3, 3, 0, 0, 0, 3, 1.5))])[0], "
        "[(3, occ.addCylinder(3, 3, -1, 0, 0, 5, 0.7))])")
# a slot above and one below, crossing in the plane, with a web between
CROSSED = ("occ.cut([(3, occ.addBox(0, 0, 0, 6, 6, 3))], [(3, occ.addBox(2, -1, 2, 2, 8, 2)), "
           "(3, occ.addBox(-1, 2, -1, 8, 2, 2))])")
STEPS = ("occ.fuse([(3, occ.addBox(0, 0, 0, 6, 4, 1))], [(3, occ.addBox(0, 0, 1, 4, 4, 1)), "
         "(3, occ.addBox(0, 0, 2, 2, 2.5, 1))])")
DRILLED = ("occ.cut([(3, occ.addBox(0, 0, 0, 6, 6, 5))], [(3, occ.addCylinder(3, 3, 2, 0, 0, 4, 1.2)), "
           "(3, occ.addCone(3, 3, 1.2, 0, 0, 0.8, 0, 1.2))])")
HOLLOW = "occ.cut([(3, occ.addBox(0, 0, 0, 5, 5, 4))], [(3, occ.addBox(1, 1, 1, 2, 2, 2))])"
TABLE = (f"occ.fuse([{PLATE}], [(3, occ.addBox(x, y, -3, 1.5, 1.5, 3)) for x in (0, 6.5) for y in (0, 4.5)])")

# name: (solid, size, faces, worst scaled Jacobian, mean, volume)
SOLIDS = {"boss": (BOSS, 1.0, 9, 0.6, 0.85, 48 + np.pi * 1.5 ** 2 * 2 - np.pi * 0.49 * 3),
          "crossed slots": (CROSSED, 1.0, 14, 0.99, 0.99, 108 - 2 * 12.0),
          "steps": (STEPS, 1.0, 11, 0.7, 0.9, 24 + 16 + 5.0),
          "drilled": (DRILLED, 1.0, 8, 0.5, 0.85, 180 - np.pi * 1.44 * (3 + 1.2 / 3)),
          "hollow": (HOLLOW, 1.0, 12, 0.6, 0.75, 100 - 8.0),
          "table": (TABLE, 1.0, 18, 0.7, 0.9, 48 + 4 * 2.25 * 3)}


@pytest.mark.parametrize("name", SOLIDS)
def test_solids(tmp_path, name):
    build, size, faces, worst, mean, exact = SOLIDS[name]
    mesh = hexcon.mesh_solid(cad_file(build, tmp_path / "solid.brep"), size)
    surface = mesh.surface
    assert (mesh.method, surface.method) == ("proposal", "layered")
    assert mesh.certificate.certified and not faults(mesh.points, mesh.hexes, surface.quads, surface.points)
    assert set(surface.face_of_quad) == set(range(1, faces + 1))
    assert mesh.quality.min > worst and mesh.quality.mean > mean
    assert abs(enclosed(surface) / exact - 1.0) < (1e-9 if "Cyl" not in build else 0.03)
    assert any(note.startswith("layered along z") for note in surface.notes)


def test_edges_are_kept(tmp_path):
    """Of a plate with a boss, turned out of the axes: points between quads of different faces lie on the two circles of
    the boss, the two of the hole, or on an edge of the plate."""
    build = f"occ.rotate({BOSS}[0], 0, 0, 0, 1, 2, 3, 0.7)"
    surface = surface_from_solid(cad_file(build, tmp_path / "solid.brep"), 1.0, "layered")
    k = np.array([1.0, 2.0, 3.0]) / np.sqrt(14.0)
    p = surface.points
    p = p * np.cos(-0.7) + np.cross(k, p) * np.sin(-0.7) + np.outer(p @ k, k) * (1 - np.cos(0.7))
    ring = np.stack([surface.quads, np.roll(surface.quads, -1, axis=1)], -1).reshape(-1, 2)
    face = dict(zip(map(tuple, ring.tolist()), np.repeat(surface.face_of_quad, 4).tolist()))
    sharp = {v for edge, f in face.items() if face[edge[::-1]] != f for v in edge}
    r = np.hypot(p[:, 0] - 3, p[:, 1] - 3)
    on = {"boss": np.isclose(r, 1.5) & (np.isclose(p[:, 2], 1) | np.isclose(p[:, 2], 3)),
          "hole": np.isclose(r, 0.7) & (np.isclose(p[:, 2], 0) | np.isclose(p[:, 2], 3))}
    plate = sum(np.isclose(p[:, axis], side).astype(int) for axis, sides in enumerate(((0, 8), (0, 6), (0, 1)))
                for side in sides) >= 2
    assert sharp == set(np.flatnonzero(on["boss"] | on["hole"] | plate))
    assert on["boss"].sum() >= 16 and on["hole"].sum() >= 16 and plate.sum() > 30


def test_the_mesh_does_not_change(tmp_path):
    path = cad_file(DRILLED, tmp_path / "solid.brep")
    one, other = (surface_from_solid(path, 1.0, "layered") for _ in range(2))
    assert np.array_equal(one.points, other.points) and np.array_equal(one.quads, other.quads)
    assert np.array_equal(one.hexes[0], other.hexes[0]) and np.array_equal(one.hexes[1], other.hexes[1])


@pytest.mark.parametrize("build,words", [
    ("occ.addTorus(0, 0, 0, 3, 1)", "no direction"),
    ("occ.cut([(3, occ.addBox(0, 0, 0, 6, 6, 6))], [(3, occ.addCylinder(3, 3, -1, 0, 0, 8, 1)), "
     "(3, occ.addCylinder(3, -1, 3, 0, 4, 0, 1))])", "no direction")])
def test_others_are_refused(tmp_path, build, words):
    with pytest.raises(ToolError) as caught:
        surface_from_solid(cad_file(build, tmp_path / "solid.brep"), 1.0, "layered")
    assert caught.value.code is FaultCode.NOT_LAYERED and words in str(caught.value) and "Face" in str(caught.value)


def test_a_thin_wall_is_divided_finely_there_only(tmp_path):
    """A hole 0.1 from a side of a plate, where elements are of 1: chords of the size would cross the side."""
    build = f"occ.cut([{PLATE}], [(3, occ.addCylinder(1.6, 3, -1, 0, 0, 5, 1.5))])"
    mesh = hexcon.mesh_solid(cad_file(build, tmp_path / "solid.brep"), 1.0, surface_method="layered")
    surface = mesh.surface
    assert mesh.certificate.certified and not faults(mesh.points, mesh.hexes, surface.quads, surface.points)
    assert mesh.quality.min > 0.5 and len(mesh.hexes) < 150 and set(surface.face_of_quad) == set(range(1, 8))
    left = np.unique(np.round(surface.points[np.abs(surface.points[:, 0]) < 1e-9, 1], 9))
    steps, middles = np.diff(left), (left[1:] + left[:-1]) / 2
    assert steps[np.abs(middles - 3.0) < 0.5].max() < 0.5 < steps[np.abs(middles - 3.0) > 2.0].min()


def test_it_can_be_cancelled(tmp_path):
    class Stop(Exception):
        pass

    def progress(stage, fraction):
        if stage == "levels":
            raise Stop
    with pytest.raises(Stop):
        surface_from_solid(cad_file(BOSS, tmp_path / "solid.brep"), 0.25, "layered", progress=progress)


def test_numbers_of_intervals():
    """Even round a loop of four pieces, alike on opposite sides, as held; what cannot be is refused."""
    ideal, least = np.array([3.2, 2.0, 4.9, 2.4]), np.array([1, 1, 1, 1])
    loop, opposite = ({0: 1, 1: 1, 2: 1, 3: 1}, 2, None), [({0: 1, 2: -1}, 0, 1.5), ({1: 1, 3: -1}, 0, 1.5)]
    found = divide(ideal, least, [loop, *opposite])
    assert found[0] == found[2] and found[0] in (3, 4, 5) and found.tolist()[1::2] == [2, 2]
    assert divide(ideal, least, [loop]).tolist() == [3, 2, 5, 2]
    assert divide(ideal, least, [loop, *opposite], step=2).tolist() == [4, 2, 4, 2]
    long, short = divide(np.array([10.0, 1.0]), least[:2], [({0: 1, 1: -1}, 0, 50.0), ({0: 1, 1: 1}, 2, None)])
    assert long == short >= 5       # rather more short ones than intervals of twice the size
    ideal[0] = least[0] = 6
    held = divide(ideal, least, [loop, *opposite], held={0: 6})
    assert held[0] == 6 and held.sum() % 2 == 0
    with pytest.raises(NotLayered, match="intervals"):
        divide(ideal, least, [({0: 1}, 0, None)], held={0: 6})

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Given hex meshes smoothed on their solid: points stay on it, and no mesh comes out worse."""
import json
import pathlib
import subprocess
import sys

import numpy as np
import pytest
from mesh_checker import boundary_faults
from sliding_bodies import body

import hexcon
import hexcon_native as hn
from hexcon.errors import FaultCode
from hexcon.files import read_mesh

ROOT = pathlib.Path(__file__).resolve().parents[2]
MAKE_SOLIDS = """
import gmsh, sys
gmsh.initialize([], False)
gmsh.option.setNumber("General.Terminal", 0)
occ = gmsh.model.occ
if sys.argv[1] == "box":
    occ.addBox(0, 0, 0, 1, 1, 1)
else:
    wall = occ.cut([(3, occ.addCylinder(0, 0, 0, 0, 0, 1, 2))], [(3, occ.addCylinder(0, 0, 0, 0, 0, 1, 1))])[0]
    occ.intersect(wall, [(3, occ.addBox(0, 0, 0, 3, 3, 1))])
occ.synchronize()
gmsh.write(sys.argv[2])
"""


@pytest.fixture(scope="module")
def solids(tmp_path_factory):
    """name: path of a .brep file; "cube" and "pipe" are those of sliding_bodies."""
    folder = tmp_path_factory.mktemp("solids")
    made = {}
    for name, shape in (("cube", "box"), ("pipe", "pipe")):
        made[name] = str(folder / f"{name}.brep")
        subprocess.run([sys.executable, "-c", MAKE_SOLIDS, shape, made[name]], check=True, timeout=60)
    return made


class Given:
    """A mesh of a body whose points were moved along what they lie on, so that it is poor."""

    def __init__(self, name, n, part, seed):
        self.points, self.hexes, self.carrier_of_point, self.carriers = body(name, n)
        rng = np.random.default_rng(seed)
        moved = self.points + rng.uniform(-part, part, self.points.shape) / n
        self.points = hn.project_points(moved, self.carrier_of_point, self.carriers)[0]


def off_carriers(given, points):
    return np.abs(hn.project_points(points, given.carrier_of_point, given.carriers)[0] - points).max()


@pytest.mark.parametrize(("name", "part"), [("cube", 0.25), ("pipe", 0.4)])
def test_poor_meshes_come_right(solids, name, part):
    given = Given(name, 4, part, 1)
    found = hexcon.smooth(given, solids[name])
    assert found.improved and found.certificate.certified
    assert found.quality.min > 0.9 > 0.6 > found.before.min
    assert off_carriers(given, found.points) < 1e-12
    assert (np.bincount(found.dimension) == [8, 36, 54, 27]).all()
    assert not len(found.kept) and not found.notes
    assert set(found.face_of_quad) == set(range(1, 7))
    assert boundary_faults(found.hexes, found.quads) == []


def test_a_good_mesh_stays(solids):
    given = Given("cube", 3, 0.0, 1)
    found = hexcon.smooth(given, solids["cube"])
    assert not found.improved
    assert (found.points == given.points).all()


def test_points_a_little_off_are_put_on(solids):
    given = Given("pipe", 4, 0.3, 2)
    rng = np.random.default_rng(3)
    given.points += rng.uniform(-1e-4, 1e-4, given.points.shape)
    found = hexcon.smooth(given, solids["pipe"])
    assert found.improved and off_carriers(given, found.points) < 1e-12
    assert 1e-5 < found.off.max() < 3e-4
    with pytest.raises(hexcon.HexconError) as caught:
        hexcon.smooth(given, solids["pipe"], tolerance=1e-6)
    assert caught.value.code == FaultCode.NOT_ON_SOLID


def test_strays_are_refused_or_kept(solids):
    given = Given("cube", 4, 0.2, 4)
    stray = int(
        np.flatnonzero([k >= 0 and given.carriers[k].kind == "plane" for k in given.carrier_of_point])[5])
    given.points[stray] += 0.04 / np.sqrt(3)
    with pytest.raises(hexcon.HexconError) as caught:
        hexcon.smooth(given, solids["cube"])
    assert caught.value.code == FaultCode.NOT_ON_SOLID and list(caught.value.elements) == [stray]
    found = hexcon.smooth(given, solids["cube"], keep=True)
    assert list(found.kept) == [stray]
    assert (found.points[stray] == given.points[stray]).all()
    given.points += 5.0
    with pytest.raises(hexcon.HexconError) as caught:
        hexcon.smooth(given, solids["cube"], keep=True)
    assert caught.value.code == FaultCode.NOT_ON_SOLID and len(caught.value.elements) == 98


@pytest.mark.parametrize("options", [{"tolerance": -1}, {"tolerance": float("nan")}, {"timeout": 0}])
def test_bad_options(solids, options):
    with pytest.raises(hexcon.HexconError) as caught:
        hexcon.smooth(Given("cube", 2, 0.0, 1), solids["cube"], **options)
    assert caught.value.code == FaultCode.BAD_OPTION


def run(*arguments):
    return subprocess.run([str(ROOT / "bin" / "hexcon"), *map(str, arguments)], capture_output=True, text=True,
                          timeout=120)


def test_command_line(solids, tmp_path):
    given = Given("pipe", 3, 0.4, 5)
    source, out = tmp_path / "given.vtu", tmp_path / "out.inp"
    hexcon.write(given, source)
    done = run("smooth", source, solids["pipe"], "-o", out, "--json")
    assert done.returncode == 0, done.stderr
    facts = json.loads(done.stdout)
    assert facts["improved"] and facts["certified"] and facts["quality"]["min"] > facts["before"]["min"]
    assert [facts["at_corners"], facts["on_edges"], facts["on_faces"]] == [8, 24, 24]
    again = read_mesh(out)
    assert off_carriers(given, again.points) < 1e-12
    assert set(again.face_of_quad) == set(range(1, 7))
    words = run("smooth", out, solids["pipe"])
    assert words.returncode == 0
    assert "boundary      8 points at corners of the solid, 24 on edges, 24 on faces" in words.stdout
    wrong = run("smooth", source, solids["cube"])
    assert wrong.returncode == 1 and "NOT_ON_SOLID" in wrong.stderr
    assert run("smooth", source, solids["pipe"], "-o", source).returncode == 1


def test_order_2_lies_on_the_solid(solids):
    given = Given("pipe", 4, 0.2, 3)
    found = hexcon.smooth(given, solids["pipe"], order=2)
    assert found.order == 2 and found.hexes.shape[1] == 20 and found.certificate.certified
    told = found.report["curved"]
    assert told["straight"] == told["reduced_count"] == 0 and abs(told["volume"] / told["cad_volume"] - 1) < 1e-4
    flat = hexcon.smooth(given, solids["pipe"])
    assert (found.points[:len(flat.points)] == flat.points).all()
    with pytest.raises(hn.HexconError) as caught:
        hexcon.smooth(given, solids["pipe"], order=3)
    assert caught.value.code is FaultCode.BAD_OPTION

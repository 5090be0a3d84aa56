# SPDX-License-Identifier: LGPL-2.1-or-later
"""bin/hexcon as a user types it: every command, format and exit status."""
import json
import os
import pathlib
import subprocess
import sys
import zipfile

import meshio
import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
from hex_grids import block  # noqa: E402
from surfaces import box, permuted, turn_edge  # noqa: E402

from hexcon import cli, files  # noqa: E402
from hexcon.quads import surface_from_file  # noqa: E402

PROGRAM = str(ROOT / "bin" / "hexcon")
WEDGE, BOX = (str(ROOT / "resources" / "examples" / name) for name in ("wedge.step", "box.step"))
MESH_ENDINGS = ("inp", "msh", "vtu", "vtk", "unv", "med")
SURFACE_ENDINGS = ("msh", "inp", "vtk", "vtu", "obj", "mesh")


def hexcon(*arguments, program=PROGRAM, **environment):
    """The finished process."""
    return subprocess.run([program, *map(str, arguments)], env=dict(os.environ, **environment),
                          stdin=subprocess.DEVNULL, capture_output=True, encoding="utf-8",
                          check=False)


def facts(*arguments, status=0, **environment):
    """What --json prints, and nothing else on standard output."""
    done = hexcon(*arguments, "--json", **environment)
    assert done.returncode == status, done.stderr
    return json.loads(done.stdout)


def surface_of(mesh):
    """(points, quads) of a hex mesh's boundary, no other points."""
    used, quads = np.unique(mesh.quads, return_inverse=True)
    return mesh.points[used], quads.reshape(-1, 4)


def put(path, points, quads):
    """Write a quad surface; returns its path as text."""
    meshio.Mesh(points, [("quad", quads)]).write(str(path))
    return str(path)


@pytest.fixture(scope="module")
def wedge(tmp_path_factory):
    """Function: path of the meshed wedge at an order, in the format of an ending."""
    folder, made = tmp_path_factory.mktemp("wedge"), {}

    def path(ending, order=1):
        if order not in made:
            outputs = [folder / f"{order}.{e}" for e in (*MESH_ENDINGS, "FCStd")]
            made[order] = facts("mesh", WEDGE, "--size", 8, "--order", order,
                                *(word for out in outputs for word in ("-o", out)))
            assert made[order]["written"] == [str(out) for out in outputs]
            assert made[order]["certificate"]["certified"] and made[order]["order"] == order
        return str(folder / f"{order}.{ending}")
    return path


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("ending", MESH_ENDINGS)
def test_a_solid_in_every_format(wedge, ending, order):
    found = facts("check", wedge(ending, order))
    assert found["certified"] and found["order"] == order
    assert (found["hexes"], found["quads"]) == (64, 112)
    below = 1e-6 if order == 1 else 0.005       # of curved hexes it is a proved bound
    assert 0.943858 - below < found["quality"]["min"] < 0.943858 + 1e-6


def test_a_document(wedge, tmp_path):
    """Out as .FCStd, with its solid; and in again, by that solid."""
    assert zipfile.is_zipfile(wedge("FCStd"))
    assert facts("mesh", wedge("FCStd"), "--size", 8, "-o", tmp_path / "x.vtu")["hexes"] == 64


def test_a_document_where_freecad_does_not_load_into_python(tmp_path):
    """Then the command runs in freecadcmd: same answer, same status."""
    elsewhere = {"FREECAD_LIB": str(tmp_path)}
    out = tmp_path / "x.FCStd"
    found = facts("mesh", WEDGE, "--size", 8, "-o", out, **elsewhere)
    assert found["hexes"] == 64 and zipfile.is_zipfile(out)
    fault = facts("mesh", out, "-o", tmp_path / "y.inp", status=1, **elsewhere)
    assert fault["code"] == "BAD_OPTION" and "--size" in fault["error"]


@pytest.mark.parametrize("ending", SURFACE_ENDINGS)
def test_a_surface_in_every_format(tmp_path, ending):
    points, quads = surface_of(block(3, 2, 2, (3.0, 2.0, 1.0)))
    out = tmp_path / "out.vtu"
    made = facts("mesh", put(tmp_path / f"s.{ending}", points, quads), "-o", out)
    assert made["hexes"] == 12 and made["certificate"]["certified"]
    assert np.array_equal(files.read_mesh(out).points[:len(points)], points)


def test_a_surface_in_unv_and_words_for_people(wedge, tmp_path):
    done = hexcon("mesh", wedge("unv"), "-o", tmp_path / "out.inp", "--method", "swept")
    assert done.returncode == 0 and not done.stderr
    for word in ("112 quads", "64 hexes", "16 cap quads x 4 rings", "scaled Jacobian min 0.9439",
                 "every Jacobian proved positive", f"written       {tmp_path / 'out.inp'}"):
        assert word in done.stdout


@pytest.mark.parametrize("arguments", [
    (), ("bake", WEDGE), ("mesh", WEDGE), ("mesh", WEDGE, "-o", "x.inp", "--size", "big"),
    ("mesh", WEDGE, "-o", "x.inp", "--order", "3"),
    ("mesh", WEDGE, "-o", "x.inp", "--method", "x"),
    ("check",), ("info", "a", "b"), ("solve", "m.inp"), ("example", "a", "b"),
    ("solve", "m.inp", "--fixed", "Face1", "--force", "Face2=1,2"),
    ("solve", "m.inp", "--fixed", "Face1", "--force", "Face2=0,0,nan"),
    ("solve", "m.inp", "--fixed", "Face1", "--pressure", "Face2"),
    ("solve", "m.inp", "--fixed", "Face1", "--pressure", "Face2=inf"),
    ("solve", "m.inp", "--fixed", "Face1", "--pressure", "Face2=1", "--merge-tolerance", "0.1")])
def test_wrong_usage(arguments):
    done = hexcon(*arguments)
    assert done.returncode == 2 and "usage" in done.stderr and not done.stdout


def test_help_and_refusals_name_every_format(tmp_path):
    """They read the tables: a new format is in them by itself."""
    said = " ".join(hexcon("mesh", "--help").stdout.split())
    assert f"decides its format: {' '.join(files.shown(files.WRITERS))} (" in said
    said = " ".join(hexcon("check", "--help").stdout.split())
    assert f"any hex mesh ({' '.join(files.shown(files.READERS))})" in said
    refused = hexcon("mesh", BOX, "--size", 9, "-o", tmp_path / "x.stl")
    assert refused.returncode == 1 and all(ending in refused.stderr for ending in files.shown(files.WRITERS))


def test_help_tells_the_exit_status():
    for command in ("mesh", "check", "repair", "smooth", "info", "example", "solve"):
        done = hexcon(command, "--help")
        assert done.returncode == 0
        assert "3 check, repair, smooth: not certified" in " ".join(done.stdout.split())


FAULTS = {
    "no file": (("mesh", "none.step", "--size", 1, "-o", "x.inp"), "FILE_IO"),
    "no surface": (("info", "none.obj"), "FILE_IO"),
    "no mesh": (("check", "none.inp"), "FILE_IO"),
    "no CAD": (("mesh", "garbage.step", "--size", 1, "-o", "x.inp"), "FILE_FORMAT"),
    "no such input": (("mesh", "part.iges", "--size", 1, "-o", "x.inp"), "FILE_IO"),
    "no size": (("mesh", WEDGE, "-o", "x.inp"), "BAD_OPTION"),
    "size below zero": (("mesh", WEDGE, "--size", -1, "-o", "x.inp"), "BAD_OPTION"),
    "ending": (("mesh", "none.step", "-o", "x.xyz"), "FILE_FORMAT"),
    "second ending": (("mesh", "none.step", "-o", "x.inp", "-o", "x"), "FILE_FORMAT"),
    "ending of results": (("solve", "none.inp", "--fixed", 1, "-o", "x.inp"), "FILE_FORMAT"),
    "folder": (("mesh", "none.step", "-o", "none/x.inp"), "FILE_IO"),
    "over the input": (("mesh", "box.vtu", "-o", "./box.vtu"), "BAD_OPTION"),
    "no such face": (("solve", "box.vtu", "--fixed", "Face9", "--force", "Face2=0,0,1"), "BAD_OPTION"),
    "no face": (("solve", "box.vtu", "--fixed", "top", "--force", "Face2=0,0,1"), "BAD_OPTION"),
    "two forces": (("solve", "box.vtu", "--fixed", 1, "--force", "Face2=0,0,1", "--force",
                    "face2=0,1,0"), "BAD_OPTION"),
    "material": (("solve", "box.vtu", "--fixed", 1, "--young", -5, "--force", "Face2=0,0,1"), "BAD_OPTION"),
    "not hexes": (("check", "quads.obj"), "FILE_FORMAT"),
    "other surface": (("check", "box.vtu", "--surface", "quads.obj"), "FILE_FORMAT"),
    "odd": (("mesh", "odd.obj", "-o", "x.inp"), "ODD"),
}


@pytest.fixture(scope="module")
def things(tmp_path_factory):
    """A folder with a mesh, surfaces and rubbish, for FAULTS."""
    folder = tmp_path_factory.mktemp("things")
    (folder / "garbage.step").write_text("no CAD at all\n")
    files.write(block(2, 1, 1), folder / "box.vtu")
    put(folder / "quads.obj", *surface_of(block(1, 1, 1, (1.0, 1.0, 3.0))))
    put(folder / "odd.obj", *odd_surface())
    return folder


def odd_surface():
    """A cube with one quad cut in two by a path from corner to corner."""
    points, quads = surface_of(block(1, 1, 1))
    (a, b, c, d), rest = quads[0].tolist(), quads[1:].tolist()
    middle = points[[a, c, d]].mean(axis=0) * 1.1 - 0.05
    return np.vstack([points, middle]), np.array([(a, b, c, 8), (a, 8, c, d), *rest])


@pytest.mark.parametrize("name", FAULTS)
def test_fault(things, name, monkeypatch):
    """Status 1, code and words; nothing is left. Wrong endings and folders are told before the
    input is even looked for."""
    arguments, code = FAULTS[name]
    before = sorted(things.iterdir())
    monkeypatch.chdir(things)
    told = facts(*arguments, status=1)
    assert told["code"] == code and told["error"]
    assert sorted(things.iterdir()) == before


def test_fault_in_words_for_people(things):
    done = hexcon("check", things / "box.vtu", "--surface", things / "quads.obj")
    assert done.returncode == 1 and not done.stdout
    assert done.stderr.startswith("hexcon: 4 points of the surface") and "[FILE_" in done.stderr
    assert "hexcon: ids: " in done.stderr and "Traceback" not in done.stderr


def test_output_that_cannot_be_written_leaves_nothing(tmp_path):
    (tmp_path / "x.inp").mkdir()
    told = facts("mesh", WEDGE, "--size", 8, "-o", tmp_path / "x.inp", status=1)
    assert told["code"] == "FILE_IO" and "x.inp" in told["error"]
    assert [p.name for p in tmp_path.rglob("*")] == ["x.inp"]


def test_interrupt(monkeypatch, capsys):
    def interrupted(*_, **__):
        raise KeyboardInterrupt
    monkeypatch.setattr(cli.commands, "read_mesh", interrupted)
    assert cli.program(["check", "x.inp"]) == 130
    assert "ended by SIGINT" in capsys.readouterr().err


def test_check_against_a_surface_numbered_otherwise(wedge, tmp_path):
    surface = surface_from_file(wedge("vtu"))
    points, quads = permuted((surface.points, surface.quads), np.random.default_rng(4))
    for ending in SURFACE_ENDINGS:
        path = put(tmp_path / f"s.{ending}", points, quads)
        assert facts("check", wedge("inp"), "--surface", path)["certified"]
    points[7] += 0.01
    told = facts("check", wedge("inp"), "--surface", put(tmp_path / "moved.vtk", points, quads),
                 status=1)
    assert told["code"] == "FILE_FORMAT" and told["elements"] == [7]


def test_check_against_the_same_points_in_other_quads(tmp_path):
    mesh = block(2, 2, 2)
    files.write(mesh, tmp_path / "m.inp")
    path = put(tmp_path / "s.vtu", *turn_edge(surface_of(mesh), 0))
    found = facts("check", tmp_path / "m.inp", "--surface", path, status=3)
    assert not found["certificate"]["boundary_exact"] and not found["certified"]
    assert "boundary exact False" in hexcon("check", tmp_path / "m.inp", "--surface", path).stdout


@pytest.mark.parametrize("order", [1, 2])
def test_check_names_the_inverted_hex(tmp_path, order):
    mesh = block(3, 1, 1)
    mesh.hexes[1] = mesh.hexes[1, [4, 5, 6, 7, 0, 1, 2, 3]]
    files.write(mesh, tmp_path / "m.vtu", order=order)
    found = facts("check", tmp_path / "m.vtu", status=3)
    assert found["certificate"]["nonpositive"] == [1]
    assert found["quality"]["min"] == pytest.approx(-1.0, abs=1e-9)
    done = hexcon("check", tmp_path / "m.vtu")
    assert done.returncode == 3 and "NOT certified" in done.stdout
    assert "not positive  hexes 1\n" in done.stdout + "\n"


def test_check_proves_curved_hexes(tmp_path):
    """An edge of the third hex alone is bent a little, then so far that it folds."""
    from hexcon.femmesh import elements_of
    curved = elements_of(block(3, 1, 1), 2)
    for bend, status in ((0.03, 0), (1.2, 3)):
        curved.points[curved.hexes[2, 9]] += (0.0, 0.0, bend)
        files.write(curved, tmp_path / "m.msh")
        found = facts("check", tmp_path / "m.msh", status=status)
        assert found["curved"] == [2] and found["certified"] is (status == 0)
        assert found["certificate"]["nonpositive"] == ([2] if status else [])
    done = hexcon("check", tmp_path / "m.msh")
    assert "curved        hexes 2" in done.stdout and "not positive  hexes 2" in done.stdout


def test_info(tmp_path):
    surface = surface_of(block(2, 2, 2))
    found = facts("info", put(tmp_path / "s.obj", *surface))
    assert (found["n"], found["points"], found["genus"], found["components"]) == (24, 26, 0, 1)
    assert found["even"] and found["bipartite"] and found["convex"] and found["embedded"] and not found["crossings"]
    assert found["volume"] == pytest.approx(1.0)
    assert found["loops"] == {"count": 6, "lengths": [8] * 6, "self_crossings": [0] * 6}
    assert "volume 1\n" in hexcon("info", tmp_path / "s.obj").stdout
    points, quads = surface
    through = points + 3.0 * (np.arange(len(points)) == 0)[:, None]      # one corner pulled out on the other side
    found, told = facts("info", put(tmp_path / "x.obj", through, quads)), hexcon("info", tmp_path / "x.obj").stdout
    assert found["embedded"] is False and found["crossings"] and found["volume"] is None
    assert "no volume: it bounds no solid" in told and "volume 1" not in told
    crossing = put(tmp_path / "crossing.obj", *turn_edge(surface, 0))
    found = facts("info", crossing)
    assert sorted(found["loops"]["self_crossings"]) == [0, 0, 0, 6] and found["even"]
    assert "4, 1 of them cross themselves (6 crossings)" in hexcon("info", crossing).stdout
    told = facts("mesh", crossing, "--method", "swept", "-o", tmp_path / "x.inp", status=1)
    assert told["code"] == "NOT_SWEPT" and told["elements"]


def test_info_names_an_odd_surface(things):
    done = hexcon("info", things / "odd.obj")
    assert done.returncode == 0 and "7 quads (ODD)" in done.stdout


def test_solve_a_mesh_file(tmp_path):
    """The cantilever of 100 x 10 x 10 mm, 100 N, order 2: 0.192 mm by Timoshenko."""
    mesh = str(tmp_path / "box.inp")
    facts("mesh", BOX, "--size", 5, "--order", 2, "-o", mesh)
    outputs = [tmp_path / "r.vtu", tmp_path / "r.vtk", tmp_path / "r.png"]
    found = facts("solve", mesh, "--fixed", "Face1", "--force", "Face2=0,0,-100",
                  *(word for out in outputs for word in ("-o", out)))
    assert found["max_displacement"] == pytest.approx(0.192, rel=0.015)
    assert found["written"] == [str(out) for out in outputs] and found["order"] == 2
    for path in outputs[:2]:
        read = meshio.read(path)
        length = np.linalg.norm(read.point_data["displacement"], axis=1)
        assert length.max() == pytest.approx(found["max_displacement"])
        assert read.point_data["von_mises"].max() == pytest.approx(found["max_von_mises"])
    assert outputs[2].read_bytes().startswith(b"\x89PNG") and outputs[2].stat().st_size > 10000


def test_solve_a_solid(tmp_path):
    """A bar under end pressure 21 MPa, fixed at the other end: about p L / E longer or shorter."""
    done = hexcon("solve", BOX, "--size", 5, "--fixed", "face1", "--pressure", "2=-21",
                  "--poisson", 0, "-o", tmp_path / "r.vtu")
    assert done.returncode == 0, done.stderr
    assert "deflection    0.01 mm at most" in done.stdout and "certificate" in done.stdout
    moved = meshio.read(tmp_path / "r.vtu").point_data["displacement"]
    assert moved[:, 0].max() == pytest.approx(0.01, rel=1e-6)


def test_a_link_on_the_path_and_the_module(tmp_path):
    (tmp_path / "hexcon").symlink_to(PROGRAM)
    surface = put(tmp_path / "s.obj", *surface_of(block(1, 1, 1)))
    assert hexcon("info", surface, program=str(tmp_path / "hexcon")).returncode == 0
    path = os.pathsep.join([str(ROOT), str(ROOT / "workbench")])
    done = hexcon("-P", "-m", "hexcon", "info", surface, program=sys.executable, PYTHONPATH=path)
    assert "6 quads (even)" in done.stdout


@pytest.mark.parametrize("method,words", [("sheets", "sheets; "), ("diced", "coarse triangles"),
                                          ("smallest", "hexes a quad"), ("cells", "pairs of quads")])
def test_mesh_says_what_every_method_counts(tmp_path, method, words):
    """Two cubes of edge 1 in each direction are diced as an octahedron too; one is the smallest surface."""
    path = put(tmp_path / "quads.obj", *box(*([1] * 3 if method == "smallest" else [2] * 3)))
    done = hexcon("mesh", path, "--method", method, "-o", tmp_path / "hexes.vtu")
    assert done.returncode == 0, done.stderr
    assert any(line.startswith("mesh ") and words in line for line in done.stdout.splitlines())

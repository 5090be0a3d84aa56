# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surfaces of the literature: the files are what the generators make, and `hexcon example` lists and writes them."""
import json
import pathlib
import subprocess
import sys

import numpy as np
import pytest
import quad_figures
from example_surfaces import GENERATORS, text_of

import hexcon
import hexcon_native as hn
from hexcon import cli, examples
from hexcon.errors import FaultCode, ToolError
from hexcon.files.surfaces import SURFACE_ENDINGS, write_surface
from hexcon.quads import surface_from_file
from hexcon.quads.figures import face_doublets, flat_corners, loop_edges

ROOT = pathlib.Path(__file__).resolve().parents[2]
QUADS = {"schneiders": 16, "octahedron": 8, "eppstein-16": 16, "eppstein-18": 18, "eppstein-20": 20,
         "eppstein-22": 22}


def run(capsys, *arguments, status=0):
    """(what the command line prints as an object, what it says on standard error)."""
    assert cli.main([*map(str, arguments), "--json"]) == status
    said = capsys.readouterr()
    return json.loads(said.out), said.err


def test_names():
    assert hexcon.example_names() == list(QUADS) == list(GENERATORS)
    assert sorted(path.stem for path in pathlib.Path(examples.FOLDER).iterdir()) == sorted(QUADS)


@pytest.mark.parametrize("name", QUADS)
def test_files_equal_their_generators(name):
    """Words and quads exactly; points but for the last bit, in which sines differ between processors."""
    surface, (points, quads) = hexcon.example(name), GENERATORS[name]()
    assert np.array_equal(surface.quads, quads)
    assert np.abs(surface.points - points).max() <= 4e-16
    written = pathlib.Path(examples.FOLDER, f"{name}.obj").read_text(encoding="utf-8")
    assert [line for line in written.splitlines() if line[0] != "v"] == \
        [line for line in text_of(name).splitlines() if line[0] != "v"]


@pytest.mark.parametrize("name", QUADS)
def test_even_closed_spheres(name):
    surface = hexcon.example(name)
    report = hn.check_surface(surface.points, surface.quads)
    assert report.n == QUADS[name] and report.points == QUADS[name] + 2
    assert report.even and report.oriented and report.convex and report.bipartite
    assert (report.components, report.genus) == (1, 0)
    assert surface.method == "given" and not surface.notes and not surface.face_of_quad.any()
    assert surface.points.dtype == np.float64 and surface.quads.dtype == np.int64


def test_doublets_and_flat_corners():
    """What no hex can stand on: the cubes that have sides with two quads, and no other, have flat corners."""
    found = {}
    for name in QUADS:
        surface = hexcon.example(name)
        doublets, corners = face_doublets(surface.quads), flat_corners(surface.points, surface.quads)
        assert np.array_equal(doublets, np.sort(quad_figures.face_doublets(surface.quads), axis=1))
        assert np.array_equal(corners, quad_figures.flat_corners(surface.points, surface.quads))
        found[name] = len(doublets), len(corners)
    assert found == {"schneiders": (0, 0), "octahedron": (0, 0), "eppstein-16": (1, 3), "eppstein-18": (0, 1),
                     "eppstein-20": (0, 0), "eppstein-22": (0, 0)}


@pytest.mark.parametrize("name", QUADS)
def test_loops_as_edges(name):
    """The core's loops, and every step goes through a quad to the next."""
    quads = hexcon.example(name).quads
    edges = np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2)
    loops = loop_edges(quads)
    for loop in loops:
        out = np.sort(edges[loop // 4 * 4 + (loop + 2) % 4], axis=1)
        assert np.array_equal(out, np.sort(edges[np.roll(loop, -1)], axis=1))

    def rings(loops):
        """Each loop as it reads from the place, and in the sense, that come first in order."""
        return sorted(min(tuple(np.roll(way, k)) for way in (loop, loop[::-1]) for k in range(len(loop)))
                      for loop in loops)
    assert rings([loop // 4 for loop in loops]) == rings(hn.loops(quads))


def test_an_unknown_name_is_told_the_known():
    with pytest.raises(ToolError, match="there is no example 'cube'.*octahedron.*eppstein-22") as raised:
        hexcon.example("cube")
    assert raised.value.code is FaultCode.BAD_OPTION


def test_missing_resources_are_told(monkeypatch, tmp_path):
    monkeypatch.setattr(examples, "FOLDER", str(tmp_path))
    with pytest.raises(ToolError, match="resources belongs beside") as raised:
        hexcon.example("schneiders")
    assert raised.value.code is FaultCode.FILE_IO


def test_numpy_is_enough(tmp_path):
    """Embedded use: neither meshio nor VTK nor FreeCAD is loaded for an example, nor to write it as .obj."""
    script = ("import sys, hexcon\n"
              "from hexcon.files.surfaces import write_surface\n"
              "write_surface(hexcon.example('schneiders'), sys.argv[1])\n"
              "assert not {'meshio', 'vtk', 'vtkmodules', 'FreeCAD'} & set(sys.modules)\n")
    subprocess.run([sys.executable, "-c", script, tmp_path / "s.obj"], check=True,
                   env={"PYTHONPATH": f"{ROOT}:{ROOT / 'workbench'}"})
    assert len(surface_from_file(tmp_path / "s.obj").quads) == 16


@pytest.mark.parametrize("ending", SURFACE_ENDINGS)
def test_surfaces_there_and_back(tmp_path, ending, capfd):
    """Every bit of every point, in every format; nothing is printed, nothing left beside."""
    for name in ("schneiders", "octahedron"):
        surface = hexcon.example(name)
        path = tmp_path / f"{name}{ending}"
        write_surface(surface, path)
        read = surface_from_file(path)
        assert np.array_equal(read.points, surface.points) and np.array_equal(read.quads, surface.quads)
    assert len(list(tmp_path.iterdir())) == 2
    said = capfd.readouterr()
    assert not said.out and not said.err


def test_faults_of_writing_a_surface(tmp_path):
    for path, code in (("s.stl", FaultCode.FILE_FORMAT), ("no/s.obj", FaultCode.FILE_IO), ("no/s.vtk", FaultCode.FILE_IO)):
        with pytest.raises(ToolError) as raised:
            write_surface(hexcon.example("schneiders"), tmp_path / path)
        assert raised.value.code is code
    assert not list(tmp_path.iterdir())


def test_the_list(capsys):
    assert cli.main(["example"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == list(QUADS)
    assert [int(line.split()[1]) for line in lines] == list(QUADS.values())
    assert "1 face doublet, 3 flat corners" in lines[2] and "no face doublets, no flat corners" in lines[0]
    told = run(capsys, "example")[0]["examples"]
    assert [one["name"] for one in told] == list(QUADS) and told[2]["face_doublets"] == [[4, 6]]


def test_a_surface_is_written(capsys, tmp_path):
    outputs = [tmp_path / "s.obj", tmp_path / "s.vtu"]
    told, said = run(capsys, "example", "eppstein-20", "-o", outputs[0], "-o", outputs[1])
    assert told["written"] == [str(path) for path in outputs] and told["quads"] == 20 and not said
    for path in outputs:
        assert np.array_equal(surface_from_file(path).quads, hexcon.example("eppstein-20").quads)


def test_a_mesh_is_written_and_the_name_is_an_input(capsys, tmp_path):
    """`hexcon example NAME --method M` is `hexcon mesh example:NAME --method M`."""
    one, other = tmp_path / "one.vtu", tmp_path / "other.vtu"
    made, _ = run(capsys, "example", "octahedron", "--method", "cells", "-o", one)
    same, _ = run(capsys, "mesh", "example:octahedron", "--method", "cells", "-o", other)
    assert made["certificate"]["certified"] and made["hexes"] == same["hexes"] == 320
    assert one.read_bytes() == other.read_bytes()
    assert run(capsys, "check", one, "--surface", "example:octahedron")[0]["certified"]
    assert run(capsys, "info", "example:octahedron")[0]["loops"]["self_crossings"] == [8]


@pytest.mark.parametrize("arguments, code, words", [
    (("example", "cube"), "BAD_OPTION", "schneiders, octahedron"),
    (("info", "example:cube"), "BAD_OPTION", "schneiders, octahedron"),
    (("mesh", "example:", "-o", "x.vtu"), "BAD_OPTION", "schneiders, octahedron"),
    (("example", "-o", "x.obj"), "BAD_OPTION", "which example"),
    (("example", "schneiders", "-o", "x.stl"), "FILE_FORMAT", ".obj"),
    (("example", "schneiders", "-o", "no/x.obj"), "FILE_IO", "folder"),
    (("example", "schneiders", "--order", 2, "-o", "x.obj"), "BAD_OPTION", "--method"),
    (("example", "schneiders", "--method", "cells"), "BAD_OPTION", "-o or --gallery"),
    (("example", "schneiders", "--method", "cells", "-o", "x.obj"), "FILE_FORMAT", ".vtu"),
    (("example", "eppstein-16", "--method", "cells", "-o", "x.vtu"), "UNFILLABLE_QUAD", "degrees")])
def test_faults(capsys, tmp_path, monkeypatch, arguments, code, words):
    monkeypatch.chdir(tmp_path)
    told, _ = run(capsys, *arguments, status=1)
    assert told["code"] == code and words in told["error"]
    assert not list(tmp_path.iterdir())

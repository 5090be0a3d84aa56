# SPDX-License-Identifier: LGPL-2.1-or-later
"""A full disk: the cause is named, and nothing is left behind.

Files may not grow beyond a few kilobytes in the processes below (RLIMIT_FSIZE), and the disk is said
to have no room: so what every program really does when a write fails is met without a disk to fill.
"""
import errno
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import pytest

from hexcon import disk
from hexcon.calculix import frd
from hexcon.errors import FaultCode, HexconError, ToolError

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = """
import collections, json, os, resource, shutil, sys, tempfile, types
sys.path[:0] = [{tests!r}]
from hex_grids import block
from hexcon import HexconError, files
import hexcon
import numpy
from hexcon.calculix import solve_inp, static_deck
from hexcon.files.surfaces import write_surface
from hexcon import example
from hexcon.pictures import gallery, render
folder = {folder!r}
tempfile.tempdir = os.path.join(folder, "temporary")
mesh = block(9, 9, 9)
deck = static_deck(mesh, None, ["Face1"], {{"Face2": (0, 0, 100.0)}})
random = numpy.random.default_rng(1)
many = types.SimpleNamespace(points=random.random((900, 3)), quads=random.integers(0, 900, (900, 4)))
usage = collections.namedtuple("usage", "total used free")
shutil.disk_usage = lambda _: usage(1, 1, 0)
resource.setrlimit(resource.RLIMIT_FSIZE, ({limit}, resource.RLIM_INFINITY))
calls = {{"write " + ending: lambda ending=ending: files.write(mesh, os.path.join(folder, "mesh" + ending))
         for ending in files.WRITERS}}
calls.update({{"surface " + ending: lambda ending=ending: write_surface(many, os.path.join(folder, "quads" + ending))
              for ending in (".obj", ".msh", ".vtu", ".mesh")}})
calls["picture"] = lambda: render(mesh, os.path.join(folder, "mesh.png"))
calls["gallery"] = lambda: gallery.stages(example("schneiders"), None, os.path.join(folder, "new", "pictures"))
calls["solve"] = lambda: solve_inp(deck)
calls["gmsh"] = lambda: hexcon.mesh_solid({solid!r}, 1.0)
told = {{}}
for name, call in calls.items():
    try:
        call()
        told[name] = ["no fault", ""]
    except HexconError as fault:
        told[name] = [fault.code.name, str(fault)]
    except Exception as fault:
        told[name] = [type(fault).__name__, str(fault)]
os.write(3, json.dumps(told).encode())
os._exit(0)
"""


@pytest.fixture(scope="module")
def told(tmp_path_factory):
    """{what was tried: (code, words)}, and the files left."""
    folder = tmp_path_factory.mktemp("full")
    (folder / "temporary").mkdir()
    (folder / "mesh.inp").write_text("old")
    program = PROGRAM.format(tests=str(ROOT / "tests"), folder=str(folder), limit=8192,
                             solid=str(ROOT / "resources" / "examples" / "bracket.step"))
    answer, end = os.pipe()
    with tempfile.TemporaryFile() as errors, subprocess.Popen(["bash", "-c", f'exec 3>&{end}; exec "$0" -c "$1"', sys.executable, program], pass_fds=[end],
                          stdout=subprocess.DEVNULL, stderr=errors) as process:
        os.close(end)
        with os.fdopen(answer) as stream:
            said = stream.read()
        process.wait()
        errors.seek(0)
        assert said, errors.read().decode()
    return json.loads(said), sorted(p.relative_to(folder).as_posix() for p in folder.rglob("*")), folder


def test_every_writer_names_the_cause(told):
    answers, _, _ = told
    assert len(answers) == 18
    for name, (code, words) in answers.items():
        assert code == "FILE_IO" and "no space left on the disk" in words, (name, code, words)


def test_nothing_is_left_behind(told):
    _, left, folder = told
    assert left == ["mesh.inp", "temporary"] and (folder / "mesh.inp").read_text() == "old"


def test_other_faults_are_not_put_down_to_the_disk(tmp_path):
    with pytest.raises(ToolError, match="gmsh failed") as raised, disk.naming(tmp_path, "work"):
        raise ToolError("gmsh failed", FaultCode.TOOL_FAILED)
    assert raised.value.code is FaultCode.TOOL_FAILED
    with pytest.raises(ToolError, match="cannot work: Permission denied"), disk.naming(tmp_path, "work"):
        raise OSError(errno.EACCES, os.strerror(errno.EACCES))
    with pytest.raises(ZeroDivisionError), disk.naming(tmp_path, "work"):
        raise ZeroDivisionError


def test_a_full_disk_does_not_hide_other_faults(tmp_path, monkeypatch):
    monkeypatch.setattr(disk, "is_full", lambda _: True)
    with pytest.raises(HexconError) as raised, disk.naming(tmp_path, "work"):
        raise ToolError("no such method", FaultCode.BAD_OPTION)
    assert raised.value.code is FaultCode.BAD_OPTION


def test_results_cut_short_are_no_results(tmp_path):
    """CalculiX does not notice that its disk is full, and ends with status 0."""
    path, row = tmp_path / "deck.frd", " -1%10d" + 3 * "%12.5E" + "\n"
    text = "    1C\n -4  DISP        4    1\n" + row % (1, 0, 0, 1e-3) + row % (2, 0, 0, 2e-3) + " -3\n 9999\n"
    path.write_text(text)
    assert frd.read(path)["displacements"][1, 2] == 2e-3
    for end in (len(text) - 6, len(text) - 9, len(text) - 30):
        path.write_text(text[:end])
        assert frd.read(path) is None


def test_the_command_line_says_it_in_a_line(tmp_path):
    command = f'ulimit -f 1; exec "{sys.executable}" -m hexcon example schneiders --method pyramid -o "{tmp_path}/m.vtu"'
    ended = subprocess.run(["bash", "-c", command], capture_output=True, text=True, check=False, cwd=ROOT)
    assert ended.returncode == 1 and "Traceback" not in ended.stderr
    assert ended.stderr.startswith(f"hexcon: cannot write {tmp_path}/m.vtu: ") and ended.stderr.count("\n") == 1
    assert not list(tmp_path.iterdir())

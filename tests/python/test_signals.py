# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever signal ends the command line, and whatever it is waiting for: nothing runs on, nothing is left behind."""
import os
import pathlib
import signal
import subprocess
import sys
import time
import uuid

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
from hex_grids import block  # noqa: E402

from hexcon import files  # noqa: E402

PROGRAM = [str(ROOT / "bin" / "hexcon")]
MODULE = [sys.executable, "-P", "-m", "hexcon"]     # HEXCON_PYTHON is the drawing program's alone
WEDGE = str(ROOT / "resources" / "examples" / "wedge.step")
SIGNALS = {signal.SIGINT: 130, signal.SIGTERM: 143, signal.SIGHUP: 129, signal.SIGKILL: -9}
PATIENCE = 20.0     # seconds after which something will not happen any more

# What stands in for each program: it asks for help, leaves a file half done, says that it is there, and hangs.
FAKE = """#!/bin/sh
[ "$1" = -c ] && exit 0
sleep 600 &
echo half > half-done
: > "$READY"
wait
"""
# stage: (command, its arguments, environment that puts FAKE in place)
STAGES = {
    "gmsh": (PROGRAM, ["mesh", WEDGE, "--size", "8", "-o", "out/x.inp"], {"HEXCON_GMSH_PYTHON": "fake"}),
    "tetgen": (PROGRAM, ["mesh", "example:octahedron", "--method", "cells", "-o", "out/x.vtu"],
               {"HEXCON_GMSH_PYTHON": "none", "HEXCON_TETGEN": "fake"}),
    "ccx": (PROGRAM, ["solve", "box.vtu", "--fixed", "Face1", "--force", "Face2=0,0,1", "-o", "out/x.vtu"],
            {"HEXCON_CCX": "fake"}),
    "freecadcmd": (PROGRAM, ["mesh", WEDGE, "--size", "8", "-o", "out/x.FCStd"],
                   {"FREECADCMD": "fake", "FREECAD_LIB": "nowhere"}),
    "reading": (MODULE, ["check", "box.vtu"], {"HEXCON_PYTHON": "fake"}),
    "drawing": (MODULE, ["example", "schneiders", "--gallery", "out/new"], {"HEXCON_PYTHON": "fake"}),
}


@pytest.fixture
def place(tmp_path):
    """A working folder with a mesh, the fake, and folders for temporary files and for output."""
    files.write(block(2, 1, 1), tmp_path / "box.vtu")
    (tmp_path / "fake").write_text(FAKE)
    (tmp_path / "fake").chmod(0o755)
    for name in ("temporary", "out", "cwd"):
        (tmp_path / name).mkdir()
    return tmp_path


def processes_with(token):
    """Ids of the living processes that have the token in their environment."""
    found = []
    for entry in pathlib.Path("/proc").iterdir():
        try:
            state = (entry / "stat").read_text().rsplit(")", 1)[1].split()[0] if entry.name.isdigit() else "Z"
            if state != "Z" and token.encode() in (entry / "environ").read_bytes():
                found.append(int(entry.name))
        except OSError:
            pass
    return found


def wait_for(condition):
    limit = time.monotonic() + PATIENCE
    while not condition() and time.monotonic() < limit:
        time.sleep(0.01)
    return condition()


def begin(place, command, environment):
    """(process, token that it and all that it starts have in their environment)."""
    token = f"HEXCON_TEST={uuid.uuid4().hex}"
    path = os.pathsep.join([str(ROOT), str(ROOT / "workbench")])
    more = {name: str(place / value) for name, value in environment.items()}
    process = subprocess.Popen(
        command, cwd=place, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        env={**os.environ, "PYTHONPATH": path, "TMPDIR": str(place / "temporary"), "READY": str(place / "ready"),
             "HEXCON_TEST": token.split("=")[1], **more},
        preexec_fn=lambda: [signal.signal(number, signal.SIG_DFL) for number in SIGNALS if number != signal.SIGKILL])
    return process, token


def check_nothing_is_left(place, token):
    assert wait_for(lambda: not processes_with(token)), processes_with(token)
    left = [*(place / "temporary").rglob("*"), *(place / "out").rglob("*")]
    assert not left


@pytest.mark.parametrize("number", SIGNALS, ids=lambda number: number.name)
@pytest.mark.parametrize("stage", STAGES)
def test_signal(place, stage, number):
    command, arguments, environment = STAGES[stage]
    process, token = begin(place, [*command, *arguments], environment)
    assert wait_for((place / "ready").exists), process.communicate()
    assert len(processes_with(token)) >= 4      # ours, its keeper, the fake and its helper
    process.send_signal(number)
    output, errors = process.communicate(timeout=PATIENCE)
    assert process.returncode == SIGNALS[number] and not output
    assert "Traceback" not in errors
    if number != signal.SIGKILL:
        assert f"ended by {number.name}" in errors
    check_nothing_is_left(place, token)


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGKILL], ids=lambda number: number.name)
def test_signal_to_real_gmsh(place, number):
    """Blossom on a fine wedge takes gmsh half a minute."""
    process, token = begin(place, [*PROGRAM, "mesh", WEDGE, "--size", "0.1", "--surface-method", "blossom", "-o",
                                   "out/x.inp"], {})
    assert wait_for(lambda: list((place / "temporary").rglob("progress.txt")))
    process.send_signal(number)
    process.communicate(timeout=PATIENCE)
    assert process.returncode == SIGNALS[number]
    check_nothing_is_left(place, token)


def test_killed_while_it_writes(place):
    """The writer hangs; what it has written goes, and the old file stays."""
    (place / "out" / "x.inp").write_text("old")
    process, token = begin(place, [sys.executable, "-P", "-c", f"""
import pathlib, time
from hexcon.files import replace_file
def write(beside):
    pathlib.Path(beside).write_text("half")
    pathlib.Path({str(place / "ready")!r}).touch()
    time.sleep(600)
replace_file({str(place / "out" / "x.inp")!r}, write)
"""], {})
    assert wait_for((place / "ready").exists)
    assert len(list((place / "out").iterdir())) == 2
    process.kill()
    process.communicate()
    assert wait_for(lambda: not processes_with(token))
    assert [p.name for p in (place / "out").iterdir()] == ["x.inp"] and (place / "out" / "x.inp").read_text() == "old"


def test_the_core_is_ended_too(place):
    """A surface that takes long to fill; the signal is met inside the core."""
    process, token = begin(place, [sys.executable, "-P", "-c", f"""
import pathlib, sys
from hexcon.cli import program
import hexcon_native
from hexcon.cli import commands
sys.path.insert(0, {str(ROOT / "tests")!r})
real = commands.mesh_quad_surface
def slow(surface, **options):
    pathlib.Path({str(place / "ready")!r}).touch()
    while True:
        real(surface, **options)
commands.mesh_quad_surface = slow
sys.exit(program(["mesh", "example:schneiders", "-o", "out/x.vtu", "--method", "cells"]))
"""], {})
    assert wait_for((place / "ready").exists)
    process.send_signal(signal.SIGTERM)
    _, errors = process.communicate(timeout=PATIENCE)
    assert process.returncode == 143 and "Traceback" not in errors
    check_nothing_is_left(place, token)


def test_a_signal_while_modules_load(place):
    """There is nothing to explain: no traceback."""
    (place / "numpy.py").write_text("import os, signal, time\nos.kill(os.getpid(), signal.SIGINT)\ntime.sleep(600)\n")
    done = subprocess.run([*PROGRAM, "info", "box.vtu"], env={**os.environ, "PYTHONPATH": str(place)}, check=False,
                          capture_output=True, preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
    assert done.returncode == -signal.SIGINT and not done.stderr


def test_ignored_signals_stay_ignored(place):
    """As of nohup: SIGHUP is ignored from the start, and the work is done."""
    done = subprocess.run(["sh", "-c", f'trap "" HUP; "{PROGRAM[0]}" example schneiders -o out/x.obj & '
                           'for k in 1 2 3 4 5; do kill -HUP $!; sleep 0.1; done; wait $!'], cwd=place, check=False)
    assert done.returncode == 0 and (place / "out" / "x.obj").exists()

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line in surroundings that mean it no good: modules in the working folder, variables of another Python,
streams that are closed, full or narrow."""
import json
import os
import pathlib
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))
from hex_grids import block  # noqa: E402

from hexcon import files  # noqa: E402

PROGRAM = str(ROOT / "bin" / "hexcon")
WEDGE = str(ROOT / "resources" / "examples" / "wedge.step")
FREECADCMD = os.environ.get("FREECADCMD") or "freecadcmd"
# What a folder of somebody's may well hold, each of which says that it was run.
MODULES = ("json", "numpy", "meshio", "gmsh", "scipy", "vtk", "vtkmodules", "FreeCAD", "FreeCADGui", "Part", "Fem", "Mesh",
           "ObjectsFem", "femtools", "PySide", "hexcon", "hexcon_native", "palette", "scene", "gmsh_worker",
           "tetrahedra_worker", "file_worker", "sitecustomize", "usercustomize", "argparse", "traceback", "tempfile",
           "subprocess", "secrets", "zipfile", "inspect", "dataclasses", "h5py", "lxml", "rich", "unittest")
CLEAN = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}   # that of the tests is relative
PULL = ("--fixed", "Face1", "--force", "Face2=0,0,-1")
COMMANDS = {
    "mesh": ((PROGRAM, "mesh", WEDGE, "--size", "8", "-o", "x.inp", "-o", "x.vtu", "-o", "x.msh", "-o", "x.unv", "-o",
              "x.FCStd", "-o", "x.med"), {}),
    "tetrahedra": ((PROGRAM, "mesh", "example:octahedron", "--method", "cells", "-o", "t.vtu"), {}),
    "mesh with another Python": ((PROGRAM, "mesh", WEDGE, "--size", "8", "-o", "y.inp"),
                                 {"HEXCON_GMSH_PYTHON": sys.executable}),
    "mesh in freecadcmd": ((PROGRAM, "mesh", WEDGE, "--size", "8", "-o", "z.FCStd"), {"FREECAD_LIB": "nowhere"}),
    "check": ((PROGRAM, "check", "box.vtu", "--surface", "box.vtk"), {}),
    "info": ((PROGRAM, "info", "box.msh"), {}),
    "draw": ((PROGRAM, "example", "schneiders", "--gallery", "pictures"), {}),
    "solve": ((PROGRAM, "solve", "box.vtu", *PULL, "-o", "r.vtu", "-o", "r.png"), {}),
    "solve a document": ((PROGRAM, "mesh", "box.FCStd", "--size", "1", "-o", "d.inp"), {}),
    "batch": ((FREECADCMD, str(ROOT / "resources" / "batch" / "mesh_folder.py"), "--", "parts", "--size", "8"), {}),
    "module": ((sys.executable, "-P", "-m", "hexcon", "info", "box.msh"),
               {"PYTHONPATH": f"{ROOT}:{ROOT / 'workbench'}"}),
}


@pytest.fixture(scope="module")
def hostile(tmp_path_factory):
    """A working folder with modules that must not be run, and with files to work on."""
    folder = tmp_path_factory.mktemp("hostile")
    for name in MODULES:
        (folder / f"{name}.py").write_text(f"open({str(folder / 'ran')!r}, 'a').write('{name} ')\n")
    for ending in ("vtu", "vtk", "msh", "inp"):
        files.write(block(2, 1, 1), folder / f"box.{ending}")
    (folder / "parts").mkdir()
    (folder / "parts" / "wedge.step").write_bytes(pathlib.Path(WEDGE).read_bytes())
    done = subprocess.run([PROGRAM, "mesh", WEDGE, "--size", "8", "-o", str(folder / "box.FCStd")], check=False)
    assert done.returncode == 0
    return folder


def run(hostile, command, **environment):
    """The finished process, in that folder; no module of it was run."""
    (hostile / "ran").unlink(missing_ok=True)
    done = subprocess.run(command, cwd=hostile, env={**CLEAN, **environment}, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, check=False)
    assert not (hostile / "ran").exists(), (hostile / "ran").read_text()
    assert "Traceback" not in done.stderr
    return done


@pytest.mark.parametrize("name", COMMANDS)
def test_no_module_of_the_working_folder_is_run(hostile, name):
    command, environment = COMMANDS[name]
    done = run(hostile, command, **environment)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("path", [":", "./", "parts/..:/usr/lib:", "*"])
def test_relative_entries_of_the_path(hostile, path):
    done = run(hostile, [PROGRAM, "info", "box.msh"], PYTHONPATH=path)
    assert done.returncode == 0 and "10 quads" in done.stdout
    done = run(hostile, [PROGRAM, "mesh", WEDGE, "--size", "8", "-o", "p.inp"], PYTHONPATH=path,
               HEXCON_GMSH_PYTHON=sys.executable) if path == ":" else done
    assert done.returncode == 0


def test_an_absolute_entry_counts(hostile, tmp_path):
    (tmp_path / "numpy.py").write_text("raise SystemExit(77)\n")
    assert run(hostile, [PROGRAM, "info", "box.msh"], PYTHONPATH=f".:{tmp_path}").returncode == 77


@pytest.mark.parametrize("variables", [
    {"PYTHONHOME": "/nowhere", "PYTHONSTARTUP": "json.py", "PYTHONINSPECT": "1"},
    {"PYTHONIOENCODING": "ascii", "LC_ALL": "C", "PYTHONOPTIMIZE": "2"},
    {"PYTHONSAFEPATH": "", "TMPDIR": "/nowhere", "HOME": "/nowhere", "CDPATH": "/", "IFS": "/"}],
    ids=lambda variables: "-".join(variables))
def test_variables(hostile, variables):
    done = run(hostile, [PROGRAM, "mesh", WEDGE, "--size", "8", "-o", "v.inp"], **variables)
    assert done.returncode == 0, done.stderr
    assert "every Jacobian proved positive" in done.stdout


def test_names_that_are_no_text(tmp_path):
    """Names outside of ASCII, and bytes that are no UTF-8, on streams that take neither."""
    for name in ("straße.vtu".encode(), b"\xff\xfe.vtu"):
        path = os.path.join(os.fsencode(tmp_path), name)
        for streams in ({"PYTHONIOENCODING": "ascii"}, {"LC_ALL": "C", "PYTHONCOERCECLOCALE": "0", "PYTHONUTF8": "0"}):
            environment = {**CLEAN, **streams}
            for command in ((b"mesh", b"example:schneiders", b"--method", b"pyramid", b"-o", path), (b"check", path + b".none"), (b"check", path, b"--json")):
                done = subprocess.run([os.fsencode(PROGRAM), *command], env=environment, capture_output=True, check=False)
                assert done.returncode in (0, 1, 3) and b"Traceback" not in done.stderr, done.stderr
                if command[-1] == b"--json":
                    json.loads(done.stdout)


# ---------------------------------------------------------------------------------------- streams

SAID = {"lines": ("info", "box.msh"), "help": ("--help",), "a fault in json": ("info", "none.msh", "--json")}


def shell(hostile, line):
    """(exit status of the program, standard error) of a line in which hexcon is $0 and its words are $@."""
    done = subprocess.run(["bash", "-c", f'{line}; exit "${{PIPESTATUS[0]}}"', PROGRAM, *shell.words], cwd=hostile,
                          env=CLEAN, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    assert "Traceback" not in done.stderr and "Exception" not in done.stderr
    return done.returncode, done.stderr, done.stdout


@pytest.mark.parametrize("name", SAID)
def test_streams(hostile, name):
    shell.words = SAID[name]
    status = 1 if name == "a fault in json" else 0
    # a reader that is gone before the first word; the sleep makes sure of it
    code, errors, _ = shell(hostile, '(sleep 0.3; exec "$0" "$@") | true')
    assert code in (141, status) and not errors
    code, errors, _ = shell(hostile, '"$0" "$@" > /dev/full')
    assert code == 1 and errors == "hexcon: cannot write on standard output: No space left on device\n"
    assert shell(hostile, '"$0" "$@" >&-') == (status, "", "")
    code, _, said = shell(hostile, '"$0" "$@" 2>&- <&-')
    assert code == status and said
    assert shell(hostile, '"$0" "$@" >&- 2>&- <&-') == (status, "", "")


def test_a_reader_that_leaves(hostile):
    """More is said than a pipe holds, and one line is read."""
    shell.words = ()
    code, errors, said = shell(hostile, f'PYTHONPATH={ROOT}:{ROOT / "workbench"} {sys.executable} -P -c "import sys; '
                               'from hexcon.cli import terminal; sys.exit(terminal.run(lambda: '
                               'terminal.say(\'x\\n\' * 10**6), \'hexcon\'))" | head -1')
    assert (code, errors, said) == (141, "", "x\n")


@pytest.mark.parametrize("line", ['"$0" info none.msh 2>&-', '"$0" info none.msh 2>/dev/full', '"$0" bake 2>&-',
                                  '"$0" bake 2>/dev/full', '"$0" 2>&-'])
def test_words_that_nobody_hears(hostile, line):
    """They do not come out of standard output instead, and the status is the fault's."""
    shell.words = ()
    assert shell(hostile, line) == (1 if "none" in line else 2, "", "")


def test_closed_streams_are_no_files(hostile):
    """With standard output closed, the first file opened would get its number, and what libraries print."""
    shell.words = ()
    assert shell(hostile, f'"$0" mesh {WEDGE} --size 8 -o c.inp -o c.FCStd >&- 2>&- <&-')[0] == 0
    assert files.read_mesh(hostile / "c.inp").hexes.shape == (64, 8)


@pytest.mark.parametrize("line,status", [('| true', (141, 0, 1)), ('> /dev/full', (1,)), ('>&-', (0,)), ('2>&-', (0,))])
def test_batch(hostile, line, status):
    shell.words = ()
    script = ROOT / "resources" / "batch" / "mesh_folder.py"
    assert shell(hostile, f'{FREECADCMD} {script} -- parts --size 8 {line}')[0] in status

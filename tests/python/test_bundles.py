# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD as a bundle with a Python of its own: folders laid out as AppImage, Windows and Flatpak lay theirs out, and a
process that stands in for FreeCAD, with the variables that the bundle sets."""
import json
import os
import pathlib
import subprocess
import sys

import numpy
import pytest

from hexcon.gmsh_process import gmsh_python

ROOT = pathlib.Path(__file__).resolve().parents[2]
VERSION = f"python{sys.version_info.major}.{sys.version_info.minor}"
PYTHON = os.path.realpath(sys.executable)
# The stand-in: FreeCAD is sys.executable, and its Python lives where the bundle says.
FREECAD = f"""
import json, os, sys
sys.path[:0] = [{str(ROOT)!r}, {str(ROOT / 'workbench')!r}]
sys.executable, sys.base_prefix = sys.argv[1], sys.argv[2]
os.environ.update(json.loads(sys.argv[3]))
sys.path += json.loads(sys.argv[4])
from hexcon import gmsh_process, interpreter
from hexcon.errors import ToolError
answer = {{"python": interpreter.python(), "bundles": interpreter.bundles()}}
try:
    gmsh_process.SYSTEM_PYTHON = sys.argv[5]
    answer["gmsh"] = gmsh_process.gmsh_python()
except ToolError as fault:
    answer["fault"] = str(fault)
print(json.dumps(answer))
"""


def executable(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)
    path.chmod(0o755)
    return str(path)


def python_without_gmsh(path, home):
    """A Python whose home is `home`, with the standard library and numpy alone; its libraries are its own."""
    library = home / "lib" / VERSION
    library.parent.mkdir(parents=True, exist_ok=True)
    if not library.exists():
        library.symlink_to(os.path.dirname(os.__file__))
        packages = home / "packages"
        packages.mkdir()
        for found in pathlib.Path(numpy.__file__).parents[1].glob("numpy*"):
            (packages / found.name).symlink_to(found)
    return executable(path, f'#!/bin/sh\nunset LD_LIBRARY_PATH\nexport PYTHONHOME={home}\n'
                      f'export PYTHONPATH={home}/packages:$PYTHONPATH\nexec {PYTHON} -S "$@"\n')


def ask(program, home, variables=(), added=(), system="/usr/bin/python3", path="/usr/bin:/bin"):
    """What hexcon finds in a FreeCAD that is `program` and whose Python's home is `home`."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "HEXCON_"))}
    done = subprocess.run([PYTHON, "-c", FREECAD, program, str(home), json.dumps({"PATH": path, **dict(variables)}),
                           json.dumps([*map(str, added)]), system],
                          env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.splitlines()[-1])


@pytest.fixture
def appimage(tmp_path):
    """The variables that AppRun sets, with a library that the system's Python does not start with."""
    usr = tmp_path / "mount" / "usr"
    python_without_gmsh(usr / "bin" / VERSION, usr)
    (usr / "lib" / "libm.so.6").write_text("Python needs it, a shell does not")
    program = executable(usr / "bin" / "freecad", "#!/bin/sh\nexit 1\n")
    return program, usr, {"PYTHONHOME": str(usr), "LD_LIBRARY_PATH": f"{usr}/lib", "APPDIR": str(usr.parent)}


def test_appimage_takes_the_systems_gmsh(appimage):
    """Its own Python has no gmsh; the system's starts, though PYTHONHOME and LD_LIBRARY_PATH are the bundle's."""
    program, usr, variables = appimage
    found = ask(program, usr, variables)
    assert found["python"] == str(usr / "bin" / VERSION) and str(usr) in found["bundles"]
    assert found["gmsh"] == "/usr/bin/python3"


def test_what_each_python_lacks_is_told(appimage, tmp_path):
    program, usr, variables = appimage
    bare = executable(tmp_path / "bare" / "python3", f'#!/bin/sh\nexec {PYTHON} -S -E "$@"\n')
    executable(tmp_path / "bare" / "gmsh", "#!/bin/sh\n")
    found = ask(program, usr, variables, system=bare, path=f"{tmp_path}/bare")
    assert f"{usr}/bin/{VERSION} has no gmsh and no scipy" in found["fault"]
    assert f"{bare} has no gmsh and no numpy and no scipy" in found["fault"] and found["fault"].count(bare) == 1
    assert f"The program {tmp_path}/bare/gmsh alone is not enough" in found["fault"]
    assert "Addon Manager" in found["fault"]


def test_packages_of_the_addon_manager_count(appimage, tmp_path):
    """FreeCAD has them on its path; its Python as a child has them only from us."""
    program, usr, variables = appimage
    added = tmp_path / "FreeCAD" / "AdditionalPythonPackages" / "py311"
    for name in ("gmsh", "scipy"):
        (added / name).mkdir(parents=True)
        (added / name / "__init__.py").write_text("")
    assert ask(program, usr, variables, [added])["gmsh"] == str(usr / "bin" / VERSION)


def test_windows(tmp_path):
    """Programs lie beside FreeCAD.exe, and the home of its Python is that folder."""
    folder = tmp_path / "FreeCAD 1.1" / "bin"
    program = executable(folder / "FreeCAD.exe", "")
    python = python_without_gmsh(folder / "python", folder)       # Windows' PATHEXT finds python.exe by this name
    found = ask(program, folder)
    assert found["python"] == python and found["gmsh"] == "/usr/bin/python3"


def test_flatpak(tmp_path):
    """FreeCAD is in /app, its Python the runtime's in /usr: of the same version, and its modules come by PYTHONPATH."""
    program = executable(tmp_path / "app" / "bin" / "freecad", "")
    modules = tmp_path / "app" / "lib" / VERSION / "site-packages"
    modules.mkdir(parents=True)
    python = python_without_gmsh(tmp_path / "usr" / "bin" / VERSION, tmp_path / "usr")
    assert "gmsh" not in ask(program, tmp_path / "usr", system=python, path=str(tmp_path / "nothing"))
    for name in ("gmsh", "scipy"):
        (modules / f"{name}.py").write_text("")
    found = ask(program, tmp_path / "usr", {"PYTHONPATH": str(modules)}, system=python, path=str(tmp_path / "nothing"))
    assert found["gmsh"] == python


def test_other_programs_do_not_get_the_bundles_libraries(appimage, monkeypatch, tmp_path):
    from hexcon import child
    from hexcon.calculix import find_ccx
    program, usr, variables = appimage
    for name, value in {**variables, "LD_LIBRARY_PATH": f"{usr}/lib:/opt/mine"}.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr(sys, "executable", program)
    monkeypatch.setattr(sys, "base_prefix", str(usr))
    assert child.program_environment("/bin/ls")["LD_LIBRARY_PATH"] == "/opt/mine"
    ccx = executable(usr / "bin" / "ccx", "#!/bin/sh\n")
    assert child.python_environment(program)["PYTHONHOME"] == str(usr)       # FreeCAD itself
    assert "PYTHONHOME" not in child.python_environment("/usr/bin/python3")
    assert child.program_environment(ccx)["LD_LIBRARY_PATH"] == f"{usr}/lib:/opt/mine"
    environment = child.python_environment("/usr/bin/python3")
    ended = child.run(["/usr/bin/python3", "-c", "print('starts')"], "Python", environment=environment)
    assert ended.output == "starts\n"
    monkeypatch.setenv("PATH", str(tmp_path / "nothing"))
    monkeypatch.delenv("HEXCON_CCX", raising=False)
    assert find_ccx() == ccx


def test_one_click_gets_what_is_missing(monkeypatch, tmp_path):
    """pip of FreeCAD's Python puts it where the Addon Manager does; pip's words where it cannot."""
    from hexcon import freecad_compat, packages
    from hexcon.errors import FaultCode, ToolError
    folder = tmp_path / "AdditionalPythonPackages" / "py311"
    monkeypatch.setattr(freecad_compat, "packages_folder", lambda: str(folder))
    monkeypatch.setattr(packages, "missing", lambda: ["gmsh"])
    monkeypatch.setattr(sys, "path", list(sys.path))
    monkeypatch.setenv("HEXCON_PYTHON", executable(
        tmp_path / "python3", f'#!/bin/sh\necho "$@" >{tmp_path}/said\n'
        'while [ "$1" != --target ]; do shift; done\nmkdir -p "$2/$3"\n'))
    packages.install()
    assert (tmp_path / "said").read_text().endswith(f" --target {folder} gmsh\n")
    assert (folder / "gmsh").is_dir() and str(folder) in sys.path
    bare = executable(tmp_path / "python", "#!/bin/sh\necho 'No module named pip'; exit 1\n")
    monkeypatch.setenv("HEXCON_PYTHON", bare)
    with pytest.raises(ToolError, match="could not install gmsh: No module named pip") as caught:
        packages.install()
    assert caught.value.code is FaultCode.TOOL_FAILED


def test_this_python_has_gmsh():
    """So what is above is not about a system without it."""
    assert gmsh_python()

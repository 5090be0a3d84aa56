# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench in a real FreeCAD window, under Xvfb. No window is a failure, not a skip.

The scripts write steps.log and pictures (panel_done.png, ...) into the test's tmp_path.
"""
import glob
import os
import pathlib
import shutil
import signal
import subprocess
import sys

import pytest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PATIENCE = 300  # seconds for one FreeCAD; it needs about fifteen


@pytest.fixture
def home(tmp_path):
    """A user's folder of its own: no settings and no addons but those of the test."""
    folder = tmp_path / "home"
    (folder / "Mod").mkdir(parents=True)
    return folder


def freecad(command, tmp_path, home, **variables):
    """Run FreeCAD to its end; the test fails with all it said unless the status is 0."""
    env = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    env.update(FREECAD_USER_HOME=str(home), HEXCON_TEST_OUT=str(tmp_path),
               QTWEBENGINE_DISABLE_SANDBOX="1", **variables)  # as root it would not start
    log = tmp_path / "freecad.log"
    with open(log, "wb") as stream:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=stream,
                                   stderr=subprocess.STDOUT, env=env, start_new_session=True)
        try:
            status = process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            status = f"none after {PATIENCE} s"
        finally:
            left = gmsh_of(process.pid)
            _end(process.pid)  # xvfb-run leaves its children behind when it is stopped
            process.wait()
    steps = tmp_path / "steps.log"
    said = steps.read_text(encoding="utf-8") if steps.exists() else ""
    assert status == 0, f"status {status}\n{said}\n{log.read_text(errors='replace')}"
    assert not left, f"gmsh outlived FreeCAD: {left}"
    return said


def gmsh_of(group):
    """Processes of the group that run HexCon's gmsh worker."""
    found = []
    for folder in glob.glob("/proc/[0-9]*"):
        try:
            stat = pathlib.Path(folder, "stat").read_text()
            command = pathlib.Path(folder, "cmdline").read_text()
        except OSError:
            continue  # it ended while we looked
        if int(stat.rsplit(")", 1)[1].split()[2]) == group and \
                ("gmsh_worker" in command or "tetrahedra_worker" in command):
            found.append(command)
    return found


def _end(group):
    try:
        os.killpg(group, signal.SIGKILL)
    except ProcessLookupError:
        pass


def window(script, tmp_path, home, *arguments, **variables):
    """Run a script in FreeCAD's window; all its steps must pass."""
    said = freecad(["xvfb-run", "-a", "-s", "-screen 0 1400x900x24",
                    os.environ.get("FREECAD", "freecad"), str(HERE / script), *arguments],
                   tmp_path, home, **variables)
    assert "all steps passed" in said, said


def test_session_with_the_addon_named_on_the_command_line(tmp_path, home):
    window("script_mesh.py", tmp_path, home, "-M", str(ROOT))


def test_session_with_the_addon_linked_into_mod(tmp_path, home):
    (home / "Mod" / "HexCon").symlink_to(ROOT)
    window("script_mesh.py", tmp_path, home)


def test_looking_inside_and_at_dual_loops(tmp_path, home):
    window("script_inside.py", tmp_path, home, "-M", str(ROOT))


def test_what_crosses_itself_is_told_and_drawn(tmp_path, home):
    window("script_crossing.py", tmp_path, home, "-M", str(ROOT))


def test_groups_are_held_and_loaded_by_name(tmp_path, home):
    window("script_groups.py", tmp_path, home, "-M", str(ROOT))


def test_conventions_of_the_window(tmp_path, home):
    window("script_conventions.py", tmp_path, home, "-M", str(ROOT))


def test_the_window_in_german(tmp_path, home):
    window("script_german.py", tmp_path, home, "-M", str(ROOT))


def bare_addon(folder):
    """The addon as it is before `make build`."""
    native = folder / "hexcon_native"
    native.mkdir(parents=True)
    for name in ("Init.py", "InitGui.py", "package.xml", "resources", "workbench"):
        (folder / name).symlink_to(ROOT / name)
    for path in (ROOT / "hexcon_native").glob("*.py"):
        (native / path.name).symlink_to(path)
    return folder


def test_missing_core_is_told_and_building_it_is_enough(tmp_path, home):
    (core,) = glob.glob(str(ROOT / "hexcon_native" / "_core*.so"))
    addon = bare_addon(home / "Mod" / "HexCon")
    window("script_missing_core.py", tmp_path, home, HEXCON_TEST_ADDON=str(addon),
           HEXCON_TEST_CORE=core)


def test_actions_without_a_window(tmp_path, home):
    command = shutil.which(os.environ.get("FREECADCMD", "freecadcmd"))
    assert command, "freecadcmd is missing"
    freecad([command, str(HERE / "script_cmd.py"), "-M", str(ROOT)], tmp_path, home)


def test_objects_without_a_window(tmp_path, home):
    command = shutil.which(os.environ.get("FREECADCMD", "freecadcmd"))
    assert command, "freecadcmd is missing"
    freecad([command, str(HERE / "script_recompute.py"), "-M", str(ROOT)], tmp_path, home)


def test_the_parametric_road_by_clicks(tmp_path, home):
    window("script_objects.py", tmp_path, home, "-M", str(ROOT))


def test_translations_are_collected():
    subprocess.run([sys.executable, str(ROOT / "scripts" / "translations.py"), "--check"], check=True)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which core an import takes: the one built here, or a release's for this system; and what it says without one."""
import pathlib
import shutil
import subprocess
import sys

import pytest

import hexcon_native
from hexcon_native import core_builds

CORE = pathlib.Path(hexcon_native._core.__file__)
HERE = core_builds.system_name()


@pytest.fixture
def package(tmp_path):
    """hexcon_native without a core; returns its folder."""
    folder = tmp_path / "hexcon_native"
    folder.mkdir()
    for path in pathlib.Path(core_builds.HERE).glob("*.py"):
        shutil.copy(path, folder)
    return folder


def core_of(package):
    """(path of the core that an import of that package takes or None, what it says)."""
    done = subprocess.run([sys.executable, "-c", "import hexcon_native; print(hexcon_native._core.__file__)"],
                          cwd=package.parent, env={"PYTHONPATH": str(package.parent)}, capture_output=True, text=True,
                          check=False)
    return (pathlib.Path(done.stdout.strip()) if done.returncode == 0 else None), done.stderr


@pytest.mark.parametrize("platform,machine,name", [
    ("linux", "x86_64", "linux-x86_64"), ("linux", "aarch64", "linux-aarch64"), ("win32", "AMD64", "windows-x86_64"),
    ("darwin", "arm64", "macos-aarch64")])
def test_names_of_systems(monkeypatch, platform, machine, name):
    monkeypatch.setattr(sys, "platform", platform)
    monkeypatch.setattr(core_builds.platform, "machine", lambda: machine)
    assert core_builds.system_name() == name


def test_a_release_has_this_systems_core_and_one_built_here_comes_first(package):
    for system in (HERE, "other-system"):
        (package / "built" / system).mkdir(parents=True)
    (package / "built" / "other-system" / CORE.name).write_text("not for this system")
    shutil.copy(CORE, package / "built" / HERE)
    assert core_of(package)[0] == package / "built" / HERE / CORE.name
    shutil.copy(CORE, package)
    assert core_of(package)[0] == package / CORE.name


def test_what_is_there_and_what_is_missing_is_told(package):
    core, said = core_of(package)
    assert core is None and f"This system is {HERE}; of cores there is none. Build it with `make build`" in said
    (package / "built" / "other-system").mkdir(parents=True)
    core, said = core_of(package)
    assert core is None and f"This system is {HERE}; of cores there are: other-system." in said
    (package / CORE.name).write_text("of another system")
    core, said = core_of(package)
    assert core is None and "there are: built here, other-system. One that was built here comes first" in said

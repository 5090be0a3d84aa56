# SPDX-License-Identifier: LGPL-2.1-or-later
"""The C library, installed into a folder of its own: examples/c is built against it by pkg-config and by CMake.

Static and shared. The header, Python and the workbench's package.xml tell one version.
"""
import os
import re
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest

import hexcon
import hexcon_native as hn

ROOT = Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "examples" / "c"
NAMESPACE = {"p": "https://wiki.freecad.org/Package_Metadata"}


def run(*command, **environment):
    done = subprocess.run([str(word) for word in command], env={**os.environ, **environment}, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300)
    assert done.returncode == 0, done.stdout
    return done.stdout


@pytest.fixture(scope="module", params=["static", "shared"])
def installed(request, tmp_path_factory):
    """Folder of a fresh installation, moved after it was made: nothing in it may know where it was."""
    folder = tmp_path_factory.mktemp(request.param)
    shared = "ON" if request.param == "shared" else "OFF"
    run("cmake", "-S", ROOT / "hexcon_native", "-B", folder / "build", "-G", "Ninja", "-DHEXCON_PYTHON=OFF",
        f"-DBUILD_SHARED_LIBS={shared}", "-DCMAKE_C_FLAGS_RELEASE=-O1", f"-DCMAKE_INSTALL_PREFIX={folder / 'first'}")
    run("ninja", "-C", folder / "build")
    run("cmake", "--install", folder / "build")
    shutil.rmtree(folder / "build")
    (folder / "first").rename(folder / "prefix")
    return folder / "prefix"


def library_folder(prefix):
    return next(prefix.glob("**/pkgconfig")).parent


def check_words(words):
    """A box of 4 x 4 x 4 cubes; without a quad it is open, and the four neighbours of the gap are listed."""
    assert f"HexCon {hn.__version__}\n" in words
    assert "method swept: 64 hexes, 125 points\n" in words
    assert "certified: yes; worst scaled Jacobian 1.000\n" in words
    assert "NOT_CLOSED: " in words and len(re.search("listed: (.*)", words)[1].split(", ")) == 4


def test_built_by_pkg_config(installed, tmp_path):
    libraries = library_folder(installed)
    found = {"PKG_CONFIG_PATH": str(libraries / "pkgconfig")}
    assert run("pkg-config", "--modversion", "hexcon", **found).strip() == hn.__version__
    flags = run("pkg-config", "--cflags", "--libs", "hexcon", **found).split()
    run("cc", "-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Werror", EXAMPLE / "fill_surface.c", *flags,
        "-o", tmp_path / "fill_surface")
    check_words(run(tmp_path / "fill_surface", LD_LIBRARY_PATH=str(libraries)))


def test_built_by_cmake(installed, tmp_path):
    run("cmake", "-S", EXAMPLE, "-B", tmp_path, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={installed}")
    run("ninja", "-C", tmp_path)
    check_words(run(tmp_path / "fill_surface"))


def test_another_minor_version_is_not_taken(installed, tmp_path):
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.22)\nproject(p LANGUAGES C)\nfind_package(hexcon 0.1 QUIET)\n"
        "if(hexcon_FOUND)\n  message(FATAL_ERROR taken)\nendif()\n")
    run("cmake", "-S", tmp_path, "-B", tmp_path / "build", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={installed}")


def test_only_the_headers_names_are_exported(installed):
    """Of a shared library; a static one has no such list."""
    libraries = library_folder(installed)
    declared = set(re.findall(r"\b(hexcon_\w+)\(", (installed / "include" / "hexcon.h").read_text()))
    shared = list(libraries.glob("libhexcon.so"))
    if not shared:
        assert (libraries / "libhexcon.a").is_file()
        return
    table = run("nm", "--dynamic", "--defined-only", shared[0])
    exported = {line.split()[-1] for line in table.splitlines()} - {"_init", "_fini"}
    assert exported <= declared, exported - declared
    assert {"hexcon_mesh_surface", "hexcon_certify", "hexcon_version"} <= exported


def test_versions_agree():
    header = (ROOT / "hexcon_native" / "include" / "hexcon.h").read_text(encoding="utf-8")
    typed = re.search(r'^#define HEXCON_VERSION "(\d+\.\d+\.\d+)"$', header, re.MULTILINE)[1]
    package = ElementTree.parse(ROOT / "package.xml").getroot().findtext("p:version", namespaces=NAMESPACE)
    newest = re.search(r"^## (\d+\.\d+\.\d+)", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)[1]
    assert typed == hn.__version__ == hexcon.__version__ == package == newest

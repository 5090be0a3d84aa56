# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python for processes of our own, and what else comes with this FreeCAD, where sys.executable is FreeCAD itself.

FreeCAD is a package of the system, or a bundle that brings its own Python, libraries and programs:

AppImage   .../usr/bin/{freecad,python3.11,ccx}, with PYTHONHOME and LD_LIBRARY_PATH set to itself
Windows    ...\\bin\\{FreeCAD.exe,python.exe,ccx.exe}
Flatpak    /app/bin/{freecad,ccx}, Python that of the runtime in /usr
"""
import os
import shutil
import sys

_SYSTEM = {"/", "/usr", "/usr/local"}


def is_python(program):
    """Whether a program is called as Pythons are."""
    return os.path.basename(program or "").lower().startswith("python")


def python():
    """$HEXCON_PYTHON, or this interpreter, or inside FreeCAD the one that FreeCAD brings or was built for."""
    if os.environ.get("HEXCON_PYTHON"):
        return os.environ["HEXCON_PYTHON"]
    if is_python(sys.executable):
        return sys.executable
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    return beside(version, "python3", "python") or shutil.which(version) or "python3"


def beside(*names):
    """Path of a program that this FreeCAD, or the home of its Python, has in its folder of programs; or None. The first
    of the names that is there."""
    folders = [os.path.join(sys.base_prefix, "bin"), sys.base_prefix]
    if sys.executable:
        folders.insert(0, os.path.dirname(sys.executable))
    for name in names:
        found = shutil.which(name, path=os.pathsep.join(folders))
        if found:
            return os.path.abspath(found)
    return None


def bundles():
    """Folders of the bundle that this FreeCAD is, none where it is a package of the system."""
    roots = {os.path.realpath(root) for root in (sys.base_prefix, os.environ.get("APPDIR")) if root}
    return sorted(roots - _SYSTEM)


def is_bundled(path):
    """Whether a file or folder is the bundle's."""
    path = os.path.realpath(path)
    return any(path == root or path.startswith(root + os.sep) for root in bundles())

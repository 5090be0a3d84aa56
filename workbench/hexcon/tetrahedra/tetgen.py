# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tetrahedra by tetgen, in a subprocess, where it is installed: for surfaces that gmsh cannot fill.

$HEXCON_TETGEN names the program; if it is set but empty, tetgen is not used; else it is sought on PATH.
"""
import os
import shutil
import subprocess
import time

import numpy as np

from hexcon import disk
from hexcon.errors import FaultCode, ToolError
from hexcon.gmsh_process import last_words, watch

from .tetrahedra_worker.shells import shells_of

# -p fill a surface, -Y keep its triangles, -q no flat tetrahedra, -z count from 0, -Q say little
OPTIONS = "-pYqzQ"
INTO_CAVITY = 1e-3      # of a triangle's size: so far from its middle lies the point that marks a cavity


def find_tetgen():
    """Path of tetgen, or None. Raises ToolError TOOL_MISSING where HEXCON_TETGEN names no program."""
    named = os.environ.get("HEXCON_TETGEN")
    if named == "":
        return None
    found = shutil.which(named or "tetgen")
    if named and not found:
        raise ToolError(f"HEXCON_TETGEN is {named}, which is no program", FaultCode.TOOL_MISSING)
    return found


def by_tetgen(program, points, triangles, timeout, progress):
    """(points (Q,3), tetrahedra (M,4)) in a closed surface, unchecked; the given points come first, bit for bit.

    points (P,3) float64, triangles (T,3) int64, outward, those of cavities into the cavity. timeout: seconds.
    Raises ToolError TOOL_FAILED (with tetgen's last words), TOOL_TIMEOUT, and what progress raises.
    """
    with disk.working_folder("hexcon-tetgen-") as folder, disk.naming(folder, f"work in {folder}"):
        path = os.path.join(folder, "surface.poly")
        _write(path, points, triangles)
        code = _run(program, folder, timeout, progress)
        try:
            made, tetrahedra = (_table(os.path.join(folder, "surface.1" + ending)) for ending in (".node", ".ele"))
        except OSError as error:
            raise ToolError(f"tetgen ended with status {code}: {last_words(folder)}", FaultCode.TOOL_FAILED) from error
    return np.concatenate([points, made[len(points):, 1:4]]), tetrahedra[:, 1:5].astype(np.int64)


def _write(path, points, triangles):
    """A .poly file; every cavity has a point that marks it as empty."""
    marks = [_point_in_cavity(points, triangles[shell]) for shell in shells_of(points, triangles)[1:]]
    with open(path, "w", encoding="ascii") as stream:
        stream.write(f"{len(points)} 3 0 0\n")
        np.savetxt(stream, np.column_stack([np.arange(len(points)), points]), fmt="%d %.17g %.17g %.17g")
        stream.write(f"{len(triangles)} 0\n")
        for a, b, c in triangles:
            stream.write(f"1\n3 {a} {b} {c}\n")
        stream.write(f"{len(marks)}\n")
        for k, mark in enumerate(marks):
            stream.write("{} {:.17g} {:.17g} {:.17g}\n".format(k, *mark))
        stream.write("0\n")


def _point_in_cavity(points, shell):
    """A point near the middle of the largest triangle, on the side to which it faces."""
    corners = points[shell]
    if np.linalg.det(corners - corners.reshape(-1, 3).mean(axis=0)).sum() > 0.0:
        raise ToolError("the surface encloses several bodies", FaultCode.TOOL_FAILED)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    sizes = np.linalg.norm(normals, axis=1)
    k = int(sizes.argmax())
    return corners[k].mean(axis=0) + INTO_CAVITY * normals[k] / np.sqrt(sizes[k])


def _run(program, folder, timeout, progress):
    """Start, watch, and in any case end it; its exit status."""
    with open(os.path.join(folder, "log.txt"), "wb") as log:
        try:
            process = subprocess.Popen([program, OPTIONS, "surface.poly"], stdin=subprocess.DEVNULL, stdout=log,
                                       stderr=subprocess.STDOUT, cwd=folder)
        except OSError as error:
            raise ToolError(f"cannot start {program}: {error}", FaultCode.TOOL_MISSING) from error
    try:
        return watch(process, "tetgen", time.monotonic() + timeout, timeout, os.path.join(folder, "progress.txt"),
                     progress)
    finally:
        if process.poll() is None:
            process.kill()
        process.wait()


def _table(path):
    """Rows of one of tetgen's files: a line with their number, then as many; comments begin with #."""
    return np.loadtxt(path, skiprows=1, ndmin=2, comments="#")

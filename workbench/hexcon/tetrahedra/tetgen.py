# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tetrahedra by tetgen, in a subprocess, where it is installed: for surfaces that gmsh cannot fill.

$HEXCON_TETGEN names the program; if it is set but empty, tetgen is not used; else it is sought on PATH.
"""
import os
import shutil

import numpy as np

from hexcon import child, disk
from hexcon.errors import FaultCode, ToolError

from .tetrahedra_worker.shells import shells_of

# -p fill a surface, -Y keep its triangles, -q no flat tetrahedra, -z count from 0, -Q say little
OPTIONS = "-pYqzQ"
MOST = 1 << 30          # bytes of a file of tetgen's: 10^7 points
INTO_CAVITY = 1e-3      # of a triangle's size: so far from its middle lies the point that marks a cavity


def find_tetgen():
    """Path of tetgen, or None. Raises ToolError TOOL_MISSING where HEXCON_TETGEN names no program."""
    named = os.environ.get("HEXCON_TETGEN")
    if named == "":
        return None
    found = shutil.which(named or "tetgen")
    if named and not found:
        raise ToolError(f"HEXCON_TETGEN is {named}, which is no program", FaultCode.TOOL_MISSING)
    return found and os.path.abspath(found)     # work is done in another folder


def by_tetgen(program, points, triangles, timeout, progress):
    """(points (Q,3), tetrahedra (M,4)) in a closed surface, unchecked; the given points come first, bit for bit.

    points (P,3) float64, triangles (T,3) int64, outward, those of cavities into the cavity. timeout: seconds.
    Raises ToolError TOOL_FAILED (with tetgen's last words), TOOL_TIMEOUT, and what progress raises.
    """
    with disk.working_folder("hexcon-tetgen-") as folder, disk.naming(folder, f"work in {folder}"):
        path = os.path.join(folder, "surface.poly")
        _write(path, points, triangles)
        look = progress and (lambda: progress("start", 0.0))
        ended = child.run([program, OPTIONS, "surface.poly"], "tetgen", folder=folder, timeout=timeout, look=look,
                          most_files=8 * MOST)
        if ended.status != 0:
            raise _gave_up(ended)
        try:
            made, tetrahedra = (_table(os.path.join(folder, "surface.1" + ending), columns)
                                for ending, columns in ((".node", 4), (".ele", 5)))
        except (OSError, ValueError) as error:
            raise _gave_up(ended, str(error)) from error
    if len(made) < len(points) or not (np.isfinite(made).all() and np.isfinite(tetrahedra).all()):
        raise _gave_up(ended, "points are missing, or numbers are no numbers")
    if tetrahedra[:, 1:].min(initial=0) < 0 or tetrahedra[:, 1:].max(initial=0) >= len(made):
        raise _gave_up(ended, "a tetrahedron has a point that does not exist")
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


def _gave_up(ended, what="no tetrahedra"):
    return ToolError(f"tetgen {ended.how()} ({what}): {ended.last_words()}", FaultCode.TOOL_FAILED)


def _table(path, columns):
    """Rows of one of tetgen's files: a line with their number, then as many; comments begin with #.

    Raises ValueError where rows or columns are missing, or are no numbers."""
    if os.path.getsize(path) > MOST:
        raise ValueError(f"{os.path.basename(path)} is larger than {MOST >> 20} MB")
    with open(path, encoding="ascii", errors="replace") as stream:
        count = int((stream.readline().split() or ["0"])[0])
        rows = np.loadtxt(stream, ndmin=2, comments="#") if count else np.empty((0, columns))
    if len(rows) != count or rows.shape[1] < columns:
        raise ValueError(f"{os.path.basename(path)} has {len(rows)} rows of {rows.shape[1]}, not {count} of {columns}")
    return rows[:, :columns]

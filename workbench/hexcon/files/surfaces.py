# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of quad surfaces: what hexcon.quads.surface_from_file reads again, bit for bit."""
import os

import numpy as np

from hexcon.errors import FaultCode, ToolError

from . import replace_file
from .cell_kinds import CORNERS, linear_kind
from .library import cells_by_meshio
from .regular import naming_faults, regular_file
from .text import write_rows
from .through_meshio import import_meshio
from .unv_cells import read_unv

# Ending -> meshio's name of the format; .obj is written here, so that it needs no meshio.
_MESHIO_FORMATS = {".msh": "gmsh", ".inp": "abaqus", ".vtk": "vtk", ".vtu": "vtu", ".mesh": "medit"}
SURFACE_ENDINGS = (".obj", *_MESHIO_FORMATS)

# What surfaces are read from.
MESH_ENDINGS = (".msh", ".inp", ".unv", ".vtk", ".vtu", ".obj", ".mesh")

__all__ = ["MESH_ENDINGS", "SURFACE_ENDINGS", "read_cells", "write_obj", "write_surface"]


def write_surface(surface, path):
    """Write a quad surface; the ending of path decides the format: .obj .msh .inp .vtk .vtu .mesh.

    surface   .points (V,3) float, .quads (n,4) int, 0-based: a quads.QuadSurface
    The file is written beside its place and then put there: never a partial file.
    Raises ToolError: FILE_FORMAT (ending), FILE_IO, TOOL_MISSING (meshio, for all but .obj).
    """
    path = os.fspath(path)
    ending = os.path.splitext(path)[1].lower()
    if ending not in SURFACE_ENDINGS:
        raise ToolError(f"cannot write {path}: a surface is written to one of {', '.join(SURFACE_ENDINGS)}",
                        FaultCode.FILE_FORMAT)
    replace_file(path, lambda beside: _write(surface, beside, ending))


def _write(surface, path, ending):
    if ending == ".obj":
        with open(path, "w", encoding="utf-8") as stream:
            write_obj(stream, surface)
        return
    meshio = import_meshio(path)
    meshio.Mesh(surface.points, [("quad", surface.quads)]).write(path, file_format=_MESHIO_FORMATS[ending])


def write_obj(stream, surface, comments=()):
    """The surface as .obj text: comments, a v line a point, an f line a quad (1-based)."""
    for comment in comments:
        stream.write(f"# {comment}\n")
    write_rows(stream, "v %r %r %r\n", surface.points)
    write_rows(stream, "f %d %d %d %d\n", surface.quads + 1)


def read_cells(path, progress=None):
    """(points (P,3), dict of kind (keys of cell_kinds.CORNERS) -> (k, corners) rows, whether second-order elements were
    cut down) of a file with one of MESH_ENDINGS.

    All but .unv are read by a library in a process of its own; see reading.read for progress.
    Raises ToolError FILE_IO, FILE_FORMAT, TOOL_MISSING, TOOL_TIMEOUT.
    """
    path = regular_file(path)
    ending = os.path.splitext(path)[1].lower()
    if ending not in MESH_ENDINGS:
        raise ToolError(f"{ending or 'no ending'}: a surface is read from {', '.join(MESH_ENDINGS)}",
                        FaultCode.FILE_FORMAT)
    found = None if ending == ".unv" else cells_by_meshio(path, progress)
    with naming_faults(path):
        return read_unv(path) if found is None else _linear_cells(found)


def _linear_cells(found):
    """(points (P,3), dict kind -> rows, whether second-order elements were cut down)."""
    parts, second = {}, False
    for name, rows, _ in found.blocks:
        kind, linear = linear_kind(name)
        if kind:
            if rows.shape[1] < CORNERS[kind]:
                raise ValueError(f"a {name} with {rows.shape[1]} points")
            second |= not linear
            parts.setdefault(kind, []).append(rows[:, :CORNERS[kind]])
    return found.points, {k: np.concatenate(p) for k, p in parts.items()}, second

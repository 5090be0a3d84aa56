# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quad surfaces from mesh files."""
import os

import numpy as np

from hexcon.errors import FaultCode, ToolError
from hexcon.files.library import cells_by_meshio
from hexcon.files.regular import naming_faults, regular_file

from .cells import CORNERS, surface_from_cells
from .unv import read_unv

MESH_ENDINGS = (".msh", ".inp", ".unv", ".vtk", ".vtu", ".obj", ".mesh")


def surface_from_file(path, *, progress=None):
    """The closed quad surface in a .msh .inp .unv .vtk .vtu .obj or .mesh file, as a QuadSurface ("given").

    The file's quad elements, in the file's order; or, if it has volume elements and no closed set of quads, the
    outer faces of these. Second-order elements give their corners. Unused points are dropped, coincident points
    merged only if the surface is open otherwise; notes tell. All but .unv are read by a library in a process of its
    own (see files.reading); progress is called as it runs, and what it raises cancels and comes out here.
    Raises ToolError FILE_IO, FILE_FORMAT, TOOL_MISSING, TOOL_TIMEOUT, NOT_ALL_QUAD (says how many triangles), BAD_SHAPE.
    An odd surface, or one of several parts, is returned: that is for the core to judge.
    """
    path = regular_file(path)
    ending = os.path.splitext(path)[1].lower()
    if ending not in MESH_ENDINGS:
        raise ToolError(f"{ending or 'no ending'}: a surface is read from {', '.join(MESH_ENDINGS)}",
                        FaultCode.FILE_FORMAT)
    found = None if ending == ".unv" else cells_by_meshio(path, progress)
    with naming_faults(path):
        points, cells, second = read_unv(path) if found is None else _linear_cells(found)
        notes = ["second-order elements: their mid-side points are dropped"] if second else []
        return surface_from_cells(points, cells, notes)


def _linear_cells(found):
    """(points (P,3), dict kind -> rows, whether second-order elements were cut down)."""
    parts, second = {}, False
    for name, rows, _ in found.blocks:
        kind, linear = _linear_kind(name)
        if kind:
            if rows.shape[1] < CORNERS[kind]:
                raise ValueError(f"a {name} with {rows.shape[1]} points")
            second |= not linear
            parts.setdefault(kind, []).append(rows[:, :CORNERS[kind]])
    return found.points, {k: np.concatenate(p) for k, p in parts.items()}, second


def _linear_kind(name):
    """("quad", False) for quad8 and so on; (None, True) for points and lines."""
    for kind in CORNERS:
        if name == kind:
            return kind, True
        if name.startswith(kind) and name[len(kind):].isdigit():
            return kind, False
    return None, True

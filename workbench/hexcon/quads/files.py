# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quad surfaces from mesh files."""
from hexcon.files.regular import naming_faults, regular_file
from hexcon.files.surfaces import MESH_ENDINGS, read_cells

from .cells import surface_from_cells

__all__ = ["MESH_ENDINGS", "surface_from_file"]


def surface_from_file(path, *, progress=None):
    """The closed quad surface in a .msh .inp .unv .vtk .vtu .obj or .mesh file, as a QuadSurface ("given").

    The file's quad elements, in the file's order; or, if it has volume elements and no closed set of quads, the
    outer faces of these. Second-order elements give their corners. Unused points are dropped, coincident points
    merged only if the surface is open otherwise; notes tell. All but .unv are read by a library in a process of its
    own (see files.reading); progress is called as it runs, and what it raises cancels and comes out here.
    Raises ToolError FILE_IO, FILE_FORMAT, TOOL_MISSING, TOOL_TIMEOUT, NOT_ALL_QUAD (says how many triangles),
    BAD_SHAPE, and HexconError for what is no closed surface, as surface.given.
    An odd surface, or one of several parts, is returned: that is for the core to judge.
    """
    path = regular_file(path)
    points, cells, second = read_cells(path, progress)
    with naming_faults(path):
        notes = ["second-order elements: their mid-side points are dropped"] if second else []
        return surface_from_cells(points, cells, notes)

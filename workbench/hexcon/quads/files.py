# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quad surfaces from mesh files."""
from hexcon.files.readers import READERS, read_contents
from hexcon.files.regular import naming_faults, regular_file

from .cells import surface_of

MESH_ENDINGS = tuple(READERS)   # what surfaces are read from

__all__ = ["MESH_ENDINGS", "surface_from_file"]


def surface_from_file(path, *, merge_tolerance=None, progress=None, **lengths):
    """The closed quad surface in a mesh file (files.readers.READERS), as a QuadSurface ("given").

    The file's quad elements, in the file's order; or, if it has volume elements and no closed set of quads, the
    outer faces of these. Second-order elements give their corners. Unused points are dropped; points are merged where
    they are nearer than merge_tolerance, without it only if the surface is open otherwise; notes tell. Named groups of
    quads and of points are kept. What a library reads is read in a process of its own (see files.reading); progress is
    called as it runs, and what it raises cancels and comes out here.
    lengths: scale, unit, as files.readers.read_contents.
    Raises ToolError FILE_IO, FILE_FORMAT, TOOL_MISSING, TOOL_TIMEOUT, NOT_ALL_QUAD (says how many triangles),
    BAD_SHAPE, BAD_OPTION, and HexconError for what is no closed surface, as surface.given, with its cause.
    An odd surface, or one of several parts, is returned: that is for the core to judge.
    """
    path = regular_file(path)
    found = read_contents(path, progress, **lengths)
    with naming_faults(path):
        return surface_of(found, merge_tolerance)

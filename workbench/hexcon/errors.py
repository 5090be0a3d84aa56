# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faults of the programs and files around the core."""
import enum

from hexcon_native.errors import HexconError


class FaultCode(enum.Enum):
    """One member per fault; the value is the word used in logs and in --json."""

    TOOL_MISSING = "tool missing"              # gmsh, ccx or freecadcmd is not installed
    TOOL_FAILED = "tool failed"                # it ran and reported an error
    TOOL_TIMEOUT = "tool timeout"              # it ran into the time limit
    NOT_SWEEPABLE = "solid not sweepable"      # method sweep on a solid that is no sweep
    NOT_BLOCKS = "solid not made of blocks"    # method blocks on a solid with other corners, or round elsewhere
    NOT_TRANSFINITE = "solid not transfinite"  # a face without four sides
    NOT_ALL_QUAD = "not all quads"             # triangles left in the surface
    ODD_SURFACE = "odd surface"                # an odd number of quads, whatever the size
    OFF_CAD = "points off the CAD surface"     # further than 1e-7 from their CAD face
    BAD_SHAPE = "bad shape"                    # no solid, several solids, invalid geometry
    BAD_OPTION = "bad option"                  # unknown method, size <= 0, ...
    FILE_FORMAT = "file format"                # unknown ending, or not readable as such
    FILE_IO = "file input/output"              # missing, no permission, disk full
    FREECAD_MISSING = "FreeCAD missing"        # this call needs FreeCAD's Python modules
    BAD_TRIANGLES = "bad triangles"            # not closed, not outward, a point unused or not finite
    TOPOLOGICAL_MESH = "topological mesh"      # topology only, asked for where a solver would take it
    BAD_MESH = "bad mesh"                      # not a hex mesh: wrong shape, index out of range


class ToolError(HexconError):
    """A fault outside the core; `code` is a FaultCode."""

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What reads each mesh file: one table, for hex meshes and for surfaces alike. The ending decides."""
import functools
import os

from hexcon.errors import FaultCode, ToolError

from .deck import read_deck
from .lengths import UNITS, doubt
from .library import contents_by
from .medit_reading import read_medit
from .nastran_reading import read_nastran
from .obj_reading import read_obj
from .off_reading import read_off
from .regular import naming_faults, regular_file
from .unv_reading import read_unv


def _by(reader, program):
    """A library's reader, in a process that can be told to stop: callable(path, progress=...)."""
    return functools.partial(contents_by, reader, program=program)


def _refuse_stl(path):
    raise ToolError(f"{path}: STL holds triangles only; HexCon needs quads. Mesh the solid itself (STEP, BREP, "
                    ".FCStd), or write quads from the program that made it (.obj, .ply, .msh)", FaultCode.NOT_ALL_QUAD)


_VTK, _GMSH = _by("mesh", "VTK"), _by("mesh", "gmsh")

# ending -> callable(path) -> contents.Contents; those by _by take progress too, and file_worker/mesh.py says which
# library reads what. Of the others each says why no library does.
READERS = {
    ".inp": read_deck, ".unv": read_unv, ".msh": _GMSH, ".vtk": _VTK, ".vtu": _VTK, ".mesh": read_medit,
    ".obj": read_obj, ".med": _by("med", "FreeCAD"), ".fcstd": _by("document", "FreeCAD"), ".bdf": read_nastran,
    ".nas": read_nastran, ".ply": _VTK, ".off": read_off, ".exo": _VTK, ".e": _VTK, ".ex2": _VTK, ".cgns": _VTK,
    **dict.fromkeys((".vtp", ".vts", ".vtr", ".vti"), _VTK), ".stl": _refuse_stl}


def read_contents(path, progress=None, *, scale=1.0, unit=None):
    """contents.Contents of a mesh file with one of READERS' endings.

    scale, unit: what lengths are multiplied by, and one of lengths.UNITS that they are in; None: mm, or what the file
    says
    progress: callable(stage, fraction), called before and while it is read: what it raises cancels and comes out here.
    Raises ToolError FILE_FORMAT, FILE_IO, TOOL_MISSING, TOOL_TIMEOUT, FREECAD_MISSING (.med).
    """
    path = regular_file(path)
    ending = os.path.splitext(path)[1].lower()
    if ending not in READERS:
        raise ToolError(f"cannot read {path}: ending {ending or '(none)'} is unknown; one of {', '.join(READERS)} is "
                        f"possible",
                        FaultCode.FILE_FORMAT)
    if progress is not None:
        progress("read", 0.0)
    reader = READERS[ending]
    with naming_faults(path):
        found = reader(path, progress=progress) if isinstance(reader, functools.partial) else reader(path)
        _check(found, path)
        _scale(found, path, scale, unit)
    return found


def _scale(found, path, scale, unit):
    if unit is not None and found.converted:
        raise ToolError(f"{path} says what unit its lengths are in, and they are converted to mm: leave --unit, or "
                        f"take "
                        "--scale", FaultCode.BAD_OPTION)
    factor = scale * (1.0 if unit is None else UNITS[unit])
    if factor != 1.0:
        found.points = found.points * factor
        found.notes.append(f"lengths multiplied by {factor:g}")
    found.notes += doubt(found.points)


def _check(found, path):
    """Raise for cells that name points which are not there."""
    for kind, rows in found.cells.items():
        if rows.size and (rows.min() < 0 or rows.max() >= len(found.points)):
            raise ToolError(f"{path}: a {kind} names a point that does not exist", FaultCode.FILE_FORMAT)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What reads each mesh file: one table, for hex meshes and for surfaces alike. The ending decides."""
import functools
import os

from hexcon.errors import FaultCode, ToolError

from .deck import read_deck
from .library import contents_by
from .regular import naming_faults, regular_file
from .unv_reading import read_unv


def _by(reader, program):
    return functools.partial(_through, reader, program)


def _through(reader, program, path, progress=None):
    return contents_by(reader, path, program, progress)


_VTK, _MESHIO = _by("mesh", "VTK"), _by("mesh", "meshio")

# ending -> callable(path, progress) -> contents.Contents
READERS = {".inp": read_deck, ".unv": read_unv, ".msh": _MESHIO, ".vtk": _VTK, ".vtu": _VTK, ".mesh": _MESHIO,
           ".obj": _MESHIO, ".med": _by("med", "FreeCAD")}
_IN_THIS_PROCESS = (read_deck, read_unv)


def read_contents(path, progress=None):
    """contents.Contents of a mesh file with one of READERS' endings.

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
        found = reader(path) if reader in _IN_THIS_PROCESS else reader(path, progress)
        _check(found, path)
    return found


def _check(found, path):
    """Raise for cells that name points which are not there."""
    for kind, rows in found.cells.items():
        if rows.size and (rows.min() < 0 or rows.max() >= len(found.points)):
            raise ToolError(f"{path}: a {kind} names a point that does not exist", FaultCode.FILE_FORMAT)

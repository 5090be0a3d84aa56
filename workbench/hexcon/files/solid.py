# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids in CAD files and FreeCAD documents: FreeCAD opens them in a process of its own and writes them as BREP."""
import os

from hexcon import disk, freecad_compat
from hexcon.answers import Array

from . import reading
from .regular import regular_file
from .solid_choice import choice_of

_TABLE = {"face_numbers": Array("i", ("faces",), 1), "notes": Array("s", ("notes",))}


def solid_as_brep(path, brep, progress=None):
    """Write the one solid of a .FCStd, .step, .brep, .iges ... file, or the one of a SolidChoice, to a new file.

    Returns (numbers (f,) of its faces in the shape that the file holds, None where they are the same; notes).
    Raises ToolError: BAD_SHAPE (no solid, several, not closed, not valid), BAD_OPTION, and those of reading.read.
    """
    found = _converted(path, brep, True, progress)
    return (found["face_numbers"] if len(found["face_numbers"]) else None), [str(note) for note in found["notes"]]


def shape_of_file(path):
    """The Part shape in such a file. Raises ToolError as solid_as_brep, and FREECAD_MISSING."""
    part = freecad_compat.freecad_module("Part")
    with disk.working_folder("hexcon-shape-") as folder:
        brep = os.path.join(folder, "shape.brep")
        _converted(path, brep, False, None)
        return part.read(brep)  # OpenCASCADE's own writing, of what it could read before


def _converted(path, brep, alone, progress):
    choice = choice_of(path)
    return reading.read("solid", regular_file(path), _TABLE, program="FreeCAD", progress=progress,
                        brep=os.path.abspath(brep), alone=alone, choice=choice.as_dict())

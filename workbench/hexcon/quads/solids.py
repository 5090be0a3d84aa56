# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solid to surface: the caller's side of the gmsh subprocess."""
import os
from dataclasses import replace

import numpy as np

from hexcon.errors import FaultCode, ToolError
from hexcon.files.lengths import doubt
from hexcon.files.regular import regular_file
from hexcon.files.shapes import IGES_ENDINGS, from_shape
from hexcon.files.solid import solid_as_brep
from hexcon.files.solid_choice import choice_of
from hexcon.gmsh_process import run_job

from . import local_sizes as sizes_by_place
from .checked_numbers import check_number
from .fit import fit_of
from .gmsh_worker.methods import METHODS, VOLUME_ERROR
from .surface import finished

CAD_ENDINGS = (".step", ".stp", ".brep", ".brp", *IGES_ENDINGS)


def surface_from_solid(shape_or_file, size, method="auto", *, local_sizes=(), per_turn=0, volume_error=0.0, care=0,
                       timeout=120.0, progress=None):
    """A closed, outward, even QuadSurface on the boundary of one solid.

    shape_or_file  a FreeCAD Part.Shape, or the path of a .step .stp .brep .brp file (plain Python will do), or
                   of a .FCStd .iges .igs file (needs FreeCAD), or a files.solid_choice.SolidChoice of one solid in a file
    size           wanted edge length, in the units of the shape (millimetres)
    method         one of METHODS
    local_sizes    smaller sizes at places: {"Face3": 1.5, "Edge7": 0.5, "Vertex1": 0.3, "point:x,y,z": 1.0,
                   "ball:x,y,z,radius": 1.0, "box:x,y,z,x,y,z": 1.0}, or texts "Face3=1.5"; away from there elements
                   grow. Methods that follow no local sizes are left out by auto, and refused otherwise
    per_turn       so many quads are wanted round a full turn of round faces; 0: as many as come by the size
    volume_error   part of the volume that chords of round faces may cut: more quads are taken there. 0: VOLUME_ERROR, which
                   only a grid follows; others say where it is exceeded
    care           0: the first good surface; 1, 2, ...: so many of the coarser ways are passed over, for where no hexes
                   could be made in those (subdivided-triangles: smaller at curves and narrow places)
    timeout        seconds for gmsh
    progress       callable(stage, fraction in 0..1); an exception from it cancels and comes out here

    Points lie on their CAD faces within 1e-7 * max(1, diagonal / 1000). Where the CAD's own edges and corners are
    further off its faces, the points lie on the edge or the corner and a note says so, up to 1/20 of the size.
    Raises ToolError: BAD_OPTION, BAD_SHAPE, FILE_IO, FILE_FORMAT, FREECAD_MISSING, TOOL_MISSING, TOOL_TIMEOUT,
    TOOL_FAILED, NOT_SWEEPABLE, NOT_BLOCKS, NOT_REVOLVED, NOT_LAYERED, NOT_BOXED, NOT_GRIDDED, NOT_FILLED,
    NOT_TRANSFINITE, NOT_ALL_QUAD, ODD_SURFACE, OFF_CAD.
    """
    _check_options(size, method, timeout, per_turn, volume_error)
    local_sizes = sizes_by_place.parsed(local_sizes)
    source, numbers_of, read_notes = source_of(shape_or_file, progress)
    job = {"method": method, "size": float(size), "care": int(care), "local_sizes": local_sizes,
           "per_turn": int(per_turn), "volume_error": float(volume_error)}

    def write(folder):
        path = source(folder)
        job["local_sizes"] = sizes_by_place.of_the_solid(local_sizes, numbers_of())
        return path
    try:
        found = run_job("gmsh_worker", write, job, timeout, progress)
    except ToolError as fault:
        raise naming_file(fault, shape_or_file) from fault
    notes = [*read_notes, *(str(n) for n in found["notes"])]
    _check_distance(found, notes)
    notes += doubt(found["points"])
    faces = found["faces"]
    face_numbers = numbers_of()
    if face_numbers is not None:
        faces = np.asarray(face_numbers, np.int64)[faces - 1]
    fit = fit_of(found, face_numbers)
    notes += fit.notes(volume_error or VOLUME_ERROR) if fit else []
    return replace(finished(found["points"], found["quads"], faces, str(found["method"]), notes, found.get("hexes")),
                   size=float(size), fit=fit, pieces=_pieces_of(found))


def _pieces_of(found):
    """QuadSurface.pieces; of an answer that has none, or whose counts are not of its hexes: ()."""
    counts = found.get("piece_hexes", np.zeros(0, np.int64)).tolist()
    if not counts or "hexes" not in found or sum(counts) != len(found["hexes"]):
        return ()
    return tuple(zip((str(name) for name in found["piece_names"]), counts))


def _check_options(size, method, timeout, per_turn, volume_error):
    if method not in METHODS:
        raise ToolError(f"unknown method {method!r}; there are {', '.join(METHODS)}", FaultCode.BAD_OPTION)
    check_number("size", size)
    check_number("timeout", timeout)
    check_number("per_turn", per_turn, at_least_zero=True)
    check_number("volume_error", volume_error, at_least_zero=True)


def _check_distance(found, notes):
    """Raise OFF_CAD for points off their faces; note the gaps that the CAD itself has."""
    off, tolerance = found["off_cad"], float(found["tolerance"])
    bad = np.flatnonzero(~(off <= tolerance))
    if len(bad):
        faces = np.unique(found["faces"][np.isin(found["quads"], bad).any(axis=1)])
        raise ToolError(f"{len(bad)} points are off their CAD faces, by up to {np.fmax.reduce(off):.3g} "
                        f"(allowed {tolerance:.3g}; on edges and corners of the CAD that are themselves off its faces, "
                        f"1/20 of the size), at " + ", ".join(f"Face{f}" for f in faces[:10]), FaultCode.OFF_CAD, bad)
    gap = float(found["cad_gap"].max(initial=0.0))
    if gap > 0.0:
        notes.append(f"the CAD's edges and corners are up to {gap:.3g} off its faces; points there lie on them")


def naming_file(fault, shape_or_file):
    """The fault, with the file's name in it where there is a file."""
    path = os.fsdecode(shape_or_file) if isinstance(shape_or_file, (str, os.PathLike)) else ""
    return fault if path in str(fault) else ToolError(f"{path}: {fault}", fault.code, fault.elements)


def source_of(shape_or_file, progress):
    """(callable(folder) -> CAD path, callable() -> face numbers of the caller's shape, None if they are 1, 2, 3, ...,
    list of notes); the second is called, and the third is filled, after the first."""
    if not isinstance(shape_or_file, (str, os.PathLike)):
        write, face_numbers = from_shape(shape_or_file)

        def write_into(folder):
            path = os.path.join(folder, "solid.brep")
            write(path)
            return path
        return write_into, lambda: face_numbers, []
    choice, path = choice_of(shape_or_file), regular_file(shape_or_file)
    ending = os.path.splitext(path)[1].lower()
    if ending != ".fcstd" and ending not in CAD_ENDINGS:
        raise ToolError(f"{ending or 'no ending'}: a solid is read from {', '.join(CAD_ENDINGS)} or .FCStd",
                        FaultCode.FILE_FORMAT)
    if ending in (".fcstd", *IGES_ENDINGS) or not choice.plain:
        return _through_freecad(shape_or_file, progress)
    return (lambda folder: path), lambda: None, []


def _through_freecad(path, progress):
    """As source_of, of a file that FreeCAD reads."""
    numbers, notes = [], []

    def write(folder):
        brep = os.path.join(folder, "solid.brep")
        found, told = solid_as_brep(path, brep, progress)
        numbers.append(found)
        notes[:] = told
        return brep
    return write, lambda: numbers[-1], notes

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of order 2 curved: middle nodes of the boundary on the solid's edges and faces, certified."""
import os

import numpy as np

from hexcon import disk
from hexcon.errors import FaultCode, ToolError
from hexcon.gmsh_process import run_job
from hexcon.quads.solids import naming_file, source_of

from .curving_worker import ON_EDGE, ON_FACE, STRAIGHT
from .judging import judge_again

MOST_LISTED = 1000


def curve(mesh, shape_or_file, *, timeout=120.0, progress=None):
    """Curve a mesh of order 2 in place: its boundary edges come to lie on the solid.

    mesh           a hexcon_native.Mesh of order 2 with .face_of_quad: the 1-based CAD face of each boundary quad
    shape_or_file  the solid: as of quads.surface_from_solid
    timeout        seconds for gmsh;  progress: callable(stage, fraction), an exception from it cancels
    The middle of an edge that runs along an edge of the solid goes to the nearest place on that, of any other edge of
    the boundary to the nearest place on its face. Where a hex would fold, inner edges near it bend as well, and inner
    corners move; what still folds gets as much of the curvature as is proved positive, and faces that would cross as
    much as is proved apart. Corners of the boundary stay where they are.
    mesh.certificate and quality are those of the curved hexes; mesh.report["curved"] tells: edges on_edges, on_faces,
    straight (that found no place), inner (that bend inside), moved (inner corners), reduced {hex: part of its
    curvature}, and of the curved mesh and the CAD volume, cad_volume, area, cad_area, chord: how far its faces are off
    the CAD at most, by 25 places of each. Raises ToolError: those of surface_from_solid but for options. Linear.
    """
    found = _placed(mesh, shape_or_file, timeout, progress)
    mesh.points[:] = found["points"]
    on, factor = found["on"], found["factor"]
    reduced = np.flatnonzero(factor < 1.0)
    mesh.report["curved"] = {
        "on_edges": int((on == ON_EDGE).sum()), "on_faces": int((on == ON_FACE).sum()),
        "straight": int((on == STRAIGHT).sum()), "inner": int(found["inner"]), "moved": int(found["moved"]),
        "reduced_count": len(reduced),
        "reduced": {int(h): float(factor[h]) for h in reduced[:MOST_LISTED]},
        **{name: float(found[name]) for name in ("volume", "cad_volume", "area", "cad_area", "chord")}}
    judge_again(mesh, progress)


def _placed(mesh, shape_or_file, timeout, progress):
    """The worker's answer."""
    source, numbers_of, _ = source_of(shape_or_file, progress)
    given = np.asarray(mesh.face_of_quad, np.int64)

    def write(folder):
        path = source(folder)
        disk.write_arrays(os.path.join(folder, "mesh.npz"),
                          {"points": mesh.points, "hexes": mesh.hexes, "quads": mesh.quads,
                           "faces": _of_file(given, numbers_of())})
        return path
    try:
        found = run_job("curving_worker", write, {}, timeout, progress)
    except ToolError as fault:
        raise naming_file(fault, shape_or_file) from fault
    if len(found["points"]) != len(mesh.points) or len(found["factor"]) != len(mesh.hexes):
        raise ToolError("what gmsh handed back is damaged: it is another mesh", FaultCode.TOOL_FAILED)
    return found


def _of_file(faces, numbers):
    """The caller's face numbers as the file's; numbers: the caller's of each of the file's, or None."""
    if numbers is None:
        return faces
    numbers = np.asarray(numbers, np.int64)
    order = np.argsort(numbers)
    return order[np.searchsorted(numbers[order], faces)] + 1

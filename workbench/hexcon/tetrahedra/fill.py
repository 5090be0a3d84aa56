# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface to tetrahedra: by gmsh, or where it finds none, by tetgen."""
import math
import os
import time

import numpy as np

from hexcon import disk
from hexcon.errors import FaultCode, ToolError
from hexcon.gmsh_process import run_job

from .check import check_surface, fault_of
from .quality import diced_quality
from .relax import relax
from .split import split_doubles
from .tetgen import by_tetgen, find_tetgen

ALGORITHMS = ("Delaunay", "HXT")
_FOR_TETGEN = (FaultCode.TOOL_MISSING, FaultCode.TOOL_FAILED)     # gmsh's faults after which there is time left


def tetrahedralise(points, triangles, *, timeout=120.0, deadline=None, progress=None, coarsening=0.5):
    """Graded tetrahedra in a closed surface, whose triangles are kept: (points (Q,3) float64, tetrahedra (M,4) int32).

    points      (P,3) float64; they come back as the first P rows, bit for bit
    triangles   (T,3) int, counter-clockwise seen from outside; every point belongs to one
    timeout     seconds for gmsh
    deadline    of time.monotonic: after it, points are no longer moved, and nothing else is begun; None: there is none
    progress    callable(stage, fraction in 0..1); an exception from it cancels and comes out here
    coarsening  how much longer an edge is for each unit of distance from the surface: 0 as on the surface, 0.5
                about 1 to 8 tetrahedra a triangle

    det(b - a, c - a, d - a) > 0 for each tetrahedron (a, b, c, d), in exact arithmetic. The boundary faces are the
    given triangles, of the outer shell and of cavities, whose triangles face into the cavity; a tetrahedron with two of them is a good one. Of gmsh's algorithms the
    one is taken whose worst tetrahedron, diced into four hexes, is best; its inner points are then moved to make the
    worst hexes better.
    HXT of gmsh 4.8 may differ a little from run to run. Where gmsh finds none, tetgen is asked if it is installed
    (see tetgen.py): it makes no graded ones.
    Raises ToolError: BAD_TRIANGLES (not closed, ...), BAD_OPTION, TOOL_MISSING, TOOL_TIMEOUT, TOOL_FAILED (neither
    could do it, as where the surface crosses itself; the message tells the reasons).
    Cost: about a second, and another for every 2,000 triangles.
    """
    _check_options(timeout, coarsening)
    points, triangles = np.ascontiguousarray(points, np.float64), np.asarray(triangles)
    check_surface(points, triangles)
    triangles = triangles.astype(np.int64)

    candidates, reasons = _by_gmsh(points, triangles, coarsening, timeout, progress)
    if not candidates and not _is_over(deadline):
        candidates, more = _by_tetgen(points, triangles, timeout, progress)
        reasons += more
    for _, mesh_points, tetrahedra in sorted(candidates, key=lambda mesh: -mesh[0]):
        mesh_points = relax(mesh_points, tetrahedra, len(points), lambda: _goes_on(deadline, progress))
        reason = fault_of(mesh_points, tetrahedra, points, triangles)
        if reason is None:
            return mesh_points, tetrahedra.astype(np.int32)
        reasons.append(reason)
    raise ToolError("the surface could not be filled with tetrahedra; " + "; ".join(reasons), FaultCode.TOOL_FAILED)


def _is_over(deadline):
    return deadline is not None and time.monotonic() > deadline


def _goes_on(deadline, progress):
    """Whether there is time left; progress is asked too, and may raise."""
    if progress is not None:
        progress("relax", 1.0)
    return not _is_over(deadline)


def _by_gmsh(points, triangles, coarsening, timeout, progress):
    """([(worst quality, points, tetrahedra), ...], [reasons]); raises what run_job does, unless tetgen is there."""
    def write(folder):
        path = os.path.join(folder, "surface.npz")
        disk.write_arrays(path, {"points": points, "triangles": triangles})
        return path
    try:
        found = run_job("tetrahedra_worker", write, {"coarsening": float(coarsening)}, timeout, progress)
    except ToolError as fault:
        if fault.code not in _FOR_TETGEN or not find_tetgen():
            raise
        return [], [str(fault)]
    return _candidates(found, points, triangles, progress)


def _by_tetgen(points, triangles, timeout, progress):
    """As _by_gmsh; nothing where tetgen is not installed."""
    program = find_tetgen()
    if not program:
        return [], []
    try:
        mesh = _oriented(*by_tetgen(program, points, triangles, timeout, progress))
    except ToolError as fault:
        return [], [str(fault)]
    reason = fault_of(*mesh, points, triangles)
    if reason is not None:
        return [], [f"tetgen: {reason}"]
    mesh = split_doubles(*mesh)
    return [(float(diced_quality(*mesh).min()), *mesh)], []


def _check_options(timeout, coarsening):
    for name, value, least in (("timeout", timeout, "above zero"), ("coarsening", coarsening, "of at least zero")):
        try:
            number = float(value)
        except (TypeError, ValueError):
            number = math.nan
        if not (math.isfinite(number) and (number > 0.0 or name == "coarsening" and number == 0.0)):
            raise ToolError(f"{name} must be a finite number {least}, not {value!r}", FaultCode.BAD_OPTION)


def _candidates(found, points, triangles, progress):
    """([(worst quality, points, tetrahedra), ...], [why an algorithm's work is not among them, ...])."""
    made, reasons = [], []
    for name in ALGORITHMS:
        if progress is not None:
            progress("check", 1.0)
        if name + "_tetrahedra" in found:
            mesh = _oriented(found[name + "_points"], found[name + "_tetrahedra"].astype(np.int64))
            reason = fault_of(*mesh, points, triangles)
        else:
            reason = str(found.get(name + "_fault", "not tried"))
        if reason is None:
            mesh = split_doubles(*mesh)
            made.append((float(diced_quality(*mesh).min()), *mesh))
        else:
            reasons.append(f"{name}: {reason}")
    return made, reasons


def _oriented(points, tetrahedra):
    """Two corners exchanged if the tetrahedra as a whole are inside out, as some versions of gmsh number them."""
    if len(tetrahedra) and np.linalg.det(points[tetrahedra[:, 1:]] - points[tetrahedra[:, :1]]).sum() < 0.0:
        tetrahedra = tetrahedra[:, [0, 2, 1, 3]]
    return points, tetrahedra

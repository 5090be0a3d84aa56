# SPDX-License-Identifier: LGPL-2.1-or-later
"""Given hex meshes smoothed on the solid that they mesh: points slide on its faces and edges."""
import os
from dataclasses import dataclass, field

import numpy as np

import hexcon_native
from hexcon import disk
from hexcon.curving import curve
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.elements import elements_of
from hexcon.files import read_mesh
from hexcon.gmsh_process import run_job
from hexcon.quads.checked_numbers import check_number
from hexcon.quads.solids import naming_file, source_of

ENOUGH = 0.3        # scaled Jacobian above which, as for method auto, the mean decides
MEAN_PASSES = 4     # of hexcon_native.optimize


@dataclass
class Smoothed:
    """A mesh with all of its points in their old rows, of order 2 with middle nodes after them.

    points (P,3), hexes (H,8|20) VTK order, quads (n,4) its boundary, outward; face_of_quad (n,): 1-based CAD face
    certificate, quality   of the mesh as it is;  before: the Quality of the mesh that was given
    improved               False: no better mesh was found, and the points are those that were given
    dimension (P,)         0: lies at a corner of the solid, 1: on an edge, 2: on a face, 3: inside, or on nothing
    off (P,)               how far the given points of the boundary were off the solid
    kept                   points of the boundary that lie on nothing and were kept where they are
    notes                  what else is to be said, in words
    """

    points: np.ndarray
    hexes: np.ndarray
    quads: np.ndarray
    face_of_quad: np.ndarray
    certificate: hexcon_native.Certificate
    quality: hexcon_native.Quality
    before: hexcon_native.Quality
    improved: bool
    dimension: np.ndarray
    off: np.ndarray
    kept: np.ndarray
    notes: list
    order: int = 1
    report: dict = field(default_factory=dict)


def smooth(mesh, shape_or_file, *, order=1, tolerance=0.0, keep=False, timeout=120.0, progress=None):
    """Smooth a hex mesh on the solid that it meshes, hexes and boundary together; a Smoothed.

    mesh           mesh-like: .points, .hexes (H,8|20); or the path of a hex mesh file. Of order 2 the corners count
    shape_or_file  the solid: as of quads.surface_from_solid
    order          of the mesh that comes out; 2: its edges are curved on the solid, see curving.curve
    tolerance      how far a point of the boundary may be off the solid and is still taken to lie on it, in the unit of
                   both; 0: 1/100 of the boundary edges about the point
    keep           True: points that lie on nothing are kept where they are; False: they are refused. More than half
                   are refused in any case
    timeout        seconds for gmsh and the relaxation in its process; the relaxation ends after half of them with
                   the best so far
    progress       callable(stage, fraction); an exception from it cancels and comes out here
    Points near a corner of the solid are put there and stay; those near a sharp edge slide along it; all others slide
    on their face and those that continue it smoothly (by less than 25 degrees). Then the inside is improved with the
    boundary held (hexcon_native.optimize), and the mesh certified. The better mesh is returned: a certified one before
    one that is not, fewer hexes that are not positive, the higher worst scaled Jacobian (what is above 0.3 counts the
    same), the higher mean.
    Raises HexconError: those of quads.surface_from_solid and files.read_mesh, BAD_MESH, NOT_ON_SOLID (elements:
    points).
    Cost: some Newton steps on the mesh, and for curves and patches without a closed form (splines; several faces) a
    projection by gmsh for each of their points and each step.
    """
    if order not in (1, 2):
        raise ToolError(f"order must be 1 or 2, not {order!r}", FaultCode.BAD_OPTION)
    check_number("tolerance", tolerance, at_least_zero=True)
    check_number("timeout", timeout)
    if isinstance(mesh, (str, os.PathLike)):
        mesh = read_mesh(mesh, progress=progress)
    given = elements_of(mesh, 1)
    points, hexes, quads = given.points, given.hexes, given.quads
    before = hexcon_native.certify(points, hexes, quads), hexcon_native.quality(points, hexes)
    found = _relaxed(given, shape_or_file, {"tolerance": float(tolerance), "keep": bool(keep)}, timeout, progress)
    after_points = hexcon_native.optimize(found["points"], hexes, _boundary(quads, len(points)),
                                          mean_passes=MEAN_PASSES, progress=progress)
    after = hexcon_native.certify(after_points, hexes, quads), hexcon_native.quality(after_points, hexes)
    improved = _rank(*after) > _rank(*before)
    certificate, quality = after if improved else before
    smoothed = Smoothed(after_points if improved else points, hexes, quads, found["faces"], certificate, quality,
                        before[1], improved, found["dimension"], found["off"], found["kept"],
                        [str(n) for n in found["notes"]])
    if order == 2:
        smoothed.points, smoothed.hexes = hexcon_native.raise_order(smoothed.points, hexes)
        smoothed.order = order
        curve(smoothed, shape_or_file, timeout=timeout, progress=progress)
    return smoothed


def _relaxed(given, shape_or_file, job, timeout, progress):
    """The worker's answer."""
    source, numbers_of, read_notes = source_of(shape_or_file, progress)

    def write(folder):
        disk.write_arrays(os.path.join(folder, "mesh.npz"),
                          {"points": given.points, "hexes": given.hexes, "quads": given.quads})
        return source(folder)
    try:
        found = run_job("smoothing_worker", write, job, timeout, progress)
    except ToolError as fault:
        raise naming_file(fault, shape_or_file) from fault
    if len(found["points"]) != len(given.points) or len(found["faces"]) != len(given.quads):
        raise ToolError("what gmsh handed back is damaged: it is another mesh", FaultCode.TOOL_FAILED)
    numbers = numbers_of()
    if numbers is not None:
        found["faces"] = np.asarray(numbers, np.int64)[found["faces"] - 1]
    found["notes"] = [*read_notes, *found["notes"]]
    return found


def _boundary(quads, count):
    fixed = np.zeros(count, bool)
    fixed[quads] = True
    return fixed


def _rank(certificate, quality):
    return certificate.certified, -len(certificate.nonpositive), min(quality.min, ENOUGH), quality.mean

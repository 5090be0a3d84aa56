# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a quad surface, or from a solid, to a hex mesh: certified, or of topology only."""
import time

import hexcon_native
from hexcon_native import ErrorCode, HexconError

from ..errors import ToolError
from ..quads import surface_from_solid
from ..tetrahedra import tetrahedralise
from ..topological import is_topological

_ABOUT_THE_SURFACE = (ErrorCode.NOT_SWEPT, ErrorCode.NO_SHEETS, ErrorCode.NOT_DICED, ErrorCode.NOT_STAR_SHAPED,
                      ErrorCode.UNFILLABLE_QUAD, ErrorCode.NOT_BIPARTITE, ErrorCode.NO_HEX_MESH, ErrorCode.NOT_CERTIFIED)

# How fast tetrahedra inside grow, up to this many triangles and beyond: slow growth makes a fifth
# more hexes, somewhat better ones, and takes twice as long to improve.
_FINE, _FINE_TRIANGLES, _COARSE = 0.5, 1000, 1.0

__all__ = ["mesh_quad_surface", "mesh_solid", "mesh_surface", "raising"]


def mesh_surface(points, quads, method="auto", *, timeout=120.0, progress=None, **options):
    """Fill a quad surface; arguments, result and errors as hexcon_native.mesh.

    The mesh of a topological method says so in report["topological"]; with certify=False its
    certificate and quality are None.
    Where cells or diced need tetrahedra inside, gmsh is asked for them (timeout: seconds for each call), as
    long as it is there; report["gmsh"] lists what it said where it found none.
    """
    said = []
    mesh = hexcon_native.mesh(points, quads, method, progress=progress,
                              tetrahedralise=_gmsh_tetrahedra(timeout, progress, said), **options)
    if said:
        mesh.report["gmsh"] = said
    mesh.report["topological"] = is_topological(mesh)
    return mesh


def _gmsh_tetrahedra(timeout, progress, said):
    """A tetrahedral mesher for the core, which goes on without where gmsh finds nothing."""
    def fill(points, triangles):
        coarsening = _FINE if len(triangles) <= _FINE_TRIANGLES else _COARSE
        try:
            filled, tetrahedra = tetrahedralise(points, triangles, timeout=timeout,
                                                coarsening=coarsening,
                                                progress=_as_one_stage(progress))
        except ToolError as fault:
            said.append(str(fault))
            return None
        return filled[len(points):], tetrahedra
    return fill


def _as_one_stage(progress):
    """gmsh's stages are not the surface's of the same names: they are all "tetrahedra inside"."""
    report = raising(progress)
    return report and (lambda _, fraction: report("tetrahedra inside", fraction))


def mesh_quad_surface(surface, method="auto", **options):
    """As mesh_surface for a quads.QuadSurface; the mesh gets .surface and .face_of_quad.

    A fault of the core has the surface as its .surface: where .elements are quads, they are its rows.
    """
    try:
        mesh = mesh_surface(surface.points, surface.quads, method, **options)
    except HexconError as fault:
        fault.surface = surface
        if fault.code in _ABOUT_THE_SURFACE and surface.notes:
            told = HexconError(f"{fault} (the surface: {'; '.join(surface.notes)})", fault.code, fault.elements)
            told.surface = surface
            raise told from fault
        raise
    mesh.surface = surface
    mesh.face_of_quad = surface.face_of_quad
    mesh.report["surface method"] = surface.method
    mesh.report["surface notes"] = list(surface.notes)
    return mesh


def mesh_solid(shape_or_file, size, *, surface_method="auto", method="auto", timeout=120.0,
               progress=None, **options):
    """A hex mesh of one solid: certified, but for the topological methods and allow_uncertified.

    shape_or_file   a FreeCAD Part.Shape, or the path of a .step .stp .brep .brp .FCStd file
    size            wanted edge length, in the unit of the shape (mm)
    surface_method  how its surface is meshed with quads: hexcon.quads.METHODS
    method          how the surface is filled: hexcon_native.METHODS
    timeout         seconds for gmsh
    progress        callable (stage, fraction); returning False or raising cancels
    options         order, layers, threads, budget, allow_uncertified, and for the topological methods
                    pairing and certify: as hexcon_native.mesh
    Returns a Mesh with more attributes: .surface (quads.QuadSurface), .face_of_quad ((n,) int64,
    1-based CAD face of each boundary quad) and .solid (shape_or_file).
    Raises HexconError: those of quads.surface_from_solid and hexcon_native.mesh.
    """
    hexcon_native.check_options(method, **{name: options[name] for name in
                                           ("order", "layers", "threads", "pairing", "budget")
                                           if name in options})
    started = time.monotonic()
    surface = surface_from_solid(shape_or_file, size, surface_method, timeout=timeout,
                                 progress=raising(progress))
    seconds = time.monotonic() - started
    mesh = mesh_quad_surface(surface, method, timeout=timeout, progress=progress, **options)
    mesh.solid = shape_or_file
    mesh.report["seconds surface"] = seconds
    return mesh


def raising(progress):
    """A progress for surfaces, which cancel by exception only: a False is turned into one."""
    if progress is None:
        return None

    def report(stage, fraction):
        if progress(stage, fraction) is False:
            raise HexconError(f"cancelled during {stage}", ErrorCode.CANCELLED)
    return report

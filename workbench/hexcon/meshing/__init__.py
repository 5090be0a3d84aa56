# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a quad surface, or from a solid, to a hex mesh: certified, or of topology only."""
import time

import hexcon_native
from hexcon_native import ErrorCode, HexconError

from ..errors import FaultCode, ToolError
from ..quads import METHOD_TABLE as SURFACE_METHOD_TABLE
from ..quads import surface_from_solid
from ..tetrahedra import tetrahedralise
from ..topological import is_topological

_ABOUT_THE_SURFACE = (ErrorCode.NOT_SWEPT, ErrorCode.NO_SHEETS, ErrorCode.NOT_DICED, ErrorCode.NOT_STAR_SHAPED,
                      ErrorCode.UNFILLABLE_QUAD, ErrorCode.NOT_BIPARTITE, ErrorCode.NO_HEX_MESH, ErrorCode.NOT_CERTIFIED,
                      ErrorCode.SELF_INTERSECTING)

# A surface of another size may do where these are the matter.
_WORTH_ANOTHER = (*_ABOUT_THE_SURFACE, ErrorCode.NON_MANIFOLD_VERTEX, ErrorCode.NON_MANIFOLD_EDGE, FaultCode.OFF_CAD,
                  FaultCode.NOT_ALL_QUAD, FaultCode.ODD_SURFACE)

# What auto tries next: parts of the size, and how careful the surface is to be (see surface_from_solid).
_MORE_TRIES = ((0.94, 1), (0.88, 2), (0.8, 3))

# Surfaces of more quads than this are diced before anything else where their method says so: no other method makes
# fewer hexes of them, and to look for layers takes longer than to dice.
_DICED_FIRST = 600

# How fast tetrahedra inside grow, up to this many triangles and beyond: slow growth makes a fifth
# more hexes, somewhat better ones, and takes twice as long to improve.
_FINE, _FINE_TRIANGLES, _COARSE = 0.5, 1000, 1.0

__all__ = ["mesh_quad_surface", "mesh_solid", "mesh_surface", "raising"]


def mesh_surface(points, quads, method="auto", *, timeout=120.0, progress=None, **options):
    """Fill a quad surface; arguments, result and errors as hexcon_native.mesh.

    The mesh of a topological method says so in report["topological"]; with certify=False its
    certificate and quality are None.
    Where cells or diced need tetrahedra inside, gmsh is asked for them (timeout: seconds for each call), as
    long as it is there; report["gmsh"] lists what it said where it found none. A budget ends its work, too.
    """
    said = []
    mesher = _gmsh_tetrahedra(timeout, _deadline(options), progress, said)
    mesh = hexcon_native.mesh(points, quads, method, progress=progress, tetrahedralise=mesher, **options)
    if said:
        mesh.report["gmsh"] = said
    mesh.report["topological"] = is_topological(mesh)
    return mesh


def _deadline(options):
    """When the monotonic clock says so, the budget among the options is used up; None: there is none."""
    budget = options.get("budget")
    return time.monotonic() + budget if isinstance(budget, (int, float)) and budget > 0 else None


def _gmsh_tetrahedra(timeout, deadline, progress, said):
    """A tetrahedral mesher for the core, which goes on without where gmsh finds nothing."""
    def fill(points, triangles):
        coarsening = _FINE if len(triangles) <= _FINE_TRIANGLES else _COARSE
        left = timeout if deadline is None else min(timeout, deadline - time.monotonic())
        if left <= 0.0:
            return None     # the core finds out by itself
        try:
            filled, tetrahedra = tetrahedralise(points, triangles, timeout=left, coarsening=coarsening,
                                                deadline=deadline, progress=_as_one_stage(progress))
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
    budget          (an option, see below) seconds for all of it: the surface, and what is left of them for the
                    hexes. Reading the file and handing over the mesh come on top. Without time left for hexes:
                    OUT_OF_TIME
    With both methods "auto", and unless there is a budget, other surfaces are tried where the first cannot be
    filled: somewhat smaller elements, and smaller ones at curves and narrow places; report["surface tries"] tells.
    options         order, layers, threads, budget, allow_uncertified, and for the topological methods
                    pairing and certify: as hexcon_native.mesh
    Returns a Mesh with more attributes: .surface (quads.QuadSurface), .face_of_quad ((n,) int64,
    1-based CAD face of each boundary quad) and .solid (shape_or_file).
    Raises HexconError: those of quads.surface_from_solid and hexcon_native.mesh.
    """
    hexcon_native.check_options(method, **{name: options[name] for name in
                                           ("order", "layers", "threads", "pairing", "budget")
                                           if name in options})
    tries = [(1.0, 0)]
    if surface_method == "auto" and method == "auto" and not options.get("budget"):
        tries += _MORE_TRIES

    deadline = _deadline(options)

    def surface_of(factor, care):
        return surface_from_solid(shape_or_file, size if factor == 1.0 else factor * size, surface_method, care=care,
                                  timeout=timeout, progress=_limited(raising(progress), deadline))
    mesh, seconds = _first_filled(surface_of, tries, method, deadline,
                                  {"timeout": timeout, "progress": progress, **options})
    mesh.solid = shape_or_file
    mesh.report["seconds surface"] = seconds
    return mesh


def _limited(progress, deadline):
    """A progress for surfaces that ends them once the budget is used up: their programs are killed."""
    if deadline is None:
        return progress

    def report(stage, fraction):
        if time.monotonic() > deadline:
            raise _out_of_time()
        if progress is not None:
            progress(stage, fraction)
    return report


def _out_of_time():
    return HexconError("the time budget ran out while the surface was being made, before there was a mesh: allow "
                       "more time, or mesh with larger quads", ErrorCode.OUT_OF_TIME)


def _in_budget(options, deadline):
    """The options with what is left of the budget; raises OUT_OF_TIME where nothing is."""
    if deadline is None:
        return options
    left = deadline - time.monotonic()
    if left <= 0.0:
        raise _out_of_time()
    return {**options, "budget": left}


def _first_filled(surface_of, tries, method, deadline, options):
    """(mesh, seconds for surfaces): of the first of the tries, arguments of surface_of, that can be filled."""
    told, seconds = [], 0.0
    for one in tries:
        started = time.monotonic()
        try:
            surface = surface_of(*one)
            seconds += time.monotonic() - started
            mesh = _filled(surface, method, deadline, options, last=one == tries[-1])
            break
        except HexconError as fault:
            if one == tries[-1] or not _is_worth_another(fault):
                raise
            told.append(f"{one[0]:g} times the size: {fault.code.name}: {fault}")
    if told:
        mesh.report["surface tries"] = told
    return mesh, seconds


def _filled(surface, method, deadline, options, last):
    """mesh_quad_surface; large surfaces of some methods are diced first. last: no other surface comes after."""
    row = SURFACE_METHOD_TABLE.get(surface.method)  # none of given quads
    large = len(surface.quads) > _DICED_FIRST and row is not None and row.diced_first
    if method == "auto" and large and not options.get("layers"):
        try:
            return mesh_quad_surface(surface, "diced", **{**_in_budget(options, deadline), "allow_uncertified": False})
        except HexconError as fault:
            if not last or not _is_worth_another(fault):
                raise
    return mesh_quad_surface(surface, method, **_in_budget(options, deadline))


def _is_worth_another(fault):
    """Whether another surface of the same solid may do."""
    return fault.code in _WORTH_ANOTHER or (fault.code is FaultCode.BAD_SHAPE and bool(fault.elements))


def raising(progress):
    """A progress for surfaces, which cancel by exception only: a False is turned into one."""
    if progress is None:
        return None

    def report(stage, fraction):
        if progress(stage, fraction) is False:
            raise HexconError(f"cancelled during {stage}", ErrorCode.CANCELLED)
    return report

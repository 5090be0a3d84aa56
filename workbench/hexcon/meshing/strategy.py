# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one road from a solid, or from quads, to hexes: what is tried, and what comes next where it fails.

mesh_solid, the command line, the batch and the document objects all go it, so one input gives one mesh.
"""
import time
from dataclasses import dataclass, replace

import hexcon_native
from hexcon_native import ErrorCode, HexconError

from ..curving import curve
from ..curving.given import curve_as_given
from ..errors import FaultCode
from ..quads import METHOD_TABLE as SURFACE_METHOD_TABLE, surface_from_solid
from ..quads.fit import notes_of_curved
from ..quads.solids import VOLUME_ERROR
from ..topological import is_topological
from .filling import mesh_surface
from .progress import deadline_of, in_budget, limited, raising

_ABOUT_THE_SURFACE = (ErrorCode.NOT_SWEPT, ErrorCode.NO_SHEETS, ErrorCode.NOT_DICED, ErrorCode.NOT_STAR_SHAPED,
                      ErrorCode.UNFILLABLE_QUAD, ErrorCode.NOT_BIPARTITE, ErrorCode.NO_HEX_MESH,
                      ErrorCode.NOT_CERTIFIED, ErrorCode.SELF_INTERSECTING)

# A surface of another size may do where these are the matter.
_WORTH_ANOTHER = (*_ABOUT_THE_SURFACE, ErrorCode.NON_MANIFOLD_VERTEX, ErrorCode.NON_MANIFOLD_EDGE, ErrorCode.NOT_CLOSED,
                  ErrorCode.NOT_ORIENTABLE, ErrorCode.REPEATED_VERTEX, ErrorCode.NOT_FINITE, FaultCode.OFF_CAD,
                  FaultCode.NOT_ALL_QUAD, FaultCode.ODD_SURFACE)

# After these no method goes on where another was refused.
_ENDS_ALL = (ErrorCode.CANCELLED, ErrorCode.OUT_OF_TIME, ErrorCode.OUT_OF_MEMORY)

# After these a mesh of order 2 is there, but with straight edges.
_STAYS_STRAIGHT = (FaultCode.TOOL_FAILED, FaultCode.TOOL_TIMEOUT, ErrorCode.OUT_OF_TIME)
_OF_QUADS_ALONE = "edges are straight: the hexes were made of quads alone, without their solid"
_FACES_UNKNOWN = "edges are straight: it is not known on which face of the solid each quad lies"

# Surfaces of more quads than this are diced before anything else where their method says so: no other method makes
# fewer hexes of them, and to look for layers takes longer than to dice.
_DICED_FIRST = 600

_CHECKED = ("order", "layers", "threads", "pairing", "pillow", "budget")    # what hexcon_native.check_options looks at


@dataclass(frozen=True)
class Try:
    """A surface to be tried: what part of the size, and how careful (see quads.surface_from_solid).

    crossing: only where the quads of the one before cross, as in walls much thinner than they are long
    """

    factor: float
    care: int
    crossing: bool = False


TRIES = (Try(1.0, 0), Try(0.94, 1), Try(0.88, 2), Try(0.8, 3), Try(0.5, 3, crossing=True))


class Strategy:
    """What is wanted of a mesh, and the order in which it is tried.

    method          how surfaces are filled: hexcon_native.METHODS
    surface_method  how a solid's surface is meshed with quads: hexcon.quads.METHODS
    timeout         seconds for gmsh, each time
    local_sizes, per_turn, volume_error  of a solid's surface: see quads.surface_from_solid
    options         as mesh_surface
    With both methods "auto", and without a budget, the surfaces of TRIES are tried until one is filled. Of each
    come first: the hexes that its method has in mind (QuadSurface.hexes), then, of large surfaces made to be
    diced, dicing, then `method`; for the first two only where `method` is "auto" and no layers are asked for.
    Raises HexconError BAD_ARGUMENT for options that hexcon_native.mesh would refuse.
    """

    def __init__(self, method="auto", surface_method="auto", *, timeout=120.0, local_sizes=(), per_turn=0,
                 volume_error=0.0, **options):
        hexcon_native.check_options(method, **{name: options[name] for name in _CHECKED if name in options})
        self.method, self.surface_method = method, surface_method
        self._timeout, self._options = timeout, options
        wanted = {"local_sizes": local_sizes, "per_turn": per_turn, "volume_error": volume_error}
        self._sizes = {name: value for name, value in wanted.items() if value}

    @property
    def tries(self):
        """The surfaces of a solid that are tried, the first of which has the size asked for."""
        free = self.method == self.surface_method == "auto" and not self._options.get("budget")
        return TRIES if free else TRIES[:1]

    def of_solid(self, shape_or_file, size, progress=None, first=None):
        """Mesh of a solid; the arguments as hexcon.mesh_solid's.

        first   the QuadSurface of the first try, where there is one already
        mesh.surface tells by .tried and .size which it became; report["surface tries"] what was the matter with
        those before. Raises HexconError: that of the last try.
        """
        deadline, tries = deadline_of(self._options), self.tries
        told, seconds = [], 0.0
        for number, one in enumerate(tries):
            started = time.monotonic()
            try:
                surface = first if number == 0 and first is not None else \
                    self._surface(shape_or_file, size, number, limited(raising(progress), deadline))
                seconds += time.monotonic() - started
                mesh = self._fill(surface, progress, deadline,
                                  last=all(after.crossing for after in tries[number + 1:]))
                break
            except HexconError as fault:
                if not _is_worth_going_on(tries[number + 1:], fault):
                    raise
                told.append(f"{one.factor:g} times the size: {fault.code.name}: {fault}")
        if told:
            mesh.report["surface tries"] = told
        mesh.solid = shape_or_file
        mesh.report["seconds surface"] = seconds
        self._curve(mesh, shape_or_file, progress, deadline)
        return mesh

    def of_surface(self, surface, progress=None, solid=None):
        """Mesh of a quads.QuadSurface as it is; result and faults as hexcon.mesh_quad_surface's.

        solid   what it was made of, as of_solid's: edges of order 2 come to lie on it; None: they are straight
        """
        deadline = deadline_of(self._options)
        mesh = self._fill(surface, progress, deadline, last=True)
        if solid is not None:
            self._curve(mesh, solid, progress, deadline)
        elif self._is_to_be_curved(mesh):
            if surface.middles is not None:
                curve_as_given(mesh, *surface.middles, progress=limited(raising(progress), deadline))
            else:
                mesh.report["straight edges"] = _OF_QUADS_ALONE
        return mesh

    def _is_to_be_curved(self, mesh):
        """Whether it is of order 2, and for solvers."""
        return self._options.get("order", 1) == 2 and not is_topological(mesh)

    def _curve(self, mesh, solid, progress, deadline):
        """Curve what is of order 2 and for solvers. Where its CAD faces are not known, or gmsh or the time fails, edges
        stay straight, and the report says so."""
        if not self._is_to_be_curved(mesh):
            return
        if not (mesh.face_of_quad > 0).all():
            mesh.report["straight edges"] = _FACES_UNKNOWN
            return
        started = time.monotonic()
        try:
            curve(mesh, solid, timeout=self._timeout, progress=limited(raising(progress), deadline))
        except HexconError as fault:
            if fault.code not in _STAYS_STRAIGHT:
                raise
            mesh.report["straight edges"] = f"edges stay straight: {fault.code.name}: {fault}"
        else:
            told = mesh.report["curved"]
            mesh.report["surface notes"] = notes_of_curved(mesh.report["surface notes"],
                                                           told["volume"] / told["cad_volume"] - 1.0,
                                                           self._sizes.get("volume_error", VOLUME_ERROR))
        mesh.report["seconds curved edges"] = time.monotonic() - started

    def _surface(self, shape_or_file, size, number, progress):
        factor, care = TRIES[number].factor, TRIES[number].care
        made = surface_from_solid(shape_or_file, size if factor == 1.0 else factor * size, self.surface_method,
                                  care=care, timeout=self._timeout, progress=progress, **self._sizes)
        return replace(made, tried=number)

    def _fill(self, surface, progress, deadline, last):
        """Of the ways to fill one surface the first that goes. last: no other surface comes after."""
        refused = []
        if surface.hexes is not None and self._is_free():
            try:
                return _naming_pieces(self._filled(surface, "proposal", progress, deadline, hexes=surface.hexes,
                                                   allow_uncertified=False), surface.pieces)
            except HexconError as fault:
                if fault.code in _ENDS_ALL:
                    raise
                refused.append(f"proposal: {fault.code.name}: {fault}")
        if _is_diced_first(surface) and self._is_free():
            try:
                mesh = self._filled(surface, "diced", progress, deadline, allow_uncertified=False)
                return _telling(mesh, refused)
            except HexconError as fault:
                if not last or not is_worth_another(fault):
                    raise
                refused.append(f"diced: {fault.code.name}: {fault}")
        hexes = {"hexes": surface.hexes} if self.method == "proposal" and surface.hexes is not None else {}
        return _telling(self._filled(surface, self.method, progress, deadline, **hexes), refused)

    def _is_free(self):
        """Whether the strategy may choose the method."""
        return self.method == "auto" and not self._options.get("layers")

    def _filled(self, surface, method, progress, deadline, **more):
        """The mesh with its surface; a fault of the core has the surface as its .surface."""
        options = in_budget({**self._options, **more}, deadline)
        try:
            mesh = mesh_surface(surface.points, surface.quads, method, timeout=self._timeout, progress=progress,
                                **options)
        except HexconError as fault:
            fault.surface = surface
            if fault.code in _ABOUT_THE_SURFACE and surface.notes:
                told = HexconError(f"{fault} (the surface: {'; '.join(surface.notes)})", fault.code, fault.elements)
                told.surface = surface
                raise told from fault
            raise
        mesh.surface = surface
        mesh.face_of_quad = surface.face_of_quad
        mesh.quad_groups, mesh.node_groups = surface.quad_groups, surface.node_groups
        mesh.report["surface method"] = surface.method
        mesh.report["surface notes"] = list(surface.notes)
        if surface.fit is not None:
            mesh.report["fit"] = surface.fit.as_dict()
        return mesh


def _naming_pieces(mesh, pieces):
    """The mesh, its report telling of the pieces as of stages, unless it has stages of its own: a pillow, say."""
    if pieces and sum(count for _, count in pieces) == len(mesh.hexes) and not any(
            k.startswith("hexes of") for k in mesh.report):
        mesh.report.update({f"hexes of {name}": count for name, count in pieces})
    return mesh


def _is_diced_first(surface):
    row = SURFACE_METHOD_TABLE.get(surface.method)  # none of given quads
    return row is not None and row.diced_first and len(surface.quads) > _DICED_FIRST


def _telling(mesh, refused):
    """The mesh, its log beginning with what was tried before it."""
    mesh.report["log"][:0] = refused
    return mesh


def _is_worth_going_on(left, fault):
    """Whether the first of the tries that are left may do."""
    return bool(left) and is_worth_another(fault) and (not left[0].crossing
                                                       or fault.code is ErrorCode.SELF_INTERSECTING)


def is_worth_another(fault):
    """Whether another surface of the same solid may do."""
    return fault.code in _WORTH_ANOTHER or (fault.code is FaultCode.BAD_SHAPE and bool(fault.elements))

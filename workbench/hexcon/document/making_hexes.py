# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hex mesh objects, made and made anew, and reports of their quality.

These are calls for macros; hexcon.gui.actions has them too.
"""
from hexcon import freecad_compat, preferences
from hexcon.meshing import mesh_solid
from hexcon.objects import (
    hex_mesh as hex_mesh_objects,
    quad_surface as quad_surface_objects,
    quality_report as quality_report_objects,
)
from hexcon.objects.parametric import solid_shape
from hexcon.objects.quad_surface import TIMEOUT
from hexcon.pillows import pillow_of
from hexcon.quads.local_sizes import written
from hexcon.topological import refuse_topological_method

from .changing import hide, update
from .prepared import taken


def make_hex_mesh(surface_object, *, method="auto", layers=0, pillow="auto", order=1, budget=0.0,
                  allow_topological=False):
    """Fill a quad surface object with hexes; returns the new FEM mesh object.

    The quads are taken as they are. Where other quads of the same solid may do as well: mesh_solid_object.

    method, layers, pillow, order, budget  as hexcon_native.mesh; pillow at most 3 here
    allow_topological  make the object even by a method of topology only; it is marked as such
    Raises HexconError: those of hexcon.mesh_quad_surface.
    """
    settings = {"method": method, "layers": layers, "pillow": pillow, "order": order, "budget": float(budget),
                "allow_topological": allow_topological}
    mesh = taken() or hex_mesh_objects.job_of(surface_object, **settings)[1](None)
    document = surface_object.Document
    with freecad_compat.transaction(document, "Hex mesh"):
        made = hex_mesh_objects.add_hex_mesh(document, mesh, surface_object, settings)
        hide(surface_object, surface_object.Source)
    return made


def update_hex_mesh(mesh_object, **settings):
    """Make a hex mesh anew with other settings: those of make_hex_mesh, and try_other_surfaces. Raises as that."""
    whole = {"method": mesh_object.Method, "layers": mesh_object.Layers, "pillow": mesh_object.Pillow,
             "order": int(mesh_object.Order),
             "budget": mesh_object.Budget, "allow_topological": mesh_object.AllowTopological,
             "try_other_surfaces": mesh_object.TryOtherSurfaces, **settings}
    mark, job = hex_mesh_objects.job_of(mesh_object.Surface, **whole)
    update(mesh_object, taken() or job(None), mark, settings,
            hex_mesh_objects.set_settings)


def mesh_solid_object(solid_object, size, *, surface_method="auto", method="auto", local_sizes=(), per_turn=0,
                      layers=0, pillow="auto", order=1, budget=0.0, timeout=TIMEOUT, allow_topological=False):
    """The short road: mesh a solid's surface with quads, and fill it; returns the hex mesh object.

    solid_object    a document object whose Shape holds exactly one solid
    size            wanted edge length, mm
    surface_method  hexcon.quads.METHODS
    method          hexcon_native.METHODS
    local_sizes, per_turn  smaller elements at places of the solid, as hexcon.quads.surface_from_solid
    layers          cells: at least so many layers of plain hexes under the surface
    pillow          sheets of hexes under the surface, as hexcon_native.mesh; at most 3 here
    order           1 (C3D8) or 2 (C3D20R)
    budget          seconds after which the best mesh until then is taken; 0: no limit
    timeout         seconds for gmsh
    allow_topological  make the object even by a method of topology only; it is marked as such
    The quad surface object is the mesh's Surface; it and the solid are hidden, as the mesh covers
    them. Where the quads of that size cannot be filled, others are tried, here and whenever the mesh is made anew;
    the surface object keeps the size asked for, and its SizeUsed tells that of its quads.
    Raises HexconError: those of hexcon.meshing.mesh_solid and femmesh.add_to_document.
    """
    refuse_topological_method(method, allow_topological)  # before the work, not after it
    of_surface = {"source": solid_object, "size": float(size), "method": surface_method,
                  "local_sizes": written(local_sizes), "per_turn": int(per_turn)}
    of_mesh = {"method": method, "layers": layers, "pillow": pillow, "order": order, "budget": float(budget),
               "allow_topological": allow_topological, "try_other_surfaces": True}
    shape = solid_shape(solid_object)
    mesh = taken() or mesh_solid(
        shape, size, surface_method=surface_method, method=method, local_sizes=local_sizes, per_turn=per_turn,
        layers=layers, pillow=pillow_of(pillow), order=order, budget=budget, timeout=timeout,
        threads=preferences.value("Threads"))
    mark, _ = quad_surface_objects.job_of(**of_surface)
    document = solid_object.Document
    with freecad_compat.transaction(document, "Hex mesh"):
        surface = quad_surface_objects.add_quad_surface(document, mesh.surface, mark, of_surface)
        made = hex_mesh_objects.add_hex_mesh(document, mesh, surface, of_mesh)
        hide(surface, solid_object)
    return made


def make_quality_report(mesh_object, worst=10):
    """A quality report object about a FEM mesh object of hexes; returns it.

    worst  how many of the worst elements it lists. It follows the mesh on recompute.
    Raises HexconError as check_mesh_object.
    """
    mark, job = quality_report_objects.job_of(mesh_object)
    result = taken() or job(None)
    document = mesh_object.Document
    with freecad_compat.transaction(document, "Quality report"):
        return quality_report_objects.add_quality_report(document, mesh_object, result, mark, worst)

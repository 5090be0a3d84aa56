# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a quad surface, or from a solid, to a hex mesh: certified, or of topology only."""
from .filling import mesh_surface
from .progress import raising
from .strategy import Strategy

__all__ = ["Strategy", "mesh_quad_surface", "mesh_solid", "mesh_surface", "raising"]


def mesh_quad_surface(surface, method="auto", *, timeout=120.0, progress=None, **options):
    """As mesh_surface for a quads.QuadSurface; the mesh gets .surface and .face_of_quad.

    With method "auto" what the surface's own method knows comes first: see strategy.Strategy.
    A fault of the core has the surface as its .surface: where .elements are quads, they are its rows.
    """
    return Strategy(method, timeout=timeout, **options).of_surface(surface, progress)


def mesh_solid(shape_or_file, size, *, surface_method="auto", method="auto", local_sizes=(), per_turn=0,
               volume_error=0.0, timeout=120.0, progress=None, **options):
    """A hex mesh of one solid: certified, but for the topological methods and allow_uncertified.

    shape_or_file   a FreeCAD Part.Shape, or the path of a .step .stp .brep .brp .FCStd file
    size            wanted edge length, in the unit of the shape (mm)
    surface_method  how its surface is meshed with quads: hexcon.quads.METHODS
    method          how the surface is filled: hexcon_native.METHODS
    local_sizes, per_turn, volume_error  smaller elements at faces, edges, corners, points, balls, boxes; quads round a
                    full turn; part of the volume that chords may cut: as hexcon.quads.surface_from_solid
    timeout         seconds for gmsh
    progress        callable (stage, fraction); returning False or raising cancels
    budget          (an option, see below) seconds for all of it: the surface, and what is left of them for the
                    hexes. Reading the file and handing over the mesh come on top. Without time left for hexes:
                    OUT_OF_TIME
    With both methods "auto", and unless there is a budget, other surfaces are tried where the first cannot be
    filled: somewhat smaller elements, and smaller ones at curves and narrow places; report["surface tries"] tells,
    and mesh.surface.size the size used.
    options         order, layers, threads, budget, allow_uncertified, and for the topological methods
                    pairing and certify: as hexcon_native.mesh
    Returns a Mesh with more attributes: .surface (quads.QuadSurface), .face_of_quad ((n,) int64,
    1-based CAD face of each boundary quad) and .solid (shape_or_file).
    Raises HexconError: those of quads.surface_from_solid and hexcon_native.mesh.
    """
    return Strategy(method, surface_method, timeout=timeout, local_sizes=local_sizes, per_turn=per_turn,
                    volume_error=volume_error, **options).of_solid(shape_or_file, size, progress)

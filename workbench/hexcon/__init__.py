# SPDX-License-Identifier: LGPL-2.1-or-later
"""HexCon: hexahedral meshes that keep a given quad surface, from solid to solved model.

The core (hexcon_native) and the programs around it: gmsh for quad surfaces, FreeCAD's FEM
workbench and CalculiX behind. FreeCAD is imported only by the calls that need it.
"""
from hexcon_native import HexconError, Mesh, __version__

from .errors import FaultCode, ToolError
from .examples import example, example_names
from .meshing import mesh_quad_surface, mesh_solid, mesh_surface
from .smoothing import smooth

__all__ = ["FaultCode", "HexconError", "Mesh", "ToolError", "__version__", "example", "example_names",
           "mesh_quad_surface", "mesh_solid", "mesh_surface", "smooth", "solve", "to_femmesh", "write"]


def to_femmesh(mesh, order=None, *, allow_topological=False):
    """FreeCAD's Fem.FemMesh of a mesh; see hexcon.femmesh.to_femmesh."""
    from .femmesh import to_femmesh as convert
    return convert(mesh, order, allow_topological=allow_topological)


def write(mesh, path, **options):
    """Write a mesh file; the ending of the path decides. See hexcon.files.write."""
    from .files import write as write_file
    write_file(mesh, path, **options)


def solve(doc, mesh, solid, **options):
    """Solve in a FreeCAD document through CalculiX; see hexcon.calculix.solve."""
    from .calculix import solve as run
    return run(doc, mesh, solid, **options)

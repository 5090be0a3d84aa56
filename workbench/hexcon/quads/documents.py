# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quad surfaces from objects of FreeCAD documents."""
from hexcon.errors import FaultCode, ToolError
from hexcon.files.femmesh_contents import contents_of_femmesh
from hexcon.freecad_compat import shape_of

from .cells import surface_of


def surface_from_object(obj):
    """The closed quad surface ("given") in a FreeCAD document object.

    A FEM mesh object gives its quad faces, or the outer faces of its volumes. A FreeCAD Mesh object holds
    triangles only and is refused with NOT_ALL_QUAD; an object with a Shape with BAD_OPTION (surface_from_solid
    is for those). Raises ToolError, also BAD_SHAPE and ODD_SURFACE.
    """
    if hasattr(obj, "FemMesh"):
        return surface_from_femmesh(obj.FemMesh)
    name = getattr(obj, "Label", type(obj).__name__)
    if hasattr(obj, "Mesh"):
        count = getattr(obj.Mesh, "CountFacets", 0)
        raise ToolError(f"{name} is a FreeCAD mesh of {count} triangles; such a mesh cannot hold quads. Make a quad "
                        "mesh of the solid with hexcon.quads (Part, Create shape from mesh, if there is no solid), "
                        "or read the quads from their file into a FEM mesh", FaultCode.NOT_ALL_QUAD)
    if shape_of(obj) is not None:
        raise ToolError(f"{name} is a solid, not a mesh: use surface_from_solid with its Shape",
                        FaultCode.BAD_OPTION)
    raise ToolError(f"{name} has neither a mesh nor a shape", FaultCode.BAD_OPTION)


def surface_from_femmesh(mesh):
    """The same for a Fem.FemMesh, its groups included. About 2 microseconds per node and element."""
    return surface_of(contents_of_femmesh(mesh))

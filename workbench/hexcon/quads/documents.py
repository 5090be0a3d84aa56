# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quad surfaces from objects of FreeCAD documents."""
import numpy as np

from hexcon.errors import FaultCode, ToolError

from .cells import surface_from_cells

_FACES = {3: "triangle", 6: "triangle", 4: "quad", 8: "quad", 9: "quad"}
_VOLUMES = {4: "tetra", 10: "tetra", 5: "pyramid", 13: "pyramid", 6: "wedge", 15: "wedge", 8: "hexahedron",
            20: "hexahedron", 27: "hexahedron"}
_CORNERS = {"triangle": 3, "quad": 4, "tetra": 4, "pyramid": 5, "wedge": 6, "hexahedron": 8}


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
    if hasattr(obj, "Shape"):
        raise ToolError(f"{name} is a solid, not a mesh: use surface_from_solid with its Shape",
                        FaultCode.BAD_OPTION)
    raise ToolError(f"{name} has neither a mesh nor a shape", FaultCode.BAD_OPTION)


def surface_from_femmesh(mesh):
    """The same for a Fem.FemMesh. About 2 microseconds per node and element in FreeCAD's Python interface."""
    nodes = mesh.Nodes
    row = {n: k for k, n in enumerate(nodes)}
    points = np.array([(p.x, p.y, p.z) for p in nodes.values()], float).reshape(-1, 3)
    cells, second = {}, False
    for ids, kinds in ((mesh.Faces, _FACES), (mesh.Volumes, _VOLUMES)):
        for i in ids:
            element = mesh.getElementNodes(i)
            kind = kinds.get(len(element))
            if kind:
                second |= len(element) > _CORNERS[kind]
                cells.setdefault(kind, []).append([row[n] for n in element[:_CORNERS[kind]]])
    notes = ["second-order elements: their mid-side points are dropped"] if second else []
    return surface_from_cells(points, cells, notes)

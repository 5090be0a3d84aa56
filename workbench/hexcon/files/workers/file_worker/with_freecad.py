# SPDX-License-Identifier: LGPL-2.1-or-later
"""What only FreeCAD reads: .med (SMESH), documents, and shapes through OpenCASCADE."""
import contextlib
import os

import numpy as np

from .mesh import mesh_arrays
from .refusal import Refusal


@contextlib.contextmanager
def _named():
    """Faults of hexcon's own become refusals with their code."""
    from hexcon.errors import ToolError
    try:
        yield
    except ToolError as fault:
        raise Refusal(fault.code.name, str(fault), fault.elements) from fault


def read_med(job):
    """The arrays of a mesh of hexahedra, VTK order."""
    with _named():
        from hexcon.femmesh.convert import from_femmesh
        from hexcon.freecad_compat import fem_module
        femmesh = fem_module("Fem").read(job["file"])
        if not femmesh.NodeCount:
            raise Refusal("FILE_FORMAT", "FreeCAD finds no mesh in it: it looks for one that is called like the file, so "
                          "give a renamed file its first name back")
        mesh = from_femmesh(femmesh)
    kind = "hexahedron20" if mesh.order == 2 else "hexahedron"
    boundary = None if mesh.quads is None else (mesh.quads, mesh.face_of_quad)
    return mesh_arrays(mesh.points, [(kind, mesh.hexes, None)], boundary=boundary)


def read_solid(job):
    """Write the shape in a document or CAD file to job["brep"]; with job["alone"] its one solid alone.

    Returns {"face_numbers": (f,) the numbers of the solid's faces in the shape}, empty where they are the same.
    """
    with _named():
        from hexcon.files import shapes
        from hexcon.freecad_compat import freecad_module
        if job["file"].lower().endswith(".fcstd"):
            shape = shapes.shape_in_document_file(job["file"])
        else:
            shape = freecad_module("Part").read(job["file"])
        numbers = None
        if job["alone"]:
            write, numbers = shapes.from_shape(shape)
            write(job["brep"])
        else:
            shape.exportBrep(job["brep"])
    if not os.path.exists(job["brep"]):
        raise Refusal("FILE_IO", "FreeCAD wrote no shape of it")
    return {"face_numbers": np.array([] if numbers is None else numbers, np.int64)}

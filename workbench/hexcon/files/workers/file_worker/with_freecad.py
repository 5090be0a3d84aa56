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
    """The arrays of a mesh, VTK order, with its groups."""
    with _named():
        from hexcon.files.femmesh_contents import contents_of_femmesh
        from hexcon.freecad_compat import fem_module
        femmesh = fem_module("Fem").read(job["file"])
        if not femmesh.NodeCount:
            raise Refusal("FILE_FORMAT", "FreeCAD finds no mesh in it: it looks for one that is called like the file, so "
                          "give a renamed file its first name back")
        found = contents_of_femmesh(femmesh)
    return mesh_arrays(found.points, list(found.cells.items()), [(g.name, g.kind, g.rows) for g in found.groups])


def read_document(job):
    """The arrays of the one FEM mesh in a document."""
    with _named():
        from hexcon.files.archive import check_document
        from hexcon.files.femmesh_contents import contents_of_femmesh
        from hexcon.freecad_compat import fem_module, freecad
        check_document(job["file"])
        fem_module("Fem")       # the types of FEM meshes, which the document names
        try:
            document = freecad().openDocument(job["file"], True)
        except Exception as error:
            raise Refusal("FILE_FORMAT", f"FreeCAD cannot open it: {error}") from error
        meshes = [o for o in document.Objects if o.isDerivedFrom("Fem::FemMeshObject") and o.FemMesh.NodeCount]
        solids = [o for o in meshes if o.FemMesh.VolumeCount] or meshes
        if len(solids) != 1:
            raise Refusal("FILE_FORMAT", f"{len(solids)} FEM meshes are in it"
                          + (f" ({', '.join(o.Label for o in solids)})" if solids else "") + "; exactly one is needed")
        found = contents_of_femmesh(solids[0].FemMesh)
    return mesh_arrays(found.points, list(found.cells.items()), [(g.name, g.kind, g.rows) for g in found.groups],
                       [f"FEM mesh {solids[0].Label} of the document"])


def read_solid(job):
    """Write the shape that job["choice"] means, of a document or CAD file, to job["brep"]; with job["alone"] its one
    solid alone.

    Returns {"face_numbers": (f,) the numbers of the solid's faces in the shape, empty where they are the same; "notes"}.
    """
    with _named():
        from hexcon.files import shapes
        from hexcon.files.solid_choice import SolidChoice
        from hexcon.freecad_compat import freecad_module
        choice, numbers, notes = SolidChoice(job["file"], **job["choice"]), None, []
        if job["alone"] or not choice.plain or job["file"].lower().endswith(".fcstd"):
            shape, row, notes = shapes.chosen_shape(job["file"], choice)
            write, numbers = shapes.from_shape(shape, row) if job["alone"] else (shape.exportBrep, None)
        else:
            write = freecad_module("Part").read(job["file"]).exportBrep     # of several solids, too
        write(job["brep"])
    if not os.path.exists(job["brep"]):
        raise Refusal("FILE_IO", "FreeCAD wrote no shape of it")
    return {"face_numbers": np.array([] if numbers is None else numbers, np.int64), "notes": np.array(notes, str)}

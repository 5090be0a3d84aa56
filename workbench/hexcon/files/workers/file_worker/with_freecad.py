# SPDX-License-Identifier: LGPL-2.1-or-later
"""What only FreeCAD reads: .med (SMESH), documents, and shapes through OpenCASCADE."""
import contextlib
import os
import re
import tempfile

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


_MOST_NAMES = 400       # tried in a .med file
_NO_MESHES = {b"ENS_MAA", b"FAS", b"MAI", b"NOE", b"COO", b"FAM", b"NUM", b"NOD", b"NOM", b"TREE", b"HEAP", b"SNOD", b"GRO",
              b"ELEME", b"FAMILLE_ZERO", b"INFOS_GENERALES", b"CHA", b"PROFILS"}


def _names_in(data):
    """Texts in an HDF5 file that may be names of links: with their length before them, or ended by a NUL."""
    found = {}
    for run in re.finditer(rb"[ -.0-~]{1,80}", data):
        start = run.start()
        for at in (start, start + 1):
            length = data[at - 1] if at else 0
            word = data[at:at + length]
            if 0 < length <= 64 and at + length <= run.end():
                found[word] = None
        if data[run.end():run.end() + 1] == b"\0" and len(run.group()) <= 64:
            found[run.group()] = None
    return [word for word in found if word not in _NO_MESHES]


def _by_name(read, path):
    """The mesh in a .med file: FreeCAD looks for one that is called like the file, and files are called otherwise.

    So each text in the file that may be a name is tried, by a link of that name, until there is a mesh."""
    femmesh = read(path)
    if femmesh.NodeCount:
        return femmesh
    with open(path, "rb") as stream:
        data = stream.read()
    for word in _names_in(data)[:_MOST_NAMES]:
        with tempfile.TemporaryDirectory(dir=os.getcwd()) as folder:
            link = os.path.join(folder, word.decode("ascii").strip() + ".med")
            try:
                os.symlink(path, link)
                found = read(link)
            except Exception:
                continue
            if found.NodeCount:
                return found
    raise Refusal("FILE_FORMAT", "FreeCAD finds no mesh in it, by the name of the file or by any text in the file")


def read_med(job):
    """The arrays of a mesh, VTK order, with its groups."""
    with _named():
        from hexcon.files.femmesh_contents import contents_of_femmesh
        from hexcon.freecad_compat import fem_module
        femmesh = _by_name(fem_module("Fem").read, job["file"])
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

# SPDX-License-Identifier: LGPL-2.1-or-later
""".FCStd and .med: the endings that need FreeCAD's modules."""
import os
import zipfile

from hexcon import freecad_compat

from .solid import shape_of_file


def _shape(solid):
    """A Part shape of a shape, or of the path of a file that holds one solid."""
    return shape_of_file(solid) if isinstance(solid, (str, os.PathLike)) else solid


def write_fcstd(path, elements, solid=None, name="HexMesh"):
    """A document with the mesh object and, where given, its solid (a Part shape, or a path)."""
    from hexcon.femmesh.convert import femmesh_of_elements
    from hexcon.femmesh.document import insert
    app = freecad_compat.freecad()
    femmesh = femmesh_of_elements(elements)
    active = app.ActiveDocument
    doc = app.newDocument("HexConExport", hidden=True, temp=True)
    try:
        solid_object = None
        if solid is not None:
            solid_object = doc.addObject("Part::Feature", "Solid")
            solid_object.Shape = _shape(solid)
        insert(doc, femmesh, solid_object, name, elements.topological)
        doc.recompute()
        _by_freecad(doc.saveCopy, path)
    finally:
        app.closeDocument(doc.Name)
        if active is not None:
            app.setActiveDocument(active.Name)
    _complete(path)


def write_med(path, elements):
    """MED with groups, through FreeCAD's FemMesh (SMESH)."""
    from hexcon.femmesh.convert import femmesh_of_elements
    _by_freecad(femmesh_of_elements(elements).write, path)


def _by_freecad(write, path):
    """write(path), whatever FreeCAD raises as an OSError; it reports some failures on the console only."""
    try:
        write(path)
    except Exception as error:  # a class of FreeCAD's own; its words are MED's C++ calls
        raise OSError(f"FreeCAD could not write it: {error}") from error
    if not os.path.exists(path) or not os.path.getsize(path):
        raise OSError("FreeCAD wrote nothing")


def _complete(path):
    """Raise OSError unless all of a document was written: on a full disk FreeCAD (0.20) says nothing."""
    try:
        with zipfile.ZipFile(path) as document:
            whole = document.testzip() is None
    except zipfile.BadZipFile:
        whole = False
    if not whole:
        raise OSError("FreeCAD wrote only a part of it")

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one solid in a FreeCAD shape, or in a document."""
from hexcon.errors import FaultCode, ToolError
from hexcon.freecad_compat import freecad

from .archive import check_document


def from_shape(shape):
    """(callable(path) that writes the one solid of a FreeCAD shape as BREP, numbers of the solid's faces in the shape
    or None if they are the same). Raises ToolError BAD_OPTION, BAD_SHAPE."""
    if not hasattr(shape, "exportBrep"):
        raise ToolError(f"expected a FreeCAD shape or a path, not {type(shape).__name__}", FaultCode.BAD_OPTION)
    if shape.isNull():
        raise ToolError("the shape is empty", FaultCode.BAD_SHAPE)
    solids = shape.Solids
    if len(solids) != 1:
        raise ToolError(f"the shape holds {len(solids)} solids; exactly one is needed", FaultCode.BAD_SHAPE)
    solid = solids[0]
    if not solid.isValid():
        raise ToolError("the solid is not valid (Part, Check geometry tells more)", FaultCode.BAD_SHAPE)
    if not all(shell.isClosed() for shell in solid.Shells):
        raise ToolError("the solid is not closed", FaultCode.BAD_SHAPE)
    return solid.exportBrep, _face_numbers(shape, solid)


def _face_numbers(shape, solid):
    """Numbers of the solid's faces in the shape; None where they are the same."""
    if len(shape.Faces) == len(solid.Faces):
        return None
    by_hash = {}
    for number, face in enumerate(shape.Faces, 1):
        by_hash.setdefault(face.hashCode(), []).append((number, face))
    return [next(number for number, face in by_hash[f.hashCode()] if face.isSame(f)) for f in solid.Faces]


def shape_in_document_file(path):
    """The Shape of the one solid in a .FCStd file; needs FreeCAD, which a damaged file may end: files.solid calls this
    in a process of its own.

    Objects other objects are made from (the tools of a cut, the features below a body's tip) do not count.
    Raises ToolError FREECAD_MISSING, FILE_FORMAT, BAD_SHAPE (names the solids if there are several).
    """
    check_document(path)
    app = freecad()
    try:
        document = app.openDocument(path, True)
    except Exception as error:
        raise ToolError(f"FreeCAD cannot open {path}: {error}", FaultCode.FILE_FORMAT) from error
    try:
        tops = _top_solids(document)
        if len(tops) != 1:
            names = ", ".join(o.Label for o in tops) or "none"
            raise ToolError(f"{path} holds {len(tops)} solids ({names}); exactly one is needed", FaultCode.BAD_SHAPE)
        return tops[0].Shape.copy()
    finally:
        app.closeDocument(document.Name)


def _top_solids(document):
    """Objects with a solid that no other such object is made from."""
    solids = [o for o in document.Objects if hasattr(o, "Shape") and o.Shape.Solids]
    names = {o.Name for o in solids}
    return [o for o in solids if not any(user.Name in names for user in o.InList)]

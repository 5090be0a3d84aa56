# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one solid in a FreeCAD shape, in a document, or in a CAD file that FreeCAD opens."""
from hexcon.errors import FaultCode, ToolError
from hexcon.freecad_compat import freecad, freecad_module, mod_folders_on_path

from .archive import check_document
from .document_solids import choose, refuse_dropped

IGES_ENDINGS = (".iges", ".igs")
_SEW = 1e-4     # of the diagonal: how far edges of an IGES file's faces may be apart


def from_shape(shape, row=None):
    """(callable(path) that writes one solid of a FreeCAD shape as BREP, numbers of the solid's faces in the shape
    or None if they are the same). row: of shape.Solids; None: the only one. Raises ToolError BAD_OPTION, BAD_SHAPE."""
    if not hasattr(shape, "exportBrep"):
        raise ToolError(f"expected a FreeCAD shape or a path, not {type(shape).__name__}", FaultCode.BAD_OPTION)
    if shape.isNull():
        raise ToolError("the shape is empty", FaultCode.BAD_SHAPE)
    solids = shape.Solids
    if row is None and len(solids) != 1:
        raise ToolError(f"the shape holds {len(solids)} solids; exactly one is needed", FaultCode.BAD_SHAPE)
    solid = solids[row or 0]
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


def chosen_shape(path, choice):
    """(shape, row of the solid in its .Solids, notes) of a .FCStd, STEP, BREP or IGES file; lengths are scaled.

    choice  a solid_choice.SolidChoice. Needs FreeCAD, which a damaged file may end: files.solid calls this in a
    process of its own. Raises ToolError FREECAD_MISSING, FILE_FORMAT, BAD_SHAPE, BAD_OPTION.
    """
    shape, row, notes = (_of_document if path.lower().endswith(".fcstd") else _of_cad_file)(path, choice)
    if choice.scale != 1.0:
        shape = shape.copy()
        shape.scale(choice.scale, freecad().Vector(0, 0, 0))
        notes.append(f"lengths multiplied by {choice.scale:g}")
    return shape, row, notes


def _of_document(path, choice):
    check_document(path)
    app = freecad()
    mod_folders_on_path()
    try:
        document = app.openDocument(path, True)
    except Exception as error:
        raise ToolError(f"FreeCAD cannot open {path}: {error}", FaultCode.FILE_FORMAT) from error
    try:
        refuse_dropped(path, document)
        place, row, notes = choose(document, choice)
        return place.shape, row, notes
    finally:
        app.closeDocument(document.Name)


def _of_cad_file(path, choice):
    if choice.object_name is not None:
        raise ToolError("--object names an object of a FreeCAD document; take --solid N here", FaultCode.BAD_OPTION)
    shape = freecad_module("Part").read(path)
    notes = []
    if not shape.Solids and path.lower().endswith(IGES_ENDINGS):
        shape = _sewn(shape)
        notes.append("the faces of the IGES file were sewn into a solid")
    count = len(shape.Solids)
    if choice.number is not None and not 1 <= choice.number <= count:
        raise ToolError(f"there is no solid {choice.number}; there are {count}", FaultCode.BAD_OPTION)
    if choice.number is None and count != 1:
        raise ToolError(f"the shape holds {count} solids{_boxes(shape.Solids)}; exactly one is needed"
                        + (": choose it by --solid N" if count else ""), FaultCode.BAD_SHAPE)
    return shape, (choice.number or 1) - 1, notes


def _boxes(solids):
    told = []
    for number, solid in enumerate(solids[:20], 1):
        box = solid.BoundBox
        told.append(f"{number}: {box.XLength:.4g} x {box.YLength:.4g} x {box.ZLength:.4g} at "
                    f"({box.XMin:.4g}, {box.YMin:.4g}, {box.ZMin:.4g})")
    return f" ({'; '.join(told)}{'; ...' if len(solids) > 20 else ''})" if told else ""


def _sewn(shape):
    """A solid of loose faces, as IGES holds them. Raises ToolError BAD_SHAPE."""
    part = freecad_module("Part")
    sewn = part.Compound(shape.Faces) if len(shape.Faces) > 1 else shape.copy()
    sewn.sewShape(_SEW * shape.BoundBox.DiagonalLength)
    solids = []
    for shell in sewn.Shells:
        if not shell.isClosed():
            raise ToolError("the faces of the IGES file do not close, even where edges up to "
                            f"{_SEW * shape.BoundBox.DiagonalLength:.3g} apart are sewn", FaultCode.BAD_SHAPE)
        solid = part.Solid(shell)
        if solid.Volume < 0:
            solid.reverse()
        solids.append(solid)
    if not solids:
        raise ToolError("there is no solid in it, and no faces that could be sewn into one", FaultCode.BAD_SHAPE)
    return solids[0] if len(solids) == 1 else part.Compound(solids)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Everything the window does, as calls that a macro or a batch script can make.

    import hexcon.gui.actions
    mesh = hexcon.gui.actions.mesh_solid_object(FreeCAD.ActiveDocument.Box, 2.5, order=2)
    print(hexcon.gui.actions.check_mesh_object(mesh))
"""
import math
from contextlib import contextmanager
from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np

import hexcon_native
from hexcon import freecad_compat
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh import elements_of, from_femmesh, to_femmesh
from hexcon.femmesh.document import insert
from hexcon.femmesh.hexahedron import EDGES
from hexcon.inspection.dual_loops import LoopedSurface
from hexcon.inspection.opening import InspectedMesh, Opening
from hexcon.meshing import mesh_solid
from hexcon.quads.documents import surface_from_object
from hexcon.topological import is_topological, refuse_topological_method

from . import words

TIMEOUT = 3600.0  # seconds for gmsh: in the window the user stops it, not the clock
_NICE = (1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)

# What a panel's worker has just computed for the very call that puts it into the document.
_prepared = {}


@contextmanager
def prepared(result):
    """Inside, the next action takes this result instead of computing it.

    So the panels work in a thread, and what lands in the macro recorder is still the whole call.
    """
    _prepared["result"] = result
    try:
        yield
    finally:
        _prepared.clear()


# ------------------------------------------------------------------------------------------- mesh

def solid_shape(solid_object):
    """A copy of the object's shape that another thread may use. Raises ToolError(BAD_SHAPE)."""
    shape = getattr(solid_object, "Shape", None)
    count = len(getattr(shape, "Solids", ()))
    if count != 1:
        raise ToolError(f"{getattr(solid_object, 'Label', solid_object)} holds {count} solids; "
                        "exactly one is needed", FaultCode.BAD_SHAPE)
    return shape.copy()


def default_size(shape):
    """A tenth of the bounding box's diagonal, rounded to a handy figure, in mm."""
    tenth = shape.BoundBox.DiagonalLength / 10.0
    if not (math.isfinite(tenth) and tenth > 0.0):
        return 1.0
    power = math.floor(math.log10(tenth))
    return min((float(f"{n}e{power}") for n in _NICE), key=lambda size: abs(size - tenth))


def mesh_solid_object(solid_object, size, *, surface_method="auto", method="auto", layers=0,
                      order=1, timeout=TIMEOUT, allow_topological=False):
    """Mesh the one solid of a document object with hexes; returns the new FEM mesh object.

    solid_object    a document object whose Shape holds exactly one solid
    size            wanted edge length, mm
    surface_method  hexcon.quads.METHODS
    method          hexcon_native.METHODS
    layers          cells: at least so many layers of plain hexes under the surface
    order           1 (C3D8) or 2 (C3D20)
    timeout         seconds for gmsh
    allow_topological  make the object even by a method of topology only; it is marked as such
    One undo step; the solid is hidden, as the mesh covers it. Raises HexconError, the document
    untouched: those of hexcon.meshing.mesh_solid and femmesh.add_to_document.
    """
    refuse_topological_method(method, allow_topological)  # before the work, not after it
    mesh = _prepared.pop("result", None) or mesh_solid(
        solid_shape(solid_object), size, surface_method=surface_method, method=method,
        layers=layers, order=order, timeout=timeout)
    return insert_mesh(mesh, solid_object, allow_topological=allow_topological)


def insert_mesh(mesh, solid_object, *, allow_topological=False):
    """femmesh.add_to_document, and the solid hidden in the same undo step."""
    document = solid_object.Document
    # may fail: before the document is touched
    femmesh = to_femmesh(mesh, allow_topological=allow_topological)
    with freecad_compat.transaction(document, "Hex mesh"):
        mesh_object = insert(document, femmesh, solid_object, "HexMesh",
                             is_topological(mesh))
        if getattr(solid_object, "ViewObject", None) is not None:
            solid_object.ViewObject.Visibility = False
    return mesh_object


# ------------------------------------------------------------------------------------------ check

@dataclass
class CheckReport:
    """What is known of a FEM mesh of hexes; str() says it in words.

    counts           namespace: points, hexes, quads, order
    certificate      hexcon_native.Certificate (row numbers)
    quality          hexcon_native.Quality
    nonpositive      FreeCAD's element numbers of the hexes not proved positive
    surface_known    the boundary was compared with the quads kept in the mesh's face groups
    straight         every middle node is the middle of its edge (True at order 1): the
                     certificate holds for the elements as they are
    topological      the object says that it holds topology only
    """

    counts: SimpleNamespace
    certificate: hexcon_native.Certificate
    quality: hexcon_native.Quality
    nonpositive: list
    surface_known: bool
    straight: bool
    topological: bool = False

    def __str__(self):
        return words.as_text(words.of_check(self))


def check_mesh_object(mesh_object):
    """Certify a FEM mesh object made of hexes; returns a CheckReport.

    Changes nothing. Raises HexconError: ToolError(BAD_MESH) for other elements, and those of
    hexcon_native.certify.
    """
    return _prepared.pop("result", None) or check_mesh(read_mesh_object(mesh_object))


def read_mesh_object(mesh_object):
    """The arrays of a FEM mesh object, and its mark, for check_mesh. See femmesh.from_femmesh."""
    found = from_femmesh(mesh_object.FemMesh)
    found.topological = is_topological(mesh_object)
    return found


def check_mesh(found, progress=None):
    """CheckReport of what read_mesh_object gave; needs no FreeCAD, so any thread may call it."""
    own = elements_of(SimpleNamespace(points=found.points, hexes=found.hexes))
    # face groups that cover the boundary are the surface the mesh was made for; fewer of them
    # are somebody's selection and say nothing of the rest
    known = found.quads is not None and len(found.quads) == len(own.quads)
    quads = np.asarray(found.quads if known else own.quads)[:, :4]
    certificate = hexcon_native.certify(found.points, found.hexes, quads, progress=progress)
    return CheckReport(
        SimpleNamespace(points=len(found.points), hexes=len(found.hexes), quads=len(own.quads),
                        order=found.order),
        certificate, hexcon_native.quality(found.points, found.hexes),
        np.asarray(found.hex_ids)[certificate.nonpositive].tolist(), known, _is_straight(found),
        is_topological(found))


def _is_straight(found):
    if found.order == 1:
        return True
    ends = found.points[found.hexes[:, EDGES]]
    off = found.points[found.hexes[:, 8:]] - ends.mean(axis=2)
    lengths = np.linalg.norm(ends[:, :, 1] - ends[:, :, 0], axis=2)
    return bool((np.linalg.norm(off, axis=2) <= 1e-9 * lengths).all())


def mark_hexes(mesh_object, elements):
    """Show these elements (FreeCAD's numbers) in red, inside ones too; none: as before.

    Needs FreeCAD's window. A matter of the view: the document does not change.
    """
    from .marking import mark
    mark(mesh_object, elements)


# ----------------------------------------------------------------------------------------- looking
#
# A matter of the view: the document does not change, and what is drawn is neither saved nor undone.
# What is shown of an object ends by hide_..., with the object, or when its mesh changes.

def inspect_mesh_object(mesh_object):
    """hexcon.inspection.opening.InspectedMesh of any FEM mesh object made of hexes; needs no window.

    worst = hexcon.inspection.figures.worst(inspected.scaled_jacobian, 10)  # rows
    inspected.hex_ids[worst]                                                # FreeCAD's element numbers
    Raises ToolError BAD_MESH for other elements.
    """
    return InspectedMesh(from_femmesh(mesh_object.FemMesh))


def show_inside(mesh_object, *, axis=None, offset=None, flip=False, peel=0, shrink=0.0, element=None):
    """Draw the hexes of a FEM mesh object in the 3D view, coloured by scaled Jacobian, in place of its own display.

    axis     cut by a plane with this normal, "x", "y", "z" or a vector; hexes stay whole. None: no cut
    offset   mm from the origin to the plane along the axis; None: the middle of the mesh
    flip     take away the hexes before the plane, not those beyond it
    peel     layers of hexes to take away, from the boundary inwards
    shrink   0 to 0.9: each hex smaller by this part, so that they stand apart
    element  FreeCAD's number of a hex to outline, seen through the others
    Another call changes what is shown. Needs FreeCAD's window. Raises ToolError BAD_MESH, BAD_OPTION.
    """
    from . import inside
    opening = Opening(axis, offset, flip, peel, shrink)
    known = inside.drawings.find(mesh_object)
    mesh = known.mesh if known else _prepared.pop("result", None) or inspect_mesh_object(mesh_object)
    inside.show(mesh_object, mesh, opening, element)


def zoom_to_hex(mesh_object, element):
    """Move the camera to the hex with FreeCAD's number element, its direction kept. Needs show_inside before."""
    from . import inside
    drawing = inside.drawings.find(mesh_object)
    if drawing is None:
        raise ToolError(f"nothing of {mesh_object.Label} is shown; call show_inside first", FaultCode.BAD_OPTION)
    drawing.zoom(element)


def hide_inside(mesh_object):
    """End show_inside: the object's own display as it was."""
    from . import inside
    inside.drawings.remove(mesh_object)


def loops_of_object(mesh_object):
    """hexcon.inspection.dual_loops.LoopedSurface of a FEM mesh object: its quads, or the boundary of its hexes.

    Needs no window. Raises ToolError, as hexcon.quads.documents.surface_from_object.
    """
    return LoopedSurface(surface_from_object(mesh_object))


def show_loops(mesh_object, *, pairs=False, loop=None):
    """Draw the dual loops of a FEM mesh object's surface as curves, balls where one crosses itself, in place of
    the object's own display.

    pairs  show the paired partition as well: one colour for both quads of a pair, and a bar between them
    loop   row of LoopedSurface.loops to draw thick
    Another call changes what is shown. Needs FreeCAD's window. Raises those of loops_of_object, HexconError
    ODD (pairs of an odd number of quads), ToolError BAD_OPTION.
    """
    from . import loop_curves
    known = loop_curves.drawings.find(mesh_object)
    looped = known.looped if known else _prepared.pop("result", None) or loops_of_object(mesh_object)
    loop_curves.show(mesh_object, looped, pairs, loop)


def hide_loops(mesh_object):
    """End show_loops: the object's own display as it was."""
    from . import loop_curves
    loop_curves.drawings.remove(mesh_object)

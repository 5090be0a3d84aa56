# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh opened in the 3D view, and the dual loops of its surface.

A matter of the view: the document does not change, and what is drawn is neither saved nor undone.
What is shown of an object ends by hide_..., with the object, or when its mesh changes. These are
calls for macros; hexcon.gui.actions has them too.
"""
from hexcon.document.prepared import taken
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh import from_femmesh
from hexcon.inspection.dual_loops import LoopedSurface
from hexcon.inspection.opening import InspectedMesh, Opening
from hexcon.objects.hex_mesh import stages_of_object
from hexcon.quads.documents import surface_from_object


def inspect_mesh_object(mesh_object):
    """hexcon.inspection.opening.InspectedMesh of any FEM mesh object made of hexes; needs no window.

    worst = hexcon.inspection.figures.worst(inspected.scaled_jacobian, 10)  # rows
    inspected.hex_ids[worst]                                                # FreeCAD's element numbers
    Raises ToolError BAD_MESH for other elements.
    """
    return InspectedMesh(from_femmesh(mesh_object.FemMesh), stages_of_object(mesh_object))


def show_inside(mesh_object, *, axis=None, offset=None, flip=False, peel=0, shrink=0.0, hidden=(), element=None):
    """Draw the hexes of a FEM mesh object in the 3D view, coloured by scaled Jacobian, in place of its own display.

    axis     cut by a plane with this normal, "x", "y", "z" or a vector; hexes stay whole. None: no cut
    offset   mm from the origin to the plane along the axis; None: the middle of the mesh
    flip     take away the hexes before the plane, not those beyond it
    peel     layers of hexes to take away, from the boundary inwards
    hidden   names of stages to take away, of inspect_mesh_object(mesh_object).stages: ("layers", "cells")
    shrink   0 to 0.9: each hex smaller by this part, so that they stand apart
    element  FreeCAD's number of a hex to outline, seen through the others
    Another call changes what is shown. Needs FreeCAD's window. Raises ToolError BAD_MESH, BAD_OPTION.
    """
    from . import inside
    opening = Opening(axis, offset, flip, peel, shrink, tuple(hidden))
    known = inside.drawings.find(mesh_object)
    mesh = known.mesh if known else taken() or inspect_mesh_object(mesh_object)
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
    looped = known.looped if known else taken() or loops_of_object(mesh_object)
    loop_curves.show(mesh_object, looped, pairs, loop)


def hide_loops(mesh_object):
    """End show_loops: the object's own display as it was."""
    from . import loop_curves
    loop_curves.drawings.remove(mesh_object)


def mark_hexes(mesh_object, elements):
    """Show these elements (FreeCAD's numbers) in red, inside ones too; none: as before.

    Needs FreeCAD's window. A matter of the view: the document does not change.
    """
    from .marking import mark
    mark(mesh_object, elements)

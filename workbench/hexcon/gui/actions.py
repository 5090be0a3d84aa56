# SPDX-License-Identifier: LGPL-2.1-or-later
"""Everything the window does, as calls that a macro or a batch script can make.

    import hexcon.gui.actions
    mesh = hexcon.gui.actions.mesh_solid_object(FreeCAD.ActiveDocument.Box, 2.5, order=2)
    print(hexcon.gui.actions.check_mesh_object(mesh))

Each is one undo step and all or nothing: on a HexconError the document is as it was.
"""
import math
from contextlib import contextmanager
from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np

import hexcon_native
from hexcon import freecad_compat, preferences
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh import elements_of, from_femmesh
from hexcon.femmesh.hexahedron import EDGES
from hexcon.inspection.dual_loops import LoopedSurface
from hexcon.inspection.opening import InspectedMesh, Opening
from hexcon.meshing import mesh_solid
from hexcon.objects import hex_mesh as hex_mesh_objects
from hexcon.objects import quad_surface as quad_surface_objects
from hexcon.objects import quality_report as quality_report_objects
from hexcon.objects.parametric import solid_shape
from hexcon.objects.quad_surface import TIMEOUT
from hexcon.quads.documents import surface_from_object
from hexcon.topological import is_topological, refuse_topological_method

from . import words
from .analyses import into_analysis, load_and_solve, show_displacement  # noqa: F401  calls for macros
from .example_documents import EXAMPLES, open_example  # noqa: F401

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


# ---------------------------------------------------------------------------------- quad surfaces

def default_size(shape):
    """A tenth of the bounding box's diagonal, rounded to a handy figure, in mm."""
    tenth = shape.BoundBox.DiagonalLength / 10.0
    if not (math.isfinite(tenth) and tenth > 0.0):
        return 1.0
    power = math.floor(math.log10(tenth))
    return min((float(f"{n}e{power}") for n in _NICE), key=lambda size: abs(size - tenth))


def make_quad_surface(source, size=None, *, method="auto"):
    """A quad surface object made from a document object; returns it.

    source  an object whose Shape holds exactly one solid, or a FEM mesh object whose quads
            (or the outer faces of whose volumes) are taken; then size and method do not matter
    size    wanted edge length, mm; None: a tenth of the solid's diagonal
    method  hexcon.quads.METHODS
    The solid is hidden, as the quads cover it. Raises HexconError: those of
    hexcon.quads.surface_from_solid and surface_from_object.
    """
    if size is None:
        size = default_size(source.Shape) if hasattr(source, "Shape") else 1.0
    settings = {"source": source, "size": float(size), "method": method}
    return _new_quad_surface(source.Document, settings)


def import_quad_surface(path, document=None):
    """A quad surface object with the quads of a mesh file (hexcon.quads.files.MESH_ENDINGS).

    document  None: the active one, or a new one. The object is made anew on recompute when the
    file has changed. Raises HexconError: those of hexcon.quads.surface_from_file.
    """
    settings = {"file": str(path)}
    mark, job = quad_surface_objects.job_of(**settings)
    surface = job(None)  # may fail: before there is a document
    app = freecad_compat.freecad()
    document = document or app.ActiveDocument or app.newDocument()
    with prepared(surface):
        return _new_quad_surface(document, settings)


def _new_quad_surface(document, settings, name="QuadSurface"):
    mark, job = quad_surface_objects.job_of(**settings)
    surface = _prepared.pop("result", None) or job(None)
    with freecad_compat.transaction(document, "Quad surface"):
        made = quad_surface_objects.add_quad_surface(document, surface, mark, settings, name)
        _hide(settings.get("source"))
    return made


def update_quad_surface(surface_object, **settings):
    """Make a quad surface anew with other settings (size, method), then what is made from it.

    Nothing changes if the quads cannot be made; a hex mesh that then fails keeps its hexes and
    says so in its Status. Raises HexconError as make_quad_surface.
    """
    whole = {"source": surface_object.Source, "file": surface_object.File, "example": surface_object.Example,
             "size": surface_object.Size.Value, "method": surface_object.Method, **settings}
    mark, job = quad_surface_objects.job_of(**whole)
    _update(surface_object, _prepared.pop("result", None) or job(None), mark, settings,
            quad_surface_objects.set_settings)


def _update(obj, result, mark, settings, set_settings):
    with freecad_compat.transaction(obj.Document, f"Update {obj.Label}"):
        set_settings(obj, settings)
        obj.Proxy.take(obj, result, mark)
        obj.Document.recompute()


def _hide(*objects):
    """Not to be seen any more, as something made from them covers them."""
    for thing in objects:
        if getattr(thing, "ViewObject", None) is not None:
            thing.ViewObject.Visibility = False


# ------------------------------------------------------------------------------------- hex meshes

def make_hex_mesh(surface_object, *, method="auto", layers=0, order=1, budget=0.0, allow_topological=False):
    """Fill a quad surface object with hexes; returns the new FEM mesh object.

    method, layers, order, budget  as hexcon_native.mesh
    allow_topological  make the object even by a method of topology only; it is marked as such
    Raises HexconError: those of hexcon.mesh_quad_surface.
    """
    settings = {"method": method, "layers": layers, "order": order, "budget": float(budget),
                "allow_topological": allow_topological}
    mesh = _prepared.pop("result", None) or hex_mesh_objects.job_of(surface_object, **settings)[1](None)
    document = surface_object.Document
    with freecad_compat.transaction(document, "Hex mesh"):
        made = hex_mesh_objects.add_hex_mesh(document, mesh, surface_object, settings)
        _hide(surface_object, surface_object.Source)
    return made


def update_hex_mesh(mesh_object, **settings):
    """Make a hex mesh anew with other settings: those of make_hex_mesh. Raises as that."""
    whole = {"method": mesh_object.Method, "layers": mesh_object.Layers, "order": int(mesh_object.Order),
             "budget": mesh_object.Budget, "allow_topological": mesh_object.AllowTopological, **settings}
    mark, job = hex_mesh_objects.job_of(mesh_object.Surface, **whole)
    _update(mesh_object, _prepared.pop("result", None) or job(None), mark, settings,
            hex_mesh_objects.set_settings)


def mesh_solid_object(solid_object, size, *, surface_method="auto", method="auto", layers=0,
                      order=1, budget=0.0, timeout=TIMEOUT, allow_topological=False):
    """The short road: mesh a solid's surface with quads, and fill it; returns the hex mesh object.

    solid_object    a document object whose Shape holds exactly one solid
    size            wanted edge length, mm
    surface_method  hexcon.quads.METHODS
    method          hexcon_native.METHODS
    layers          cells: at least so many layers of plain hexes under the surface
    order           1 (C3D8) or 2 (C3D20)
    budget          seconds after which the best mesh until then is taken; 0: no limit
    timeout         seconds for gmsh
    allow_topological  make the object even by a method of topology only; it is marked as such
    The quad surface object is the mesh's Surface; it and the solid are hidden, as the mesh covers
    them. Raises HexconError: those of hexcon.meshing.mesh_solid and femmesh.add_to_document.
    """
    refuse_topological_method(method, allow_topological)  # before the work, not after it
    of_surface = {"source": solid_object, "size": float(size), "method": surface_method}
    of_mesh = {"method": method, "layers": layers, "order": order, "budget": float(budget),
               "allow_topological": allow_topological}
    shape = solid_shape(solid_object)
    mesh = _prepared.pop("result", None) or mesh_solid(
        shape, size, surface_method=surface_method, method=method, layers=layers, order=order,
        budget=budget, timeout=timeout, threads=preferences.value("Threads"))
    mark, _ = quad_surface_objects.job_of(**of_surface)
    document = solid_object.Document
    with freecad_compat.transaction(document, "Hex mesh"):
        surface = quad_surface_objects.add_quad_surface(document, mesh.surface, mark, of_surface)
        made = hex_mesh_objects.add_hex_mesh(document, mesh, surface, of_mesh)
        _hide(surface, solid_object)
    return made


# ---------------------------------------------------------------------------------------- quality

def make_quality_report(mesh_object, worst=10):
    """A quality report object about a FEM mesh object of hexes; returns it.

    worst  how many of the worst elements it lists. It follows the mesh on recompute.
    Raises HexconError as check_mesh_object.
    """
    mark, job = quality_report_objects.job_of(mesh_object)
    result = _prepared.pop("result", None) or job(None)
    document = mesh_object.Document
    with freecad_compat.transaction(document, "Quality report"):
        return quality_report_objects.add_quality_report(document, mesh_object, result, mark, worst)


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

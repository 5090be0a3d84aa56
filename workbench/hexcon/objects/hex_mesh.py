# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "hex mesh": a FEM mesh of hexes made from a quad surface object."""
from hexcon import preferences
from hexcon.calculix import constraint_groups
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh import to_femmesh
from hexcon.femmesh.document import mark_topological
from hexcon.femmesh.element_types import CHOICES as ELEMENT_CHOICES, PROPERTY as ELEMENT_TYPE
from hexcon.freecad_compat import shape_of
from hexcon.inspection.stages import counts_of
from hexcon.meshing import Strategy
from hexcon.meshing.strategy import is_worth_another
from hexcon.pillows import CHOICES, pillow_of
from hexcon.topological import is_topological, refuse_topological_method
from hexcon_native import METHOD_CHOICES, methods_that

from . import old_results
from .parametric import FAILED, OUTDATED, Parametric, fingerprint, is_a, new_mesh_object, set_changed, solid_shape
from .quad_surface import TIMEOUT, is_quad_surface, surface_of, take_another

ORDERS = ("1", "2")

PROPERTIES = (
    ("App::PropertyLink", "Surface", "HexCon", "The quad surface that is filled", None, False),
    ("App::PropertyEnumeration", "Method", "HexCon", "How the surface is filled", tuple(METHOD_CHOICES), False),
    ("App::PropertyInteger", "Layers", "HexCon", "At least so many layers of plain hexes under the surface; for "
     f"methods {', '.join(methods_that(lambda method: method.layers))}", 0, False),
    ("App::PropertyEnumeration", "Pillow", "HexCon", "Sheets of hexes under the whole surface: one where it makes a "
     "poor worst hex clearly better, none, or so many; not for methods of topology only", CHOICES, False),
    ("App::PropertyEnumeration", "Order", "HexCon", "1: C3D8, 2: C3D20R, edges of the boundary on the solid", ORDERS, False),
    ("App::PropertyEnumeration", ELEMENT_TYPE, "HexCon", "What CalculiX gets from Hold, load and solve and from an exported "
     ".inp; R: reduced integration. FreeCAD's own solver object writes C3D8 and C3D20", ELEMENT_CHOICES, False),
    ("App::PropertyFloat", "Budget", "HexCon", "Seconds after which the best mesh until then is taken; 0: no limit",
     0.0, False),
    ("App::PropertyBool", "AllowTopological", "HexCon", "Allow the methods whose meshes are topology only: no "
     "solver must be given them", False, False),
    ("App::PropertyBool", "TryOtherSurfaces", "HexCon", "Where the quads cannot be filled, others of the same solid "
     "are tried, somewhat smaller, and the quad surface object takes those that can; only for automatic methods and "
     "without a time limit", False, False),
    ("App::PropertyInteger", "Hexes", "Result", "Number of hexes", 0, True),
    ("App::PropertyString", "MethodUsed", "Result", "The method that made the hexes", "", True),
    ("App::PropertyFloat", "MinimumScaledJacobian", "Result", "Worst scaled Jacobian of a hex", 0.0, True),
    ("App::PropertyFloat", "MeanScaledJacobian", "Result", "Mean scaled Jacobian", 0.0, True),
    ("App::PropertyBool", "Certified", "Result", "Every Jacobian is proved positive, the mesh is proper and "
     "conforming, its boundary exactly the quads", False, True),
    ("App::PropertyStringList", "Stages", "Result", "The stages that put hexes in, from outside to inside", None,
     True),
    ("App::PropertyIntegerList", "HexesOfStages", "Result", "How many hexes each stage put in; their numbers follow "
     "one another", None, True),
    ("App::PropertyStringList", "Log", "Result", "What was tried", None, True),
)
SETTINGS = {"surface": "Surface", "method": "Method", "layers": "Layers", "pillow": "Pillow", "order": "Order", "budget": "Budget",
            "allow_topological": "AllowTopological", "try_other_surfaces": "TryOtherSurfaces"}


def job_of(surface, method="auto", layers=0, order=1, budget=0.0, allow_topological=False, try_other_surfaces=False,
           pillow="auto"):
    """(fingerprint, job(progress) -> Mesh); surface is a quad surface object.

    try_other_surfaces  go the way from the solid: see meshing.Strategy. The mesh's .surface may be another then
    Raises HexconError: TOPOLOGICAL_MESH for such a method if not allowed, BAD_SHAPE without quads, BAD_ARGUMENT.
    """
    refuse_topological_method(method, allow_topological)
    strategy = Strategy(method, surface.Method, timeout=TIMEOUT, layers=layers, order=order, budget=budget,
                        pillow=pillow_of(pillow), threads=preferences.value("Threads"), allow_topological=allow_topological,
                        local_sizes=list(surface.LocalSizes), per_turn=surface.PerTurn)
    held = surface_of(surface)
    mark = mark_of(held, method, layers, order, budget, pillow=pillow)
    if not (try_other_surfaces and shape_of(surface.Source) is not None):
        solid = solid_shape(surface.Source) if order == 2 and shape_of(surface.Source) is not None else None
        return mark, lambda progress: strategy.of_surface(held, progress=progress, solid=solid)
    shape, size, first = solid_shape(surface.Source), surface.Size.Value, held if held.tried == 0 else None
    if surface.Proxy.fault is not None:     # the quads are those of older inputs
        mark, first = fingerprint(surface.Proxy.first_try(surface)[0], mark), None
    return mark, lambda progress: strategy.of_solid(shape, size, progress=progress, first=first)


def mark_of(surface, method="auto", layers=0, order=1, budget=0.0, allow_topological=False, try_other_surfaces=False,
            pillow="auto"):
    """The fingerprint for a QuadSurface. What is allowed, or might have been tried, changes no mesh of it."""
    settings = (method, int(layers), int(order), float(budget), *([str(pillow)] if pillow != "auto" else []))
    return fingerprint(surface.points, surface.quads, surface.face_of_quad, *settings)


class HexMeshObject(Parametric):
    """Proxy of a parametric hex mesh. Saved documents name this class: never rename or move it."""

    Type = "HexCon::HexMeshFromSurface"
    PROPERTIES = PROPERTIES

    def waits_for(self, obj):
        fault = getattr(getattr(obj.Surface, "Proxy", None), "fault", None)
        if obj.TryOtherSurfaces and fault is not None and is_worth_another(fault):
            return ""   # the next surfaces are for this object to try
        status = getattr(obj.Surface, "Status", "")
        return f"its quad surface is not up to date ({status})" if status.startswith((FAILED, OUTDATED)) else ""

    def inputs(self, obj):
        if obj.Surface is None:
            return None
        if not is_quad_surface(obj.Surface):
            raise ToolError(f"{obj.Surface.Label} is no quad surface", FaultCode.BAD_SHAPE)
        return job_of(obj.Surface, obj.Method, obj.Layers, int(obj.Order), obj.Budget, obj.AllowTopological,
                      obj.TryOtherSurfaces, obj.Pillow)

    def take(self, obj, result, mark):
        before, settings = obj.MadeFrom, {"method": obj.Method, "layers": obj.Layers, "order": int(obj.Order),
                                          "budget": obj.Budget, "pillow": obj.Pillow}
        if mark_of(result.surface, **settings) != mark or result.surface.tried != obj.Surface.Tried:
            take_another(obj.Surface, result.surface)
            mark = mark_of(surface_of(obj.Surface), **settings)
        super().take(obj, result, mark)
        if before not in ("", mark):
            old_results.mark(obj, before, mark)

    def store(self, obj, result):
        femmesh = to_femmesh(result, allow_topological=obj.AllowTopological)
        obj.FemMesh = femmesh
        mark_topological(obj, is_topological(result))
        quality, certificate, stages = result.quality, result.certificate, counts_of(result.report)
        set_changed(obj, {
            "Hexes": len(result.hexes), "MethodUsed": result.method,
            "MinimumScaledJacobian": quality.min if quality else 0.0,
            "MeanScaledJacobian": quality.mean if quality else 0.0,
            "Certified": bool(certificate and certificate.certified),
            "Stages": [name for name, _ in stages], "HexesOfStages": [count for _, count in stages],
            "Log": [str(line) for line in (*result.report.get("surface tries", ()), *result.report["log"])]})
        constraint_groups.watch()
        constraint_groups.name_all(obj)

    def onDocumentRestored(self, obj):
        super().onDocumentRestored(obj)
        constraint_groups.watch()


def stages_of_object(obj):
    """[(name, hexes)] of a FEM mesh object; empty of one that is no parametric hex mesh."""
    return list(zip(getattr(obj, "Stages", ()), getattr(obj, "HexesOfStages", ())))


def is_hex_mesh(obj):
    """Whether the document object is a parametric hex mesh."""
    return is_a(obj, HexMeshObject.Type)


def add_hex_mesh(document, mesh, surface_object, settings, name="HexMesh"):
    """A hex mesh object that holds a mesh already made of that surface object's quads.

    settings  job_of's arguments, without the surface. No transaction of its own.
    """
    solid = surface_object.Source
    obj = new_mesh_object(document, name, solid if shape_of(solid) is not None else None, HexMeshObject, "HexMeshView")
    set_settings(obj, {**settings, "surface": surface_object})
    obj.Proxy.take(obj, mesh, mark_of(surface_of(surface_object), **settings))
    obj.purgeTouched()
    return obj


def set_settings(obj, settings):
    """Set the inputs by job_of's names."""
    for key, value in settings.items():
        setattr(obj, SETTINGS[key], str(value) if key in ("order", "pillow") else value)

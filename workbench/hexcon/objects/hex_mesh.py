# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "hex mesh": a FEM mesh of hexes made from a quad surface object."""
from hexcon import preferences
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh import to_femmesh
from hexcon.femmesh.document import mark_topological
from hexcon.inspection.stages import counts_of
from hexcon.meshing import mesh_quad_surface
from hexcon.topological import is_topological, refuse_topological_method
from hexcon_native import METHOD_CHOICES, methods_that

from . import old_results
from .parametric import FAILED, OUTDATED, Parametric, fingerprint, is_a, new_mesh_object, set_changed
from .quad_surface import TIMEOUT, is_quad_surface, surface_of

ORDERS = ("1", "2")

PROPERTIES = (
    ("App::PropertyLink", "Surface", "HexCon", "The quad surface that is filled", None, False),
    ("App::PropertyEnumeration", "Method", "HexCon", "How the surface is filled", tuple(METHOD_CHOICES), False),
    ("App::PropertyInteger", "Layers", "HexCon", "At least so many layers of plain hexes under the surface; for "
     f"methods {', '.join(methods_that(lambda method: method.layers))}", 0, False),
    ("App::PropertyEnumeration", "Order", "HexCon", "1: C3D8, 2: C3D20 with straight edges", ORDERS, False),
    ("App::PropertyFloat", "Budget", "HexCon", "Seconds after which the best mesh until then is taken; 0: no limit",
     0.0, False),
    ("App::PropertyBool", "AllowTopological", "HexCon", "Allow the methods whose meshes are topology only: no "
     "solver must be given them", False, False),
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
SETTINGS = {"surface": "Surface", "method": "Method", "layers": "Layers", "order": "Order", "budget": "Budget",
            "allow_topological": "AllowTopological"}


def job_of(surface, method="auto", layers=0, order=1, budget=0.0, allow_topological=False):
    """(fingerprint, job(progress) -> Mesh); surface is a quad surface object.

    Raises ToolError: TOPOLOGICAL_MESH for such a method if not allowed, BAD_SHAPE without quads.
    """
    refuse_topological_method(method, allow_topological)
    filled = surface_of(surface)
    return mark_of(filled, method, layers, order, budget), lambda progress: mesh_quad_surface(
        filled, method, timeout=TIMEOUT, progress=progress, layers=layers, order=order, budget=budget,
        threads=preferences.value("Threads"), allow_topological=allow_topological)


def mark_of(surface, method="auto", layers=0, order=1, budget=0.0, allow_topological=False):
    """The fingerprint for a QuadSurface. That something is allowed changes no mesh."""
    return fingerprint(surface.points, surface.quads, surface.face_of_quad, method, int(layers), int(order),
                       float(budget))


class HexMeshObject(Parametric):
    """Proxy of a parametric hex mesh. Saved documents name this class: never rename or move it."""

    Type = "HexCon::HexMeshFromSurface"
    PROPERTIES = PROPERTIES

    def waits_for(self, obj):
        status = getattr(obj.Surface, "Status", "")
        return f"its quad surface is not up to date ({status})" if status.startswith((FAILED, OUTDATED)) else ""

    def inputs(self, obj):
        if obj.Surface is None:
            return None
        if not is_quad_surface(obj.Surface):
            raise ToolError(f"{obj.Surface.Label} is no quad surface", FaultCode.BAD_SHAPE)
        return job_of(obj.Surface, obj.Method, obj.Layers, int(obj.Order), obj.Budget, obj.AllowTopological)

    def take(self, obj, result, mark):
        before = obj.MadeFrom
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
            "Log": [str(line) for line in result.report["log"]]})


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
    obj = new_mesh_object(document, name, solid if hasattr(solid, "Shape") else None, HexMeshObject, "HexMeshView")
    set_settings(obj, {**settings, "surface": surface_object})
    obj.Proxy.take(obj, mesh, mark_of(surface_of(surface_object), **settings))
    obj.purgeTouched()
    return obj


def set_settings(obj, settings):
    """Set the inputs by job_of's names."""
    for key, value in settings.items():
        setattr(obj, SETTINGS[key], str(value) if key == "order" else value)

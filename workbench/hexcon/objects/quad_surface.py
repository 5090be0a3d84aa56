# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "quad surface": a FEM mesh of quads, one face group for each CAD face."""
import base64
import os
import zlib

import numpy as np

import hexcon_native
from hexcon import examples, freecad_compat
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.convert import add_group
from hexcon.files.hex_contents import take_cad_faces
from hexcon.meshing import raising
from hexcon.quads import METHODS, QuadSurface, surface_from_file, surface_from_object, surface_from_solid
from hexcon.quads.local_sizes import WAYS

from .parametric import Parametric, fingerprint, is_a, new_mesh_object, set_changed, solid_shape

TIMEOUT = 3600.0  # seconds for gmsh: in the window the user stops it, not the clock

PROPERTIES = (
    ("App::PropertyLink", "Source", "HexCon", "The solid whose surface is meshed with quads, or a "
     "FEM mesh whose quads are taken", None, False),
    ("App::PropertyString", "File", "HexCon", "The mesh file that the quads are read from", "", False),
    ("App::PropertyString", "Example", "HexCon", "Name of the example surface", "", False),
    ("App::PropertyLength", "Size", "HexCon", "Wanted length of the quads' edges, for a solid", 1.0, False),
    ("App::PropertyEnumeration", "Method", "HexCon", "How a solid's surface is meshed with quads", METHODS, False),
    ("App::PropertyStringList", "LocalSizes", "HexCon", f"Smaller edges at places of a solid, WHERE=SIZE: {WAYS}", None,
     False),
    ("App::PropertyInteger", "PerTurn", "HexCon", "So many quads, about, round a full turn of round faces; 0: as many "
     "as come by the size", 0, False),
    ("App::PropertyFloat", "Scale", "HexCon", "What lengths of the file are multiplied by: 1000 where they are metres, "
     "25.4 where they are inches", 1.0, False),
    ("App::PropertyLength", "MergeTolerance", "HexCon", "Points of the file nearer than this become one; 0: only where "
     "the surface is open, very near ones", 0.0, False),
    ("App::PropertyInteger", "Quads", "Result", "Number of quads", 0, True),
    ("App::PropertyBool", "Even", "Result", "The number of quads is even; only then is there a hex mesh", False, True),
    ("App::PropertyInteger", "Loops", "Result", "Number of dual loops", 0, True),
    ("App::PropertyInteger", "SelfCrossings", "Result", "Number of loops that cross themselves", 0, True),
    ("App::PropertyInteger", "Genus", "Result", "Number of holes through the body; -1: unknown", 0, True),
    ("App::PropertyInteger", "Cavities", "Result", "Number of cavities in the body", 0, True),
    ("App::PropertyString", "Embedded", "Result", "Whether the quads cross and touch each other nowhere but in their "
     "common points and edges: yes, or what was found", "", True),
    ("App::PropertyString", "Fillable", "Result", "Whether a hex mesh with these quads exists: yes, no or unknown", "",
     True),
    ("App::PropertyString", "MethodUsed", "Result", "The method that made the quads", "", True),
    ("App::PropertyStringList", "Notes", "Result", "What is to be known of the quads", None, True),
    ("App::PropertyLength", "SizeUsed", "Result", "Wanted length of the quads' edges that these were made with: Size, "
     "or less where a hex mesh needed other quads; 0: not made from a solid, or by an older version", 0.0, True),
    ("App::PropertyInteger", "Tried", "Result", "How many other surfaces of the solid were tried before this one, that "
     "of Size being the first; -1: unknown, as an older version made it", -1, True),
    ("App::PropertyString", "Proposal", "Result", "Hexes that the method has in mind inside the quads, packed", "",
     True),
)


def job_of(source=None, file="", example="", size=1.0, method="auto", local_sizes=(), per_turn=0, scale=1.0,
           merge_tolerance=0.0):
    """(fingerprint, job(progress) -> QuadSurface) of one source; None where there is none.

    source is a document object, file the path of a mesh file (scale and merge_tolerance, mm, are for it), example a
    name that hexcon.example knows. Raises HexconError for a source that cannot be read.
    """
    if source is not None and hasattr(source, "FemMesh"):
        found = surface_from_object(source)
        return fingerprint("mesh", found.points, found.quads), lambda progress: found
    if source is not None:
        shape = solid_shape(source)
        more = (*map(str, local_sizes), f"{per_turn} a turn") if local_sizes or per_turn else ()
        mark = fingerprint("solid", shape.exportBrepToString(), float(size), method, *more)
        return mark, lambda progress: surface_from_solid(
            shape, size, method, local_sizes=local_sizes, per_turn=per_turn, timeout=TIMEOUT,
            progress=raising(progress))
    if example:
        return fingerprint("example", example), lambda progress: examples.example(example)
    if file:
        if not 0.0 < scale < float("inf"):
            raise ToolError(f"a scale above zero is needed, not {scale:g}", FaultCode.BAD_OPTION)
        mark = _file_mark(file)
        if scale != 1.0 or merge_tolerance:
            mark = fingerprint(mark, float(scale), float(merge_tolerance))
        return mark, lambda progress: surface_from_file(file, scale=scale, merge_tolerance=merge_tolerance or None,
                                                        progress=raising(progress))
    return None


def mark_of_try(mark, tried):
    """The fingerprint of the surface that a hex mesh took after so many others, of that of job_of, the first."""
    return fingerprint(mark, "try", int(tried)) if tried > 0 else mark


def take_another(obj, surface):
    """Give a quad surface object another surface of its solid, which a hex mesh of it found good.

    It stands for the present inputs: the object stays as it is until they change. Others that are made from the
    object are recomputed next.
    """
    first = obj.Proxy.first_try(obj)
    if first is None:
        raise ToolError(f"what {obj.Label} was made from is gone", FaultCode.BAD_SHAPE)
    obj.Proxy.take(obj, surface, mark_of_try(first[0], surface.tried))
    obj.Proxy.fault = None
    for user in obj.InList:
        user.touch()
    obj.purgeTouched()


def _file_mark(path):
    try:
        return fingerprint("file", os.path.basename(path), os.stat(path).st_size, os.stat(path).st_mtime_ns)
    except OSError as error:
        raise ToolError(f"cannot read {path}: {error.strerror}", FaultCode.FILE_IO) from error


class QuadSurfaceObject(Parametric):
    """Proxy of a quad surface. Saved documents name this class: never rename or move it."""

    Type = "HexCon::QuadSurface"
    PROPERTIES = PROPERTIES

    def inputs(self, obj):
        found = self.first_try(obj)
        if found is None or mark_of_try(found[0], obj.Tried) != obj.MadeFrom:
            return found
        return obj.MadeFrom, found[1]   # the quads that a hex mesh found good stay

    @staticmethod
    def first_try(obj):
        """job_of for what the object says: the quads of the size asked for."""
        return job_of(obj.Source, obj.File, obj.Example, obj.Size.Value, obj.Method, list(obj.LocalSizes), obj.PerTurn,
                      obj.Scale, obj.MergeTolerance.Value)

    def store(self, obj, result):
        facts = facts_of(result)
        obj.FemMesh = to_quad_femmesh(result)
        set_changed(obj, {**facts, "MethodUsed": result.method, "Notes": list(result.notes), "Tried": result.tried,
                          "Proposal": packed(result.hexes)})
        if obj.SizeUsed.Value != result.size:
            obj.SizeUsed = result.size


def facts_of(surface):
    """dict of the counts that the panel and the object show; an odd surface has them too."""
    report = hexcon_native.check_surface(surface.points, surface.quads)
    return {"Quads": report.n, "Even": bool(report.even), "Loops": len(report.loops.lengths),
            "SelfCrossings": int(np.count_nonzero(report.loops.self_crossings)),
            "Genus": -1 if report.genus is None else int(report.genus), "Cavities": int(report.cavities),
            "Embedded": "yes" if report.embedded else report.embedding_reason,
            "Fillable": {True: "yes", False: "no", None: "unknown"}[report.fillable]}


def to_quad_femmesh(surface):
    """Fem.FemMesh of a QuadSurface: node i+1 is point i, face k+1 quad k, groups Face1, ..."""
    femmesh = freecad_compat.fem_module("Fem").FemMesh()
    for node, (x, y, z) in enumerate(surface.points.tolist(), 1):
        femmesh.addNode(x, y, z, node)
    for face, nodes in enumerate((surface.quads + 1).tolist(), 1):
        femmesh.addFace(nodes, face)
    for number in np.unique(surface.face_of_quad[surface.face_of_quad > 0]).tolist():
        add_group(femmesh, f"Face{number}", "Face", np.flatnonzero(surface.face_of_quad == number) + 1)
    for name, rows in surface.quad_groups.items():
        add_group(femmesh, name, "Face", rows + 1)
    for name, rows in surface.node_groups.items():
        add_group(femmesh, name, "Node", rows + 1)
    return femmesh


def surface_of(obj):
    """The QuadSurface in a quad surface object, quads in the order of their face numbers.

    Raises ToolError(BAD_SHAPE) where the object holds no quads yet.
    """
    femmesh = obj.FemMesh
    faces = femmesh.Faces
    if not faces:
        raise ToolError(f"{obj.Label} holds no quads", FaultCode.BAD_SHAPE)
    nodes = femmesh.Nodes
    ids = sorted(nodes)
    row = {node: k for k, node in enumerate(ids)}
    points = np.array([tuple(nodes[node]) for node in ids])
    quads = np.array([[row[node] for node in femmesh.getElementNodes(face)] for face in faces])
    face_of_quad = np.zeros(len(quads), np.int64)
    rank = {face: k for k, face in enumerate(faces)}
    named, node_groups = {}, {}
    for group in femmesh.Groups:
        name, members = femmesh.getGroupName(group), femmesh.getGroupElements(group)
        if femmesh.getGroupElementType(group) == "Node":
            node_groups[name] = np.array([row[node] for node in members])
        else:
            named[name] = np.array([rank[face] for face in members])
    groups = take_cad_faces(named, face_of_quad)
    return QuadSurface(points, quads, face_of_quad, obj.MethodUsed or "given", list(obj.Notes), obj.SizeUsed.Value,
                       obj.Tried, unpacked(obj.Proposal), quad_groups=groups, node_groups=node_groups)


def packed(proposal):
    """A QuadSurface's hexes, or None, as text for a property."""
    if proposal is None:
        return ""
    inner, hexes = proposal if isinstance(proposal, tuple) else (None, proposal)
    parts = (np.asarray(hexes, "<i8"), *(() if inner is None else (np.asarray(inner, "<f8"),)))
    return " ".join(base64.b64encode(zlib.compress(part.tobytes())).decode() for part in parts)


def unpacked(text):
    """What packed was given."""
    if not text:
        return None
    hexes, *inner = (zlib.decompress(base64.b64decode(part)) for part in text.split(" "))
    hexes = np.frombuffer(hexes, "<i8").reshape(-1, 8)
    return (np.frombuffer(inner[0], "<f8").reshape(-1, 3), hexes) if inner else hexes


def is_quad_surface(obj):
    """Whether the document object is a quad surface."""
    return is_a(obj, QuadSurfaceObject.Type)


def add_quad_surface(document, surface, mark, settings, name="QuadSurface"):
    """A quad surface object that holds a surface already made.

    mark, settings  job_of's fingerprint and arguments for this surface, or for the first one tried
    No transaction of its own: see hexcon.gui.actions.
    """
    solid = settings.get("source")
    obj = new_mesh_object(document, name, solid if freecad_compat.shape_of(solid) is not None else None,
                          QuadSurfaceObject, "QuadSurfaceView")
    set_settings(obj, settings)
    obj.Proxy.take(obj, surface, mark_of_try(mark, surface.tried))
    obj.purgeTouched()
    return obj


def set_settings(obj, settings):
    """Set the inputs by job_of's names."""
    names = {"source": "Source", "file": "File", "example": "Example", "size": "Size", "method": "Method",
             "local_sizes": "LocalSizes", "per_turn": "PerTurn", "scale": "Scale",
             "merge_tolerance": "MergeTolerance"}
    for key, value in settings.items():
        setattr(obj, names[key], value)

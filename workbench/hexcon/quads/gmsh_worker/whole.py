# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface meshes of the whole solid by gmsh: subdivided, subdivided-triangles, blossom, transfinite."""
import numpy as np

import gmsh

from .corner_room import GOOD, corner_room
from .fault import WorkerFault
from .local_size import LocalSize

# gmsh's numbers of Mesh.Algorithm: the frontal one (6) makes the better quads, but leaves triangles at the narrow
# corners of plane triangles whatever the size; Delaunay (5) does so less often.
ALGORITHMS = {"blossom": (6, 5)}
SCALES = (None, 2.0, 1.4, 1.0, 0.7)     # of the local sizes; None: without them
FACTORS = (1.0, 0.97, 1.03, 0.94, 1.06, 0.91, 1.09, 0.88, 1.12)   # sizes tried until all quads, and even


def whole_surface(solid, size, method, link):
    """dict with points (V,3), quads (n,4), faces (n,), notes.

    link: a Link. Raises WorkerFault NOT_ALL_QUAD, ODD_SURFACE, NOT_TRANSFINITE, TOOL_FAILED.
    """
    notes, last = [], None
    tries = [(k, factor, algorithm) for algorithm in ALGORITHMS.get(method, (6,)) for k, factor in enumerate(FACTORS)]
    for done, (k, factor, algorithm) in enumerate(tries):
        link.progress("mesh", done / len(tries))
        if not link.risk(f"{method} at size {size * factor:g}, algorithm {algorithm}"):
            last = WorkerFault("TOOL_FAILED", f"gmsh crashed on {method} at every size tried from {size:g} on")
            continue
        try:
            _generate(solid, size * factor, method, algorithm, even=k > 0)
        except WorkerFault:
            raise
        except Exception as error:      # gmsh raises plain Exception
            last = WorkerFault("TOOL_FAILED", f"gmsh: {error}")
            continue
        triangles, mesh = _collect(solid)
        if triangles:
            last = WorkerFault("NOT_TRANSFINITE" if method == "transfinite" else "NOT_ALL_QUAD",
                               f"{triangles} triangles are left at every size tried from {size:g} on")
        elif len(mesh["quads"]) % 2:
            last = WorkerFault("ODD_SURFACE", f"the number of quads is odd at every size tried from {size:g} on")
        else:
            if algorithm != 6:
                notes.append(f"{method}: by gmsh's algorithm {algorithm}, because 6 found no such surface at any size "
                             "tried")
            if factor != 1.0:
                notes.append(f"{method}: size {size * factor:g} instead of {size:g}, because {_reason(last)}")
            mesh["notes"] = notes + [f"{method}: {len(mesh['quads'])} quads"]
            return mesh
    raise last


def triangle_surface(solid, size, link):
    """As whole_surface for subdivided-triangles; where the even size leaves corners without room, smaller elements at
    curves, short edges and narrow places, and the best of these surfaces.
    """
    best, last, notes = None, None, []
    for k, scale in enumerate(SCALES):
        link.progress("mesh", k / len(SCALES))
        name = "the even size" if scale is None else f"sizes of curves and gaps times {scale:g}"
        if not link.risk(f"subdivided-triangles by {name}"):
            last = WorkerFault("TOOL_FAILED", f"gmsh crashed on {name}")
            continue
        local = None if scale is None else LocalSize(solid, 2.0 * size, scale)
        try:
            _generate(solid, size, "subdivided-triangles", 6, even=False, local=local)
        except Exception as error:      # gmsh raises plain Exception
            last = WorkerFault("TOOL_FAILED", f"gmsh: {error}")
            continue
        triangles, mesh = _collect(solid)
        if triangles:
            last = WorkerFault("NOT_ALL_QUAD", f"{triangles} triangles are left")
            continue
        room = corner_room(mesh["points"], mesh["quads"])
        if best is None or room > best[0]:
            best = room, mesh, local
        if room >= GOOD:
            break
        notes.append(f"subdivided-triangles: {_room_words(room)} by {name}")
    if best is None:
        raise last
    return _noted(*best, notes, size)


def _room_words(room):
    if room < -1.5:
        return "the quads do not close"
    if room < -0.5:
        return "two quads have two edges in common"
    return f"the worst corner of a quad has a sine of {room:.2f}"


def _noted(room, mesh, local, notes, size):
    if local is not None:
        notes.append(f"subdivided-triangles: smaller where the solid is curved or narrow, down to {local.least / 2:.3g} "
                     f"instead of {size:g}; the worst corner of a quad has a sine of {room:.2f}")
    mesh["notes"] = notes + [f"subdivided-triangles: {len(mesh['quads'])} quads"]
    return mesh


def _reason(fault):
    return {"ODD_SURFACE": "the one before gave an odd number of quads",
            "TOOL_FAILED": "gmsh failed at the one before"}.get(fault.code, "the one before left triangles")


def _generate(solid, size, method, algorithm, even, local=None):
    """A new mesh of the solid's faces in the current model.

    local: a LocalSize to follow, of the triangles before they are subdivided.
    even: every edge gets an even number of intervals, without which a face cannot be recombined to quads only.
    """
    gmsh.model.mesh.clear()
    subdivide = method.startswith("subdivided")
    _options(2.0 * size if subdivide else size, algorithm)
    if local is not None:
        gmsh.option.setNumber("Mesh.MeshSizeMin", local.least)
        gmsh.model.mesh.setSizeCallback(local)
    for face in solid.faces:
        gmsh.model.mesh.removeConstraints([(2, face)])
    for edge in solid.edges:
        gmsh.model.mesh.removeConstraints([(1, edge)])
    if method == "transfinite":
        _make_transfinite(solid, size)
    elif even and method == "blossom":
        for edge in solid.edges:
            gmsh.model.mesh.setTransfiniteCurve(edge, 2 * max(1, int(np.rint(solid.length(edge) / size / 2))) + 1)
    if method != "subdivided-triangles":
        for face in solid.faces:
            gmsh.model.mesh.setRecombine(2, face)
    gmsh.model.mesh.generate(2)
    if local is not None:
        gmsh.model.mesh.removeSizeCallback()
    if subdivide:
        gmsh.option.setNumber("Mesh.SubdivisionAlgorithm", 1)
        gmsh.model.mesh.refine()


def _options(size, algorithm):
    for name, value in (("MeshSizeMin", size), ("MeshSizeMax", size), ("MeshSizeExtendFromBoundary", 0),
                        ("MeshSizeFromPoints", 0), ("MeshSizeFromCurvature", 0), ("Algorithm", algorithm),
                        ("RecombinationAlgorithm", 1), ("SubdivisionAlgorithm", 0), ("RecombineAll", 0),
                        ("Smoothing", 1), ("ElementOrder", 1)):
        gmsh.option.setNumber("Mesh." + name, value)


def _make_transfinite(solid, size):
    """Opposite edges of four-sided faces get equal counts; every face must have four sides."""
    bad = [f for f in solid.faces if len(solid.loops[f]) != 1 or len(solid.boundary[f]) != 4
           or len({abs(e) for e in solid.boundary[f]}) != 4]
    if bad:
        raise WorkerFault("NOT_TRANSFINITE", "without four sides: " + ", ".join(f"Face{f}" for f in bad[:10]), bad)
    root = {e: e for e in solid.edges}

    def find(e):
        while root[e] != e:
            e = root[e]
        return e

    for f in solid.faces:
        a, b, c, d = (abs(e) for e in solid.boundary[f])
        root[find(a)] = find(c)
        root[find(b)] = find(d)
    groups = {}
    for e in solid.edges:
        groups.setdefault(find(e), []).append(e)
    for edges in groups.values():
        count = max(1, int(np.rint(np.mean([solid.length(e) for e in edges]) / size)))
        for e in edges:
            gmsh.model.mesh.setTransfiniteCurve(e, count + 1)
    for f in solid.faces:
        gmsh.model.mesh.setTransfiniteSurface(f)


def _collect(solid):
    """(number of triangles, dict of points, quads, faces) with every point moved onto its CAD entity."""
    tags, xyz, _ = gmsh.model.mesh.getNodes()
    points = np.array(xyz).reshape(-1, 3)
    row = np.full(int(tags.max()) + 1, -1)
    row[np.asarray(tags, int)] = np.arange(len(tags))
    for dim, entities in ((1, solid.edges), (2, solid.faces)):
        for tag in entities:
            own = row[np.asarray(gmsh.model.mesh.getNodes(dim, tag)[0], int)]
            points[own] = solid.project(dim, tag, points[own])
    triangles, quads, faces = 0, [], []
    for face in solid.faces:
        for kind, _, nodes in zip(*gmsh.model.mesh.getElements(2, face)):
            if kind == 3:
                quads.append(row[np.asarray(nodes, int)].reshape(-1, 4))
                faces.append(np.full(len(quads[-1]), face))
            elif kind == 2:
                triangles += len(nodes) // 3
    if not quads:
        return max(triangles, 1), None
    quads = np.concatenate(quads)
    used, packed = np.unique(quads, return_inverse=True)
    return triangles, {"points": points[used], "quads": packed.reshape(-1, 4), "faces": np.concatenate(faces)}

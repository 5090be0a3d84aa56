# SPDX-License-Identifier: LGPL-2.1-or-later
"""One mesh of the whole solid's faces by gmsh, and how it is read back."""
import gmsh
import numpy as np

from .fault import WorkerFault


def generate(solid, size, method, algorithm=6, even=False, local=None):
    """A new mesh of the solid's faces in the current model.

    algorithm  gmsh's number of Mesh.Algorithm
    even       every edge gets an even number of intervals, without which a face cannot be recombined to quads only
    local      a LocalSize to follow, of the elements before they are subdivided
    """
    gmsh.model.mesh.clear()
    subdivide = method.startswith("subdivided")
    _options(2.0 * size if subdivide else size, algorithm)
    if local is not None:
        gmsh.option.setNumber("Mesh.MeshSizeMin", local.least)
        gmsh.option.setNumber("Mesh.LcIntegrationPrecision", 1e-3)     # 1e-9 asks for a size a million times
        gmsh.model.mesh.setSizeCallback(local)
    for face in solid.faces:
        gmsh.model.mesh.removeConstraints([(2, face)])
    for edge in solid.edges:
        gmsh.model.mesh.removeConstraints([(1, edge)])
    if method == "transfinite":
        _make_transfinite(solid, size)
    elif even and method == "blossom":
        for edge in solid.edges:
            wanted = solid.length(edge) / size if local is None else local.count(solid, edge)
            gmsh.model.mesh.setTransfiniteCurve(edge, 2 * max(1, int(np.rint(wanted / 2))) + 1)
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


def collect(solid):
    """(number of triangles, dict of points, quads, faces) with every point moved onto its CAD entity.

    Raises WorkerFault TOOL_FAILED where a face has no elements.
    """
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
        if not len(gmsh.model.mesh.getElements(2, face)[0]):     # a small ball, without a word
            raise WorkerFault("TOOL_FAILED", f"gmsh left Face{face} without elements", [face])
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

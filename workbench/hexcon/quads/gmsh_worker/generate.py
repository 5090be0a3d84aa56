# SPDX-License-Identifier: LGPL-2.1-or-later
"""One mesh of the whole solid's faces by gmsh, and how it is read back."""
import gmsh
import numpy as np

from .coarse_mesh import CoarseMesh
from .detail_sizes import count_along
from .fault import WorkerFault


def is_cut(method):
    """Whether the elements are to be cut about their middles."""
    return method.startswith("subdivided")


def generate(solid, size, method, algorithm=6, even=False, local=None):
    """A new mesh of the solid's faces in the current model; of methods that cut it, with edges of twice the size.

    algorithm  gmsh's number of Mesh.Algorithm
    even       every edge gets an even number of intervals, without which a face cannot be recombined to quads only
    local      a SizeField to follow
    """
    gmsh.model.mesh.clear()
    _options(2.0 * size if is_cut(method) else size, algorithm)
    if local is not None:
        gmsh.option.setNumber("Mesh.MeshSizeMin", local.least)
        gmsh.option.setNumber("Mesh.LcIntegrationPrecision", 1e-3)     # 1e-9 asks for a size a million times
        gmsh.model.mesh.setSizeCallback(local.for_gmsh)
    for face in solid.faces:
        gmsh.model.mesh.removeConstraints([(2, face)])
    for edge in (*solid.edges, *solid.left_out):
        gmsh.model.mesh.removeConstraints([(1, edge)])
    for edge in solid.left_out:
        gmsh.model.mesh.setTransfiniteCurve(edge, 2)
    if method == "transfinite":
        _make_transfinite(solid, size)
    elif even and method == "blossom":
        for edge in solid.edges:
            wanted = solid.length(edge) / size if local is None else count_along(local, solid, edge)
            gmsh.model.mesh.setTransfiniteCurve(edge, 2 * max(1, int(np.rint(wanted / 2))) + 1)
    if method != "subdivided-triangles":
        for face in solid.faces:
            gmsh.model.mesh.setRecombine(2, face)
    gmsh.model.mesh.generate(2)
    if local is not None:
        gmsh.model.mesh.removeSizeCallback()


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


def collect(solid, cut):
    """(number of triangles, dict of points, quads, faces) with every point moved onto its CAD entity.

    cut: every element about its middle into quads. Raises WorkerFault TOOL_FAILED where a face has no elements.
    """
    mesh = CoarseMesh(solid)
    if cut:
        mesh.cut()
    mesh.on_cad()
    triangles, quads = (mesh.corners[count] for count in (3, 4))
    if not len(quads):
        return max(len(triangles), 1), None
    used, packed = np.unique(quads, return_inverse=True)
    return len(triangles), {"points": mesh.points[used], "quads": packed.reshape(-1, 4), "faces": mesh.faces[4]}

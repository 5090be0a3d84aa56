# SPDX-License-Identifier: LGPL-2.1-or-later
"""The solid's surface as triangles without gaps, outward, and the nearest point on them.

They tell where things are: which face is nearest, how full a cell is, what lies left of an edge. Where points lie
exactly is asked of carriers.
"""
import gmsh
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import breadth_first_order, connected_components
from scipy.spatial import cKDTree

from ..fault import WorkerFault
from ..segments import on_segments

ROUND = 20          # triangles round a full circle,
FINEST = 0.1        # but no smaller than this part of the step: curvature has no bound at the tip of a cone
CANDIDATES = 10     # triangles looked at for each point, of each class of sizes
_ALGORITHMS = (6, 5, 1)     # gmsh's numbers: frontal Delaunay, Delaunay, MeshAdapt


class Tessellation:
    """points (n,3), triangles (t,3) outward, face (t,) CAD face of each; edge_points: CAD edge -> ids along it in the
    sense of its parametrisation, ends included; shells: how many closed surfaces the boundary is made of."""

    def __init__(self, solid, step):
        self.points, self.triangles, self.face, self.edge_points = _meshed(solid, step)
        self.shells = self._turn_outward()

    def normals(self):
        """(t,3) normals, as long as twice the triangle's area."""
        a, b, c = (self.points[self.triangles[:, k]] for k in range(3))
        return np.cross(b - a, c - a)

    def normals_at(self, rows):
        """(n,3) unit normals of some triangles."""
        a, b, c = (self.points[self.triangles[rows, k]] for k in range(3))
        n = np.cross(b - a, c - a)
        return n / np.maximum(np.linalg.norm(n, axis=1, keepdims=True), 1e-300)

    def volume(self):
        a, b, c = (self.points[self.triangles[:, k]] for k in range(3))
        return float((a * np.cross(b, c)).sum() / 6)

    def left_of(self):
        """directed edge (a, b) -> triangle on its left, seen from outside."""
        ring = np.stack([self.triangles, np.roll(self.triangles, -1, axis=1)], -1).reshape(-1, 2)
        return dict(zip(map(tuple, ring.tolist()), np.repeat(np.arange(len(self.triangles)), 3).tolist()))

    def euler(self, rows=slice(None)):
        """Euler characteristic of some of the triangles, as a surface with boundary."""
        t = self.triangles[rows]
        edges = np.unique(np.sort(t[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1), axis=0)
        return len(np.unique(t)) - len(edges) + len(t)

    def _turn_outward(self):
        """Turn triangles so that each shell is of one sense, and out of the solid; returns the number of shells.

        The shell with the widest box holds the others, which bound cavities.
        """
        neighbours, same_sense = self._neighbours()
        n = len(self.triangles)
        graph = coo_matrix((np.where(same_sense, 2, 1), neighbours.T), shape=(n, n)).tocsr()
        count, shell = connected_components(graph, directed=False)
        for s in range(count):
            rows = np.flatnonzero(shell == s)
            order, before = breadth_first_order(graph, rows[0], directed=False)
            sense = np.zeros(n, np.int8)
            sense[order[0]] = 1
            kind = np.asarray((graph + graph.T)[order[1:], before[order[1:]]]).ravel()
            for t, b, k in zip(order[1:].tolist(), before[order[1:]].tolist(), kind.tolist()):
                sense[t] = sense[b] if k == 2 else -sense[b]
            self.triangles[rows[sense[rows] < 0]] = self.triangles[rows[sense[rows] < 0]][:, ::-1]
        boxes = [np.ptp(self.points[self.triangles[shell == s]].reshape(-1, 3), axis=0) for s in range(count)]
        outer = int(np.argmax([np.prod(b) for b in boxes]))
        for s in range(count):
            t = self.triangles[shell == s]
            a, b, c = (self.points[t[:, k]] for k in range(3))
            if ((a - self.points[0]) * np.cross(b - self.points[0], c - self.points[0])).sum() * \
                    (1 if s == outer else -1) < 0:
                self.triangles[shell == s] = t[:, ::-1]
        return count

    def _neighbours(self):
        """((m,2) pairs of triangles with an edge in common, (m,) whether they run through it in opposite ways)."""
        ring = np.stack([self.triangles, np.roll(self.triangles, -1, axis=1)], -1).reshape(-1, 2)
        key = np.sort(ring, axis=1)
        order = np.lexsort((key[:, 1], key[:, 0]))
        same = (key[order[1:]] == key[order[:-1]]).all(1)
        if len(order) % 2 or not (same[::2].all() and not same[1::2].any()):
            raise WorkerFault("BAD_SHAPE", "the solid's triangles do not close: an edge has other than two of them")
        a, b = order[::2], order[1::2]
        return np.stack([a, b], 1) // 3, ring[a, 0] == ring[b, 1]


def _meshed(solid, step):
    """(points, triangles, face of each, edge points) by gmsh, which is left with this mesh."""
    for algorithm in _ALGORITHMS:
        gmsh.model.mesh.clear()
        for name, value in (("MeshSizeMin", FINEST * step), ("MeshSizeMax", step), ("MeshSizeExtendFromBoundary", 0),
                            ("MeshSizeFromPoints", 0), ("MeshSizeFromCurvature", ROUND), ("Algorithm", algorithm),
                            ("RecombineAll", 0), ("SubdivisionAlgorithm", 0), ("ElementOrder", 1)):
            gmsh.option.setNumber("Mesh." + name, value)
        fault = _failure()
        empty = [f for f in solid.faces if not len(gmsh.model.mesh.getElements(2, f)[0])]
        if fault is None and not empty:
            return _collected(solid)
    raise WorkerFault("TOOL_FAILED", f"gmsh finds no triangles on {_named(empty)}: {fault or 'it said nothing'}", empty)


def _failure():
    try:
        gmsh.model.mesh.generate(2)
    except Exception as error:      # gmsh raises Exception itself
        return str(error)
    return None


def _named(faces):
    return ", ".join(f"Face{f}" for f in faces[:10]) or "the solid"


def _collected(solid):
    tags, xyz, _ = gmsh.model.mesh.getNodes()
    row = np.full(int(tags.max()) + 1, -1)
    row[np.asarray(tags, int)] = np.arange(len(tags))
    triangles, face = [], []
    for f in solid.faces:
        _, nodes = gmsh.model.mesh.getElementsByType(2, f)
        triangles.append(row[np.asarray(nodes, int)].reshape(-1, 3))
        face.append(np.full(len(triangles[-1]), f))
    edge_points = {e: _along(_segments(e, row)) for e in solid.edges}
    points, triangles, face = np.array(xyz).reshape(-1, 3), np.vstack(triangles), np.concatenate(face)
    if solid.left_out:
        merged = _merged(solid, row, points)
        triangles = merged[triangles]
        whole = (triangles != np.roll(triangles, 1, axis=1)).all(axis=1)
        triangles, face = triangles[whole], face[whole]
        edge_points = {e: merged[ids] for e, ids in edge_points.items()}
    used, packed = np.unique(triangles, return_inverse=True)
    back = np.full(len(tags), -1)
    back[used] = np.arange(len(used))
    return points[used], packed.reshape(-1, 3), face, {e: back[ids] for e, ids in edge_points.items()}


def _segments(edge, row):
    """(n, 2) rows of the nodes of an edge's elements."""
    return row[np.asarray(gmsh.model.mesh.getElementsByType(1, edge)[1], int)].reshape(-1, 2)


def _merged(solid, row, points):
    """(n,) row that stands for each: the points of an edge that is left out are one, at the vertex that it has become;
    points are changed there."""
    merged, first = np.arange(len(points)), {}
    for edge, vertex in solid.left_out.items():
        ids = np.unique(_segments(edge, row))
        one = first.setdefault(vertex, ids[0])
        merged[ids] = one
        points[one] = solid.vertex[vertex]
    return merged


def _along(segments):
    """Ids in order of the segments of an edge, which gmsh gives in the sense of its parametrisation."""
    return np.append(segments[:, 0], segments[-1, 1])


class Nearest:
    """Nearest points on triangles. Among those of one size the centres tell which are near; so they are sorted into
    classes of sizes, and a few of each class are measured: O(log t) a point."""

    def __init__(self, points, triangles):
        corners = points[triangles]
        centres = corners.mean(1)
        radius = np.linalg.norm(corners - centres[:, None], axis=2).max(1)
        size = np.floor(np.log2(np.maximum(radius, 1e-300) / max(radius.max(), 1e-300))).astype(int).clip(-12)
        self._corners = corners
        self._classes = [(rows := np.flatnonzero(size == s), cKDTree(centres[rows])) for s in np.unique(size)]

    def __call__(self, points):
        """(nearest points (n,3), triangles (n,), distances (n,))."""
        points = np.asarray(points, float).reshape(-1, 3)
        best = np.full(len(points), np.inf)
        where, which = points.copy(), np.zeros(len(points), int)
        for rows, tree in self._classes:
            count = min(CANDIDATES, len(rows))
            near = tree.query(points, count)[1].reshape(len(points), count)
            for k in range(count):
                t = rows[near[:, k]]
                q = on_triangles(points, self._corners[t])
                gap = ((q - points) ** 2).sum(1)
                better = gap < best
                best[better], where[better], which[better] = gap[better], q[better], t[better]
        return where, which, np.sqrt(best)


def on_triangles(p, corners):
    """(n,3) nearest points of triangles (n,3,3), each to its own point of p: Ericson, Real-Time Collision Detection
    (2005), 5.1.5, by the best of the plane and the three sides."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    n = np.cross(b - a, c - a)
    square = np.maximum((n * n).sum(1), 1e-300)
    q = p - (((p - a) * n).sum(1) / square)[:, None] * n
    weights = np.stack([(np.cross(v - u, q - u) * n).sum(1) for u, v in ((a, b), (b, c), (c, a))])
    outside = np.flatnonzero((weights < 0).any(0) | (square <= 1e-300))
    if len(outside):
        best, at = np.full(len(outside), np.inf), q[outside]
        for u, v in ((a, b), (b, c), (c, a)):
            s = on_segments(p[outside], u[outside], v[outside])[0]
            gap = ((s - p[outside]) ** 2).sum(1)
            better = gap < best
            best[better], at[better] = gap[better], s[better]
        q[outside] = at
    return q

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A layered mesh as one that knows its CAD: the CAD face of each quad tells its curves and corners."""
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from ..grid.captured import CapturedMesh, HalfEdges, edge_keys, face_pairs
from ..layered.fault import NotLayered


def captured(mesh, features):
    """The grid.captured.CapturedMesh of an extrude.LayeredMesh; features: grid.features.Features with every edge.

    Raises NotLayered where its faces meet otherwise than the CAD's. O(H log H).
    """
    n = len(mesh.points)
    sides, _, lone = face_pairs(mesh.hexes, n)
    quads, under = sides[lone], lone // 6
    patch = features.patch_of_face[_faces_of(mesh, quads)]
    half = HalfEdges(quads, n)
    edges, curve = _curves(mesh.points, half, patch, features)
    corner_vertex = _corners(mesh.points, quads, patch, features)
    return CapturedMesh(mesh.points, mesh.hexes, quads, patch, under, edges, curve, corner_vertex)


def _faces_of(mesh, quads):
    """(n,) CAD face of each of the mesh's quads, in another order."""
    mine, theirs = np.sort(mesh.quads, axis=1), np.sort(quads, axis=1)
    faces = np.empty(len(quads), int)
    faces[np.lexsort(theirs.T)] = mesh.faces[np.lexsort(mine.T)]
    return faces


def _curves(points, half, patch, features):
    """((m,2) edges between patches, lesser vertex first, (m,) curve of each)."""
    here = np.flatnonzero(patch.repeat(4) < patch.repeat(4)[half.twin])
    pair = np.stack([patch.repeat(4)[here], patch.repeat(4)[half.twin[here]]], 1)
    of_pair = {}
    for c, curve in enumerate(features.curves):
        of_pair.setdefault((min(curve.left, curve.right), max(curve.left, curve.right)), []).append(c)
    found = np.full(len(here), -1)
    for one in np.unique(pair, axis=0).tolist():
        rows = np.flatnonzero((pair == one).all(1))
        curves = of_pair.get(tuple(one), [])
        if not curves:
            names = [features.patches[p].faces[0] for p in one]
            raise NotLayered(f"Face{names[0]} and Face{names[1]} meet, as if corners were sharp", names)
        found[rows] = curves[0] if len(curves) == 1 else \
            _of_several(points, half.tail[here[rows]], half.head[here[rows]], curves, features)
    edges = np.sort(np.stack([half.tail[here], half.head[here]], 1), axis=1)
    order = np.argsort(edge_keys(edges[:, 0], edges[:, 1], len(points)))
    return edges[order], found[order]


def _of_several(points, tail, head, curves, features):
    """(n,) curve of each edge: that which its path of edges is nearest to, in the mean."""
    ids, packed = np.unique(np.concatenate([tail, head]), return_inverse=True)
    graph = coo_matrix((np.ones(len(tail)), (packed[:len(tail)], packed[len(tail):])), shape=(len(ids),) * 2)
    path = connected_components(graph, directed=False)[1][packed[:len(tail)]]
    middles = (points[tail] + points[head]) / 2
    off = np.stack([cKDTree(features.curves[c].samples).query(middles)[0] for c in curves], 1)
    mean = np.stack([np.bincount(path, o) / np.bincount(path) for o in off.T], 1)
    return np.asarray(curves)[mean.argmin(1)[path]]


def _corners(points, quads, patch, features):
    """(k,) vertex of each corner: the nearest of those with its patches round it."""
    pairs = np.unique(np.stack([quads.ravel(), patch.repeat(4)], 1), axis=0)
    starts = np.flatnonzero(np.diff(pairs[:, 0], prepend=-1))
    around = {}
    for first, last in zip(starts, [*starts[1:], len(pairs)]):
        around.setdefault(frozenset(pairs[first:last, 1].tolist()), []).append(int(pairs[first, 0]))
    vertex = []
    for place, wanted in zip(features.corners, features.corner_patches):
        near = around.get(frozenset(wanted), [])
        if not near:
            names = sorted(features.patches[p].faces[0] for p in wanted)
            raise NotLayered("a corner is lost, as if corners were sharp", names)
        vertex.append(near[int(np.linalg.norm(points[near] - place, axis=1).argmin())])
    if len(set(vertex)) < len(vertex):
        raise NotLayered("two corners are one, as if corners were sharp")
    return np.array(vertex, int)

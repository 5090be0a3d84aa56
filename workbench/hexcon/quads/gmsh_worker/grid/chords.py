# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces inside a hex mesh with two edges on one smooth patch of its surface: no placement unfolds both hexes beside.

About a point of the surface the hexes are triangles on a small sphere. Where the patch is flat, its quads' edges are
points on a great circle that bounds the triangles. A triangle's side between two of these points that belong to no
common quad, a *chord*, would run along that circle too, so that what it cuts off has no room. At a corner where the
patch goes round more than half of the circle it may run along the rest.
"""
import numpy as np

# The three corners of a hex that each of its corners has an edge with, in VTK's order.
_BESIDE = np.array([[1, 3, 4], [0, 2, 5], [1, 3, 6], [0, 2, 7], [0, 5, 7], [1, 4, 6], [2, 5, 7], [3, 4, 6]])


def chords(mesh):
    """(hexes, points of the surface, patches), each (k,) rows, of a CapturedMesh's chords: told by both hexes beside.

    O(H log H).
    """
    surface = np.zeros(len(mesh.points), bool)
    surface[mesh.quads] = True
    rows = np.flatnonzero(surface[mesh.hexes].sum(axis=1) > 2)
    ends = mesh.hexes[rows][:, np.stack([_BESIDE, np.roll(_BESIDE, -1, axis=1)], axis=-1)].reshape(-1, 2)
    at, rows = np.repeat(mesh.hexes[rows].ravel(), 3), np.repeat(rows, 24)
    keep = surface[at] & surface[ends].all(axis=1)
    at, ends, rows = at[keep], ends[keep], rows[keep]
    edges = np.stack([mesh.half_edges.find(at, ends[:, k]) for k in (0, 1)], axis=1)
    keep = (edges >= 0).all(axis=1)
    at, ends, edges, rows = at[keep], ends[keep], edges[keep], rows[keep]
    before = mesh.half_edges.tail[edges - edges % 4 + (edges - 1) % 4]
    apart = ~(before == ends[:, ::-1]).any(axis=1)
    beside = np.stack([mesh.patch[edges // 4], mesh.patch[mesh.half_edges.twin[edges] // 4]], axis=2)
    same = (beside[:, 0, :, None] == beside[:, 1, None, :]).any(axis=2)
    keep = apart & same.any(axis=1)
    return rows[keep], at[keep], np.where(same[:, 0], beside[:, 0, 0], beside[:, 0, 1])[keep]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of order 2 curved as a given surface is: its middle nodes are kept, certified."""
import numpy as np

from .curving_worker.boundary_edges import BoundaryEdges
from .curving_worker.unfolding import unfolded
from .judging import judge_again

_ROUNDING = 1e-14


def curve_as_given(mesh, ends, middles, progress=None):
    """Move the middle nodes of a mesh's boundary, in place, to where a surface of 8-node quads had them.

    mesh      a hexcon_native.Mesh of order 2 with straight edges
    ends      (k,2) points of edges of its boundary, the lower first;  middles  (k,3) places of their middles
    Where a hex would fold, inner edges bend along, and what still folds keeps as much of the curvature as is proved
    positive (see curving_worker.unfolding). mesh.certificate and quality are those of the curved hexes, where they were
    made; mesh.report["curved as given"] tells: edges, and reduced, how many hexes kept a part. Linear.
    """
    boundary = BoundaryEdges(mesh.points, mesh.hexes, np.asarray(mesh.quads)[:, :4], np.zeros(len(mesh.quads),
                                                                                              np.int64))
    count = len(mesh.points)
    keys, wanted = boundary.ends @ np.array([count, 1]), ends @ np.array([count, 1])
    order = np.argsort(keys)
    place = order[np.minimum(np.searchsorted(keys[order], wanted), len(keys) - 1)]
    there = keys[place] == wanted
    nodes, bend = boundary.middle[place[there]], np.zeros_like(mesh.points)
    bend[nodes] = middles[there] - mesh.points[nodes]
    told = progress or (lambda *_: None)
    found = unfolded(mesh.points, mesh.hexes, np.asarray(mesh.quads)[:, :4], bend, boundary.middle, told)
    mesh.points[:] = found.points
    off = np.linalg.norm(found.points[nodes] - middles[there], axis=1)
    kept = off <= _ROUNDING * np.abs(middles).max(initial=0)
    mesh.points[nodes[kept]] = middles[there][kept]     # bit for bit
    mesh.report["curved as given"] = {"edges": int(there.sum()), "reduced": int((found.factor < 1.0).sum())}
    judge_again(mesh, progress)

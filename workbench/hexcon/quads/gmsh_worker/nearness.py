# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far every point is from the CAD face its quads name."""
import numpy as np


def distances(solid, mesh):
    """(off (V,), gap (V,)) float64.

    off  largest distance to the faces of the point's quads. A point that belongs to several faces lies on a CAD
         edge; where that edge itself is further from a face than the tolerance (a sloppy STEP file), the point
         is measured against the edge instead,
    gap  and the distance to the face, which is the CAD's own fault, is given here (0 elsewhere).
    """
    points = mesh["points"]
    off, gap = np.zeros(len(points)), np.zeros(len(points))
    for face in solid.faces:
        ids = np.unique(mesh["quads"][mesh["faces"] == face])
        d = np.linalg.norm(solid.project(2, face, points[ids]) - points[ids], axis=1)
        bad = d > solid.tolerance
        if bad.any():
            on_edge = _edge_distance(solid, face, points[ids[bad]])
            excused = on_edge <= solid.tolerance
            gap[ids[bad][excused]] = np.maximum(gap[ids[bad][excused]], d[bad][excused])
            d[np.flatnonzero(bad)[excused]] = on_edge[excused]
        off[ids] = np.maximum(off[ids], d)
    return off, gap


def _edge_distance(solid, face, points):
    """Distance to the nearest edge of a face."""
    best = np.full(len(points), np.inf)
    for edge in {abs(e) for e in solid.boundary[face]}:
        best = np.minimum(best, np.linalg.norm(solid.project(1, edge, points) - points, axis=1))
    return best

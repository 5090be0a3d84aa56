# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far every point is from the CAD face its quads name, and the CAD's corners from its edges."""
import numpy as np

from .fault import WorkerFault

STEP = 1e-4     # of the size: what a point may be moved by, to lie on the CAD
MOST_PUT = 1000     # points that are moved so
GAP = 0.05      # of the size: what CAD edges and corners may be off their faces without bending the mesh


def check_corners(solid, size):
    """Raise WorkerFault OFF_CAD where a corner of the CAD is more than GAP * size off the end of one of its edges.

    The mesh would be bent there, and gmsh crashes on that.
    """
    gap = {edge: solid.end_gap(edge) for edge in solid.edges}
    bad = [edge for edge in solid.edges if not gap[edge] <= GAP * size]
    if bad:
        raise WorkerFault("OFF_CAD", f"corners of the CAD are up to {max(gap.values()):.3g} off the ends of their "
                          "edges, more than 1/20 of the size: "
                          + ", ".join(f"Edge{e}" for e in bad[:10]))


def distances(solid, mesh, size):
    """(off (V,), gap (V,)) float64.

    off  largest distance to the faces of the point's quads. Where a CAD edge or corner is itself further from a face
         than the tolerance (files give it to some digits, and CAD programs allow for more), the points that lie on it
         are measured against the edge, or the corner, instead, unless they are more than GAP * size off,
    gap  and the distance to the face, which is the CAD's own fault, is given here (0 elsewhere).
    mesh["joined"], if it is there, names for a face those that are one smooth face with it: the nearest counts.
    Cost: a projection for each point on each of its faces; further ones for points off them only.
    """
    points = mesh["points"]
    off, gap = np.zeros(len(points)), np.zeros(len(points))
    for face in solid.faces:
        ids = np.unique(mesh["quads"][mesh["faces"] == face])
        d = _face_distance(solid, face, points[ids])
        for other in mesh.get("joined", {}).get(face, ()):
            bad = d > solid.tolerance
            d[bad] = np.minimum(d[bad], _face_distance(solid, other, points[ids[bad]]))
        bad = np.flatnonzero((d > solid.tolerance) & (d <= GAP * size))
        if len(bad):
            to_outline = _outline_distance(solid, face, points[ids[bad]])
            excused = to_outline <= solid.tolerance
            np.maximum.at(gap, ids[bad][excused], d[bad][excused])
            d[bad[excused]] = to_outline[excused]
        off[ids] = np.maximum(off[ids], d)
    return off, gap


def put_on_cad(solid, mesh, size, off):
    """Move points that are off their faces on to the CAD, where it is STEP * size away at most: on to the one face that
    they lie on, or the edge between two.

    Edges and corners may be off their faces by the CAD's tolerance: a point between two of them is then off the face.
    off: of distances. Returns whether any was moved.
    """
    wrong = off > solid.tolerance
    if np.count_nonzero(wrong) > MOST_PUT:      # more than a fault of single corners
        return False
    moved, rows = False, np.flatnonzero(wrong[mesh["quads"]].any(axis=1))
    for point in np.flatnonzero(wrong).tolist():
        faces = set(mesh["faces"][rows[(mesh["quads"][rows] == point).any(axis=1)]].tolist())
        here = mesh["points"][point][None]
        places = [solid.project(2, *faces, here)] if len(faces) == 1 else [
            solid.project(1, edge, here) for edge in solid.edges if len(faces & set(solid.faces_of[edge])) == 2]
        for place in places:
            if np.linalg.norm(place - here) <= STEP * size:
                mesh["points"][point], moved = place[0], True
                break
    return moved


def _face_distance(solid, face, points):
    return np.linalg.norm(solid.project(2, face, points) - points, axis=1)


def _outline_distance(solid, face, points):
    """Distance to the nearest edge of a face, or to the nearest of the corners, which need not lie on the edges."""
    best = np.full(len(points), np.inf)
    edges = {abs(e) for e in solid.boundary[face]}
    for edge in edges:
        best = np.minimum(best, np.linalg.norm(solid.project(1, edge, points) - points, axis=1))
    for corner in {v for e in edges for v in solid.ends[e]}:
        best = np.minimum(best, np.linalg.norm(solid.vertex[corner] - points, axis=1))
    return best

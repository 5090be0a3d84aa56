# SPDX-License-Identifier: LGPL-2.1-or-later
"""How well the boundary of a mesh fits a solid: how far its points are off, and which of the solid's edges it has."""
import numpy as np
from quads_solids import Part, Vector

SHARP = 25.0            # degrees between the normals of two faces
NEAR, ALONG = 0.1, 20.0     # of the size, and degrees: an edge of the mesh this near to a place of a curve has it


def distances(shape, points):
    """(n,) from points (n,3) to the boundary of a solid."""
    shell = Part.Compound(shape.Shells)
    return np.array([Part.Vertex(Vector(*p)).distToShape(shell)[0] for p in points.tolist()])


def share_of_edges(shape, points, edges, size):
    """What part of the length of the sharp edges of a solid has an edge (E,2) of the mesh along it."""
    from scipy.spatial import cKDTree
    places, directions = sharp_edges(shape, size / 8)
    start, end = points[edges[:, 0]], points[edges[:, 1]]
    parts = np.linspace(0, 1, 21)
    samples = (start[:, None] * (1 - parts[:, None]) + end[:, None] * parts[:, None]).reshape(-1, 3)
    along = (end - start) / np.linalg.norm(end - start, axis=1, keepdims=True)
    found = np.zeros(len(places), bool)
    for k, near in enumerate(cKDTree(samples).query_ball_point(places, NEAR * size)):
        found[k] = (np.abs(along[np.array(near, int) // len(parts)] @ directions[k]) > np.cos(np.radians(ALONG))).any()
    return float(found.mean())


def sharp_edges(shape, step):
    """(places (n,3), directions (n,3)) along the edges at which two faces meet at an angle, at even steps."""
    places, directions = [], []
    for edge in shape.Edges:
        if _is_sharp(shape, edge):
            for distance in np.arange(step / 2, edge.Length, step):
                u = edge.getParameterByLength(distance)
                places.append(tuple(edge.valueAt(u)))
                directions.append(tuple(edge.tangentAt(u)))
    return np.array(places), np.array(directions)


def _is_sharp(shape, edge):
    if edge.Degenerated:
        return False
    place = edge.valueAt(edge.getParameterByLength(0.37 * edge.Length))
    faces = [face for face in shape.Faces if any(other.isSame(edge) for other in face.Edges)]
    if len(faces) != 2:
        return False
    a, b = (face.normalAt(*face.Surface.parameter(place)) for face in faces)
    return a.cross(b).Length > np.sin(np.radians(SHARP))

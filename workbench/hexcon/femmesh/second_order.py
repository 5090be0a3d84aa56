# SPDX-License-Identifier: LGPL-2.1-or-later
"""20-node hexahedra: back to 8 nodes, on to 27, which edges are curved. hexcon_native.raise_order makes them of 8."""
import numpy as np

from .boundary import face_keys
from .hexahedron import EDGES, FACES_8

# How far a middle node may be from the middle of its edge, in parts of the edge: what files in single precision, or
# with six figures, leave of an edge that is straight.
STRAIGHT = 1e-6

RAISED = ("raised to order 2: the edges are straight, and chords cut round faces as at order 1; hexes made at order 2 "
          "from their solid are curved")


def is_raised(mesh, order):
    """Whether a mesh-like object has order 1, and is wanted at order 2."""
    return order == 2 and np.asarray(mesh.hexes).shape[-1] == 8


def curved_edges(points, hexes):
    """(H,12) bool, of (H,8|20) hexes: the edges that are not straight, to STRAIGHT; none of order 1."""
    if hexes.shape[1] == 8:
        return np.zeros((len(hexes), 12), bool)
    start, end = (points[hexes[:, EDGES[:, k]]] for k in (0, 1))
    off = np.linalg.norm(points[hexes[:, 8:]] - (start + end) / 2, axis=2)
    return ~(off <= STRAIGHT * np.linalg.norm(end - start, axis=2))


def with_centres(points, hexes, hex_of_quad, side_of_quad):
    """(H,20) hexes as 27-node ones, of the same shape: the places that the 20 nodes' own shape functions give.

    hex_of_quad, side_of_quad  (n,) rows of hexes and of FACES
    Returns (points (P',3), hexes (H,27), quads (n,9)): after the 20 nodes the middles of the faces bottom, y-, x+, y+,
    x-, top, then that of the hex; after a quad's 8 its middle. Cost: one sort of 6 H keys.
    """
    faces = hexes[:, FACES_8].reshape(-1, 8)
    _, first, number = np.unique(face_keys(faces[:, :4], len(points)), axis=0, return_index=True, return_inverse=True)
    number = number.reshape(-1, 6) + len(points)
    corners, middles = points[faces[first, :4]], points[faces[first, 4:]]
    of_faces = middles.sum(axis=1) / 2 - corners.sum(axis=1) / 4
    of_hexes = points[hexes[:, 8:]].sum(axis=1) / 4 - points[hexes[:, :8]].sum(axis=1) / 4
    inner = len(points) + len(first) + np.arange(len(hexes))
    quads = hexes[hex_of_quad[:, None], FACES_8[side_of_quad]]
    return (np.vstack([points, of_faces, of_hexes]),
            np.column_stack([hexes, number[:, _FACES_ROUND], inner]),
            np.column_stack([quads, number[hex_of_quad, side_of_quad]]))


_FACES_ROUND = [0, 2, 3, 4, 5, 1]   # rows of FACES: bottom, y-, x+, y+, x-, top


def lower_order(points, hexes):
    """Drop the middle nodes of (H,20) hexes.

    Returns (points, hexes (H,8), kept), kept (P',) being the old index of each new point:
    the middle nodes alone leave, the others keep their sequence.
    """
    middle = np.zeros(len(points), bool)
    middle[hexes[:, 8:]] = True
    middle[hexes[:, :8]] = False
    kept = np.flatnonzero(~middle)
    new = np.full(len(points), -1, np.int64)
    new[kept] = np.arange(len(kept))
    return points[kept], new[hexes[:, :8]], kept

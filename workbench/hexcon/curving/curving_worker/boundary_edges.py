# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edges of a mesh's boundary with their middle nodes, and the CAD faces on both sides."""
import numpy as np

EDGES = np.array([(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)])
"""Ends of the edge of each middle node, VTK_QUADRATIC_HEXAHEDRON order."""


class BoundaryEdges:
    """Every edge of the boundary once.

    points (P,3); hexes (H,20); quads (n,4) the boundary; faces_of_quads (n,): CAD face of each
    ends (E,2) points, the lower first;  middle (E,) points;  faces (E,2): CAD faces of the quads on both sides
    of_quad (n,4): the edge from corner k of each quad to the next
    """

    def __init__(self, points, hexes, quads, faces_of_quads):
        count = len(points)
        ring = np.stack([quads, np.roll(quads, -1, axis=1)], axis=-1).reshape(-1, 2)
        keys, first, place = np.unique(_keys(ring, count), return_index=True, return_inverse=True)
        self.ends, self.of_quad = np.sort(ring[first], axis=1), place.reshape(-1, 4)
        order = np.argsort(place.reshape(-1), kind="stable")
        starts = np.searchsorted(place.reshape(-1)[order], np.arange(len(keys)))
        faces = np.repeat(faces_of_quads, 4)[order]
        self.faces = np.stack([faces[starts], faces[np.append(starts[1:], len(order)) - 1]], axis=1)
        known, where = np.unique(_keys(hexes[:, EDGES].reshape(-1, 2), count), return_index=True)
        self.middle = hexes[:, 8:].reshape(-1)[where[np.searchsorted(known, keys)]]


def _keys(ends, count):
    return ends.min(axis=-1).astype(np.int64) * count + ends.max(axis=-1)

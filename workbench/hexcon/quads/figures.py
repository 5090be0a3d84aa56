# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of a quad surface beside the core's: what no hex can stand on, and the ways of its loops. Plain numpy."""
import numpy as np

from .surface import edge_partners


def face_doublets(quads):
    """(k,2) int64 pairs of quads that share two edges or more, each once.

    quads (n,4) closed. Raises HexconError NOT_CLOSED if not.
    """
    quad, other = np.arange(4 * len(quads)) // 4, edge_partners(quads) // 4
    pairs, edges = np.unique(np.column_stack([quad, other])[quad < other], axis=0, return_counts=True)
    return pairs[edges > 1]


def flat_corners(points, quads):
    """(k,2) int64 rows (quad, corner 0..3) whose angle is 180 degrees or more, to 1e-9 radian.

    points (V,3), quads (n,4) outward.
    """
    corners = points[quads]
    ahead, back = np.roll(corners, -1, axis=1) - corners, np.roll(corners, 1, axis=1) - corners
    outward = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    outward /= np.linalg.norm(outward, axis=1)[:, None]
    sine = (np.cross(ahead, back) * outward[:, None]).sum(axis=2)
    angle = np.arctan2(sine, (ahead * back).sum(axis=2)) % (2 * np.pi)
    return np.argwhere(angle >= np.pi - 1e-9)


def loop_edges(quads):
    """The dual loops as the edges they enter quads by: a list of int64 arrays, each loop once.

    An edge is 4 q + k, edge k of quad q (see surface.edges_of); a loop goes on through the opposite edge. quads
    (n,4) closed, outward or all inward. Raises HexconError NOT_CLOSED if not closed. Cost: linear, in plain Python.
    """
    edges = np.arange(4 * len(quads))
    opposite = edges // 4 * 4 + (edges + 2) % 4
    onward = edge_partners(quads)[opposite].tolist()
    seen, found = [False] * len(onward), []
    for start in range(len(onward)):
        edge, way = start, []
        while not seen[edge]:
            # the way back, through the same quad from its other side, is the same loop
            seen[edge] = seen[opposite[edge]] = True
            way.append(edge)
            edge = onward[edge]
        if way:
            found.append(np.array(way))
    return found

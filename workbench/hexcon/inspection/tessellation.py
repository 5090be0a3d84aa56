# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curved faces and edges of order 2 in flat pieces, for drawing."""
import numpy as np

from hexcon.curving.curving_worker.quad_shape import quad_shape
from hexcon.femmesh.hexahedron import EDGES
from hexcon.femmesh.second_order import STRAIGHT

from .faces import edges_of_quads

_PIECES, _FEW_PIECES, _MANY = 4, 2, 20000   # along an edge; fewer where there are many faces


def weights_of_faces(n_nodes, n_faces):
    """(r r, 4|8) shape functions of a face's nodes at r x r places, row by row; between them it is drawn flat."""
    pieces = 1 if n_nodes == 4 else _PIECES if n_faces < _MANY else _FEW_PIECES
    along = np.linspace(-1.0, 1.0, pieces + 1)
    return np.array([quad_shape(n_nodes, u, v)[0] for v in along for u in along])


def pieces_of_face(places):
    """((k,4) quads, (m,) rim, round once) among a square number of places of a face, row by row."""
    side = round(places ** 0.5)
    place = np.arange(places).reshape(side, side)
    pieces = np.stack([place[:-1, :-1], place[:-1, 1:], place[1:, 1:], place[1:, :-1]], -1).reshape(-1, 4)
    return pieces, np.concatenate([place[0, :-1], place[:-1, -1], place[-1, :0:-1], place[:0:-1, 0]])


def tessellated(points, faces):
    """What to draw of faces (f,4|8) of points (P,3): (points (p,3), quads (q,4), face_of_quad (q,), edges (e,2)).

    Straight faces stay as they are; of curved ones the edges are the rims alone, in as many pieces.
    """
    curved = _curved(points, faces)
    rows = np.flatnonzero(curved)
    straight = faces[~curved, :4]
    if not len(rows):
        return points, straight, np.arange(len(faces)), edges_of_quads(straight, len(points))
    weights = weights_of_faces(8, len(rows))
    pieces, rim = pieces_of_face(len(weights))
    first = len(points) + len(weights) * np.arange(len(rows))[:, None, None]
    quads = (first + pieces).reshape(-1, 4)
    rims = (first + np.column_stack([rim, np.roll(rim, -1)])).reshape(-1, 2)
    return (np.vstack([points, np.einsum("pn,fnx->fpx", weights, points[faces[rows]]).reshape(-1, 3)]),
            np.vstack([straight, quads]), np.concatenate([np.flatnonzero(~curved), np.repeat(rows, len(pieces))]),
            np.vstack([edges_of_quads(straight, len(points)), rims]))


def edges_in_pieces(nodes):
    """(points (p,3), edges (e,2)) of one hex with nodes (8|20,3)."""
    if len(nodes) == 8:
        return nodes, EDGES
    t = np.linspace(0.0, 1.0, _PIECES + 1)[:, None]
    start, end, middle = nodes[EDGES[:, 0]], nodes[EDGES[:, 1]], nodes[8:]
    points = np.concatenate([(1 - t) * (1 - 2 * t) * a + 4 * t * (1 - t) * m + t * (2 * t - 1) * b
                             for a, b, m in zip(start, end, middle)])
    step = np.arange(_PIECES)
    one = np.column_stack([step, step + 1])
    return points, (one + (_PIECES + 1) * np.arange(12)[:, None, None]).reshape(-1, 2)


def _curved(points, faces):
    """(f,) which faces have an edge that is not straight."""
    if faces.shape[1] == 4:
        return np.zeros(len(faces), bool)
    start, middle = points[faces[:, :4]], points[faces[:, 4:]]
    end = np.roll(start, -1, axis=1)
    off = np.linalg.norm(middle - (start + end) / 2, axis=2)
    return (off > STRAIGHT * np.linalg.norm(end - start, axis=2)).any(axis=1)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A hex mesh with every hex in eight, the new points of its boundary on the CAD: so its quads are a subdivision."""
import numpy as np

from ..grid.captured import EDGES, FACES

# edges of each of FACES
_ROUND = np.array([[0, 1, 2, 3], [4, 5, 6, 7], [0, 9, 4, 8], [1, 10, 5, 9], [2, 11, 6, 10], [3, 8, 7, 11]])


def refined(shape, points, hexes, quads, faces):
    """(points (Q,3), the given ones first, hexes (8 H,8), quads (4 n,4), faces (4 n,)).

    shape: roles.Shape whose faces own the quads. Linear, and a projection for each new point of the boundary.
    """
    edges, of_hex = _named(hexes[:, EDGES].reshape(-1, 2))
    sides, of_side = _named(hexes[:, FACES].reshape(-1, 4))
    ring = np.stack([quads, np.roll(quads, -1, axis=1)], -1)
    of_quad = _found(edges, ring.reshape(-1, 2)).reshape(-1, 4)
    middle = _found(sides, quads)
    at_edges = points[edges].mean(1)
    _put_on_cad(shape, at_edges, of_quad, faces)
    of_hex, of_side = of_hex.reshape(-1, 12), of_side.reshape(-1, 6)
    at_sides = np.empty((len(sides), 3))
    at_sides[of_side] = at_edges[of_hex[:, _ROUND]].mean(2)
    for face in np.unique(faces):
        rows = middle[faces == face]
        at_sides[rows] = _on_face(shape, face, at_sides[rows])
    at_hexes = at_sides[of_side].mean(1)
    starts = np.cumsum([len(points), len(edges), len(sides)])
    made = _eight(hexes, of_hex + starts[0], of_side + starts[1], starts[2] + np.arange(len(hexes)))
    around = of_quad + starts[0]
    four = np.stack([quads, around, np.repeat(middle[:, None] + starts[1], 4, 1), np.roll(around, 1, axis=1)], -1)
    return (np.concatenate([points, at_edges, at_sides, at_hexes]), made, four.reshape(-1, 4), np.repeat(faces, 4))


def _named(rows):
    """(distinct rows, sorted within; the number of each row)."""
    found, number = np.unique(np.sort(rows, axis=1), axis=0, return_inverse=True)
    return found, number.ravel()


def _found(names, rows):
    """(n,) numbers of rows among sorted distinct ones."""
    both, first = np.unique(np.concatenate([names, np.sort(rows, axis=1)]), axis=0, return_inverse=True)
    number = np.full(len(both), -1)
    first = first.ravel()
    number[first[:len(names)]] = np.arange(len(names))
    return number[first[len(names):]]


def _put_on_cad(shape, at_edges, of_quad, faces):
    """Middles of the boundary's edges: on the CAD edge between the two faces beside, or on the one face."""
    solid = shape.solid
    edge, face = of_quad.ravel(), np.repeat(faces, 4)
    order = np.lexsort((face, edge))
    one, other, edge = face[order[::2]], face[order[1::2]], edge[order[::2]]
    between = {}
    for e in solid.edges:
        between.setdefault(tuple(sorted(solid.faces_of[e])), []).append(e)
    pairs, which = np.unique(np.stack([one, other], 1), axis=0, return_inverse=True)
    for k, (a, b) in enumerate(pairs.tolist()):
        rows = edge[which.ravel() == k]
        if a == b or (a, b) not in between:
            at_edges[rows] = _on_face(shape, a, at_edges[rows])
            continue
        tried = np.stack([solid.project(1, e, at_edges[rows]) for e in between[a, b]])
        nearest = np.linalg.norm(tried - at_edges[rows], axis=2).argmin(0)
        at_edges[rows] = tried[nearest, np.arange(len(rows))]


def _on_face(shape, face, places):
    carrier = shape.carriers[face]
    return places if carrier.kind == "Plane" else carrier.project(places)[0]


def _eight(hexes, edges, sides, centres):
    """(8 H,8) hexes from corners (H,8), middles of edges (H,12), of sides (H,6) and of hexes (H,)."""
    lattice = np.empty((len(hexes), 3, 3, 3), int)
    place = np.array([(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)])
    for ids, corners in ((hexes, np.arange(8)[:, None]), (edges, EDGES), (sides, FACES),
                         (centres[:, None], np.arange(8)[None])):
        x, y, z = (place[corners].mean(1)).astype(int).T
        lattice[:, x, y, z] = ids
    made = [lattice[:, i + place[:, 0] // 2, j + place[:, 1] // 2, k + place[:, 2] // 2]
            for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    return np.stack(made, 1).reshape(-1, 8)

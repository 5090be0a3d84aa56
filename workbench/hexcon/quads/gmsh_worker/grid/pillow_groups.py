# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pillows round many groups of hexes at once."""
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from .hex_neighbours import FACES, HexNeighbours

SWEEPS = 12        # over the faces round a copied point, to find where it goes


def pillow_groups(points, hexes, group, depth, outer=()):
    """(points, hexes, parent (H',)) with a layer of hexes inside each group's border; parent: the hex they are part of.

    points (P, 3), hexes (H, 8), group (H,) with -1 for no group, depth: part of a hex's height that the layer takes.
    Old points keep their rows and places, new ones follow; old hexes keep their rows and shrink, new ones follow. Faces
    between a group and anything else (another group, no group) get a hex of each group there; faces on the mesh's
    border only if they are among `outer`, rows of HexNeighbours.sides. Groups that touch themselves in a point or an
    edge are parted there.
    """
    mesh = HexNeighbours(hexes)
    owner = np.append(group, -1)
    rows = np.flatnonzero(mesh.mate >= 0)
    rows = rows[(group[rows // 6] >= 0) & (group[rows // 6] != owner[mesh.mate[rows] // 6])]
    rows = np.union1d(rows, np.asarray(outer, int))
    part = _parts_round_points(mesh, group)
    corners = (8 * (rows // 6)[:, None] + FACES[rows % 6])            # of each bordering side
    found, copy = np.unique(part[corners], return_inverse=True)
    copy = copy.reshape(-1, 4)
    border = np.setdiff1d(np.flatnonzero((mesh.mate < 0) & np.repeat(group >= 0, 6)), rows)
    number = np.full(part.max(initial=-1) + 1, -1)
    number[found] = np.arange(len(found))
    on_border = number[part[8 * (border // 6)[:, None] + FACES[border % 6]]]
    moves = _moves(points, mesh, rows, copy, len(found), depth, border, on_border)
    origin = np.empty(len(found), int)
    origin[copy.ravel()] = mesh.sides[rows].ravel()
    shrunk = np.where(number[part] >= 0, len(points) + number[part], hexes.ravel()).reshape(-1, 8)
    layer = np.hstack([len(points) + copy, mesh.sides[rows]])
    return (np.vstack([points, points[origin] + moves]), np.vstack([shrunk, layer]),
            np.concatenate([np.arange(len(hexes)), rows // 6]))


def _parts_round_points(mesh, group):
    """(8 H,) labels: corners at a point have the same if their hexes hang together there and are of one group."""
    rows = np.repeat(np.arange(len(mesh.corner_mates)), 3)
    other = mesh.corner_mates.ravel()
    keep = other > rows
    keep[keep] = group[rows[keep] // 8] == group[other[keep] // 8]
    graph = coo_matrix((np.ones(keep.sum(), np.int8), (rows[keep], other[keep])), shape=(len(mesh.corner_mates),) * 2)
    return connected_components(graph, directed=False)[1]


def _moves(points, mesh, rows, copy, count, depth, border, copy_on_border):
    """(count, 3): for each copied point the way that goes `depth` of their heights into all hexes under its faces.

    By projection on one half-space after the other (Agmon, The relaxation method for linear inequalities, 1954), which
    for faces along axes is exact at once; points on the mesh's border stay on it.
    """
    quads = points[mesh.sides[rows]]
    across = points[mesh.sides[rows ^ 1]].mean(axis=1) - quads.mean(axis=1)
    inward = -_normals(quads)
    turns = _turns(copy, inward, depth * (inward * across).sum(axis=1))
    slides = _turns(copy_on_border, _normals(points[mesh.sides[border]]), np.zeros(len(border)))
    moves = np.zeros((count, 3))
    for _ in range(SWEEPS):
        for who, normal, wanted in turns:
            short = np.maximum(wanted - (normal * moves[who]).sum(axis=1), 0)
            moves[who] += short[:, None] * normal
        for who, normal, _ in slides:
            moves[who] -= (normal * moves[who]).sum(axis=1)[:, None] * normal
    return moves


def _normals(quads):
    normals = np.cross(quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1])
    return normals / np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]


def _turns(copy, normals, wanted):
    """[(copies, normals, wanted lengths)], in the k-th the k-th face of each copy that has one; copy (n, 4) or -1."""
    at, face = copy.ravel(), np.repeat(np.arange(len(copy)), 4)
    at, face = at[at >= 0], face[at >= 0]
    order = np.argsort(at, kind="stable")
    at, face = at[order], face[order]
    place = np.arange(len(at)) - np.searchsorted(at, at)
    return [(at[place == k], normals[face[place == k]], wanted[face[place == k]])
            for k in range(place.max(initial=-1) + 1)]

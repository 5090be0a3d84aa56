# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sheets of hexes put into a mesh that knows its CAD.

One operation does all. Hexes X are pulled back from the rest, and from boundary quads Q of theirs; every face that
opens gets a hex. Where the sheet comes out at the surface there is a strip of new quads: it belongs to the patch on X's
side, a curve there stays with the other side's points, and a curve that the sheet crosses goes on over the strip. With
X = all and Q = some patches this is pillowing (Mitchell & Tautges, Pillowing doublets, 1995).
"""
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from .captured import CapturedMesh, edge_keys, face_pairs

DEPTH = 0.3             # how far X's points are pulled towards the middles of their hexes


class Pinched(ValueError):
    """A sheet that would touch itself, or squeeze two curves into one; .place (3,) says where."""

    def __init__(self, words, place):
        super().__init__(words)
        self.place = place


def insert(mesh, pulled, covered, depth=DEPTH):
    """A CapturedMesh with a sheet between hexes X and the rest.

    pulled   (H,) bool: X
    covered  (n,) bool: boundary quads of X that get a hex each
    Old points (those of the other side, and of the surface that is covered) keep their ids and places, old hexes and
    quads their rows; new ones come after. Raises Pinched, ValueError if a covered quad is not X's. O(H log H).
    """
    if (covered & ~pulled[mesh.under]).any():
        raise ValueError("a covered quad belongs to a hex that is not pulled")
    n = len(mesh.points)
    sheet = np.vstack([_opened(mesh, pulled), mesh.quads[covered]])      # outward from X
    if not len(sheet):
        return mesh
    goes = pulled[mesh.under] & ~covered                # quads that go with X
    rim, copy, points = _checked_rim(mesh, sheet), np.full(n, -1), None
    touched = np.unique(sheet)
    copy[touched] = n + np.arange(len(touched))
    points = np.vstack([mesh.points, _pulled_points(mesh, pulled, goes, touched, depth)])
    moved = np.where(copy >= 0, copy, np.arange(n))
    hexes = np.vstack([np.where(pulled[:, None], moved[mesh.hexes], mesh.hexes), np.hstack([copy[sheet], sheet])])
    quads, patch, under = _new_quads(mesh, sheet, rim, copy, moved, covered, goes)
    on_rim = np.zeros(n, bool)
    on_rim[sheet[rim // 4, rim % 4]] = True
    edges, curve = _new_curves(mesh, goes, on_rim, copy, moved)
    stays = on_rim.copy()
    stays[mesh.quads[~goes]] = True
    v = mesh.corner_vertex
    corner = np.where(stays[v], v, moved[v]) if len(v) else v
    return CapturedMesh(points, hexes, quads, patch, under, edges, curve, corner)


def _opened(mesh, pulled):
    """(k, 4) inner faces between X and the rest, seen from the rest counter-clockwise."""
    sides, inner, _ = face_pairs(mesh.hexes, len(mesh.points))
    first, second = pulled[inner[:, 0] // 6], pulled[inner[:, 1] // 6]
    between = first != second
    return sides[np.where(first, inner[:, 0], inner[:, 1])[between]]


def _checked_rim(mesh, sheet):
    """Places 4 f + k of sheet edges at which it comes out at the surface. Raises Pinched where it is no surface with
    one fan of faces about each of its vertices, or ends anywhere else."""
    n = len(mesh.points)
    tail, head = sheet.ravel(), np.roll(sheet, -1, axis=1).ravel()
    keys = edge_keys(tail, head, n)
    order = np.argsort(keys, kind="stable")
    _, first, count = np.unique(keys[order], return_index=True, return_counts=True)
    if count.max() > 2:
        _pinched(mesh, "a sheet would meet itself at an edge", tail[order[first[count > 2]]])
    rim = np.sort(order[first[count == 1]])
    if (mesh.half_edges.find(tail[rim], head[rim]) < 0).any():
        _pinched(mesh, "a sheet would end inside", tail[rim])
    pair = first[count == 2]
    one, two = order[pair], order[pair + 1]              # half-edges of the sheet, of opposite directions
    ahead = np.arange(len(tail)) // 4 * 4 + (np.arange(len(tail)) + 1) % 4
    # a face's corner at the edge's tail is the place itself, at its head the place after it
    rows = np.concatenate([one, ahead[one]])
    columns = np.where(tail[np.concatenate([two, two])] == tail[rows], np.concatenate([two, two]),
                       ahead[np.concatenate([two, two])])
    corners = coo_matrix((np.ones(len(rows), bool), (rows, columns)), shape=(len(tail),) * 2)
    _, fan = connected_components(corners, directed=False)
    vertex_of_fan = np.full(fan.max() + 1, -1)
    vertex_of_fan[fan] = tail
    twice = np.flatnonzero(np.bincount(vertex_of_fan, minlength=n) > 1)
    if len(twice):
        _pinched(mesh, "a sheet would touch itself at a point", twice)
    return rim


def _pinched(mesh, words, vertices):
    raise Pinched(f"{words} ({', '.join(map(str, np.unique(vertices)[:5]))})", mesh.points[np.min(vertices)])


def _pulled_points(mesh, pulled, goes, touched, depth):
    """Where X's copies of the touched points lie: towards the middles of its hexes, or of its quads, if it has some."""
    n = len(mesh.points)
    at, weight = np.zeros((n, 3)), np.zeros(n)

    def gather(cells):
        total, count = np.zeros((n, 3)), np.bincount(cells.ravel(), minlength=n)
        middles = np.repeat(mesh.points[cells].mean(axis=1), cells.shape[1], axis=0)
        for k in range(3):
            total[:, k] = np.bincount(cells.ravel(), middles[:, k], minlength=n)
        at[count > 0], weight[count > 0] = total[count > 0], count[count > 0]
    gather(mesh.hexes[pulled])
    if goes.any():
        gather(mesh.quads[goes])
    away = at[touched] / np.maximum(weight[touched], 1)[:, None] - mesh.points[touched]
    return mesh.points[touched] + depth * away


def _new_quads(mesh, sheet, rim, copy, moved, covered, goes):
    """(quads, patch, under): those before, then the strip."""
    tail, head = sheet[rim // 4, rim % 4], sheet[rim // 4, (rim + 1) % 4]
    strip = np.stack([copy[tail], copy[head], head, tail], axis=1)
    h = mesh.half_edges.find(tail, head)
    sides = np.stack([h // 4, mesh.half_edges.twin[h] // 4], axis=1)
    beside = np.where(goes[sides[:, 0]], sides[:, 0], sides[:, 1])
    if len(rim) and not (goes[sides].sum(axis=1) == 1).all():
        _pinched(mesh, "a sheet would come out on both sides of an edge", tail)
    under = mesh.under.copy()
    openings = len(sheet) - int(covered.sum())
    under[covered] = len(mesh.hexes) + openings + np.arange(int(covered.sum()))
    quads = np.where(goes[:, None], moved[mesh.quads], mesh.quads)
    return (np.vstack([quads, strip]), np.concatenate([mesh.patch, mesh.patch[beside]]),
            np.concatenate([under, len(mesh.hexes) + rim // 4]))


def _new_curves(mesh, goes, on_rim, copy, moved):
    """(edges, curve of each): a curve goes with X where its quads do, and over the strip where it crosses the rim."""
    edges, curve, n = mesh.curve_edges, mesh.curve, len(mesh.points)
    if not len(edges):
        return edges, curve
    h = mesh.half_edges.find(edges[:, 0], edges[:, 1])
    going = goes[h // 4] & goes[mesh.half_edges.twin[h] // 4]
    ends, of = edges.ravel(), np.repeat(curve, 2)
    span = int(curve.max()) + 1
    key = ends.astype(np.int64) * span + of
    names, rows = np.unique(key, return_inverse=True)
    go = np.bincount(rows, np.repeat(going, 2))
    stay = np.bincount(rows, np.repeat(~going, 2))
    vertex = names // span
    corner = mesh.corner_of_vertex[vertex] >= 0
    crosses = on_rim[vertex] & (go > 0) & ((stay > 0) | corner)
    crowded = np.bincount(vertex[crosses], minlength=n) > 1
    crowded[vertex[crosses & (go > 1)]] = True
    if crowded.any():
        _pinched(mesh, "two curves would go over one strip", np.flatnonzero(crowded))
    across = np.stack([vertex[crosses], copy[vertex[crosses]]], axis=1)
    edges = np.sort(np.vstack([np.where(going[:, None], moved[edges], edges), across]), axis=1)
    return edges, np.concatenate([curve, (names % span)[crosses]])


def under_patches(mesh, patches):
    """A sheet under all quads of some patches."""
    covered = np.isin(mesh.patch, list(patches))
    return insert(mesh, np.ones(len(mesh.hexes), bool), covered)


def round_patch(mesh, patch):
    """A sheet behind the hexes under a patch: a ring of quads along the patch's border."""
    pulled = np.zeros(len(mesh.hexes), bool)
    pulled[mesh.under[mesh.patch == patch]] = True
    return mesh if pulled.all() else insert(mesh, pulled, np.zeros(len(mesh.quads), bool))


def along_curve(mesh, chain):
    """A sheet round the hexes under the quads left of a path: a row of quads on either side of theirs."""
    pulled = np.zeros(len(mesh.hexes), bool)
    pulled[mesh.under[mesh.half_edges.find(chain[:-1], chain[1:]) // 4]] = True
    return insert(mesh, pulled, np.zeros(len(mesh.quads), bool))

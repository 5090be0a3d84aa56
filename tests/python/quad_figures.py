# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of quad surfaces: angles, edges, what no hex can fill, and how near a surface is to a canonical polyhedron.

A surface is points (V, 3), quads (n, 4), quads counter-clockwise seen from outside.
"""
import numpy as np


def normals(points, quads):
    """(n, 3) unit normals, by the diagonals."""
    corners = points[quads]
    normal = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    return normal / np.linalg.norm(normal, axis=1)[:, None]


def corner_angles(points, quads):
    """(n, 4) degrees, 0 to 360: inner angles, above 180 where a corner points inward."""
    corners = points[quads]
    ahead, back = np.roll(corners, -1, axis=1) - corners, np.roll(corners, 1, axis=1) - corners
    sine = (np.cross(ahead, back) * normals(points, quads)[:, None]).sum(axis=2)
    return np.degrees(np.arctan2(sine, (ahead * back).sum(axis=2))) % 360


def edge_lengths(points, quads):
    """(n, 4), edge k from corner k to the next."""
    corners = points[quads]
    return np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)


def flat_corners(points, quads):
    """(k, 2) rows (quad, corner 0 .. 3) with an angle of 180 degrees or more, to 1e-9: no hex has such a face."""
    return np.argwhere(corner_angles(points, quads) >= 180 - np.degrees(1e-9))


def hidden_corners(points, quads):
    """(k, 2) rows (quad, corner) whose triangle with its two neighbours is not seen from the points' mean: on a
    convex body, quads that are folded or lie upside down."""
    corners = points[quads] - points.mean(axis=0)
    before, after = np.roll(corners, 1, axis=1), np.roll(corners, -1, axis=1)
    volume = (before * np.cross(corners, after)).sum(axis=2)
    return np.argwhere(volume <= 1e-12 * np.abs(volume).max())


def face_doublets(quads):
    """(k, 2) pairs of quads that share two edges or more."""
    ends = np.sort(np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    order = np.lexsort(ends.T)
    sides = np.sort(order.reshape(-1, 2) // 4, axis=1)
    pairs, count = np.unique(sides, axis=0, return_counts=True)
    return pairs[count > 1]


def across(quads):
    """(4n, 4) int, for each edge of each quad: its ends, its quad, the quad across."""
    owner = {(a, b): q for q, quad in enumerate(quads.tolist()) for a, b in zip(quad, quad[1:] + quad[:1])}
    return np.array([(a, b, q, owner[b, a]) for (a, b), q in owner.items()])


def planarity(points, quads):
    """Largest distance of a corner from its quad's mean plane, by the size of the whole."""
    corners = points[quads]
    off = (corners - corners.mean(axis=1)[:, None]) @ normals(points, quads)[:, :, None]
    return np.abs(off).max() / np.ptp(points, axis=0).max()


def convexity(points, quads):
    """Least sine of the angle by which a quad lies below the plane of the quad across an edge: > 0 if strictly
    convex there. Corner angles say the rest."""
    first, last, quad, other = across(quads).T
    outward = normals(points, quads)
    edge = points[last] - points[first]
    edge /= np.linalg.norm(edge, axis=1)[:, None]
    return (np.cross(outward[quad], outward[other]) * edge).sum(axis=1).min()


def tangency(points, quads):
    """Largest distance of an edge's line from touching the unit sphere."""
    first, last, _, _ = across(quads).T
    edge = points[last] - points[first]
    moment = np.cross(points[first], edge)
    return np.abs(np.linalg.norm(moment, axis=1) / np.linalg.norm(edge, axis=1) - 1).max()


def volume_of(points, quads):
    """Volume inside quads; a warped one counts by its diagonals' triangles from its middle."""
    corners = points[quads[:, :4]]
    area = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]) / 2
    return float((area * corners.mean(axis=1)).sum() / 3)

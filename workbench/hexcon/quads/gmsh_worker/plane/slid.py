# SPDX-License-Identifier: LGPL-2.1-or-later
"""Boundary points slid along straight edges to where the quads inside want them: dense beside holes, wide elsewhere."""
import numpy as np
from scipy.sparse import coo_matrix, diags, identity, kron
from scipy.sparse.linalg import splu

from ..smooth import optimise

STRAIGHT = 1e-3     # of an edge's length: how far its points are off the line


def slid(outline, shares, points, quads):
    """(shares, points, quads) with the boundary on straight edges, and all inside, at the best places.

    shares  of the outline's edges, even ones;  points (m,2): the boundary first
    """
    loops = outline.place(shares)
    rows, ways, edges, first = [], [], [], 0
    for loop, (parts, places) in enumerate(zip(shares, loops)):
        ends = np.cumsum([len(p) for p in parts])
        for edge, (part, end) in enumerate(zip(parts, ends)):
            chain = places[np.arange(end - len(part), end + 1) % len(places)]
            way = chain[-1] - chain[0]
            length = np.linalg.norm(way)
            if len(part) < 2 or length == 0.0:
                continue
            way = way / length
            rel = chain - chain[0]
            if np.abs(rel[:, 0] * way[1] - rel[:, 1] * way[0]).max() < STRAIGHT * length:
                rows.append(first + end - len(part) + np.arange(1, len(part)))
                ways.append(np.tile(way, (len(part) - 1, 1)))
                edges.append((loop, edge, chain[0], way, length))
        first += len(places)
    if not rows:
        return shares, points, quads
    slides = np.concatenate(rows), np.concatenate(ways)
    fixed = np.arange(len(points)) < first
    moved = optimise(_springs(points, quads, fixed, slides), quads, fixed, slides=slides)
    given, shares = shares, [list(parts) for parts in shares]
    for (loop, edge, start, way, length), own in zip(edges, rows):
        made = np.concatenate([[0.0], (moved[own] - start) @ way / length])
        if (np.diff(np.append(made, 1.0)) <= 0.0).any():        # folded: then the even ones stay
            return given, points, quads
        shares[loop][edge] = made
    moved[:first] = np.concatenate(outline.place(shares))
    return shares, moved, quads


def _springs(points, quads, fixed, slides):
    """Points at rest if every edge were a spring, those on slides along them."""
    m = len(points)
    a, b = quads.ravel(), np.roll(quads, -1, axis=1).ravel()
    adjacent = coo_matrix((np.ones(2 * len(a)), (np.r_[a, b], np.r_[b, a])), shape=(m, m)).tocsr()
    adjacent.data[:] = 1.0
    laplace = kron(diags(np.asarray(adjacent.sum(axis=1)).ravel()) - adjacent, identity(2)).tocsr()
    free, (rows, ways) = np.flatnonzero(~fixed), slides
    column = np.arange(2 * len(free))
    at = np.r_[(2 * free[:, None] + [0, 1]).ravel(), 2 * rows, 2 * rows + 1]
    along = 2 * len(free) + np.arange(len(rows))
    basis = coo_matrix((np.r_[np.ones(len(column)), ways[:, 0], ways[:, 1]], (at, np.r_[column, along, along])),
                       shape=(2 * m, 2 * len(free) + len(rows))).tocsr()
    start = np.where(fixed[:, None], points, 0.0).ravel()
    found = splu((basis.T @ laplace @ basis).tocsc()).solve(-(basis.T @ (laplace @ start)))
    return (start + basis @ found).reshape(-1, 2)

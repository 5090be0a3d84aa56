# SPDX-License-Identifier: LGPL-2.1-or-later
"""Split tetrahedra that have two faces on the surface, where these are nearly flat or the tetrahedron is bad: diced,
its hexes have edges and corners there that no inner point can mend."""
import numpy as np

from .quality import diced_quality
from .topology import EDGES, FACES, boundary, keys

GOOD = 0.3      # scaled Jacobian of a diced tetrahedron: slack enough for triangles whose middles are on a curved face


def split_doubles(points, tetrahedra):
    """(points (Q',3), tetrahedra (M',4)): none with two boundary faces is worse than GOOD; the boundary is as it was.

    The one edge of such a tetrahedron that is in neither face is halved, with all tetrahedra around it; where that
    edge is on the surface too, or three faces are, the tetrahedron gets a point in its middle instead.
    New points come last. O(M log M) a round, a few rounds.
    """
    points, tetrahedra = np.asarray(points), np.asarray(tetrahedra)
    while True:
        outer = boundary(tetrahedra)
        doubles = np.flatnonzero(outer.sum(axis=1) >= 2)
        doubles = doubles[diced_quality(points, tetrahedra[doubles]) < GOOD]
        if not len(doubles):
            return points, tetrahedra
        edges, middles = _inner_edges(tetrahedra, outer, doubles, len(points))
        if len(middles):
            points, tetrahedra = _centred(points, tetrahedra, middles)
        else:
            points, tetrahedra = _halved(points, tetrahedra, edges)


def _inner_edges(tetrahedra, outer, doubles, count):
    """(keys of edges to halve, tetrahedra to be given a centre)."""
    on_surface = np.unique(keys(tetrahedra[:, FACES][outer][:, [[0, 1], [1, 2], [2, 0]]], count))
    two = outer[doubles].sum(axis=1) == 2
    # The faces opposite corners i and j share the edge of the other two corners; i and j end the edge that is free.
    ends = np.argsort(~outer[doubles], axis=1, kind="stable")[:, :2]
    edges = keys(np.take_along_axis(tetrahedra[doubles], ends, axis=1), count)
    inner = two & ~np.isin(edges, on_surface)
    return edges[inner], doubles[~inner]


def _centred(points, tetrahedra, chosen):
    """One tetrahedron to four, around its centre of mass."""
    new = len(points) + np.arange(len(chosen))
    parts = [np.delete(tetrahedra, chosen, axis=0)]
    for corner in range(4):
        part = tetrahedra[chosen].copy()
        part[:, corner] = new
        parts.append(part)
    return np.concatenate([points, points[tetrahedra[chosen]].mean(axis=1)]), np.concatenate(parts)


def _halved(points, tetrahedra, wanted):
    """Halve those of the edges `wanted` (keys) of which no tetrahedron has two."""
    count = len(points)
    wanted = np.unique(wanted)
    have = keys(tetrahedra[:, EDGES], count)
    rank = np.where(np.isin(have, wanted), np.searchsorted(wanted, have), len(wanted))
    first = rank.min(axis=1, keepdims=True)
    beaten = rank[(rank > first) & (rank < len(wanted))]
    free = np.setdiff1d(np.arange(len(wanted)), beaten)
    new = np.full(len(wanted) + 1, -1)
    new[free] = count + np.arange(len(free))
    rows, columns = np.nonzero(new[rank] >= 0)
    parts = [np.delete(tetrahedra, rows, axis=0)]
    for end in (0, 1):
        part = tetrahedra[rows].copy()
        part[np.arange(len(rows)), EDGES[columns, end]] = new[rank[rows, columns]]
        parts.append(part)
    ends = np.stack(np.divmod(wanted[free], count), axis=1)
    return np.concatenate([points, points[ends].mean(axis=1)]), np.concatenate(parts)

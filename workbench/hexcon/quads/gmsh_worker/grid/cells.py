# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which hexes of a grid are taken for a solid: the fuller ones, as one body whose boundary is a manifold."""
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from .manifold_repair import repaired

WAYS = ((0.5, False), (0.5, True), (0.4, False), (0.6, False), (0.4, True))
"""(hexes fuller than this are taken, thin walls and slots are kept), in the order they are worth a try."""
SPECK = 0.75           # a hex that sticks out alone is taken only if it is fuller than this
PIT = 0.25             # and one among taken ones is left only if it is emptier
THIN = 0.12            # fullness from which a hex in the middle of a wall thinner than itself is taken
FALL = 0.05            # fullnesses that differ by less are the same


@dataclass(frozen=True)
class Cells:
    """A set of hexes.

    inside     (H,) bool
    threshold  and walls: by which of WAYS
    shells     closed surfaces that its boundary has
    euler      their Euler characteristics, summed
    """

    inside: np.ndarray
    threshold: float
    walls: bool
    shells: int
    euler: int


def cells(mesh, full, shells=1, ways=WAYS):
    """Yields a Cells for each of `ways` that comes to something new: one body, its boundary manifold.

    mesh is a HexNeighbours, full (H,) the fullness of its hexes, shells how many shells the solid has. Whether Euler
    characteristic and shells are the solid's is for the caller to see. No hex at the mesh's border is taken.
    """
    known = set()
    for threshold, walls in ways:
        inside, evidence = _chosen(mesh, full, threshold, walls)
        inside = _settled(mesh, inside, full, evidence, threshold, shells)
        if inside is None or (key := inside.tobytes()) in known:
            continue
        known.add(key)
        yield Cells(inside, threshold, walls, *boundary_topology(mesh, inside))


def _settled(mesh, inside, full, evidence, threshold, shells):
    """A manifold of one body near `inside`, or None. Mended first: walls may hang together by edges only."""
    for _ in range(3):
        inside = repaired(mesh, inside, evidence, threshold)
        one = None if inside is None else one_body(mesh, inside, full, shells)
        if one is None or (one == inside).all():
            return one
        inside = one
    return None


def _chosen(mesh, full, threshold, walls):
    """(hexes to be taken, fullness as repairs are to see it: walls as full, slots as empty, doubts as half)."""
    inside, evidence = full > threshold, full
    if walls:
        wall, slot = _middles(mesh, full, inside), _middles(mesh, 1 - full, ~inside)
        evidence = np.where(full > THIN, np.maximum(full, threshold), full)
        evidence = np.where(wall, 1.0, np.where(slot, 0.0, evidence))
        inside = (inside | wall) & ~slot
        inside |= _gussets(mesh, full, inside)
    for _ in range(2):
        near = np.append(inside, False)[mesh.across].sum(axis=1)
        inside = (inside & ~((near <= 1) & (full < SPECK))) | (~inside & (near >= 5) & (full > PIT))
    return inside & ~mesh.on_border[mesh.hexes].any(axis=1), evidence


def _middles(mesh, full, inside):
    """Hexes that are not inside although a wall goes through them: across it, fullness falls off on both sides.

    Where two hexes share the wall evenly, the one on the lower side of the local axis.
    """
    found = np.zeros(len(full), bool)
    there, taken = np.append(full, 0.0), np.append(inside, True)
    for axis in range(3):
        a, b = mesh.across[:, 2 * axis], mesh.across[:, 2 * axis + 1]
        row = mesh.mate[2 * axis + 1::6]
        beyond = np.where(row < 0, -1, mesh.across.ravel()[row ^ 1])
        least = full - FALL
        found |= (there[a] < least) & ((there[b] < least) | ((there[b] < full + FALL) & (there[beyond] < least))) & \
            ~taken[a] & ~taken[b]
    return found & ~inside & (full > THIN)


def _gussets(mesh, full, inside):
    """Hexes that join two taken ones with an edge alone in common, as walls do that meet: the fuller one between."""
    rows = np.flatnonzero(~inside & (full > THIN))
    rows = (8 * rows[:, None] + np.arange(8)).ravel()
    there = np.append(inside, False)
    found = np.zeros(len(inside), bool)
    for i, j in ((0, 1), (1, 2), (2, 0)):
        a, b = mesh.corner_mates[rows, i], mesh.corner_mates[rows, j]
        pair = (a >= 0) & (b >= 0)
        pair[pair] = there[a[pair] // 8] & there[b[pair] // 8]
        here, a, b = rows[pair], mesh.corner_mates[a[pair]], mesh.corner_mates[b[pair]]
        across = np.where((a[:, :, None] == b[:, None, :]).any(axis=2) & (a != here[:, None]), a, -1).max(axis=1)
        here, across = here[across >= 0] // 8, across[across >= 0] // 8
        fuller = (full[here] > full[across]) | ((full[here] == full[across]) & (here < across))
        found[here[~there[across] & fuller]] = True
    return found


def one_body(mesh, inside, full, shells=1):
    """`inside` with its largest body alone, and only shells - 1 cavities, the emptiest; None if nothing is inside."""
    label = _parts(mesh, inside)
    weight = np.bincount(label, weights=np.where(inside, full, 0))
    if not inside.any():
        return None
    out = inside & (label == weight.argmax())
    label = _parts(mesh, out)
    outer = np.unique(label[mesh.on_border[mesh.hexes].any(axis=1)])
    empty = np.bincount(label, weights=np.where(out, 0, 1 - full))
    empty[outer] = 0
    cavities = np.argsort(-empty, kind="stable")[:shells - 1]
    void = np.zeros(len(empty), bool)
    void[outer] = True
    void[cavities[empty[cavities] > 0]] = True
    return out | ~void[label]


def _parts(mesh, inside):
    """(H,) labels: hexes that hang together through faces and are all inside or all not have the same."""
    rows = np.flatnonzero(mesh.mate > np.arange(len(mesh.mate)))
    a, b = rows // 6, mesh.mate[rows] // 6
    same = inside[a] == inside[b]
    graph = coo_matrix((np.ones(same.sum(), np.int8), (a[same], b[same])), shape=(len(inside),) * 2)
    return connected_components(graph, directed=False)[1]


def boundary_topology(mesh, inside):
    """(closed surfaces, Euler characteristic) of the boundary of taken hexes."""
    quads = mesh.sides[mesh.boundary(inside)]
    names, ids = np.unique(quads, return_inverse=True)
    ids = ids.reshape(quads.shape)
    edges = np.unique(np.sort(ids[:, [[0, 1], [1, 2], [2, 3], [3, 0]]].reshape(-1, 2), axis=1), axis=0)
    graph = coo_matrix((np.ones(len(edges), np.int8), tuple(edges.T)), shape=(len(names),) * 2)
    return connected_components(graph, directed=False)[0], len(names) - len(edges) + len(quads)

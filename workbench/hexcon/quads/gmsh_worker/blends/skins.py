# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where sheets go in under convex blends: under the level of a lid, and down the walls that the blend ends in.

A sheet parts hexes that are pulled back from it from the rest, and from quads of the surface (grid.sheets). It is made
of sides of a layered mesh's hexes: all at the level of the lid that hang together, and those below its outlines.
"""
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from ..grid.captured import FACES, edge_keys, face_pairs
from ..layered.fault import NotLayered


@dataclass
class Skin:
    """pulled (H,) bool: hexes on its inner side; covered (n,) bool: quads of the surface that it lies under."""

    pulled: np.ndarray
    covered: np.ndarray


def skins(mesh, captured, blends, patch_of_face):
    """[Skin] for convex blends of a layered mesh; those with the same hexes inside are one. captured: its CapturedMesh.

    Raises NotLayered where none would be a closed sheet, or end on the surface only. Linear, but for sorting.
    """
    sides, found = _Sides(mesh, captured), []
    for up in (1, -1):
        left = [(b, rows) for b in blends if b.up == up
                if len(rows := sides.of_lid(patch_of_face[list(b.faces)], up))]
        while left:
            level = sides.level_with(left[0][1], up)
            here = [(b, rows) for b, rows in left if np.isin(rows, level).any()]
            left = [one for one in left if one not in here]
            found.append(_skin(sides, level, patch_of_face[[f for b, _ in here for f in b.faces]], up))
    merged = []
    for one in found:
        same = next((m for m in merged if (m.pulled == one.pulled).all()), None)
        if same is None:
            merged.append(one)
        else:
            same.covered |= one.covered
    return merged


def _skin(sides, level, patches, up):
    inner = np.concatenate([level, sides.walls(level, patches, up)])
    pulled = sides.flooded(inner)
    across = sides.mate[inner]
    if pulled[across[across >= 0] // 6].any():
        raise NotLayered("no sheet goes in under a blend: it would end inside the solid")
    return Skin(pulled, np.isin(sides.lone, inner))


class _Sides:
    """Sides of a layered mesh's hexes: 6 h + k, as grid.captured.FACES has them: below, above, and four walls.

    lone (n,): those of the surface; mate (6 H,): the same side as another hex has it, -1 on the surface
    """

    def __init__(self, mesh, captured):
        self._quads, inner, self.lone = face_pairs(mesh.hexes, len(mesh.points))
        self.mate = np.full(len(self._quads), -1)
        self.mate[inner[:, 0]], self.mate[inner[:, 1]] = inner[:, 1], inner[:, 0]
        self._count, self._hexes = len(mesh.points), mesh.hexes
        level = mesh.level[self._quads]
        self._level = np.where((level == level[:, :1]).all(1), level[:, 0], -1)
        self._patch = np.full(len(self._quads), -1)
        self._patch[self.lone] = captured.patch

    def of_lid(self, patches, up):
        """Sides on the surface that lie on a blend's lid."""
        return self.lone[np.isin(self._patch[self.lone], patches) & (self.lone % 6 == (up > 0))]

    def level_with(self, rows, up):
        """Sides at the level of some, of hexes below it (up) or above, that hang together with the first of them."""
        at = np.flatnonzero((self._level == self._level[rows[0]]) & (np.arange(len(self._level)) % 6 == (up > 0)))
        ids, packed = np.unique(self._quads[at], return_inverse=True)
        who = np.repeat(np.arange(len(at)), 4)
        graph = coo_matrix((np.ones(len(who)), (who, len(at) + packed.ravel())), shape=(len(at) + len(ids),) * 2)
        part = connected_components(graph, directed=False)[1][:len(at)]
        return at[part == part[np.searchsorted(at, rows[0])]]

    def walls(self, level, patches, up):
        """Sides below a level (up), or above it, along its outlines that blends round off."""
        edge, side, outline = self._outlines(level)
        first = np.array([self._wall(s, e) for s, e in zip(side, edge)])
        columns = [self._column(w, up) for w in first]
        rounded = np.isin(self._patch[first], patches)
        taken = np.isin(outline, outline[rounded])
        taken &= ~self._left_out(level, edge, rounded, [(self.mate[c] < 0).all() for c in columns])
        return np.concatenate([columns[k] for k in np.flatnonzero(taken)]) if taken.any() else np.empty(0, int)

    def _outlines(self, level):
        """((n,2) edges of one side only, (n,) that side, (n,) number of the outline that each is on)."""
        quads = self._quads[level]
        tail, head = quads.ravel(), np.roll(quads, -1, axis=1).ravel()
        _, first, count = np.unique(edge_keys(tail, head, self._count), return_index=True, return_counts=True)
        rows = np.sort(first[count == 1])
        edge = np.stack([tail[rows], head[rows]], 1)
        return edge, level[rows // 4], _parts(edge)

    def _wall(self, side, edge):
        """The wall of a side's hex with an edge of it."""
        h = side // 6
        return 6 * h + next(k for k in range(2, 6) if np.isin(edge, self._hexes[h][FACES[k]]).all())

    def _column(self, wall, up):
        """Walls one below the other, or above, from one on."""
        found = [wall]
        while True:
            end = self.mate[found[-1] // 6 * 6 + (up < 0)]
            if end < 0:
                return np.array(found)
            edge = np.intersect1d(self._quads[found[-1]], self._quads[end])
            found.append(self._wall(end, edge))

    def _left_out(self, level, edge, rounded, outside):
        """(n,) bool: edges that are not rounded, at which a sheet may as well end: those between corners of one side at
        the level, over walls of the surface only."""
        out = np.zeros(len(edge), bool)
        rest = np.flatnonzero(~rounded)
        if not len(rest):
            return out
        count = np.bincount(self._quads[level].ravel(), minlength=self._count)
        ends = np.zeros(self._count, bool)
        ends[edge[rounded]] = True
        cut = edge[rest]
        corner = count[cut] == 1
        cut[corner] = -1 - np.arange(corner.sum())
        part = _parts(cut)
        bad = ~np.array(outside)[rest] | (ends[edge[rest]] & (count[edge[rest]] > 1)).any(1)
        out[rest] = ~np.isin(part, part[bad])
        return out

    def flooded(self, inner):
        """(H,) bool: hexes that hang together with those of some sides, not through these."""
        closed = np.zeros(len(self.mate), bool)
        closed[inner] = True
        closed[self.mate[inner][self.mate[inner] >= 0]] = True
        open_ = np.flatnonzero(~closed & (self.mate >= 0))
        pairs = open_ // 6, self.mate[open_] // 6
        graph = coo_matrix((np.ones(len(open_)), pairs), shape=(len(self._hexes),) * 2)
        part = connected_components(graph, directed=False)[1]
        return np.isin(part, part[inner // 6])


def _parts(edges):
    """(n,) which of the parts that hang together each edge is of."""
    _, packed = np.unique(edges, return_inverse=True)
    packed = packed.reshape(-1, 2)
    graph = coo_matrix((np.ones(len(packed)), packed.T), shape=(packed.max() + 1,) * 2)
    return connected_components(graph, directed=False)[1][packed[:, 0]]

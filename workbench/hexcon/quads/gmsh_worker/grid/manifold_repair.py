# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hexes taken and left, changed here and there until the boundary between them is a manifold.

A point is good if its boundary quads form one disc round it: if the taken hexes round the point hang together through
faces, and so do the others. (On the sphere that is the point's link both together say, by Jordan's curve theorem, that
the border between them is one circle.)
"""
from collections import deque

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

AGAIN = 1.5         # what it costs more to change a hex once more
ROUNDS = 400        # changes at least before it is given up; and four for each bad point


def repaired(mesh, inside, full, threshold=0.5):
    """Bool (H,) near `inside` whose boundary is a manifold, or None where none was found.

    mesh is a HexNeighbours; hexes at its border must not be taken, and never are. At each bad point the hex is changed
    that leaves the fewest bad points, and of those the one whose fullness (H,) says the least against it.
    """
    bad = bad_points(mesh, inside)
    if not len(bad):
        return inside.copy()
    return _Repair(mesh, inside, full, threshold).run(bad.tolist())


def bad_points(mesh, inside):
    """Ids of points at which the taken hexes, or the others, do not hang together."""
    flat = mesh.hexes.ravel()
    taken = np.bincount(flat[np.repeat(inside, 8)], minlength=mesh.points)
    mixed = (taken > 0) & (taken < np.bincount(flat, minlength=mesh.points))
    corners = np.flatnonzero(mixed[flat])
    mates = mesh.corner_mates[corners]
    state = np.append(np.repeat(inside, 8), False)
    joined = (mates >= 0) & (state[corners][:, None] == state[mates])
    place = np.full(len(flat), -1)
    place[corners] = np.arange(len(corners))
    a, b = np.repeat(np.arange(len(corners)), 3)[joined.ravel()], place[mates[joined]]
    graph = coo_matrix((np.ones(len(a), np.int8), (a, b)), shape=(len(corners),) * 2)
    parts, part = connected_components(graph, directed=False)
    first = np.unique(part, return_index=True)[1]
    group = 2 * flat[corners[first]] + state[corners[first]]
    return np.unique(np.flatnonzero(np.bincount(group, minlength=2 * mesh.points) > 1) // 2)


class _Repair:
    def __init__(self, mesh, inside, full, threshold):
        self.mesh, self.threshold = mesh, threshold
        self.inside, self.full = inside.copy(), full
        self.order, self.start = mesh.stars
        border = mesh.on_border[mesh.hexes].any(axis=1)
        self.fixed = border
        self.changed = {}

    def run(self, bad):
        waiting, queued = deque(bad), set(bad)
        for _ in range(ROUNDS + 4 * len(bad)):
            while waiting and not self._is_bad(waiting[0]):
                queued.discard(waiting.popleft())
            if not waiting:
                return self.inside
            hexes = [h for h in self._hexes_at(waiting[0]) if not self.fixed[h]]
            if not hexes:
                return None
            change = min(hexes, key=lambda h: (self._cost(h), h))
            self.inside[change] ^= True
            self.changed[change] = self.changed.get(change, 0) + 1
            waiting.rotate(-1)
            for v in self.mesh.hexes[change].tolist():
                if v not in queued and self._is_bad(v):
                    waiting.append(v)
                    queued.add(v)
        return None

    def _cost(self, h):
        """Bad points that changing a hex makes, less those it mends, and what its fullness says against it."""
        at = self.mesh.hexes[h].tolist()
        before = sum(map(self._is_bad, at))
        self.inside[h] ^= True
        after = sum(map(self._is_bad, at))
        self.inside[h] ^= True
        away = self.full[h] - self.threshold
        return after - before + (away if self.inside[h] else -away) + AGAIN * self.changed.get(h, 0)

    def _hexes_at(self, v):
        return sorted(set((self.order[self.start[v]:self.start[v + 1]] // 8).tolist()))

    def _is_bad(self, v):
        corners = self.order[self.start[v]:self.start[v + 1]].tolist()
        state = {c: bool(self.inside[c // 8]) for c in corners}
        return any(self._parts({c for c in corners if state[c] == side}) for side in (False, True))

    def _parts(self, left):
        """Whether corners at one point fall into several parts."""
        if len(left) < 2:
            return False
        todo = [left.pop()]
        while todo:
            found = left.intersection(self.mesh.corner_mates[todo.pop()].tolist())
            left -= found
            todo += found
        return bool(left)

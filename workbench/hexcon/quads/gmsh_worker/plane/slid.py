# SPDX-License-Identifier: LGPL-2.1-or-later
"""Boundary points slid along their edges to where the quads inside want them: dense beside holes, wide elsewhere."""
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix, identity, kron
from scipy.sparse.linalg import splu

from ..outline import LARGEST
from ..plane_mesh import laplacian
from ..smooth import optimise

STRAIGHT = 1e-3             # of an edge's length: how far its points are off the line
TURN = np.radians(25.0)     # on a bent edge: more for an even interval and it stays even,
MOST_TURN, MOST_TIMES = np.radians(12.0), 1.6   # and no interval comes to turn more than this, or so many even ones
ROUNDS = 3                  # along tangents, where edges are bent
BLENDS = 6
EFFORT = 500_000    # of optimise, for each round


@dataclass
class _Edge:
    """loop, edge: of the outline; rows: of its inner points; length: of the chain; turn: of all; straight."""

    loop: int
    edge: int
    rows: np.ndarray
    chain: np.ndarray
    straight: bool
    turn: float

    @property
    def length(self):
        return float(np.linalg.norm(np.diff(self.chain, axis=0), axis=1).sum())

    @property
    def ways(self):
        """(k,2) unit tangents at the inner points."""
        way = self.chain[2:] - self.chain[:-2]
        return way / np.linalg.norm(way, axis=1)[:, None]


def slid(outline, shares, points, quads, even):
    """(shares, points, quads) with the boundary and all inside at the best places.

    shares  of the outline's edges, even ones;  points (m,2): the boundary first
    even    weight of aspect ratios beside angles, as optimise has it
    Points slide along straight edges, and along bent ones where those are divided finely.
    """
    edges, total = _edges(outline, shares)
    if not edges:
        return shares, points, quads
    fixed = np.arange(len(points)) < total
    now, moved = shares, _springs(points, quads, fixed, [e for e in edges if e.straight])
    for _ in range(ROUNDS if any(not e.straight for e in edges) else 1):
        slides = np.concatenate([e.rows for e in edges]), np.concatenate([e.ways for e in edges])
        moved = optimise(moved, quads, fixed, EFFORT, slides, even)
        new = _shares_of(edges, now, moved, LARGEST * outline.size)     # or than even ones
        if new is None:         # folded: then the even ones stay
            return shares, points, quads
        now, moved[:total] = new, np.concatenate(outline.place(new))
        edges, _ = _edges(outline, now)
    return now, moved, quads


def _edges(outline, shares):
    """(list of _Edge with points that may slide, number of boundary points)."""
    found, first = [], 0
    for loop, (parts, places) in enumerate(zip(shares, outline.place(shares))):
        ends = np.cumsum([len(p) for p in parts])
        for edge, (part, end) in enumerate(zip(parts, ends)):
            rows = end - len(part) + np.arange(len(part) + 1)
            chain = places[rows % len(places)]
            straight, turn = _shape(chain)
            if len(part) > 1 and (straight or turn < TURN * len(part)):
                found.append(_Edge(loop, edge, first + rows[1:-1], chain, straight, turn))
        first += len(places)
    return found, first


def _shape(chain):
    """(whether a chain is straight, radians by which it turns, its last interval counted twice)."""
    way = chain[-1] - chain[0]
    length = np.linalg.norm(way)
    rel = chain - chain[0]
    if length > 0.0 and np.abs(rel[:, 0] * way[1] - rel[:, 1] * way[0]).max() < STRAIGHT * length ** 2:
        return True, 0.0
    step = np.diff(chain, axis=0)
    angle = np.arctan2(step[:, 1], step[:, 0])
    turn = np.abs((np.diff(angle) + np.pi) % (2 * np.pi) - np.pi).sum()
    return False, float(turn) * len(step) / max(len(step) - 1, 1)


def _shares_of(edges, shares, points, longest):
    """The shares at which slid points are, None where they have passed each other."""
    new = [list(parts) for parts in shares]
    for e in edges:
        here = np.append(shares[e.loop][e.edge], 1.0)
        made = here + np.r_[0.0, ((points[e.rows] - e.chain[1:-1]) * e.ways).sum(axis=1) / e.length, 0.0]
        if (np.diff(made) <= 0.0).any():
            return None
        new[e.loop][e.edge] = _gentle(made, e, longest)[:-1]
    return new


def _gentle(made, edge, longest):
    """Shares (n+1,) drawn to even ones until no interval is too long, and none of a bent edge turns too much."""
    alike = np.linspace(0.0, 1.0, len(made))
    most = max(longest / edge.length, alike[1] * (1.0 + 1e-9))
    if not edge.straight:
        most = max(MOST_TURN, MOST_TIMES * edge.turn * alike[1]) / edge.turn
    for _ in range(BLENDS):
        if np.diff(made).max() <= most:
            return made
        made = (made + alike) / 2.0
    return alike


def _springs(points, quads, fixed, edges):
    """Points at rest if every edge were a spring, those of straight edges along them."""
    rows = np.concatenate([e.rows for e in edges]) if edges else np.empty(0, int)
    ways = np.concatenate([e.ways for e in edges]) if edges else np.empty((0, 2))
    m = len(points)
    laplace = kron(laplacian(quads, m), identity(2)).tocsr()
    free = np.flatnonzero(~fixed)
    column = np.arange(2 * len(free))
    at = np.r_[(2 * free[:, None] + [0, 1]).ravel(), 2 * rows, 2 * rows + 1]
    along = 2 * len(free) + np.arange(len(rows))
    basis = coo_matrix((np.r_[np.ones(len(column)), ways[:, 0], ways[:, 1]], (at, np.r_[column, along, along])),
                       shape=(2 * m, 2 * len(free) + len(rows))).tocsr()
    start = np.where(fixed[:, None], points, 0.0).ravel()
    found = splu((basis.T @ laplace @ basis).tocsc()).solve(-(basis.T @ (laplace @ start)))
    return (start + basis @ found).reshape(-1, 2)

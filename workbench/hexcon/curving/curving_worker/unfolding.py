# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curved edges without folded hexes: inner edges bend along, inner corners move, and what still folds, or faces that
cross, get less curvature, just there."""
from dataclasses import dataclass

import numpy as np

import hexcon_native as hn

from .boundary_edges import EDGES
from .corner_moves import with_moved_corners

BENDS = ((0.5, 2), (0.9, 3), (1.0, 6))      # what an inner edge takes over of its neighbours' bend, how far in
ROUNDS = 30             # of taking over
HALVINGS = 10           # so often the part of the curvature that a hex can keep is bisected
PATIENCE = 20           # so often neighbours are asked again; then a hex that folds becomes straight
LEAST = 0.1             # part of its scaled Jacobian with straight edges that a hex must keep, or it counts as folded


@dataclass
class Unfolded:
    """points (P,3) with the middle nodes where they are; factor (H,): the part of its curvature that each hex kept, 1
    for all; inner: how many inner edges bend; moved: how many inner corners have moved."""

    points: np.ndarray
    factor: np.ndarray
    inner: int
    moved: int


def unfolded(points, hexes, quads, bend, boundary, progress):
    """An Unfolded mesh.

    points (P,3) with straight edges, hexes (H,20) all positive then;  quads (n,4) the boundary;  bend (P,3): how far
    the middle nodes `boundary` are to move, 0 of the others;  progress: callable(stage, part)
    First the bend alone; where hexes fold (are not proved positive, or all but fold: see LEAST), inner edges near them
    take over part of the bend of the edges beside them, if fewer hexes fold then; then inner corners of what still
    folds move; what is left keeps the largest part of its curvature, by bisection, with which it does not fold. Hexes
    at curved faces that are not proved apart keep half of theirs, and half again, until they are.
    """
    least = LEAST * hn.quality(points, hexes).scaled_jacobian
    folded = _folded(points + bend, hexes, least)
    inner = moved = 0
    if len(folded):
        alone, first = bend, folded
        for part, rings in BENDS:
            progress("unfold", 0.2)
            tried = _spread(hexes[_near(hexes, first, len(points), rings)], alone, boundary, part)
            still = _folded(points + tried, hexes, least)
            if len(still) < len(folded):
                bend, folded = tried, still
                inner = int((np.abs(bend).sum(1) > 0).sum() - (np.abs(bend[boundary]).sum(1) > 0).sum())
            if not len(folded):
                break
        if len(folded):
            progress("unfold", 0.4)
            points, moved = with_moved_corners(points, hexes, quads, bend, folded, least)
            folded = _folded(points + bend, hexes, least)
    factor, scale = np.ones(len(hexes)), np.ones(len(points))
    for turn in range(10 * PATIENCE):
        progress("unfold", 0.5)
        now = points + bend * scale[:, None]
        if len(folded):
            kept = np.zeros(len(folded)) if turn >= PATIENCE else \
                _largest(points, hexes[folded], bend * scale[:, None], least[folded])
        else:
            folded = _crossing(now, hexes, quads)
            folded = folded[factor[folded] > 0.0]
            kept = np.full(len(folded), 0.5 if turn < PATIENCE else 0.0)
        if not len(folded):
            break
        factor[folded] *= kept
        np.minimum.at(scale, hexes[folded, 8:], scale[hexes[folded, 8:]] * kept[:, None])
        near = _near(hexes, folded, len(points), 1)
        folded = near[_folded(points + bend * scale[:, None], hexes[near], least[near])]
        folded = folded[factor[folded] > 0.0]       # nothing is left of the others' curvature
    return Unfolded(points + bend * scale[:, None], factor, inner, moved)


def _crossing(points, hexes, quads):
    """Rows of the hexes at boundary quads that are not proved to meet only where they share nodes."""
    pairs = hn.certify(points, hexes, quads).crossings
    at_fault = quads[np.unique(pairs)]
    near = np.flatnonzero(np.isin(hexes[:, :8], at_fault).sum(axis=1) >= 4)
    return np.array([h for h in near if np.isin(at_fault, hexes[h, :8]).all(axis=1).any()], int)


def _folded(points, hexes, least):
    """Rows of hexes that are not proved positive, or worse than least (H,)."""
    found = hn.quality(points, hexes).scaled_jacobian
    return np.flatnonzero((found <= 0.0) | (found < least))


def _near(hexes, folded, count, rings):
    """Rows of the hexes that have a node of a folded one, and so on, so many times."""
    for _ in range(rings):
        touched = np.zeros(count, bool)
        touched[hexes[folded]] = True
        folded = np.flatnonzero(touched[hexes].any(axis=1))
    return folded


def _beside():
    """(24,2) pairs of the 12 edges that lie opposite to each other in a face."""
    pairs, joined = [], {frozenset(e) for e in EDGES.tolist()}
    for a in range(12):
        for b in range(12):
            (p, q), (r, s) = EDGES[a].tolist(), EDGES[b].tolist()
            across = [{frozenset((p, r)), frozenset((q, s))}, {frozenset((p, s)), frozenset((q, r))}]
            if not {p, q} & {r, s} and any(one <= joined for one in across):
                pairs.append((a, b))
    return np.array(pairs)


_BESIDE = _beside()


def _spread(hexes, bend, boundary, part):
    """Bend of inner edges of some hexes: `part` of the mean of the edges beside them, again and again."""
    to, of = hexes[:, 8:][:, _BESIDE[:, 0]].reshape(-1), hexes[:, 8:][:, _BESIDE[:, 1]].reshape(-1)
    held = np.zeros(len(bend), bool)
    held[boundary] = True
    count = np.bincount(to, minlength=len(bend))
    moving = np.flatnonzero(~held & (count > 0))
    bend = bend.copy()
    for _ in range(ROUNDS):
        mean = np.stack([np.bincount(to, bend[of, k], minlength=len(bend)) for k in range(3)], axis=1)[moving]
        bend[moving] = part * mean / count[moving, None]
    return bend


def _largest(points, hexes, bend, least):
    """(n,) the part of its bend with which each hex by itself does not fold; nearly the largest, 0 of none."""
    good, bad = np.zeros(len(hexes)), np.ones(len(hexes))
    alone = np.arange(20 * len(hexes)).reshape(-1, 20)
    straight, moved = points[hexes], bend[hexes]
    for _ in range(HALVINGS):
        tried = (good + bad) / 2
        folded = _folded((straight + tried[:, None, None] * moved).reshape(-1, 3), alone, least)
        wrong = np.zeros(len(hexes), bool)
        wrong[folded] = True
        bad[wrong], good[~wrong] = tried[wrong], tried[~wrong]
    return good

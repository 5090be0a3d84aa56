# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curved edges without folded hexes: inner edges bend along, and what still folds gets less curvature, just there."""
from dataclasses import dataclass

import numpy as np

import hexcon_native as hn

from .boundary_edges import EDGES

BENDS = (0.5, 0.9)      # what an inner edge takes over of its neighbours' bend
ROUNDS = 12             # of taking over: it dies out within as many hexes
HALVINGS = 10           # so often the part of the curvature that a hex can keep is bisected


@dataclass
class Unfolded:
    """points (P,3) with the middle nodes where they are; factor (H,): the part of its curvature that each hex kept, 1
    for all; inner: how many inner edges bend."""

    points: np.ndarray
    factor: np.ndarray
    inner: int


def unfolded(points, hexes, bend, boundary, progress):
    """An Unfolded mesh.

    points (P,3) with straight edges, hexes (H,20) all positive then;  bend (P,3): how far the middle nodes `boundary`
    are to move, 0 of the others;  progress: callable(stage, part)
    First the bend alone; where hexes fold, inner edges near them take over part of the bend of the edges beside them,
    if fewer hexes fold then; what is left keeps the largest part of its curvature, by bisection, that is proved.
    """
    folded = _folded(points + bend, hexes)
    inner = 0
    if len(folded):
        near = _near(hexes, folded, len(points))
        for part in BENDS:
            progress("unfold", 0.2)
            tried = _spread(hexes[near], bend, boundary, part)
            still = _folded(points + tried, hexes)
            if len(still) < len(folded):
                bend, folded = tried, still
                inner = int((np.abs(bend).sum(1) > 0).sum() - (np.abs(bend[boundary]).sum(1) > 0).sum())
            if not len(folded):
                break
    factor = np.ones(len(hexes))
    scale = np.ones(len(points))
    while len(folded):
        progress("unfold", 0.5)
        kept = _largest(points, hexes[folded], bend * scale[:, None])
        factor[folded] *= kept
        np.minimum.at(scale, hexes[folded, 8:], scale[hexes[folded, 8:]] * kept[:, None])
        folded = _folded(points + bend * scale[:, None], hexes)
    return Unfolded(points + bend * scale[:, None], factor, inner)


def _folded(points, hexes):
    """Rows of hexes that are not proved positive; their topology is not looked at."""
    return hn.certify(points, hexes, np.empty((0, 4), int)).nonpositive.astype(int)


def _near(hexes, folded, count):
    """Rows of the hexes that have a node of a folded one, and of those next to them."""
    for _ in range(2):
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


def _largest(points, hexes, bend):
    """(n,) the part of its bend with which each hex is positive by itself; nearly the largest, 0 of none."""
    good, bad = np.zeros(len(hexes)), np.ones(len(hexes))
    alone = np.arange(20 * len(hexes)).reshape(-1, 20)
    straight, moved = points[hexes], bend[hexes]
    for _ in range(HALVINGS):
        tried = (good + bad) / 2
        folded = _folded((straight + tried[:, None, None] * moved).reshape(-1, 3), alone)
        wrong = np.zeros(len(hexes), bool)
        wrong[folded] = True
        bad[wrong], good[~wrong] = tried[wrong], tried[~wrong]
    return good

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decks of a box 10 x 20 x 30 (volume 6000), as text: 8 hexes, or the 24 quads around them."""
import numpy as np

GRID = np.array([(x, y, z) for z in (0, 15, 30) for y in (0, 10, 20) for x in (0, 5, 10)], float)     # 27 points
HEXES = np.array([[a + d for d in (0, 1, 4, 3, 9, 10, 13, 12)] for a in (0, 1, 3, 4, 9, 10, 12, 13)])
QUADS = np.array([[h[k] for k in side] for h in HEXES.tolist() for side in
                  ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))])


def _outer():
    """The quads that one hex has, outward."""
    _, first, counts = np.unique(np.sort(QUADS, axis=1), axis=0, return_index=True, return_counts=True)
    return QUADS[np.sort(first[counts == 1])]


OUTER = _outer()


def nodes(points=GRID, first=1, head="*NODE", form="{}, {:g}, {:g}, {:g}"):
    return head + "\n" + "".join(form.format(k, *p) + "\n" for k, p in enumerate(points.tolist(), first))


def elements(rows=HEXES, kind="C3D8", first=1, shift=1, head="*ELEMENT, TYPE={}", more=""):
    return head.format(kind) + more + "\n" + "".join(
        ", ".join(map(str, [k, *(n + shift for n in row)])) + "\n" for k, row in enumerate(rows.tolist(), first))


def with_middles(rows, points=GRID):
    """(points, (k,8) rows) of 8-node quads."""
    edges = np.sort(np.stack([rows, np.roll(rows, -1, axis=1)], axis=-1).reshape(-1, 2), axis=1)
    found, number = np.unique(edges, axis=0, return_inverse=True)
    return np.vstack([points, points[found].mean(axis=1)]), np.hstack([rows, number.reshape(-1, 4) + len(points)])


BOX = nodes() + elements()
SHELL = nodes() + elements(OUTER, "S4")

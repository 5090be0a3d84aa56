# SPDX-License-Identifier: LGPL-2.1-or-later
"""Why quads do not close, by its name: bow-ties, quads that are there twice, seams and holes."""
import numpy as np

from hexcon_native import ErrorCode, HexconError

from .seams import collapsed, open_edges, words_about_open_edges

_MOST = 1000    # ids that a fault lists


def named(fault, points, quads):
    """The fault with its cause in words; another fault stays as it is."""
    if fault.code not in (ErrorCode.NOT_CLOSED, ErrorCode.NON_MANIFOLD_EDGE, ErrorCode.REPEATED_VERTEX,
                          ErrorCode.NON_MANIFOLD_VERTEX):
        return fault
    for find, words in _CAUSES:
        found = find(points, quads)
        if len(found):
            return HexconError(words.format(count=len(found), all=len(quads)), fault.code, found[:_MOST].tolist())
    if fault.code is not ErrorCode.NOT_CLOSED:
        return fault
    edges = open_edges(quads)
    return HexconError(f"the surface is not closed: {len(edges)} edges are open, of quads that are listed"
                       f"{words_about_open_edges(points, quads)}", fault.code, fault.elements)


def _repeated(points, quads):
    return collapsed(quads)


def _twice(points, quads):
    _, inverse, counts = np.unique(np.sort(quads, axis=1), axis=0, return_inverse=True, return_counts=True)
    return np.flatnonzero(counts[inverse.ravel()] > 1)


def _bow_ties(points, quads):
    """Two opposite edges cross: of the turns at the corners, two next to each other go one way and two the other."""
    corners = points[quads]
    ahead, back = np.roll(corners, -1, axis=1) - corners, np.roll(corners, 1, axis=1) - corners
    turns = np.cross(ahead, back)
    signs = np.einsum("nkx,nx->nk", turns, turns[:, 0]) > 0
    return np.flatnonzero((signs.sum(axis=1) == 2) & (signs[:, 0] != signs[:, 2]) & (signs[:, 1] != signs[:, 3]))


_CAUSES = (
    (_repeated, "{count} of {all} quads (listed) have one corner twice: they are triangles, or points, and no quads"),
    (_twice, "{count} of {all} quads (listed) have their four corners in common with another one: they are there "
             "twice, or "
             "a wall without thickness; take the second ones out"),
    (_bow_ties, "{count} of {all} quads (listed) are bow-ties, whose edges cross: their corners are listed row by "
                "row, not "
                "round (1, 2, 4, 3 instead of 1, 2, 3, 4)"))

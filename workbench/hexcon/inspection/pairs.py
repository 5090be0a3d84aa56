# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paired partition of a quad surface, ready to be drawn."""
import numpy as np

from hexcon.quads.surface import edge_partners, edges_of

from .cutting import centres_of


def bars_of_pairs(points, quads, pairs):
    """(k,3,3): for each pair (k,2) a way from centre to centre, over the middle of an edge they share."""
    pairs = np.asarray(pairs, np.int64)
    across = (edge_partners(quads) // 4).reshape(-1, 4)[pairs[:, 0]] == pairs[:, 1:]
    edges = 4 * pairs[:, 0] + np.argmax(across, axis=1)
    centres, middles = centres_of(points, quads), points[edges_of(quads)[edges]].mean(axis=1)
    return np.stack([centres[pairs[:, 0]], middles, centres[pairs[:, 1]]], axis=1)

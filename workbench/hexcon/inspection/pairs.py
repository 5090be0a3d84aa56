# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paired partition of a quad surface, ready to be drawn."""
import numpy as np

from hexcon.pictures.palette import PAIR_COLOURS
from hexcon.quads.surface import edge_partners, edges_of

from .cutting import centres_of


def bars_of_pairs(points, quads, pairs):
    """(k,3,3): for each pair (k,2) a way from centre to centre, over the middle of an edge they share."""
    pairs = np.asarray(pairs, np.int64)
    across = (edge_partners(quads) // 4).reshape(-1, 4)[pairs[:, 0]] == pairs[:, 1:]
    edges = 4 * pairs[:, 0] + np.argmax(across, axis=1)
    centres, middles = centres_of(points, quads), points[edges_of(quads)[edges]].mean(axis=1)
    return np.stack([centres[pairs[:, 0]], middles, centres[pairs[:, 1]]], axis=1)


def colours_of_pairs(quads, pairs):
    """(n,3) colours of the quads: those of a pair have one, and pairs that share an edge have two, as
    far as the palette goes."""
    pairs = np.asarray(pairs, np.int64)
    pair_of = np.empty(len(quads), np.int64)
    pair_of[pairs] = np.arange(len(pairs))[:, None]
    near = pair_of[edge_partners(quads) // 4]
    neighbours = [set() for _ in pairs]
    for one, two in zip(pair_of.repeat(4).tolist(), near.tolist()):
        if one != two:
            neighbours[one].add(two)
    chosen, used = {}, [0] * len(PAIR_COLOURS)
    for pair, around in enumerate(neighbours):
        taken = {chosen.get(other) for other in around}
        chosen[pair] = min(range(len(used)), key=lambda colour: (colour in taken, used[colour], colour))
        used[chosen[pair]] += 1
    return PAIR_COLOURS[[chosen[pair] for pair in pair_of.tolist()]]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours of a paired partition."""
import numpy as np

from hexcon.quads.surface import edge_partners

from .palette import PAIR_COLOURS


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

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which hexes of order 2 have straight edges, so that what is proved of their corners holds for them."""
import numpy as np

from hexcon.femmesh.second_order import curved_edges


def curved_hexes(points, hexes):
    """Rows of the hexes (H,8|20) with an edge that is not straight; none of order 1."""
    return np.flatnonzero(curved_edges(points, hexes).any(axis=1))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""How deep each hex lies under the boundary, counted in hexes."""
import numpy as np

from hexcon.femmesh.hexahedron import FACES


def layers(hexes, across, n_points):
    """(H,) int64: 1 for the hexes that touch the boundary, k + 1 for those that touch layer k.

    To touch is to have a point in common: what is left when layers are peeled off is again a mesh
    under which nothing of them remains. hexes (H,8), across (H,6) of faces.neighbours(). A hex that
    reaches the boundary by no way (there is none: every face has two hexes) is 0.
    """
    hex_ids, sides = np.nonzero(across < 0)
    front = np.zeros(n_points, bool)
    front[hexes[hex_ids[:, None], FACES[sides]]] = True
    layer = np.zeros(len(hexes), np.int64)
    left, number = np.arange(len(hexes)), 0
    while front.any() and len(left):
        number += 1
        reached = front[hexes[left]].any(axis=1)
        layer[left[reached]] = number
        front[:] = False
        front[hexes[left[reached]]] = True
        left = left[~reached]
    return layer

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Take a valid mesh to another boundary of the same connectivity, valid all the way: a bar is twisted."""
import numpy as np
from grids import box

import hexcon_native as hn

points, hexes, quads = box(3, 3, 9)
boundary = np.unique(quads)


def twisted(degrees):
    """Where the points go: each cross-section turns about the middle, in proportion to its height."""
    angle = np.radians(degrees) * points[:, 2] / 9
    x, y = points[:, 0] - 1.5, points[:, 1] - 1.5
    cosine, sine = np.cos(angle), np.sin(angle)
    return np.stack([1.5 + x * cosine - y * sine, 1.5 + x * sine + y * cosine, points[:, 2]], axis=1)


for degrees in (90, 180):
    moved, reached = hn.morph(points, hexes, twisted(degrees)[boundary], boundary)
    proof, quality = hn.certify(moved, hexes, quads), hn.quality(moved, hexes)
    print(f"twisted by {degrees:3d}  reached {reached:.0%}: {proof}, {quality}")

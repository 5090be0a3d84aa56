# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a surface has more quads than its size wants, and which details of the solid force them."""
import numpy as np

from .gaps import Samples
from .too_small import details, named

MOST = 2.0          # times area / size^2
LEAST = 0.1         # of the size: samples of the surface are as close as for this size, and no closer


def quad_count_words(count, features, size, sizes):
    """What is to be said of so many quads; "" where they are at most MOST times those that the size wants.

    size: of elements; sizes: the SizeField wanted: its own size is where nothing is said. Linear.
    """
    wanted = _wanted(features, size, sizes)
    if count <= MOST * wanted:
        return ""
    found = details(features, size)
    why = named(found) if found else "round faces, on which a grid makes more quads than planes want"
    why += "; between sizes, quads of transitions" if not sizes.even else ""
    return f"{count} quads, {count / wanted:.1f} times what the size wants: the solid's details force them: {why}"


def _wanted(features, size, sizes):
    """The integral of 1 / size^2 on the surface."""
    surface = Samples.of_surface(features, max(min(size, sizes.least), LEAST * size))
    return float((surface.area / np.minimum(size, sizes(surface.points)) ** 2).sum())

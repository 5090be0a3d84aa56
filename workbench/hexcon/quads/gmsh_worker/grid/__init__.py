# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface method grid: a grid of hexes laid over a solid, that takes up the solid's corners, edges and faces."""

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The legend of the scaled Jacobians in the 3D view."""
import FreeCAD
import numpy as np

from hexcon.pictures.palette import quality_colours

from .legend import legend

translate = FreeCAD.Qt.translate

STRIPS = 64
TICK = 0.25


def colour_bar(lowest):
    """A node with the colours from 0, or from the lowest scaled Jacobian where that is below, to 1."""
    low = min(0.0, float(np.floor(lowest / TICK) * TICK))
    limits = np.linspace(low, 1.0, STRIPS + 1)
    figures = [((value - low) / (1.0 - low), f"{value:.2f}".rstrip("0").rstrip("."))
               for value in np.arange(round(low / TICK), round(1 / TICK) + 1) * TICK]
    return legend(translate("HexCon", "scaled Jacobian"), quality_colours((limits[1:] + limits[:-1]) / 2), figures)

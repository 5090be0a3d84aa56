# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dual loops of a quad surface as curves, and where they cross themselves."""
from dataclasses import dataclass
from functools import cached_property

import numpy as np

import hexcon_native
from hexcon.errors import FaultCode, ToolError
from hexcon.quads.figures import loop_edges
from hexcon.quads.surface import edges_of

from .cutting import centres_of

__all__ = ["DualLoop", "LoopedSurface", "centres_of", "dual_loops"]


@dataclass
class DualLoop:
    """One loop of quads, each left by the edge opposite to that of entry.

    quads      (k,) int64, in the order of the loop
    crossings  quads that it passes twice: there it crosses itself
    curve      (k+1,3) through the middles of the edges, closed; between two of them it lies on the
               quad, and where two passages cross is the quad's centre
    """

    quads: np.ndarray
    crossings: np.ndarray
    curve: np.ndarray

    def __len__(self):
        return len(self.quads)


def dual_loops(points, quads):
    """[DualLoop] of a closed surface, points (V,3) and quads (n,4) outward.

    Raises ToolError BAD_SHAPE if it is not closed.
    """
    middles = points[edges_of(quads)].mean(axis=1)
    found = []
    for entries in loop_edges(quads):
        passed, times = np.unique(entries // 4, return_counts=True)
        found.append(DualLoop(entries // 4, passed[times > 1], middles[np.append(entries, entries[0])]))
    return found


class LoopedSurface:
    """A quad surface and its dual loops.

    surface  .points (V,3), .quads (n,4): a quads.QuadSurface
    loops    [DualLoop]
    facts    hexcon_native.SurfaceReport
    """

    def __init__(self, surface):
        self.surface = surface
        self.facts = hexcon_native.check_surface(surface.points, surface.quads)
        self.loops = dual_loops(surface.points, surface.quads)

    @property
    def crossings(self):
        """Quads in which a loop crosses itself."""
        return np.concatenate([loop.crossings for loop in self.loops])

    @cached_property
    def pairs(self):
        """(n/2,2) the paired partition. Raises HexconError ODD."""
        return hexcon_native.pairing(self.surface.quads, self.surface.points)

    def loop(self, row):
        """One of the loops. Raises ToolError BAD_OPTION if there are not so many."""
        if not 0 <= row < len(self.loops):
            raise ToolError(f"loop {row!r}: the surface has loops 0 to {len(self.loops) - 1}", FaultCode.BAD_OPTION)
        return self.loops[row]

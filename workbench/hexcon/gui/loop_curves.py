# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dual loops of a quad surface in the 3D view: curves over the quads, balls where one crosses itself."""
import numpy as np

from hexcon.freecad_compat import solid_of_mesh_object
from hexcon.inspection.dual_loops import centres_of
from hexcon.inspection.faces import edges_of_quads
from hexcon.inspection.pairs import bars_of_pairs, colours_of_pairs
from hexcon.pictures.palette import DARK, PLAIN, loop_colours

from .drawing import Drawing, Drawings
from .nodes import Faces, balls, polylines, underlay

WIDTH, CHOSEN_WIDTH = 3, 7  # pixels
BAR = 11  # a bar runs along a loop: it is seen on both sides of it
BALL = 0.06  # of an edge's length

drawings = Drawings()


class LoopCurves(Drawing):
    """The drawing of one surface.

    looped  the LoopedSurface
    pairs   whether the pairing is shown
    loop    the row of the thick loop, or None
    """

    def __init__(self, mesh_object, looped):
        solid = solid_of_mesh_object(mesh_object)
        super().__init__(mesh_object, [solid] if solid is not None else [])
        self.looped = looped
        surface = looped.surface
        self._edges = edges_of_quads(surface.quads, len(surface.points))
        self.colours = loop_colours(len(looped.loops))
        self.faces = Faces(BAR)
        self.add(self.faces.node)
        self._under_thick, self._under_thin = self.add(underlay()), self.add(underlay())
        self.add(polylines([loop.curve for loop in looped.loops], self.colours, WIDTH))
        lengths = np.linalg.norm(np.diff(surface.points[self._edges], axis=1), axis=2)
        self.add(balls(centres_of(surface.points, surface.quads[looped.crossings]), DARK,
                       BALL * np.median(lengths)))
        self._bars = self._thick = self.loop = None
        self.show_pairs(False)

    def show_pairs(self, wanted):
        """Colour the quads by their pairs, with a bar from centre to centre. Raises HexconError ODD."""
        points, quads = self.looped.surface.points, self.looped.surface.quads
        colours, bars = np.tile(PLAIN, (len(quads), 1)), None
        if wanted:
            pairs = self.looped.pairs
            colours = colours_of_pairs(quads, pairs)
            bars = polylines(bars_of_pairs(points, quads, pairs), np.tile(DARK, (len(pairs), 1)), BAR)
        self._bars = self.instead(self._bars, bars, self._under_thick)
        self.faces.show(points, quads, colours, self._edges)
        self.pairs = wanted

    def choose(self, row):
        """Draw this loop thick; None: no loop."""
        thick = None if row is None else polylines([self.looped.loop(row).curve], self.colours[[row]],
                                                   CHOSEN_WIDTH)
        self._thick = self.instead(self._thick, thick, self._under_thin)
        self.loop = row


def show(mesh_object, looped, pairs=False, loop=None):
    """Draw the dual loops of an object, whose LoopedSurface is looped; returns the LoopCurves."""
    # may raise: before the view is touched
    if pairs:
        looped.pairs  # noqa: B018
    if loop is not None:
        looped.loop(loop)
    drawing = drawings.find(mesh_object) or drawings.put(mesh_object, lambda: LoopCurves(mesh_object, looped))
    if pairs != drawing.pairs:
        drawing.show_pairs(pairs)
    drawing.choose(loop)
    return drawing

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where on the CAD the middle of a boundary edge belongs: on the solid's edge it runs along, or on its face."""
import numpy as np
from gmsh_worker.grid.carriers import curve_carrier, surface_carrier

from . import ON_EDGE, ON_FACE, STRAIGHT
from .curve_points import CurvePoints

ALONG = 1e-3        # of its length: how far its ends may be off the CAD edge that it runs along
FARTHEST = 0.55     # of its length: how far its middle may move; half of it for half a circle


class CarriersOfSolid:
    """The surfaces and curves of a cad.Solid."""

    def __init__(self, solid):
        self.solid = solid
        self._surfaces, self._curves = {}, {}
        self._between = {}
        for edge in solid.edges:
            self._between.setdefault(tuple(sorted(solid.faces_of[edge])), []).append(edge)

    def on_face(self, face, points):
        """(n,3) nearest points on the surface of a CAD face, which goes on without end where it has a closed form."""
        if face not in self._surfaces:
            self._surfaces[face] = surface_carrier(face, self.solid.diagonal)
        return self._surfaces[face].project(points)[0]

    def on_edge(self, edge, points):
        """(n,3) nearest points on a CAD edge."""
        if edge not in self._curves:
            known = curve_carrier(edge, self.solid.diagonal)
            self._curves[edge] = CurvePoints(edge) if known.kind == "other" else known
        found = self._curves[edge].project(points)
        return found[0] if isinstance(found, tuple) else found

    def middles(self, start, end, faces):
        """(places (E,3), (E,) STRAIGHT, ON_FACE or ON_EDGE) for edges from start to end (E,3) with CAD faces (E,2).

        A middle that would move too far, or that finds no place, stays on the straight edge.
        """
        middle, length = (start + end) / 2, np.linalg.norm(end - start, axis=1)
        places, on = middle.copy(), np.full(len(middle), ON_FACE)
        pairs = np.sort(faces, axis=1)
        for pair in np.unique(pairs, axis=0):
            rows = np.flatnonzero((pairs == pair).all(axis=1))
            first, second = (int(f) for f in pair)
            if first != second:
                along = self._along(self._between.get((first, second), ()), start[rows], end[rows],
                                    ALONG * length[rows])
                for edge in np.unique(along[along >= 0]):
                    there = rows[along == edge]
                    places[there], on[there] = self.on_edge(int(edge), middle[there]), ON_EDGE
                rows = rows[along < 0]
            places[rows] = self._nearest(sorted({first, second}), middle[rows])
        lost = ~(np.linalg.norm(places - middle, axis=1) <= FARTHEST * length)
        places[lost], on[lost] = middle[lost], STRAIGHT
        return places, on

    def _along(self, edges, start, end, allowed):
        """(n,) the CAD edge that each edge runs along, -1 for none."""
        best, along = allowed.copy(), np.full(len(start), -1)
        for edge in edges:
            gap = np.maximum(np.linalg.norm(self.on_edge(edge, start) - start, axis=1),
                             np.linalg.norm(self.on_edge(edge, end) - end, axis=1))
            better = gap < best
            best[better], along[better] = gap[better], edge
        return along

    def _nearest(self, faces, points):
        """The nearest place on one of some faces."""
        places, gap = points.copy(), np.full(len(points), np.inf)
        for face in faces if len(points) else ():
            found = self.on_face(face, points)
            off = np.linalg.norm(found - points, axis=1)
            better = off < gap
            places[better], gap[better] = found[better], off[better]
        places[~np.isfinite(gap)] = np.nan
        return places

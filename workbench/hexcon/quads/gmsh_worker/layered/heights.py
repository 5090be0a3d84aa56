# SPDX-License-Identifier: LGPL-2.1-or-later
"""How high caps lie over places of the plane."""
import numpy as np

from .fault import NotLayered
from .roles import PARALLEL

STEPS = 40
MOST_STEP = 0.3     # of the solid's diagonal, in one step
MIDDLES = np.array([0.31, 0.5, 0.73])      # shares of a piece at which heights are compared


class Heights:
    """Of one solid along one direction. plane: CapPlane whose normal that is; shape: roles.Shape."""

    def __init__(self, shape, plane, arrangement):
        self._shape, self._plane, self._pieces = shape, plane, arrangement.pieces
        self._known = {}

    def of_face(self, face, xy, near=None):
        """(n,) heights of a cap over places (n,2), of the surface that it is a part of. near: (n,) first guesses."""
        xy = np.asarray(xy, float).reshape(-1, 2)
        carrier, d = self._shape.carriers[face], self._plane.normal
        if carrier.kind == "Plane":
            return ((carrier.origin - self._plane.lift(xy)) @ carrier.axis) / (d @ carrier.axis)
        z = np.full(len(xy), self.middle(face)) if near is None else np.array(near, float)
        for _ in range(STEPS):
            p = self._plane.lift(xy, z)
            q, n = carrier.project(p)
            along = n @ d
            along = np.where(np.abs(along) < 0.05, np.copysign(0.05, along), along)
            move = (((q - p) * n).sum(1) / along).clip(-MOST_STEP * self._shape.solid.diagonal,
                                                       MOST_STEP * self._shape.solid.diagonal)
            z = z + move
            if np.abs(move).max(initial=0.0) < 1e-12 * self._shape.solid.diagonal:
                break
        if not np.abs(move).max(initial=0.0) < 1e-6 * self._shape.solid.diagonal:
            raise NotLayered(f"Face{face} is not over all of its outline", [face])
        return z

    def middle(self, face):
        """A height of a face."""
        solid = self._shape.solid
        return float(self._plane.height(np.concatenate([solid.edge_points(e, np.array([0.0, 0.5]))
                                                        for e in solid.boundary[face]])).mean())

    def edges_of(self, face):
        """CAD edges at whose heights a cap ends."""
        return {abs(e) for e in self._shape.solid.boundary[face]}

    def over_piece(self, c, face):
        """(3,) heights of a cap over MIDDLES of a piece: of its own edge where it ends there."""
        if (c, face) not in self._known:
            piece = self._pieces[c]
            source = piece.source(self.edges_of(face))
            self._known[c, face] = self.of_source(c, source) if source else self.of_face(face, piece.at(MIDDLES))
        return self._known[c, face]

    def is_level(self, face):
        """Whether a cap is a plane across the direction."""
        carrier = self._shape.carriers[face]
        return carrier.kind == "Plane" and abs(carrier.axis @ self._plane.normal) > 1.0 - PARALLEL ** 2

    def of_source(self, c, source):
        """(3,) heights over MIDDLES of a piece of one of its edges."""
        return self._plane.height(source_points(self._pieces[c], source, MIDDLES))


def source_points(piece, source, shares):
    """(n,3) points of a source's CAD edge over shares of a piece."""
    curve, start, end = source
    shares = np.asarray(shares, float)
    if source is piece.sources[0]:
        return curve.places(start + shares * (end - start))
    low, high = min(start, end), max(start, end)
    f, _ = curve.locate(piece.at(shares), low, high)
    f[shares == 0.0], f[shares == 1.0] = start, end
    return curve.places(f)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""One solid along one direction, from its edges to hexes."""
import numpy as np

from ..boundary import CapPlane
from ..size_field import SizeField
from .arrangement import arrange
from .columns import columns
from .extrude import extrude
from .fault import NotLayered
from .flat_mesh import flat_mesh
from .heights import Heights
from .levels import Levels
from .roles import PARALLEL, Role
from .side_places import sides_of
from .upright import Upright

SAME_PLACE, SAME_HEIGHT = 2e-3, 1e-3    # of the size: nearer is one, seen along the direction and in height
NEAR = 0.3                      # of the size: levels nearer than this are one bent sheet, where they can be


def layered_mesh(shape, direction, size, link, steep=PARALLEL, field=None):
    """The extrude.LayeredMesh of a roles.Shape along a direction (3,), its inner points not yet improved.

    steep: as Standing takes it; field: as its mesh does. Raises NotLayered.
    """
    link.progress("levels", 0.0)
    return Standing(shape, direction, size, steep).mesh(link, field=field)


class Standing:
    """A solid seen along a direction: outlines in the plane, the columns that stand on them, the levels across those.

    shape: roles.Shape; plane: CapPlane whose normal the direction is; roles: {CAD face: Role}; aslant: the sides that
    are not along it; upright, arrangement, columns, levels, heights
    """

    def __init__(self, shape, direction, size, steep=PARALLEL):
        """size: of elements; steep: sine of the angle up to which a face aslant is a side. Raises NotLayered."""
        solid = shape.solid
        self.shape, self.size = shape, size
        self.plane, self.roles = CapPlane(np.zeros(3), direction), shape.roles(direction, steep)
        hanging = [f for f, role in self.roles.items() if role is Role.NONE]
        if hanging:
            raise NotLayered("faces hang over: " + ", ".join(f"Face{f}" for f in hanging[:8]), hanging)
        self.aslant = shape.aslant(direction, self.roles)
        self.upright = Upright(shape, self.plane, self.roles, self.aslant)
        edges = [e for e in solid.edges if solid.faces_of[e][0] != solid.faces_of[e][1]]
        self.arrangement = arrange(solid, self.upright, edges, SAME_PLACE * size)
        self.heights = self._heights()
        self.columns = columns(self.arrangement, self.roles, solid, self.heights)
        self.levels = Levels(self.arrangement, self.columns, self.heights, solid, self.roles,
                             SAME_HEIGHT * size, NEAR * size)

    def _heights(self):
        return Heights(self.shape, self.plane, self.arrangement)

    def stops_between(self, low, high):
        """(n,) shares, from 0 to 1, between two levels at which a layer of hexes has to end."""
        return np.array([0.0, 1.0])

    def walls_over(self, c, heights):
        """[(side, (n,) heights of its lower edge, of its upper edge)] over a piece.

        heights: callable (source) -> (n,)
        """
        return [(face, heights(low), heights(high)) for face, low, high in
                sides_of(self.arrangement.pieces[c], self.shape.solid, self.roles, heights)]

    def mesh(self, link, fixed=None, layers=None, field=None):
        """The extrude.LayeredMesh, its inner points not yet improved.

        fixed   what a neighbour asks: callable (arrangement.Piece) -> number of intervals, or None where it is free
        layers  callable (level, the next level) -> (n,) shares, from 0 to 1, at which layers of hexes lie between
                them, or None where they are as the sizes say
        field   SizeField by place, of at most this size; None: the size everywhere
        Raises NotLayered.
        """
        link.progress("cap", 0.2)
        flat = flat_mesh(self.arrangement, sorted({c.region for c in self.columns}), self.size, link, fixed, field)
        link.over()
        link.progress("levels", 0.8)
        return extrude(self, flat, field or SizeField(self.size), layers)

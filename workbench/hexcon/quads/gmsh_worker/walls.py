# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thin walls and gaps behind curved faces: how large a triangle may be before it cuts through to the other side.

A triangle of edges h on a face of radius R leaves it by h^2 / 6R in its middle (three points on a sphere). Where
another face is nearer than that, both meshes may cross.
"""
import gmsh
import numpy as np

PART = 1 / 6        # of a wall's thickness: so far may a triangle leave its face; with more, gmsh finds no tetrahedra
MATTERS = 0.39      # radii: a wall as thick as this bounds the size no more than the curvature does


class Walls:
    """bounds() of sizes for the faces of a Solid; .least: the smallest so far, infinite where there is none."""

    def __init__(self, solid, size):
        self._solid, self._size, self.least = solid, size, np.inf
        self._box = {f: np.array(gmsh.model.getBoundingBox(2, f)) for f in solid.faces}
        self._beside = {f: {g for e in solid.boundary[f] for g in solid.faces_of[abs(e)]} | {f} for f in solid.faces}

    def bounds(self, face, points, curvature):
        """(m,) largest sizes at points (m,3) of a face with curvatures (m,), inf where no other face is near.

        Faces that share an edge with it are no walls. Cost: a projection for each point on each face whose box is near.
        """
        with np.errstate(divide="ignore"):
            radius = 1.0 / np.maximum(curvature, 1e-12)
        reach = np.minimum(MATTERS * radius, self._size ** 2 / (6 * PART * radius))
        thickness = np.full(len(points), np.inf)
        for other in self._solid.faces:
            if other not in self._beside[face]:
                box = self._box[other]
                gap = np.linalg.norm(np.maximum(0.0, np.maximum(box[:3] - points, points - box[3:])), axis=1)
                near = np.flatnonzero(gap < np.minimum(reach, thickness))
                thickness[near] = np.minimum(thickness[near], self._distance(other, points[near]))
        bound = np.where(thickness < reach, np.sqrt(6 * PART * thickness * radius), np.inf)
        self.least = min(self.least, float(bound.min(initial=np.inf)))
        return bound

    def _distance(self, face, points):
        """From points to a face, as far as OCC's nearest point of its surface lies within its box."""
        if not len(points):
            return np.zeros(0)
        on = self._solid.project(2, face, points)
        box, slack = self._box[face], self._solid.tolerance
        inside = (on >= box[:3] - slack).all(axis=1) & (on <= box[3:] + slack).all(axis=1)
        return np.where(inside, np.linalg.norm(on - points, axis=1), np.inf)

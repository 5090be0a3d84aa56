# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of the parts of a solid as one, and the CAD faces of its boundary."""
import numpy as np
from scipy.optimize import linear_sum_assignment
from scipy.spatial import cKDTree
from scipy.spatial.distance import cdist

from ..grid.tessellation import Nearest, Tessellation
from ..layered.extrude import once
from ..layered.fault import NotLayered

MOST_MOVED = 1500   # points on the sides of a box that are matched other than by place, which takes their cube of time
STEPS = 40.0        # triangles along the diagonal, at least


class Skin:
    """What of a solid's boundary is near places."""

    def __init__(self, solid):
        self._made = Tessellation(solid, solid.diagonal / STEPS)
        self._nearest = Nearest(self._made.points, self._made.triangles)

    def near(self, points):
        """((n,) CAD faces, (n,) distances), of the triangles: those of plane faces are exact."""
        _, triangle, gap = self._nearest(points)
        return self._made.face[triangle], gap


def joined(rest, pieces, skin, near):
    """(points, hexes, quads, (n,2) which mesh and which of its faces each quad is of) of meshes as one.

    rest: [LayeredMesh]; pieces: [(Box, LayeredMesh)], whose points on its sides, inside, become points of the rest
    """
    meshes = rest + [mesh for _, mesh in pieces]
    points = np.concatenate([m.points for m in meshes])
    starts = np.cumsum([0] + [len(m.points) for m in meshes])
    root = np.arange(len(points))
    for (box, mesh), start in zip(pieces, starts[len(rest):]):
        here, there = _seam_points(box, mesh, skin, near), _rest_points(box, rest, skin, near)
        root[start + here] = there[_matched(mesh.points[here], points[there], near)]
    used, new = np.unique(root, return_inverse=True)
    hexes = np.concatenate([new[m.hexes + s] for m, s in zip(meshes, starts)])
    quads = np.concatenate([new[m.quads + s] for m, s in zip(meshes, starts)])
    owner = np.concatenate([np.column_stack([np.full(len(m.quads), k), m.faces]) for k, m in enumerate(meshes)])
    alone = once(quads)
    return points[used], hexes, quads[alone], owner[alone]


def _seam_points(box, mesh, skin, near):
    """Ids of points on quads that lie on sides of a box, but not on the solid's boundary."""
    on = box.sides_of(box.feature.local(mesh.points))[mesh.quads].all(1).any(1)
    quads = mesh.quads[on]
    return np.unique(quads[skin.near(mesh.points[quads].mean(1))[1] > near]) if len(quads) else np.empty(0, int)


def _rest_points(box, rest, skin, near):
    """The same of several meshes, whose points are numbered one after the other."""
    starts = np.cumsum([0] + [len(m.points) for m in rest])
    return np.concatenate([_seam_points(box, m, skin, near) + s for m, s in zip(rest, starts)])


def _matched(points, others, near):
    """(n,) which of the others each point is: in the same place, or the nearest, all taken together."""
    if not len(points) or len(others) < len(points):
        raise NotLayered("what is beside a box is divided otherwise")
    gap, found = cKDTree(others).query(points)
    if gap.max() <= near:
        return found
    if len(others) > MOST_MOVED:
        raise NotLayered("what is beside a box is divided in other places")
    return linear_sum_assignment(cdist(points, others, "sqeuclidean"))[1]


def cad_faces(shape, skin, points, quads, owner, near):
    """(n,) the CAD face of each quad: of all quads on one face of a part that which most of them are nearest to.

    Raises NotLayered where they lie on none: sides of boxes at which parts do not meet.
    """
    nearest, _ = skin.near(points[quads].mean(1))
    faces = np.zeros(len(quads), int)
    _, part = np.unique(owner, axis=0, return_inverse=True)
    order = np.argsort(part, kind="stable")
    for rows in np.split(order, np.cumsum(np.bincount(part))[:-1]):
        found, count = np.unique(nearest[rows], return_counts=True)
        face = int(found[count.argmax()])
        on = points[np.unique(quads[rows])]
        if np.linalg.norm(shape.carriers[face].project(on)[0] - on, axis=1).max() > near:
            raise NotLayered(f"{len(rows)} quads of a box's side lie inside: what is round it does not fit")
        faces[rows] = face
    return faces

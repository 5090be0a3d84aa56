# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quads on what a room has of the solid's own boundary: triangles cut in three that begin at the neighbours' points."""
from dataclasses import dataclass

import gmsh
import numpy as np
from scipy.spatial import cKDTree

from .. import cad
from ..coarse_mesh import CoarseMesh
from ..grid.tessellation import Tessellation
from ..layered.fault import NotLayered

TURN = np.radians(45.0)     # of one interval of an edge, at most
SHORTEST = 0.15             # of the size


@dataclass
class Cover:
    """points (n,3), quads (k,4) in no sense in particular, faces (k,): of the part of the solid that is in the room."""

    points: np.ndarray
    quads: np.ndarray
    faces: np.ndarray


def covers(path, room, rim, skin, size, near):
    """[Cover] of a room, one for each part of the solid of a file that is in it.

    rim (n,3): the neighbours' points on its rim that stay corners when quads are cut: others are half way
    Raises NotLayered.
    """
    with cad.other_model("room"):
        volumes = gmsh.model.occ.importShapes(path)
        try:
            parts, _ = gmsh.model.occ.intersect(volumes, [(3, room.block())])
            gmsh.model.occ.fragment(parts, [(0, gmsh.model.occ.addPoint(*p)) for p in rim])
        except Exception as error:      # gmsh raises Exception itself
            raise NotLayered(f"Open CASCADE does not cut out a room: {error}") from error
        gmsh.model.occ.synchronize()
        solids = [cad.Solid(tag) for _, tag in gmsh.model.getEntities(3)]
        own = [_own_faces(solid, room, skin, near) for solid in solids]
        for solid, faces in zip(solids, own):
            _divide(solid, faces, rim, size, near)
        return [_cover(solid, faces, size) for solid, faces in zip(solids, own)]


def _own_faces(solid, room, skin, near):
    """Faces of a part that are the solid's, not sides of the room inside of it."""
    made = Tessellation(solid, solid.diagonal / 10.0)
    gmsh.model.mesh.clear()
    found = []
    for face in solid.faces:
        middles = made.points[made.triangles[made.face == face]].mean(1)
        if not (solid.is_plane(face) and room.is_side_of(middles, skin, near)):
            found.append(face)
    return found


def _divide(solid, own, rim, size, near):
    """Numbers of intervals of edges for gmsh: one between points of the rim."""
    tree = cKDTree(rim)
    for edge in solid.edges:
        beside = [f in own for f in solid.faces_of[edge]]
        if not any(beside):
            continue
        count = max(1, int(np.rint(solid.length(edge) / (2 * size))), int(np.ceil(solid.turning(edge) / TURN - 0.05)))
        if not all(beside):
            count = 1
            ends = [solid.vertex[v] for v in solid.ends[edge]]
            if tree.query(ends)[0].max() > near or solid.ends[edge][0] == solid.ends[edge][1]:
                raise NotLayered("what is beside a room has no points where its edges end")
        gmsh.model.mesh.setTransfiniteCurve(edge, count + 1)


def _cover(solid, own, size):
    for name, value in (("MeshSizeMin", SHORTEST * size), ("MeshSizeMax", 2 * size), ("MeshSizeExtendFromBoundary", 1),
                        ("MeshSizeFromPoints", 0), ("MeshSizeFromCurvature", 0), ("Algorithm", 6), ("RecombineAll", 0),
                        ("SubdivisionAlgorithm", 0), ("ElementOrder", 1), ("Smoothing", 1)):
        gmsh.option.setNumber("Mesh." + name, value)
    try:
        gmsh.model.mesh.generate(2)
    except Exception as error:      # gmsh raises Exception itself
        raise NotLayered(f"gmsh finds no triangles in a room: {error}") from error
    solid.faces = own
    mesh = CoarseMesh(solid)
    mesh.cut()
    mesh.on_cad()
    used, quads = np.unique(mesh.corners[4], return_inverse=True)
    return Cover(mesh.points[used], quads.reshape(-1, 4), mesh.faces[4])

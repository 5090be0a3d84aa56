# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quad surfaces that gmsh makes on convex CAD bodies, recombined ("blossom") or subdivided, in about the number of
quads that is wanted. All are even. Coarse ones of curved bodies have folded quads and face doublets now and then
(quad_figures tells); "blossom" leaves triangles on the plane triangles of hull_*, at any size.

A surface is (points (V, 3), quads (n, 4)), quads counter-clockwise seen from outside.
"""
import functools
import os

import numpy as np
from cell_surfaces import SOLIDS, cad_file
from scipy.spatial import ConvexHull

from hexcon.errors import ToolError
from hexcon.quads import surface_from_solid

METHODS = ("blossom", "subdivided")
COUNTS = (50, 200, 800, 3000)
AREA_SIZE = 0.3                           # good enough to measure a body's area
STRETCHES = (1.3, 0.85, 1.6, 0.7, 2.0, 0.6)   # of the size, after a failure; as many tries


def _prism(sides, height):
    """gmsh's code for a regular prism."""
    return (f"from math import cos, sin, tau\n"
            f"ring = [occ.addPoint(cos(tau * k / {sides}), sin(tau * k / {sides}), 0) for k in range({sides})]\n"
            f"lines = [occ.addLine(ring[k - 1], ring[k]) for k in range({sides})]\n"
            f"occ.extrude([(2, occ.addPlaneSurface([occ.addCurveLoop(lines)]))], 0, 0, {height})")


def _hull(seed, count):
    """gmsh's code for the convex hull of points near a sphere: plane triangles."""
    rng = np.random.default_rng([seed, count])
    points = rng.normal(size=(count, 3))
    points *= (rng.uniform(0.85, 1.15, count) / np.linalg.norm(points, axis=1))[:, None]
    hull = ConvexHull(points)
    corners = np.sort(hull.vertices)
    return _solid(points[corners], np.searchsorted(corners, hull.simplices).tolist())


def _cut(seed, count):
    """gmsh's code for what `count` planes near a sphere leave of space: plane polygons, three at each corner."""
    rng = np.random.default_rng([seed, count])
    k = np.arange(count) + 0.5
    height, turn = 1 - 2 * k / count, np.pi * (1 + 5 ** 0.5) * k
    ring = np.sqrt(1 - height * height)
    poles = np.column_stack([ring * np.cos(turn), ring * np.sin(turn), height])
    poles += rng.uniform(-0.3, 0.3, poles.shape) * (4 / count) ** 0.5
    poles /= np.linalg.norm(poles, axis=1)[:, None]
    hull = ConvexHull(poles)
    corners = -hull.equations[:, :3] / hull.equations[:, 3:]
    faces = []
    for pole in range(count):
        around = np.flatnonzero((hull.simplices == pole).any(axis=1))
        arms = corners[around] - poles[pole]
        side = np.cross(poles[pole], arms[0])
        faces.append(around[np.argsort(np.arctan2(arms @ side, arms @ arms[0]))].tolist())
    return _solid(corners, faces)


def _solid(points, faces):
    """gmsh's code for a body of plane polygons."""
    return (f"points, faces = {points.round(12).tolist()}, {faces}\n"
            "ids = [occ.addPoint(*p) for p in points]\n"
            "line, plane = {}, []\n"
            "for face in faces:\n"
            "    ends = [tuple(sorted((face[k - 1], face[k]))) for k in range(len(face))]\n"
            "    for a, b in ends:\n"
            "        if (a, b) not in line:\n"
            "            line[a, b] = occ.addLine(ids[a], ids[b])\n"
            "    plane.append(occ.addPlaneSurface([occ.addCurveLoop([line[e] for e in ends])]))\n"
            "occ.addVolume([occ.addSurfaceLoop(plane)])")


# name: gmsh's code; every body is about 2 wide
BODIES = {
    "box": "occ.addBox(0, 0, 0, 2, 1.5, 1)",
    "cylinder": "occ.addCylinder(0, 0, 0, 0, 0, 1.6, 0.8)",
    "frustum": SOLIDS["cone"][0],
    "hexagonal_prism": _prism(6, 1.2),
    "triangular_prism": _prism(3, 1.2),
    "ball": SOLIDS["ball"][0],
    "half_ball": SOLIDS["half_ball"][0],
    "lens": SOLIDS["lens"][0],
    "chamfered": "occ.addBox(0, 0, 0, 2, 2, 1.5)\nocc.synchronize()\n"
                 "top = [tag for _, tag in gmsh.model.getEntitiesInBoundingBox(-1, -1, 1.4, 3, 3, 1.6, 1)]\n"
                 "face = gmsh.model.getEntitiesInBoundingBox(-1, -1, 1.4, 3, 3, 1.6, 2)[0][1]\n"
                 "occ.chamfer([1], top, [face] * 4, [0.4])",
    "filleted": "occ.addBox(0, 0, 0, 2, 2, 1.5)\nocc.synchronize()\n"
                "occ.fillet([1], [tag for _, tag in gmsh.model.getEntities(1)], [0.35])",
    "hull_10": _hull(1, 10),
    "hull_14": _hull(2, 14),
    "hull_24": _hull(3, 24),
    "cut_8": _cut(1, 8),
    "cut_12": _cut(2, 12),
    "cut_20": _cut(3, 20),
}


@functools.cache
def surface_of_size(name, size, method, folder):
    """The surface of a body for a mesh size; folder: for its CAD file. Kept for the life of the process."""
    path = os.path.join(folder, f"{name}.brep")
    if not os.path.exists(path):
        cad_file(BODIES[name], path)
    surface = surface_from_solid(path, size, method)
    return surface.points, surface.quads


def blossom_surface(name, wanted, folder, method="blossom"):
    """A surface of one of BODIES with about `wanted` quads: the first within a fifth, or the nearest of some.

    folder  where the CAD file is kept; what gmsh made is kept for the life of the process
    Raises ToolError where gmsh leaves triangles or an odd number of quads at every size tried: "blossom" does so on
    coarse faces with narrow corners.
    """
    points, quads = surface_of_size(name, AREA_SIZE, "subdivided", str(folder))
    corners = points[quads]
    area = np.linalg.norm(np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]), axis=1).sum() / 2
    size = first = (area / wanted) ** 0.5
    best, fault = None, None
    for stretch in STRETCHES:
        try:
            found = surface_of_size(name, round(size, 4), method, str(folder))
        except ToolError as error:
            fault, size = error, first * stretch
            continue
        if best is None or _far(found, wanted) < _far(best, wanted):
            best = found
        if _far(best, wanted) < np.log(1.2):
            return best
        size *= (len(found[1]) / wanted) ** 0.5
    if best is None:
        raise fault
    return best


def _far(surface, wanted):
    return abs(np.log(len(surface[1]) / wanted))

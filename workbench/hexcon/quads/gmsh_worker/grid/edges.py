# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAD edges as the grid needs them: where they run, which faces lie left and right, and the angle inside between."""
from dataclasses import dataclass

import gmsh
import numpy as np

from .carriers import surface_normals

_WHERE = np.array([0.1, 0.3, 0.5, 0.7, 0.9])    # of the parameters: where angles are measured


@dataclass
class Edge:
    """One CAD edge in the sense of its parametrisation.

    start, end     vertices: ids of the tessellation's points
    left, right    CAD faces, seen from outside along it; the same for a seam
    parameters (n,), samples (n,3), lengths (n,)   along it; lengths from 0
    angle          mean of the angles inside the solid between its faces, degrees; least, greatest: of them
    """

    tag: int
    start: int
    end: int
    left: int
    right: int
    parameters: np.ndarray
    samples: np.ndarray
    lengths: np.ndarray
    angle: float = 180.0
    least: float = 180.0
    greatest: float = 180.0

    @property
    def length(self):
        return float(self.lengths[-1])


def edges_of(tessellation, solid, step):
    """list of Edge; step: how far apart samples are at most, about."""
    left = tessellation.left_of()
    senses = {f: _sense(tessellation, f) for f in solid.faces}
    return [_edge(tessellation, tag, left, senses, step) for tag in solid.edges]


def _edge(tessellation, tag, left, senses, step):
    ids = tessellation.edge_points[tag]
    a, b = int(ids[0]), int(ids[1])
    low, high = (float(x[0]) for x in gmsh.model.getParametrizationBounds(1, tag))
    rough = np.linalg.norm(np.diff(tessellation.points[ids], axis=0), axis=1).sum()
    t = np.linspace(low, high, int(max(17, min(400, 2 * len(ids), 8 * rough / step))))
    samples = np.array(gmsh.model.getValue(1, tag, t)).reshape(-1, 3)
    samples[0], samples[-1] = tessellation.points[ids[0]], tessellation.points[ids[-1]]
    lengths = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(samples, axis=0), axis=1))])
    sides = left[a, b], left[b, a]
    edge = Edge(tag, a, int(ids[-1]), *(int(tessellation.face[s]) for s in sides), t, samples, lengths)
    angles = _angles(edge, low + _WHERE * (high - low), senses, tessellation.normals_at(list(sides)))
    edge.angle, edge.least, edge.greatest = float(np.mean(angles)), float(np.min(angles)), float(np.max(angles))
    return edge


def _angles(edge, parameters, senses, fallback):
    """Angles inside, in degrees, at some parameters."""
    tangents = np.array(gmsh.model.getDerivative(1, edge.tag, parameters)).reshape(-1, 3)
    tangents /= np.maximum(np.linalg.norm(tangents, axis=1, keepdims=True), 1e-300)
    seam = edge.left == edge.right
    normals = [senses[face] * _normals(edge.tag, parameters, face, side if seam else 0)
               for side, face in enumerate((edge.left, edge.right))]
    for side, n in enumerate(normals):
        n[~np.isfinite(n).all(1) | (np.abs(np.linalg.norm(n, axis=1) - 1.0) > 1e-3)] = fallback[side]
    into_left = np.cross(normals[0], tangents)
    turn = np.degrees(np.arccos(np.clip((normals[0] * normals[1]).sum(1), -1.0, 1.0)))
    return np.where((into_left * normals[1]).sum(1) < 0.0, 180.0 - turn, 180.0 + turn)


def _normals(tag, parameters, face, which):
    try:
        at = gmsh.model.reparametrizeOnSurface(1, tag, parameters, face, which)
        return np.array(gmsh.model.getNormal(face, at)).reshape(-1, 3)
    except Exception:       # gmsh raises Exception itself
        return np.full((len(parameters), 3), np.nan)


def _sense(tessellation, face):
    """1 where gmsh's normals of a face point out of the solid, else -1: by its largest triangles."""
    rows = np.flatnonzero(tessellation.face == face)
    rows = rows[np.argsort(-np.linalg.norm(tessellation.normals()[rows], axis=1), kind="stable")[:8]]
    centres = tessellation.points[tessellation.triangles[rows]].mean(1)
    there = surface_normals(face, centres)
    return 1.0 if np.nansum(there * tessellation.normals_at(rows)) >= 0.0 else -1.0

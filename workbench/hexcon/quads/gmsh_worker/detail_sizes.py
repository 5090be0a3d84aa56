# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a solid wants smaller elements than the user's size: curves, short edges, narrow faces.

A triangle that spans half a hole folds once its edges are halved on the hole; one across a strip much narrower than
itself is a needle. The size is bounded there, and grows with the distance from there.
"""
import gmsh
import numpy as np
from scipy.spatial import cKDTree

from .size_field import SizeField
from .walls import Walls

PER_TURN = 10       # least number of elements round a full circle
WALL = 1.0          # at most so many times what a thin wall behind a curved face allows, whatever the scale
LEAST = 0.04        # of the wanted size: no bound of curves and gaps goes below
LEAST_EDGE = 0.0005  # and none of short edges, which take few elements however short they are
SAMPLES = 4000      # at most so many points on one edge


def detail_sizes(solid, size, scale=1.0, wanted=None):
    """(SizeField of a Solid, the smallest bound of thin walls at scale 1): at most `size`, and what is `wanted`, a
    SizeField.

    Cost: O(S log S) for S sample points on the edges, spaced by a third of the bounds.
    """
    points, bounds, wall = _bounds(solid, size, scale)
    field = SizeField(size, points, np.minimum(bounds, size))     # inf: no bound there
    return (field if wanted is None else field.joined(wanted)), wall


def count_along(field, solid, edge):
    """How many elements an edge of the solid has by a SizeField."""
    middles = (np.arange(64) + 0.5) / 64
    sizes = [field.for_gmsh(1, edge, *point) for point in solid.edge_points(edge, middles)]
    return solid.length(edge) * float(np.mean(1.0 / np.array(sizes)))


def _bounds(solid, size, scale):
    """(points (S,3), bounds (S,), smallest bound of a wall) on all edges and curved faces."""
    samples = {e: _edge_samples(solid, e, size) for e in solid.edges}
    short = np.concatenate([np.full(len(p), solid.length(e)) for e, (p, _) in samples.items()])
    points = [p for p, _ in samples.values()]
    bounds = [b.copy() for _, b in samples.values()]
    row = dict(zip(samples, range(len(points))))
    walls = Walls(solid, size)
    for face in solid.faces:
        edges = sorted({abs(e) for e in solid.boundary[face]})
        for e, gaps in zip(edges, _gaps(solid, edges, [points[row[e]] for e in edges])):
            np.minimum(bounds[row[e]], gaps, out=bounds[row[e]])
        if not solid.is_plane(face):
            where, bound, wall = _face_samples(face, walls)
            points.append(where)
            bounds.append(np.minimum(bound, min(WALL, scale) / scale * wall))
    bounds = np.maximum(scale * np.concatenate(bounds), LEAST * size)
    bounds[:len(short)] = np.minimum(bounds[:len(short)], np.maximum(scale * short, LEAST_EDGE * size))
    return np.concatenate(points), bounds, walls.least


def _edge_samples(solid, edge, size):
    """Points along an edge, a few to each element, and what curvature and its length allow."""
    length = solid.length(edge)
    count = int(np.clip(np.ceil(12 * length / size), 12, SAMPLES))
    points = solid.edge_points(edge, (np.arange(count + 1)) / count)
    bound = np.full(len(points), length if solid.ends[edge][0] != solid.ends[edge][1] else length / 3)
    d = np.diff(points, axis=0)
    steps = np.linalg.norm(d, axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        unit = d / steps[:, None]
        turn = np.arccos(np.clip((unit[1:] * unit[:-1]).sum(axis=1), -1.0, 1.0))
        radius = (steps[1:] + steps[:-1]) / 2 / turn
    radius = np.where(np.isfinite(radius) & (turn > 1e-4), radius, np.inf)
    bound[1:-1] = np.minimum(bound[1:-1], 2 * np.pi / PER_TURN * radius)
    return points, bound


def _gaps(solid, edges, points):
    """For each edge of a face the distances (m,) of its points from those edges of it that it does not touch."""
    found = []
    for e, own in zip(edges, points):
        ends = set(solid.ends[e])
        far = [p for other, p in zip(edges, points) if other != e and not ends & set(solid.ends[other])]
        found.append(cKDTree(np.concatenate(far)).query(own)[0] if far else np.full(len(own), np.inf))
    return found


def _face_samples(face, walls, count=9):
    """Points on a grid of parameters of a curved face, and what its curvature and walls behind it allow."""
    low, high = gmsh.model.getParametrizationBounds(2, face)
    axes = [np.linspace(a, b, count + 2)[1:-1] for a, b in zip(low, high)]
    grid = np.stack(np.meshgrid(*axes), axis=-1).reshape(-1, 2)
    points = np.array(gmsh.model.getValue(2, face, grid.ravel())).reshape(-1, 3)
    curvature = np.abs(np.array(gmsh.model.getCurvature(2, face, grid.ravel())))
    with np.errstate(divide="ignore"):
        bound = np.where(curvature > 1e-12, 2 * np.pi / PER_TURN / curvature, np.inf)
    good = np.isfinite(points).all(axis=1) & ~np.isnan(bound)
    return points[good], bound[good], walls.bounds(face, points[good], curvature[good])

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Unstructured quad meshes of a plane outline with fixed boundary points, through gmsh.

The outline becomes a polygon of its own gmsh model, so that no CAD seam or period can upset gmsh.
"""
import gmsh
import numpy as np

from .cad import other_model
from .outline import rounded, with_total
from .plane.simple import touching

# (road, gmsh's Mesh.Algorithm, density relative to the wanted one)
VARIANTS = (("halved", 6, 1.0), ("direct", 6, 1.0), ("halved", 5, 1.0), ("direct", 5, 1.0),
            ("halved", 6, 1.15), ("direct", 6, 1.1), ("direct", 5, 1.2), ("halved", 5, 1.3), ("halved", 6, 0.85),
            ("direct", 6, 1.3))


def halved_plan(outline, scale):
    """Even counts on every edge: the outline of a mesh of double size, split."""
    return [2 * np.maximum(np.rint(d * scale / 2), np.ceil(m / 2)).astype(int)
            for d, m in zip(outline.desired, outline.least)]


def direct_plan(outline, scale):
    """The nearest counts with an even sum per loop, and at least four intervals per loop."""
    counts = []
    for d, m in zip(outline.desired, outline.least):
        total = int(rounded(d * scale, m).sum())
        total = max(total + total % 2, 4)
        counts.append(with_total(d * scale, m, total))
    return counts


def halved_mesh(loops, size, algorithm):
    """Triangles and quads on every second boundary point, then every element cut about its middle.

    loops: list of (N,2) boundary points, N even, outer loop first. -> points (m,2), quads (n,4), or None.
    """
    coarse = [loop[::2] for loop in loops]
    if min(len(loop) for loop in coarse) < 3:
        return None
    points, tris, quads = _polygon_mesh(coarse, 2.0 * size, algorithm)
    return split_all(points, tris, quads, [len(c) for c in coarse], np.concatenate(loops))


def direct_mesh(loops, size, algorithm):
    """Recombined at full density; None if triangles remain."""
    points, tris, quads = _polygon_mesh(loops, size, algorithm)
    return None if len(tris) or not len(quads) else (points, quads)


def _polygon_mesh(loops, size, algorithm):
    """(points, triangles, quads); the boundary points come first, in order; counter-clockwise.

    Raises ValueError where loops cross or touch: there gmsh ends the process.
    """
    if len(touching(loops)):
        raise ValueError("its chords cross")
    with other_model("outline"):
        for name, value in (("Algorithm", algorithm), ("RecombinationAlgorithm", 1), ("SubdivisionAlgorithm", 0),
                            ("MeshSizeMin", 0.0), ("MeshSizeMax", 1.5 * size), ("MeshSizeExtendFromBoundary", 1),
                            ("MeshSizeFromPoints", 1), ("Smoothing", 5)):
            gmsh.option.setNumber("Mesh." + name, value)
        curves, count = [], 0
        for loop in loops:
            after = np.linalg.norm(np.roll(loop, -1, axis=0) - loop, axis=1)
            spacing = (after + np.roll(after, 1)) / 2
            tags = [gmsh.model.geo.addPoint(x, y, 0.0, h) for (x, y), h in zip(loop, spacing)]
            lines = [gmsh.model.geo.addLine(a, b) for a, b in zip(tags, tags[1:] + tags[:1])]
            for line in lines:
                gmsh.model.geo.mesh.setTransfiniteCurve(line, 2)
            curves.append(gmsh.model.geo.addCurveLoop(lines))
            count += len(loop)
        face = gmsh.model.geo.addPlaneSurface(curves)
        gmsh.model.geo.mesh.setRecombine(2, face)
        gmsh.model.geo.synchronize()
        gmsh.model.mesh.generate(2)
        return _collect(face, count)


def _collect(face, boundary):
    """Mesh of the current model's face; points 0..boundary-1 are its geometry points in order of tag."""
    tags, xyz, _ = gmsh.model.mesh.getNodes()
    points = np.array(xyz).reshape(-1, 3)[:, :2]
    row = np.full(int(tags.max()) + 1, -1)
    row[np.asarray(tags, int)] = np.arange(len(tags))
    first = []
    for k in range(1, boundary + 1):
        first.append(int(gmsh.model.mesh.getNodes(0, k)[0][0]))
    order = np.concatenate([row[first], np.setdiff1d(np.arange(len(tags)), row[first])])
    new = np.empty(len(order), int)
    new[order] = np.arange(len(order))
    found = {2: np.empty((0, 3), int), 3: np.empty((0, 4), int)}
    for kind, _, nodes in zip(*gmsh.model.mesh.getElements(2, face)):
        if kind in found:
            found[kind] = new[row[np.asarray(nodes, int)]].reshape(-1, 3 if kind == 2 else 4)
    points = points[order]
    areas = [_areas(points, found[kind]) for kind in (2, 3)]
    # all or none: gmsh leaves cells inverted now and then, and these are for the smoother to untangle;
    # turned one by one they would be folded over for good
    if np.concatenate(areas).sum() < 0:
        found = {kind: cells[:, ::-1] for kind, cells in found.items()}
    return points, found[2], found[3]


def _areas(points, cells):
    """(n,) twice the signed area of each cell."""
    p = points[cells]
    q = np.roll(p, -1, axis=1)
    return (p[..., 0] * q[..., 1] - p[..., 1] * q[..., 0]).sum(1)


def split_all(points, tris, quads, coarse, boundary):
    """Cut every element about its middle; boundary edge midpoints become the given points in between.

    coarse: number of boundary points per loop of the coarse mesh; boundary (2 * sum,2) the fine boundary.
    """
    count = len(points)
    edges = np.concatenate([np.stack([c, np.roll(c, -1, axis=1)], -1).reshape(-1, 2) for c in (tris, quads)])
    keys = np.sort(edges, axis=1) @ np.array([count, 1])
    unique, inverse = np.unique(keys, return_inverse=True)
    mids = (points[unique // count] + points[unique % count]) / 2
    mid_of = count + inverse
    centres = np.concatenate([points[c].mean(axis=1) for c in (tris, quads) if len(c)])
    all_points = np.concatenate([points, mids, centres])
    result, at, centre = [], 0, count + len(mids)
    for cells in (tris, quads):
        n, k = cells.shape
        m = mid_of[at:at + n * k].reshape(n, k)
        middle = np.repeat(centre + np.arange(n)[:, None], k, axis=1)
        result.append(np.stack([cells, m, middle, np.roll(m, 1, axis=1)], -1).reshape(-1, 4))
        at, centre = at + n * k, centre + n
    cells = np.concatenate(result)
    return _boundary_first(all_points, cells, unique, count, coarse, boundary)


def _boundary_first(points, quads, keys, count, coarse, boundary):
    """Renumber so that the fine boundary comes first, in order, at its given places."""
    order, at = [], 0
    for n in coarse:
        ids = at + np.arange(n)
        pair = np.sort(np.stack([ids, np.roll(ids, -1)], 1), axis=1) @ np.array([count, 1])
        where = np.searchsorted(keys, pair)
        if (where >= len(keys)).any() or (keys[np.minimum(where, len(keys) - 1)] != pair).any():
            return None
        order.append(np.stack([ids, count + where], 1).ravel())
        at += n
    order = np.concatenate(order)
    rest = np.setdiff1d(np.arange(len(points)), order)
    order = np.concatenate([order, rest])
    new = np.empty(len(points), int)
    new[order] = np.arange(len(points))
    points = points[order]
    points[:len(boundary)] = boundary
    return points, new[quads]

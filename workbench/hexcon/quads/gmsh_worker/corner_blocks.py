# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quads of a solid with corners of three edges: every face cut about its centre, one structured block per corner.

They are the surface of the midpoint subdivision: one block of hexes per corner of the solid.
"""
import numpy as np

from .boundary import CapPlane
from .corners import corner_sides
from .layers import layer_counts, thirds
from .plane_mesh import coons, harmonic
from .smooth import optimise, scaled_jacobian, space_quality
from .templates import midpoint_blocks

GOOD = 0.9              # of the sine of the worst corner: a plane face better than this is left alone
BUDGET = 400_000        # corner evaluations of smoothing per plane face
ROUNDS = 20             # of smoothing on a curved face


def corner_surface(solid, size, link):
    """dict with points, quads, faces, notes. Raises WorkerFault NOT_BLOCKS, with the reason."""
    sides = corner_sides(solid)
    layers = layer_counts(solid, sides, size)
    numbers = _Numbers(solid)
    points, quads, faces = numbers.points, [], []
    for done, (face, around) in enumerate(sides.items()):
        link.progress("faces", done / len(sides))
        outline, first = _outline(numbers, around, layers)
        made, face_quads = _face_mesh(solid, face, numbers.at(outline), first, [layers[g] for _, g in around])
        ids = np.concatenate([outline, numbers.add(made[len(outline):])])
        quads.append(ids[face_quads])
        faces.append(np.full(len(face_quads), face))
    corners = len(solid.vertex)
    return {"points": np.concatenate(points), "quads": np.concatenate(quads), "faces": np.concatenate(faces),
            "notes": [f"blocks: one at each of {corners} corners, {min(layers.values())} to {max(layers.values())} "
                      f"hexes across"]}


class _Numbers:
    """Points of the surface in the order they are numbered; those of vertices and edges are made once."""

    def __init__(self, solid):
        self.solid, self.points, self.count = solid, [], 0
        self.vertex = {v: int(self.add(p[None])[0]) for v, p in sorted(solid.vertex.items())}
        self.inner = {}

    def add(self, points):
        self.points.append(np.asarray(points, float).reshape(-1, 3))
        self.count += len(self.points[-1])
        return np.arange(self.count - len(self.points[-1]), self.count)

    def at(self, ids):
        return np.concatenate(self.points)[ids]

    def edge(self, signed, intervals):
        """Numbers along a signed edge, without its last."""
        if abs(signed) not in self.inner:
            fractions = np.arange(1, intervals) / intervals
            self.inner[abs(signed)] = self.add(self.solid.edge_points(abs(signed), fractions))
        inner = self.inner[abs(signed)]
        return np.concatenate([[self.vertex[self.solid.start(signed)]], inner if signed > 0 else inner[::-1]])


def _outline(numbers, around, layers):
    """(point numbers round a face, position of each side's start among them)."""
    parts = [numbers.edge(edge, sum(layers[f] for f in thirds(around, k))) for k, (edge, _) in enumerate(around)]
    return np.concatenate(parts), np.cumsum([0] + [len(p) for p in parts[:-1]])


def _face_mesh(solid, face, boundary, first, spokes):
    """(points (m,3), the boundary first; quads) of one face.

    boundary (Nb,3) round the face; first (n,) where its sides start; spokes (n,) intervals from the sides' middles
    to the centre.
    """
    reference, quads = midpoint_blocks(_regular_outline(first, len(boundary)), first, spokes)
    fixed = np.arange(len(reference)) < len(boundary)
    points = np.zeros((len(reference), 3))
    points[fixed] = boundary
    candidates = [harmonic(points, quads, fixed)]
    if len(first) == 4:
        candidates.append(_mapped(boundary, first, harmonic(_on_square(points, first, len(boundary)), quads, fixed)))
    for points in candidates:
        points[~fixed] = solid.project(2, face, points[~fixed])
    points = max(candidates, key=lambda p: space_quality(p, quads).min())
    improve = _improved_plane if solid.is_plane(face) else _improved_curved
    return improve(solid, face, points, quads, fixed), quads


def _regular_outline(first, total):
    """(total,2) points round a regular polygon with evenly divided sides."""
    n = len(first)
    angle = 2 * np.pi * np.arange(n + 1) / n
    corners = np.stack([np.cos(angle), np.sin(angle)], -1)
    counts = np.diff(np.append(first, total))
    return np.concatenate([corners[k] + (corners[k + 1] - corners[k]) * (np.arange(c) / c)[:, None]
                           for k, c in enumerate(counts)])


def _on_square(points, first, total):
    """(m,2) with the boundary on the square of (counts of the first, of the second side) intervals."""
    made = np.zeros((len(points), 2))
    wide, high = first[1], first[2] - first[1]
    corners = np.array([[0, 0], [wide, 0], [wide, high], [0, high], [0, 0]], float)
    counts = np.diff(np.append(first, total))
    made[:total] = np.concatenate([corners[k] + (corners[k + 1] - corners[k]) * (np.arange(c) / c)[:, None]
                                   for k, c in enumerate(counts)])
    return made


def _mapped(boundary, first, square):
    """(m,3) transfinite interpolation of four sides at the grid places `square` (m,2)."""
    ring = np.concatenate([boundary, boundary[:1]])
    bottom, right, top, left = (ring[a:b + 1] for a, b in zip(first, [*first[1:], len(boundary)]))
    grid = coons(bottom, right, top[::-1], left[::-1])
    column, row = np.rint(square).astype(int).T
    return grid[row, column]


def _improved_plane(solid, face, points, quads, fixed):
    """Smoothed in the plane where a corner of a quad is worse than the outline's own corners."""
    plane = CapPlane.of_quads(points, quads)
    flat = plane.flat(points)
    boundary_worst = _sine_limit(flat, quads, fixed)
    if scaled_jacobian(flat, quads).min() >= GOOD * boundary_worst:
        return points
    result = points.copy()
    result[~fixed] = solid.project(2, face, plane.lift(optimise(flat, quads, fixed, BUDGET))[~fixed])
    return result


def _sine_limit(flat, quads, fixed):
    """The smallest sine of a corner at which all three points are fixed: no smoothing can better it."""
    corner = flat[quads]
    ahead, back = np.roll(corner, -1, axis=1) - corner, np.roll(corner, 1, axis=1) - corner
    sine = ahead[..., 0] * back[..., 1] - ahead[..., 1] * back[..., 0]
    sine /= np.linalg.norm(ahead, axis=2) * np.linalg.norm(back, axis=2)
    held = fixed[quads]
    whole = held & np.roll(held, 1, axis=1) & np.roll(held, -1, axis=1)
    return float(sine[whole].min()) if whole.any() else 1.0


def _improved_curved(solid, face, points, quads, fixed):
    """Rounds of the mean of the neighbours, put back on the face, while they raise the worst corner."""
    a, b = quads.ravel(), np.roll(quads, -1, axis=1).ravel()
    degree = np.bincount(np.r_[a, b], minlength=len(points))[:, None]
    best, current = points, points
    for _ in range(ROUNDS):
        total = np.zeros_like(points)
        np.add.at(total, a, current[b])
        np.add.at(total, b, current[a])
        current = current.copy()
        current[~fixed] = solid.project(2, face, (total / degree)[~fixed])
        if space_quality(current, quads).min() <= space_quality(best, quads).min() + 1e-6:
            break
        best = current
    return best

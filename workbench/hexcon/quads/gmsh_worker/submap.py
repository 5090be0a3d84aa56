# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mapped meshes: an outline whose corners are multiples of a right angle becomes a polygon of lattice lines.

Rectangles of any shape (four convex corners, any angles), L, T, I and U profiles, and such profiles with
rectangular holes.
"""
import numpy as np

from .outline import balanced, rounded
from .plane_mesh import coons, harmonic

# Densities tried in turn until the lattice polygon does not touch itself, and interval counts of the longest edge
# tried after them where the wanted size is coarser than the outline's details.
SCALES = (1.0, 0.9, 1.15, 1.3, 1.6, 2.0)
COARSE = (3, 4, 5, 6, 8, 11)
STEPS = np.array([[1, 0], [0, 1], [-1, 0], [0, -1]])       # of the lattice, per direction


def submap_plan(outline):
    """Interval counts per loop for which the outline is a simple lattice polygon, or None."""
    headings = _headings(outline)
    if headings is None:
        return None
    longest = max(float(d.max()) for d in outline.desired)
    for scale in SCALES + tuple(n / longest for n in COARSE if n > 2.0 * longest):
        counts = [_closing(d * scale, m, h) for d, m, h in zip(outline.desired, outline.least, headings)]
        if any(c is None for c in counts):
            return None
        if _lattice(outline, headings, counts) is not None:
            return counts
    return None


def submap_mesh(outline, counts, boundary):
    """(points, quads) from counts of submap_plan and boundary points (Nb,2); None from others."""
    headings = _headings(outline)
    lattice = None if headings is None else _lattice(outline, headings, counts)
    if lattice is None:
        return None
    ids, inside = lattice
    if inside.all():
        w, h = inside.shape
        points = np.zeros((ids.max() + 1, 2))
        points[ids.T] = coons(boundary[ids[:, 0]], boundary[ids[w, :]], boundary[ids[:, h]], boundary[ids[0, :]])
        return points, _cells(ids, inside)
    return harmonic_mesh(ids, inside, boundary)


def _headings(outline):
    """Per loop the lattice direction 0..3 of every edge, or None where the outline is no lattice polygon."""
    turns = outline.turn
    corners = outline.corners()
    if len(turns) == 1 and len(corners) == 4 and (turns[0][corners] > 0).all():
        kinds = np.zeros(len(turns[0]), int)
        kinds[corners] = 1
        return [np.cumsum(kinds) % 4]
    headings = []
    for loop, turn in enumerate(turns):
        kinds = np.rint(turn / (np.pi / 2)).astype(int)
        if kinds.sum() != (4 if loop == 0 else -4) or np.abs(kinds).max() > 1:
            return None
        headings.append(np.cumsum(kinds) % 4)
    if len(headings) == 1:
        return headings
    frame = outline.direction[0][0] - headings[0][0] * np.pi / 2
    for loop in range(1, len(headings)):
        start = (outline.direction[loop][0] - frame) / (np.pi / 2)
        headings[loop] = (headings[loop] - headings[loop][0] + int(np.rint(start))) % 4
    return headings


def _closing(desired, least, heading):
    """Counts for which opposite directions have equal sums; None if a direction is missing."""
    counts = rounded(desired, least)
    for d in (0, 1):
        first, second = heading == d, heading == d + 2
        if not first.any() or not second.any():
            return None
        mask = first | second
        counts[mask] = balanced(desired[mask], least[mask], first[mask], second[mask])
    return counts


def _lattice(outline, headings, counts):
    """(point numbers on the lattice, (w,h) cells inside); None if the polygon is open, touches or overlaps itself."""
    paths, steps = [], []
    for heading, c in zip(headings, counts):
        step = STEPS[np.repeat(heading, c)]
        path = np.concatenate([[[0, 0]], np.cumsum(step, axis=0)])
        if path[-1].any():
            return None
        paths.append(path[:-1])
        steps.append(step)
    if len(paths) > 1:
        _place_holes(paths, outline.place(outline.divided(counts)))
    low = paths[0].min(axis=0)
    nodes = np.concatenate(paths) - low
    if nodes.min() < 0 or (nodes.max(axis=0) > (paths[0] - low).max(axis=0)).any():
        return None
    inside = inside_of(nodes, np.concatenate(steps))
    ids = numbered(nodes, np.arange(len(nodes)), inside)
    return None if ids is None else (ids, inside)


def _place_holes(paths, places):
    """Shift every hole's lattice path to where the affine image of the outline puts it."""
    matrix = np.linalg.lstsq(np.c_[places[0], np.ones(len(places[0]))], paths[0].astype(float), rcond=None)[0]
    for k in range(1, len(paths)):
        where = np.c_[places[k], np.ones(len(places[k]))] @ matrix
        middle = (where.max(axis=0) + where.min(axis=0) - paths[k].max(axis=0) - paths[k].min(axis=0)) / 2
        paths[k] = paths[k] + np.rint(middle + 1e-6).astype(int)


def inside_of(nodes, steps):
    """(w,h) bool: lattice cells inside the polygon, by parity of the vertical edges to their left."""
    size = nodes.max(axis=0)
    toggles = np.zeros((size[0] + 1, size[1]), int)
    up = steps[:, 1] != 0
    row = np.where(steps[up, 1] > 0, nodes[up, 1], nodes[up, 1] - 1)
    np.add.at(toggles, (nodes[up, 0], row), 1)
    return (np.cumsum(toggles, axis=0)[:-1] % 2).astype(bool)


def numbered(nodes, rows, inside):
    """Point numbers on the lattice: rows (n,) at nodes (n,2) of its polygon, then those inside; None if the polygon
    touches itself or has nodes inside."""
    w, h = inside.shape
    neighbours = np.zeros((w + 1, h + 1), int)
    for dx in (0, 1):
        for dy in (0, 1):
            neighbours[dx:w + dx, dy:h + dy] += inside
    ids = np.full((w + 1, h + 1), -1)
    ids[nodes[:, 0], nodes[:, 1]] = rows
    on = ids >= 0
    if on.sum() != len(nodes) or (on & ((neighbours == 4) | (neighbours == 0))).any():
        return None
    free = (neighbours > 0) & ~on
    if (neighbours[free] != 4).any():
        return None
    ids[free] = rows.max() + 1 + np.arange(free.sum())
    return ids


def harmonic_mesh(ids, inside, boundary):
    """(points, quads) of the cells inside a lattice with its points numbered, boundary (Nb,2) the first of them."""
    quads = _cells(ids, inside)
    points = np.zeros((ids.max() + 1, 2))
    points[:len(boundary)] = boundary
    return harmonic(points, quads, np.arange(len(points)) < len(boundary)), quads


def _cells(ids, inside):
    """(n,4) quads."""
    i, j = np.nonzero(inside)
    return np.stack([ids[i, j], ids[i + 1, j], ids[i + 1, j + 1], ids[i, j + 1]], -1)

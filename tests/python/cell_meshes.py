# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cells on closed even quad surfaces, placed without any care for their shape.

One domino per pair of quads or one half-cell per quad between the surface and a smaller copy of
it, and diced tetrahedra from the copy to the centre: 39 or 49 hexes a quad. Every point inside a
cell is where the trilinear map puts it, so the topology is right and some hexes are not positive.
"""
import numpy as np
from deformed_boxes import corner_rows, image
from scipy.optimize import Bounds, LinearConstraint, milp
from scipy.sparse import coo_matrix
from template_files import load_template

import hexcon_native as hn

TEMPLATES = {"domino": "domino_62", "halfcell": "halfcell_diced_41"}
MIRRORED = [0, 3, 2, 1, 4, 7, 6, 5]
# The four corners of a tetrahedron, each followed by the others so that orientation is kept.
_TURNS = ((0, 1, 2, 3), (1, 0, 3, 2), (2, 3, 0, 1), (3, 2, 1, 0))


def flat_pairing(points, quads):
    """A perfect matching of neighbouring quads that prefers flat pairs: (n/2, 4) int rows
    (quad, quad, ends of their common edge)."""
    starts = np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2)
    _, number = np.unique(np.sort(starts, axis=1), axis=0, return_inverse=True)
    sides = np.argsort(number, kind="stable").reshape(-1, 2)    # the two sides of every edge
    normal = np.cross(points[quads[:, 2]] - points[quads[:, 0]],
                      points[quads[:, 3]] - points[quads[:, 1]])
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    pairs = sides // 4
    weight = 1 + (normal[pairs[:, 0]] * normal[pairs[:, 1]]).sum(axis=1)
    once = coo_matrix((np.ones(pairs.size), (pairs.ravel(), np.repeat(np.arange(len(pairs)), 2))))
    found = milp(-weight, constraints=LinearConstraint(once, 1, 1), integrality=1,
                 bounds=Bounds(0, 1), options={"mip_rel_gap": 1e-3})
    if not found.success:
        raise ValueError(f"no pairing: {found.message}")
    chosen = found.x > 0.5
    return np.column_stack([pairs[chosen], starts[sides[chosen, 0]]])


class _Points:
    """Points numbered by what they are: an equal key is the same point."""

    def __init__(self, points):
        self.numbers = {("O", v): v for v in range(len(points))}
        self.places = list(points)

    def number(self, key, place):
        if key not in self.numbers:
            self.numbers[key] = len(self.places)
            self.places.append(place)
        return self.numbers[key]


def _seen_from(quad, black, white):
    """Corners of a quad from its black one to its white one and on; and whether they then run
    counter-clockwise seen from inside, as in the template."""
    k = list(quad).index(black)
    corners = list(np.roll(quad, -k))
    if corners[1] == white:
        return corners, False
    return [corners[0], *corners[:0:-1]], True


def _key(label, cell, quad, corners, row):
    """What a template's point is on the surface."""
    if label == "int":
        return "inside", cell, row
    kind, digits = label.rstrip("0123456789"), [int(d) for d in label if d.isdigit()]
    if kind in ("O", "I", "M"):
        return kind, corners[digits[0]]
    if kind in ("C", "E"):
        return kind, *sorted(corners[d] for d in digits)
    if kind in ("Sx", "Sy"):
        return kind, *sorted(corners[:2])
    return kind, quad    # N, Ga, Gb


def _diced_tetrahedron(vertex, middle, face, center):
    """Four hexes (4, 8): vertex[i], middle[{i, j}], face[{i, j, k}] and the centre are ids."""
    def pair(*ends):
        return middle[frozenset(ends)]

    def triple(*ends):
        return face[frozenset(ends)]
    return np.array([[vertex[i], pair(i, j), triple(i, j, k), pair(i, k),
                      pair(i, m), triple(i, j, m), center, triple(i, k, m)]
                     for i, j, k, m in _TURNS])


def _star(numbers, corners, quad, flipped, inner, center):
    """Diced tetrahedra from the two triangles over a quad's inner face to the centre."""
    hexes = []
    for triangle, centroid in (((0, 1, 3), "Gb"), ((1, 2, 3), "Ga")):
        if not flipped:    # the centre then is on the side where the triangle runs clockwise
            triangle = triangle[::-1]
        ends = [corners[t] for t in triangle]
        places = np.vstack([inner[ends], center])
        vertex = [numbers.number(("I", v), None) for v in ends] + [numbers.number("apex", center)]
        middle = {frozenset((k, 3)): numbers.number(("spoke", ends[k]), places[[k, 3]].mean(axis=0))
                  for k in range(3)}
        face = {frozenset((0, 1, 2)): numbers.number((centroid, quad), None)}
        for k in range(3):
            i, j = triangle[k], triangle[(k + 1) % 3]
            rim = tuple(sorted((corners[i], corners[j])))
            on_diagonal = {i, j} == {1, 3}
            middle[frozenset((k, (k + 1) % 3))] = numbers.number(
                ("N", quad) if on_diagonal else ("E", *rim), None)
            face[frozenset((k, (k + 1) % 3, 3))] = numbers.number(
                ("wall", quad) if on_diagonal else ("wall", *rim),
                places[[k, (k + 1) % 3, 3]].mean(axis=0))
        body = numbers.number(("body", quad, centroid), places.mean(axis=0))
        hexes.append(_diced_tetrahedron(vertex, middle, face, body))
    return np.vstack(hexes)


def star_center(points, quads):
    """A point that sees the whole surface; the mean of its points where none does."""
    found = hn.check_surface(points, quads).star_center
    return points.mean(axis=0) if found is None else found


def build_cells(points, quads, kind="domino", scale=0.6):
    """A hex mesh of cells: points (P, 3), hexes (H, 8) int64, fixed (P,) bool.

    kind   "domino" (39 hexes a quad) or "halfcell" (49)
    scale  of the copy of the surface on which the cells end
    Rows 0 .. V-1 are the surface's points, and they alone are fixed.
    """
    points, quads = np.asarray(points, float), np.asarray(quads)
    template, center = load_template(TEMPLATES[kind]), star_center(points, quads)
    inner, colour = center + scale * (points - center), hn.colouring(quads)
    numbers, hexes = _Points(points), []
    places = np.vstack([points, inner])
    for p, q, *edge in flat_pairing(points, quads).tolist():
        black, white = edge if colour[edge[0]] == 0 else edge[::-1]
        seen = {quad: _seen_from(quads[quad].tolist(), black, white) for quad in (p, q)}
        for cell in ((p, q),) if kind == "domino" else ((p,), (q,)):
            hexes.append(_cell(template, numbers, cell, seen, places))
        for quad in (p, q):
            hexes.append(_star(numbers, seen[quad][0], quad, seen[quad][1], inner, center))
    placed = np.array(numbers.places)
    return placed, np.vstack(hexes), np.arange(len(placed)) < len(points)


def _cell(template, numbers, cell, seen, places):
    """Hexes of one cell over one quad or two; places: the surface's points, then their copies."""
    owner = [cell[-1] if label[0] == "b" else cell[0] for label in template.labels]
    at = {row: template.labels[row].lstrip("b") for row in corner_rows(template)}
    rows = [seen[owner[row]][0][int(label[1])] + (label[0] == "I") * (len(places) // 2)
            for row, label in at.items()]
    image_points = image(template, places[rows])
    ids = [numbers.number(_key(label.lstrip("b"), cell, quad, seen[quad][0], row), place)
           for row, (label, quad, place) in enumerate(zip(template.labels, owner, image_points))]
    hexes = np.array(ids)[template.hexes]
    return hexes if seen[cell[0]][1] else hexes[:, MIRRORED]

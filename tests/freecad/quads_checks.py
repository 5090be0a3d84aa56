# SPDX-License-Identifier: LGPL-2.1-or-later
"""Independent checks of a quad surface against the FreeCAD shape it is to lie on."""
import re

import numpy as np
import Part
from FreeCAD import Vector

CAP_NOTE = re.compile(r"sweep: cap Face(\d+) -> Face(\d+), (\d+) cap quads x (\d+) rings")


def assert_closed_even_outward(surface, shape=None):
    quads, points = surface.quads, surface.points
    assert quads.dtype == np.int64 and points.dtype == np.float64
    assert len(quads) % 2 == 0
    assert np.array_equal(np.unique(quads), np.arange(len(points)))
    edges = np.stack([quads, np.roll(quads, -1, axis=1)], -1).reshape(-1, 2)
    assert len({tuple(e) for e in edges}) == len(edges)
    assert {tuple(e) for e in edges} == {tuple(e[::-1]) for e in edges}
    p = points[quads]
    volume = (np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1]) / 2 * p.mean(axis=1)).sum() / 3
    assert volume > 0
    if shape is not None:
        assert 0.6 * shape.Volume < volume < 1.2 * shape.Volume


def assert_on_faces(surface, shape, most=400, tolerance=1e-7):
    """FreeCAD's own distance from points of every face's quads to that face; at most `most` points in all."""
    assert set(surface.face_of_quad) == set(range(1, len(shape.Faces) + 1))
    per_face = max(6, most // len(shape.Faces))
    for number, face in enumerate(shape.Faces, 1):
        ids = np.unique(surface.quads[surface.face_of_quad == number])
        step = max(1, len(ids) // per_face)
        for point in surface.points[ids[::step]]:
            distance = Part.Vertex(Vector(*point)).distToShape(face)[0]
            assert distance < tolerance, (number, point, distance)


def vertices_kept(surface, shape):
    """Every CAD vertex is a point of the surface, to 1e-9."""
    return all(np.abs(surface.points - np.array(tuple(v.Point))).max(axis=1).min() < 1e-9 for v in shape.Vertexes)


def scaled_jacobian(points, quads):
    """(n,) of quads in space: minimum sine of the corner angles about the quad's own normal."""
    p = points[quads]
    normal = np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1])
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    a, b = np.roll(p, -1, axis=1) - p, np.roll(p, 1, axis=1) - p
    sine = np.einsum("nkd,nd->nk", np.cross(a, b), normal)
    return (sine / np.linalg.norm(a, axis=2) / np.linalg.norm(b, axis=2)).min(axis=1)


def swept(surface):
    """(cap A, cap B, cap quads, rings) as the note tells."""
    match = next(filter(None, map(CAP_NOTE.match, surface.notes)))
    return tuple(int(x) for x in match.groups())

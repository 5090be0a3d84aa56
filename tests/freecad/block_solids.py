# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids for the method `blocks`: corners of three edges, or round. Needs FreeCAD."""
import numpy as np
from quads_solids import FreeCAD, Part, Vector, filleted_box, ngon, prism, two_way_bracket

GOLDEN = (1 + 5 ** 0.5) / 2
SIGNS = [(s, t) for s in (1, -1) for t in (1, -1)]


def cut_by_planes(normals, distances, half=10.0):
    """What planes (normals (k,3) outward, distances from the origin) leave of a cube."""
    solid = Part.makeBox(2 * half, 2 * half, 2 * half, Vector(-half, -half, -half))
    for normal, distance in zip(normals, distances):
        normal = Vector(*map(float, normal))
        normal.normalize()
        far = Part.makeBox(10 * half, 10 * half, 10 * half, Vector(-5 * half, -5 * half, 0))
        far.Placement = FreeCAD.Placement(normal * float(distance), FreeCAD.Rotation(Vector(0, 0, 1), normal))
        solid = solid.cut(far)
    return solid


def dodecahedron():
    ways = [(s, t * GOLDEN, 0) for s, t in SIGNS]
    return cut_by_planes([np.roll(way, shift) for way in ways for shift in range(3)], [4] * 12)


def tetrahedron():
    return cut_by_planes([(1, 1, 1), (-1, -1, 1), (-1, 1, -1), (1, -1, -1)], [3] * 4, 12.0)


def chamfered_box():
    box = Part.makeBox(10, 8, 6)
    return box.makeChamfer(1.5, [e for e in box.Edges if abs(e.tangentAt(0).z) > 0.9])


def cut_prism():
    """A pentagonal prism with a slanted top."""
    return ngon(5, 5, 12).cut(Part.makeBox(40, 40, 40, Vector(-20, -20, 8)))


def capsule():
    ends = [Part.makeSphere(3), Part.makeSphere(3, Vector(0, 0, 8))]
    return Part.makeCylinder(3, 8).fuse(ends).removeSplitter()


def lens():
    return Part.makeSphere(5, Vector(0, 0, -2.5)).common(Part.makeSphere(5, Vector(0, 0, 2.5)))


def octant():
    return Part.makeSphere(5, Vector(0, 0, 0), Vector(0, 0, 1), 0, 90, 90)


def moved(shape):
    shape.Placement = FreeCAD.Placement(Vector(100, -50, 20), FreeCAD.Rotation(Vector(1, 2, 3), 77))
    return shape


def random_polytope(seed):
    """A cube that 3 to 7 random planes have cut."""
    rng = np.random.default_rng([7, seed])
    normals = rng.normal(size=(int(rng.integers(3, 8)), 3))
    return cut_by_planes(normals, rng.uniform(6, 11, len(normals))), float(rng.uniform(1.2, 4))


def corner_angles(shape):
    """All angles of plane faces with straight edges, in degrees."""
    found = []
    for face in shape.Faces:
        p = np.array([tuple(v.Point) for v in face.OuterWire.OrderedVertexes])
        ahead, back = np.roll(p, -1, axis=0) - p, np.roll(p, 1, axis=0) - p
        cosine = (ahead * back).sum(axis=1) / np.linalg.norm(ahead, axis=1) / np.linalg.norm(back, axis=1)
        found += list(np.degrees(np.arccos(cosine)))
    return np.array(found)


# name -> (maker, sizes, least scaled Jacobian of the quads)
CORNERED = {
    "box": (lambda: Part.makeBox(10, 7, 5), (2, 1.1), 0.999),
    "wedge": (lambda: prism([(0, 0, 0), (8, 0, 0), (0, 6, 0)], (0, 0, 10)), (2, 1), 0.5),
    "chamfered box": (chamfered_box, (2, 0.8), 0.65),
    "dodecahedron": (dodecahedron, (2, 1, 0.5), 0.9),
    "cut prism": (cut_prism, (2, 1), 0.7),
    "tetrahedron": (tetrahedron, (3, 1.5), 0.8),
    "hexagonal prism": (lambda: ngon(6, 5, 10), (2, 1), 0.8),
    "octant": (octant, (2, 1), 0.8),
    "quarter cylinder": (lambda: Part.makeCylinder(5, 12, Vector(0, 0, 0), Vector(0, 0, 1), 90), (2, 1), 0.7),
    "moved dodecahedron": (lambda: moved(dodecahedron()), (1.5,), 0.85),
}
ROUND = {
    "ball": (lambda: Part.makeSphere(5), (4, 2, 1), 0.8),
    "moved ball": (lambda: moved(Part.makeSphere(5)), (2,), 0.8),
    "cylinder": (lambda: Part.makeCylinder(5, 12), (4, 2, 1), 0.8),
    "cone frustum": (lambda: Part.makeCone(6, 3, 10), (4, 2, 1), 0.8),
    "cone": (lambda: Part.makeCone(6, 0, 10), (2, 1), 0.6),
    "capsule": (capsule, (2, 1), 0.8),
    "moved capsule": (lambda: moved(capsule()), (1,), 0.8),
    "lens": (lens, (2, 1), 0.8),
    "half ball": (lambda: Part.makeSphere(5, Vector(0, 0, 0), Vector(0, 0, 1), 0, 90, 360), (2, 1), 0.8),
    "ball cut at its side": (lambda: Part.makeSphere(5).cut(Part.makeBox(20, 20, 20, Vector(3, -10, -10))), (1,), 0.8),
    "domed cylinder": (lambda: Part.makeCylinder(5, 12).common(Part.makeSphere(13)), (1.5,), 0.8),
}


def _pyramid():
    return cut_by_planes([(1, 0, 1), (-1, 0, 1), (0, 1, 1), (0, -1, 1), (0, 0, -1)], [4] * 4 + [0])


# name -> (maker, what the fault says)
REFUSED = {
    "pyramid": (_pyramid, r"Vertex\d+ has 4 edges"),
    "filleted box": (filleted_box, r"Vertex\d+ has 4 edges"),
    "bracket": (two_way_bracket, r"Face\d+ has a hole"),
    "L": (lambda: prism([(0, 0, 0), (8, 0, 0), (8, 3, 0), (3, 3, 0), (3, 8, 0), (0, 8, 0)], (0, 0, 5)), "reentrant"),
    "thin wedge": (lambda: prism([(0, 0, 0), (20, 0, 0), (20, 2, 0)], (0, 0, 5)), "a corner of 6 degrees"),
    "torus": (lambda: Part.makeTorus(8, 3), "a seam"),
    "stepped shaft": (lambda: Part.makeCylinder(5, 6).fuse(Part.makeCylinder(3, 6, Vector(0, 0, 6))).removeSplitter(),
                      r"reentrant between Face\d and Face\d"),
    "blind hole": (lambda: Part.makeCylinder(5, 6).cut(Part.makeCylinder(3, 3, Vector(0, 0, 3))), "reentrant"),
    "thin lens": (lambda: Part.makeSphere(5, Vector(0, 0, -4.9)).common(Part.makeSphere(5, Vector(0, 0, 4.9))),
                  "too sharp"),
}

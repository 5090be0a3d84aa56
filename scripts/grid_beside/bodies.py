# SPDX-License-Identifier: LGPL-2.1-or-later
"""The solids on which the grid is set beside other meshers and elements. FreeCAD makes them."""
import math
import os
import sys
from dataclasses import dataclass

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path[:0] = [os.path.join(ROOT, "tests", "freecad")]

from any_solids import bracket, crank, elbow  # noqa: E402
from quads_solids import Part, Vector, ngon  # noqa: E402

X = Vector(1, 0, 0)


@dataclass
class Body:
    """make() -> shape; size: element size in mm; held, loaded: points on the faces that are held, and pulled by `force`
    (N); bending: whether the load bends the part, or presses and shears something stocky."""
    make: object
    size: float
    held: tuple
    loaded: tuple
    force: tuple
    bending: bool


def t_pipe():
    """A pipe with a smaller one out of its side."""
    outer = Part.makeCylinder(10, 60, Vector(0, 0, -30)).fuse(Part.makeCylinder(8, 30, Vector(0, 0, 0), X))
    inner = Part.makeCylinder(6, 60, Vector(0, 0, -30)).fuse(Part.makeCylinder(4.5, 30, Vector(0, 0, 0), X))
    return outer.removeSplitter().cut(inner.removeSplitter())


def hex_nut(radius=13.0, height=10.0, bore=6.0):
    """Chamfered at one end by a cone."""
    cone = Part.makeCone(radius + 3, radius - 1.7, height)
    nut = ngon(6, radius, height).common(cone.fuse(Part.makeCylinder(1.5 * radius, 0.4 * height)).removeSplitter())
    return nut.cut(Part.makeCylinder(bore, height))


BODIES = {
    "bracket with a boss": Body(bracket, 3.0, (2.5, 8, 24), (18.2, 8, 10), (0, 0, -100.0), True),
    "crank": Body(crank, 3.5, (0, 0, 0), (44, 0, 0), (0, 0, -100.0), True),
    "T pipe": Body(t_pipe, 4.0, (0, 8, -30), (30, 6, 0), (0, 0, -100.0), False),
    "hex nut": Body(hex_nut, 3.0, (8 * math.cos(0.5), 8 * math.sin(0.5), 0), (0, 6, 5), (0, 0, -100.0), False),
    "flanged elbow": Body(elbow, 3.0, (9, -8, 0), (-8, 9, 0), (0, -100.0, 0), True),
}


def made(body, folder):
    """(the body's shape, path of its .brep file in a folder)."""
    shape = body.make().Solids[0]
    path = os.path.join(folder, "body.brep")
    shape.exportBrep(path)
    return shape, path


def face_at(shape, point):
    """1-based number of the face that a point is nearest to."""
    vertex = Part.Vertex(Vector(*point))
    return 1 + min(range(len(shape.Faces)), key=lambda k: shape.Faces[k].distToShape(vertex)[0])

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids on which hexes are set beside quadratic tetrahedra, in SETS. FreeCAD makes them."""
import math

from bodies import BODIES as OF_GRID, Body, crank
from quads_solids import Part, Vector, prism

X, Y, Z = Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)


def box(x, y, z, dx, dy, dz):
    return Part.makeBox(dx, dy, dz, Vector(x, y, z))


def cylinder(radius, height, x=0.0, y=0.0, z=0.0, along=Z):
    return Part.makeCylinder(radius, height, Vector(x, y, z), along)


def turned(profile):
    """A full turn of straight lines through places (radius, height) round z."""
    wire = Part.makePolygon([Vector(r, 0, z) for r, z in (*profile, profile[0])])
    return Part.Face(wire).revolve(Vector(), Z, 360)


def half_torus():
    return Part.makeTorus(12, 4, Vector(), Z, 0, 360, 180)


def ball():
    """Cut flat at both ends."""
    return Part.makeSphere(10).common(box(-20, -20, -8, 40, 40, 16))


def elbow():
    outer, inner = (Part.makeTorus(20, r, Vector(), Z, 0, 360, 90) for r in (6, 4))
    return outer.cut(inner)


def shaft():
    """Three diameters, filleted between."""
    steps = turned([(0, 0), (9, 0), (9, 20), (6, 20), (6, 40), (4, 40), (4, 55), (0, 55)])
    inner = [e for e in steps.Edges if type(e.Curve).__name__ == "Circle" and
             min(abs(e.BoundBox.ZMin - z) for z in (20, 40)) < 1e-6 and e.Curve.Radius < 7]
    return steps.makeFillet(1.5, [e for e in inner if e.Curve.Radius == (6 if e.BoundBox.ZMin < 30 else 4)])


def holed_bracket():
    """An L with three holes."""
    made = box(0, 0, 0, 40, 24, 6).fuse(box(0, 0, 0, 6, 24, 36)).removeSplitter()
    for hole in (cylinder(3, 20, 20, 7, -1), cylinder(3, 20, 32, 17, -1), cylinder(4, 20, -1, 12, 24, X)):
        made = made.cut(hole)
    return made


def holed_plate():
    return box(-20, -10, 0, 40, 20, 4).cut(cylinder(4, 20, 0, 0, -1))


def pipe():
    """A quarter of a thick one."""
    whole = cylinder(10, 20).cut(cylinder(5, 20))
    return whole.common(box(0, 0, 0, 30, 30, 30))


def tapered_block():
    """Cook's membrane, with a thickness."""
    return prism([(0, 0, 0), (48, 44, 0), (48, 60, 0), (0, 44, 0)], (0, 0, 10))


ROUND = {
    "torus": Body(half_torus, 2.5, (12, 0, 0), (-12, 0, 0), (0, 0, -100.0), True),
    "ball": Body(ball, 3.5, (0, 0, -8), (0, 0, 8), (100.0, 0, 0), False),
    "cylinder": Body(lambda: cylinder(6, 30), 3.5, (0, 0, 0), (0, 0, 30), (100.0, 0, 0), True),
    "pipe elbow": Body(elbow, 2.5, (25, 0, 0), (0, 25, 0), (0, 0, -100.0), True),
    "shaft with fillets": Body(shaft, 3.0, (0, 0, 0), (0, 0, 55), (100.0, 0, 0), True),
    "crank": Body(crank, 3.5, (0, 0, 0), (44, 0, 0), (0, 0, -100.0), True),
    "bracket with holes": Body(holed_bracket, 4.0, (0, 3, 10), (40, 12, 3), (0, 0, -100.0), True),
    "plate with a hole": Body(holed_plate, 3.5, (-20, 0, 2), (20, 0, 2), (100.0, 0, 0), False),
    "thick pipe": Body(pipe, 3.0, (7.5, 0, 10), (0, 7.5, 10), (0, 100.0, 0), False),
    "tapered block": Body(tapered_block, 6.0, (0, 22, 5), (48, 52, 5), (0, 100.0, 0), True)}


def bossed_plate():
    made = box(0, 0, 0, 80, 50, 8)
    for x, y in ((15, 15), (65, 15), (15, 35), (65, 35)):
        made = made.fuse(cylinder(7, 14, x, y)).cut(cylinder(3, 20, x, y, -1))
    return made.cut(cylinder(10, 20, 40, 25, -1)).removeSplitter()


def stepped_block():
    made = box(0, 0, 0, 60, 40, 10).fuse(box(0, 0, 10, 40, 40, 10)).fuse(box(0, 0, 20, 20, 25, 10))
    return made.cut(cylinder(5, 50, 10, 12, -1)).removeSplitter()


def flange():
    made = cylinder(50, 12).fuse(cylinder(25, 40)).cut(cylinder(15, 60, 0, 0, -1))
    for k in range(6):
        made = made.cut(cylinder(4.5, 30, 38 * math.cos(k * math.pi / 3), 38 * math.sin(k * math.pi / 3), -1))
    return made


def counterbored_plate():
    made = box(0, 0, 0, 70, 40, 16)
    for x in (15, 55):
        made = made.cut(cylinder(3.5, 30, x, 20, -1)).cut(cylinder(6, 30, x, 20, 9))
    return made.cut(box(28, -1, 8, 14, 50, 20))


def chamfered_shaft():
    return turned([(0, 0), (9, 0), (10, 1), (10, 30), (15, 30), (15, 55), (20, 55), (20, 65), (12, 65), (12, 99),
                   (11, 100), (0, 100)])


def pulley():
    return turned([(8, 0), (20, 0), (20, 4), (50, 4), (50, 8), (42, 12), (42, 16), (50, 20), (50, 24), (20, 24),
                   (20, 30), (8, 30)])


def manifold():
    made = box(0, 0, 0, 80, 40, 40).cut(cylinder(6, 90, -1, 20, 20, X))
    for x in (20, 40, 60):
        made = made.cut(cylinder(4, 25, x, 20, 20))
    return made


def bearing_block():
    made = box(-40, -15, 0, 80, 30, 10).fuse(cylinder(20, 30, 0, -15, 28, Y)).fuse(box(-20, -15, 0, 40, 30, 28))
    made = made.cut(cylinder(12, 50, 0, -20, 28, Y)).removeSplitter()
    return made.cut(cylinder(4, 30, -30, 0, -1)).cut(cylinder(4, 30, 30, 0, -1))


MACHINED = {
    "plate with bosses": Body(bossed_plate, 7.0, (0, 25, 4), (80, 25, 4), (0, 0, -100.0), True),
    "stepped block": Body(stepped_block, 8.0, (0, 30, 5), (60, 20, 5), (0, 0, -100.0), True),
    "flange": Body(flange, 8.0, (0, 44, 0), (20, 0, 40), (100.0, 0, 0), False),
    "counterbored plate": Body(counterbored_plate, 6.0, (0, 20, 8), (70, 20, 8), (0, 0, -100.0), True),
    "shaft with chamfers": Body(chamfered_shaft, 9.0, (0, 0, 0), (0, 0, 100), (100.0, 0, 0), True),
    "pulley": Body(pulley, 7.0, (12, 0, 0), (50, 0, 6), (0, 0, -100.0), False),
    "manifold": Body(manifold, 8.0, (0, 4, 4), (80, 4, 4), (0, 0, -100.0), True),
    "bearing block": Body(bearing_block, 7.0, (0, 10, 0), (0, 0, 48), (100.0, 0, 0), False)}

GRID = {name: OF_GRID[name] for name in ("bracket with a boss", "crank", "T pipe", "hex nut")}
SETS = {"grid": GRID, "round": ROUND, "machined": MACHINED}

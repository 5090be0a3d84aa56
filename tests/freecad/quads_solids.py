# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids the tests of hexcon.quads sweep. Needs FreeCAD."""
import math
import sys

if "/usr/lib/freecad-python3/lib" not in sys.path:
    sys.path.append("/usr/lib/freecad-python3/lib")

import FreeCAD  # noqa: E402,F401  (must come before Part)
import Part  # noqa: E402
from FreeCAD import Vector  # noqa: E402


def prism(points, direction):
    """A polygon pulled along a direction."""
    corners = [Vector(*p) for p in points]
    return Part.Face(Part.makePolygon(corners + corners[:1])).extrude(Vector(*direction))


def ngon(n, radius, height):
    return prism([(radius * math.cos(2 * math.pi * k / n), radius * math.sin(2 * math.pi * k / n), 0)
                  for k in range(n)], (0, 0, height))


def pyramid_frustum():
    wires = [Part.makePolygon([Vector(s * x, s * y, z) for x, y in ((-5, -5), (5, -5), (5, 5), (-5, 5), (-5, -5))])
             for s, z in ((1.0, 0), (0.5, 8))]
    return Part.makeLoft(wires, True, True)


def two_hole_plate():
    plate = Part.makeBox(40, 20, 6)
    for x, r in ((10, 4), (28, 5)):
        plate = plate.cut(Part.makeCylinder(r, 6, Vector(x, 10, 0)))
    return plate


def shaft_segment():
    """A quarter of a bored shaft with a flange."""
    profile = [Vector(x, 0, z) for x, z in ((2, 0), (10, 0), (10, 3), (5, 3), (5, 12), (2, 12), (2, 0))]
    return Part.Face(Part.makePolygon(profile)).revolve(Vector(0, 0, 0), Vector(0, 0, 1), 90)


def filleted_extrusion():
    box = Part.makeBox(20, 10, 8)
    return box.makeFillet(2, [e for e in box.Edges if abs(e.tangentAt(0).z) > 0.9])


def spline_extrusion():
    curve = Part.BSplineCurve()
    curve.interpolate([Vector(0, 0, 0), Vector(10, 2, 0), Vector(14, 8, 0), Vector(6, 12, 0), Vector(-3, 7, 0)],
                      PeriodicFlag=True)
    return Part.Face(Part.Wire(curve.toShape())).extrude(Vector(0, 0, 9))


def pipe_bend():
    disk = Part.Face(Part.Wire(Part.makeCircle(3, Vector(10, 0, 0), Vector(0, 1, 0))))
    return disk.revolve(Vector(0, 0, 0), Vector(0, 0, 1), 120)


def twisted_loft():
    wires = [Part.makePolygon([Vector(5 * math.cos(math.pi * k / 2 + a), 5 * math.sin(math.pi * k / 2 + a), z)
                               for k in range(5)]) for a, z in ((0.0, 0), (0.5, 8))]
    return Part.makeLoft(wires, True, False)


def square_to_round():
    square = Part.makePolygon([Vector(*p) for p in ((-5, -5, 0), (5, -5, 0), (5, 5, 0), (-5, 5, 0), (-5, -5, 0))])
    return Part.makeLoft([square, Part.Wire(Part.makeCircle(3, Vector(0, 0, 8)))], True)


def spline_pipe():
    path = Part.BSplineCurve()
    path.interpolate([Vector(0, 0, 0), Vector(0, 0, 10), Vector(5, 0, 18), Vector(14, 3, 22)])
    return Part.Wire(path.toShape()).makePipeShell([Part.Wire(Part.makeCircle(3))], True, False)


def spring():
    wire = Part.Wire(Part.makeCircle(1, Vector(8, 0, 0), Vector(0, 1, 0)))
    return Part.Wire(Part.makeHelix(6, 12, 8)).makePipeShell([wire], True, True)


def i_beam():
    return prism([(0, 0, 0), (10, 0, 0), (10, 2, 0), (6, 2, 0), (6, 10, 0), (10, 10, 0), (10, 12, 0), (0, 12, 0),
                  (0, 10, 0), (4, 10, 0), (4, 2, 0), (0, 2, 0)], (0, 0, 20))


def keyed_shaft():
    return Part.makeCylinder(5, 12).cut(Part.makeBox(3, 2, 12, Vector(3, -1, 0)))


def bolt_flange():
    flange = Part.makeCylinder(20, 5).cut(Part.makeCylinder(8, 5))
    for k in range(6):
        flange = flange.cut(Part.makeCylinder(2, 5, Vector(14 * math.cos(k * math.pi / 3),
                                                            14 * math.sin(k * math.pi / 3), 0)))
    return flange


def square_tube():
    return Part.makeBox(20, 20, 10).cut(Part.makeBox(12, 12, 10, Vector(4, 4, 0)))


def filleted_box():
    box = Part.makeBox(10, 8, 6)
    return box.makeFillet(1.5, box.Edges)


def two_way_bracket():
    """A plate with a hole up and another across: no sweep."""
    block = Part.makeBox(20, 20, 5).fuse(Part.makeBox(5, 20, 20)).removeSplitter()
    return block.cut(Part.makeCylinder(3, 30, Vector(12, 10, -5))).cut(
        Part.makeCylinder(3, 30, Vector(-5, 10, 12), Vector(1, 0, 0)))


# name -> (maker, three sizes, least scaled Jacobian of cap quads at every size)
BRIEF = {
    "box": (lambda: Part.makeBox(10, 7, 5), (4, 2, 0.8), 0.99),
    "cylinder": (lambda: Part.makeCylinder(5, 12), (4, 2, 0.8), 0.8),
    "hexagonal prism": (lambda: ngon(6, 5, 10), (4, 2, 0.8), 0.8),
    "pentagonal prism": (lambda: ngon(5, 5, 10), (4, 2, 0.8), 0.9),
    "cone frustum": (lambda: Part.makeCone(6, 3, 10), (4, 2, 0.8), 0.8),
    "pyramid frustum": (pyramid_frustum, (4, 2, 0.8), 0.99),
    "wedge": (lambda: prism([(0, 0, 0), (8, 0, 0), (0, 6, 0)], (0, 0, 10)), (4, 2, 0.8), 0.59),
    "sheared prism": (lambda: prism([(0, 0, 0), (10, 0, 0), (10, 8, 0), (0, 8, 0)], (3, 2, 9)), (4, 2, 0.8), 0.9),
    "two-hole plate": (two_hole_plate, (4, 2, 1), 0.65),
    "pipe": (lambda: Part.makeCylinder(6, 12).cut(Part.makeCylinder(4, 12)), (4, 2, 0.8), 0.9),
    "shaft segment": (shaft_segment, (4, 2, 0.8), 0.75),
}
MORE = {
    "truncated wedge": (lambda: Part.makeWedge(0, 0, 0, 2, 2, 10, 10, 10, 8, 8), (2,), 0.9),
    "filleted extrusion": (filleted_extrusion, (2,), 0.8),
    "spline extrusion": (spline_extrusion, (2,), 0.8),
    "half cylinder": (lambda: Part.makeCylinder(5, 12, Vector(0, 0, 0), Vector(0, 0, 1), 180), (2, 1), 0.75),
    "quarter cylinder": (lambda: Part.makeCylinder(5, 12, Vector(0, 0, 0), Vector(0, 0, 1), 90), (2,), 0.8),
    "pipe bend": (pipe_bend, (2,), 0.8),
    "twisted loft": (twisted_loft, (2,), 0.9),
    "square to round": (square_to_round, (2,), 0.6),
    "spline pipe": (spline_pipe, (2,), 0.8),
    "spring": (spring, (1.5,), 0.8),
    "I beam": (i_beam, (4, 1), 0.9),
    "keyed shaft": (keyed_shaft, (2,), 0.6),
    "bolt flange": (bolt_flange, (3,), 0.65),
    "square tube": (square_tube, (2,), 0.9),
    "stacked cylinders": (lambda: Part.makeCylinder(5, 6).fuse(Part.makeCylinder(5, 8, Vector(0, 0, 6))), (2,), 0.8),
    "domed cylinder": (lambda: Part.makeCylinder(5, 12).common(Part.makeSphere(13)), (2,), 0.8),
    "saddle end": (lambda: Part.makeCylinder(4, 20).cut(
        Part.makeCylinder(8, 30, Vector(-15, 0, 20), Vector(1, 0, 0))), (2,), 0.8),
    "oblique cylinder": (lambda: Part.Face(Part.Wire(Part.makeCircle(5))).extrude(Vector(4, 0, 10)), (2,), 0.8),
}

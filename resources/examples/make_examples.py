# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the example parts and writes them as STEP: freecadcmd make_examples.py

The parts are committed; this script is how they were made, and how to change them.
"""
import math
import os
import sys
import traceback

import FreeCAD  # noqa: F401  before Part
import Part
from FreeCAD import Vector


def bracket():
    """An L with a fillet inside, rounded ends and three bores: a sweep of genus 3."""
    thickness, long, tall, round_, depth = 16.0, 90.0, 70.0, 12.0, 30.0
    corner = Vector(thickness + round_, 0, thickness + round_)
    mid = corner + Vector(-round_ * math.cos(math.pi / 4), 0, -round_ * math.sin(math.pi / 4))
    points = [Vector(0, 0, 0), Vector(long, 0, 0), Vector(long, 0, thickness),
              Vector(thickness + round_, 0, thickness), Vector(thickness, 0, thickness + round_),
              Vector(thickness, 0, tall), Vector(0, 0, tall)]
    edges = [Part.makeLine(a, b) for a, b in zip(points, points[1:] + points[:1])]
    edges[3] = Part.Arc(points[3], mid, points[4]).toShape()
    solid = Part.Face(Part.Wire(edges)).extrude(Vector(0, depth, 0))
    for x, z in ((50, 8), (75, 8), (8, 52)):
        solid = solid.cut(Part.makeCylinder(4.5, depth, Vector(x, 0, z), Vector(0, 1, 0)))
    return solid


def shaft_segment():
    """A quarter of a bored shaft with a flange: its profile swept about the axis."""
    profile = [(10, 0), (40, 0), (40, 12), (20, 12), (20, 60), (10, 60)]
    wire = Part.makePolygon([Vector(r, 0, z) for r, z in profile + profile[:1]])
    return Part.Face(wire).revolve(Vector(0, 0, 0), Vector(0, 0, 1), 90)


def wedge():
    """A doorstop: a right triangle with a blunt tip, extruded."""
    profile = [(0, 0), (60, 0), (60, 4), (0, 25)]
    wire = Part.makePolygon([Vector(x, 0, z) for x, z in profile + profile[:1]])
    return Part.Face(wire).extrude(Vector(0, 30, 0))


def box():
    """The cantilever of the textbooks: 10 : 1 : 1."""
    return Part.makeBox(100, 10, 10)


def main():
    folder = os.path.dirname(os.path.abspath(__file__))
    for make in (bracket, shaft_segment, wedge, box):
        make().exportStep(os.path.join(folder, make.__name__ + ".step"))
        print(f"{make.__name__}.step")


if __name__ in ("__main__", "make_examples"):
    status = 0
    try:
        main()
    except Exception:
        traceback.print_exc()
        status = 1
    sys.stdout.flush()
    os._exit(status)  # FreeCAD would run a script that raises twice and exit with 0

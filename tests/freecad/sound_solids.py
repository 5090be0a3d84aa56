# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids as files give them: sound, but not exact to the last digit. Needs FreeCAD."""
import re

from quads_solids import FreeCAD, Part, Vector

_POINT = re.compile(r"#(\d+) = CARTESIAN_POINT\('',\(([^)]*)\)\)")
_VERTEX = re.compile(r"#(\d+) = VERTEX_POINT\('',#(\d+)\)")
_AWAY = ((1.0, 0.3, -0.5), (-0.4, 1.0, 0.2), (0.1, -0.6, 1.0))


def step_of(shape, path):
    """Path of a STEP file of a shape."""
    shape.exportStep(str(path))
    return str(path)


def with_corners_moved(shape, path, by):
    """STEP file of a shape all of whose corners are moved by up to `by`, while edges and faces stay."""
    text = open(step_of(shape, path), encoding="utf-8").read()
    place = {number: [float(c) for c in xyz.split(",")] for number, xyz in _POINT.findall(text)}
    names = max(int(n) for n in re.findall(r"#(\d+) =", text))
    made = []

    def moved(match):
        vertex, point = match.groups()
        xyz = [c + by * d for c, d in zip(place[point], _AWAY[len(made) % 3])]
        made.append("#%d = CARTESIAN_POINT('',(%.12f,%.12f,%.12f));\n" % (names + len(made) + 1, *xyz))
        return f"#{vertex} = VERTEX_POINT('',#{names + len(made)})"
    text = _VERTEX.sub(moved, text)
    end = text.rindex("ENDSEC;")
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text[:end] + "".join(made) + text[end:])
    return str(path)


def cone_askew():
    """A cone far from the origin and along no axis: its apex is some 1e-10 long in a file."""
    return Part.makeCone(37.3, 0, 81.7, Vector(1000.3, 200.7, -55.1), Vector(1, 2, 3))


def notched_block():
    return Part.makeBox(20, 20, 20).cut(Part.makeBox(10, 10, 10, Vector(10, 10, 10))).cut(
        Part.makeCylinder(3, 30, Vector(5, 5, -5)))


def tip_with_short_edge(length=0.004):
    """A bored block that a slanted plane cuts down to an edge of no length to speak of."""
    plane = Part.makePolygon([Vector(*p) for p in ((20, 20, length), (0, 20, 12), (20, 0, 14), (20, 20, length))])
    normal = Part.Face(plane).normalAt(0, 0)
    away = Part.makeBox(100, 100, 100, Vector(-50, -50, 0))
    away.Placement = FreeCAD.Placement(Vector(20, 20, length), FreeCAD.Rotation(Vector(0, 0, 1), normal)).multiply(
        away.Placement)
    return Part.makeBox(20, 20, 20).cut(away).cut(Part.makeCylinder(3, 30, Vector(6, 6, -5)))

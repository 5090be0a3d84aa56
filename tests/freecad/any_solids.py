# SPDX-License-Identifier: LGPL-2.1-or-later
"""Six parts that are no ball or not convex, and how they are held and loaded. Needs FreeCAD."""
from dataclasses import dataclass

from quads_solids import Part, Vector

X, Y, Z = Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)


@dataclass
class Body:
    """make() -> shape; handles and cavities of it; fixed, loaded: points in the middle of, or on, a face that is held or
    pulled by 100 N along `force`; size: of the coarsest mesh, in mm."""
    make: object
    size: float
    handles: int
    cavities: int
    fixed: tuple
    loaded: tuple
    force: tuple


def torus(ring=10.0, tube=3.5):
    return Part.makeTorus(ring, tube)


def cut_torus(ring=10.0, tube=3.5):
    """A torus with a flat on either side to hold it by, and still a torus."""
    body = torus(ring, tube)
    return body.common(Part.makeBox(4 * ring, 2 * ring + 1.4 * tube, 4 * ring,
                                    Vector(-2 * ring, -ring - 0.7 * tube, -2 * ring)))


def plate(length=40.0, width=24.0, thickness=5.0, radii=(3.0, 4.0, 2.5)):
    """Three holes in a row."""
    body = Part.makeBox(length, width, thickness)
    for k, radius in enumerate(radii):
        body = body.cut(Part.makeCylinder(radius, thickness, Vector((k + 0.75) * length / 3.5, width / 2, 0)))
    return body


def bracket(leg=24.0, width=16.0, thickness=5.0, boss=5.0, bore=2.5):
    """An L with a bored boss on its foot."""
    foot = Part.makeBox(leg, width, thickness)
    wall = Part.makeBox(thickness, width, leg)
    middle = Vector(0.62 * leg, width / 2, 0)
    body = foot.fuse(wall).fuse(Part.makeCylinder(boss, 2 * thickness, middle)).removeSplitter()
    return body.cut(Part.makeCylinder(bore, 2 * thickness, middle))


def elbow(bend=14.0, radius=6.0, bore=4.0, straight=8.0):
    """A pipe bent by 90 degrees, with a flange at one end."""
    start, end = Vector(bend, 0, 0), Vector(0, bend, 0)

    def solid(r):
        disc = Part.Face(Part.Wire(Part.makeCircle(r, start, Y)))
        return disc.revolve(Vector(0, 0, 0), Z, 90).fuse(
            [Part.makeCylinder(r, straight, start, -Y), Part.makeCylinder(r, straight, end, -X)])
    flange = Part.makeCylinder(1.6 * radius, 3.0, start - Y * straight, Y)
    return solid(radius).fuse(flange).removeSplitter().cut(solid(bore))


def hollow_ball(radius=10.0, cavity=5.0):
    """A ball with a ball taken out of it, a flat at either end to hold it by."""
    body = Part.makeSphere(radius).common(Part.makeBox(1.7 * radius, 4 * radius, 4 * radius,
                                                       Vector(-0.85 * radius, -2 * radius, -2 * radius)))
    return body.cut(Part.makeSphere(cavity, Vector(0.1 * radius, 0, 0)))


def crank(pin=4.0, throw=10.0, web=5.0):
    """Two main journals, two webs and the pin between."""
    def journal(radius, start, length, off):
        return Part.makeCylinder(radius, length, Vector(start, 0, off), X)

    def cheek(start):
        return Part.makeBox(web, 3 * pin, throw + 3 * pin, Vector(start, -1.5 * pin, -1.5 * pin))
    parts = [cheek(12), journal(pin, 12 + web, 10, throw), cheek(22 + web), journal(1.2 * pin, 22 + 2 * web, 12, 0)]
    return journal(1.2 * pin, 0, 12, 0).fuse(parts).removeSplitter()


BODIES = {
    "torus": Body(torus, 4.0, 1, 0, (), (), ()),
    "torus with flats": Body(cut_torus, 4.0, 1, 0, (0, -12.45, 0), (0, 12.45, 0), (0, 100.0, 0)),
    "plate, three holes": Body(plate, 4.0, 3, 0, (0, 12, 2.5), (40, 12, 2.5), (100.0, 0, 0)),
    "bracket with a boss": Body(bracket, 4.0, 1, 0, (2.5, 8, 24), (18.2, 8, 10), (0, 0, -100.0)),
    "pipe elbow": Body(elbow, 4.0, 1, 0, (9, -8, 0), (-8, 9, 0), (0, -100.0, 0)),
    "hollow ball": Body(hollow_ball, 4.0, 0, 1, (-8.5, 0, 0), (8.5, 0, 0), (-100.0, 0, 0)),
    "crank": Body(crank, 4.0, 0, 0, (0, 0, 0), (44, 0, 0), (0, 0, -100.0)),
}

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Round bodies as .brep files, drawn by gmsh: name, wanted edge length, how."""
import math
import os

import gmsh

TURN = 2 * math.pi


def _cut(occ, *tools):
    return occ.cut([tools[0]], list(tools[1:]))


def pipe(occ):
    _cut(occ, (3, occ.addCylinder(0, 0, 0, 0, 0, 10, 10)), (3, occ.addCylinder(0, 0, 0, 0, 0, 10, 5)))


def elbow(occ):
    """A bent pipe: an annulus turned by a quarter."""
    rings = [occ.addCurveLoop([occ.addCircle(20, 0, 0, r)]) for r in (6, 4)]
    occ.revolve([(2, occ.addPlaneSurface(rings))], 0, 0, 0, 0, 1, 0, TURN / 4)


def shaft(occ):
    """Two diameters with a fillet between."""
    points = [occ.addPoint(*p) for p in ((0, 0, 0), (10, 0, 0), (10, 0, 12), (8, 0, 14), (8, 0, 30), (0, 0, 30))]
    centre = occ.addPoint(10, 0, 14)
    lines = [occ.addLine(points[0], points[1]), occ.addLine(points[1], points[2]),
             occ.addCircleArc(points[2], centre, points[3]), occ.addLine(points[3], points[4]),
             occ.addLine(points[4], points[5]), occ.addLine(points[5], points[0])]
    occ.revolve([(2, occ.addPlaneSurface([occ.addCurveLoop(lines)]))], 0, 0, 0, 0, 0, 1, TURN)


def plate(occ):
    _cut(occ, (3, occ.addBox(-20, -20, 0, 40, 40, 5)), (3, occ.addCylinder(0, 0, 0, 0, 0, 5, 6)))


def barrel(occ):
    """A spline turned about an axis."""
    points = [occ.addPoint(*p) for p in ((0, 0, 0), (8, 0, 0), (11, 0, 10), (8, 0, 20), (0, 0, 20))]
    lines = [occ.addLine(points[0], points[1]), occ.addSpline(points[1:4]), occ.addLine(points[3], points[4]),
             occ.addLine(points[4], points[0])]
    occ.revolve([(2, occ.addPlaneSurface([occ.addCurveLoop(lines)]))], 0, 0, 0, 0, 0, 1, TURN)


def quarter_pipe(occ):
    """A quarter of a thick pipe, radii 5 and 10, height 2, between the planes x = 0 and y = 0."""
    outer, inner = (occ.addCylinder(0, 0, 0, 0, 0, 2, r, angle=TURN / 4) for r in (10, 5))
    _cut(occ, (3, outer), (3, inner))


def quarter_plate(occ):
    """A quarter of a plate of 40 x 40 x 2 with a hole of radius 5, between the planes x = 0 and y = 0."""
    _cut(occ, (3, occ.addBox(0, 0, 0, 20, 20, 2)), (3, occ.addCylinder(0, 0, 0, 0, 0, 2, 5)))


BODIES = {
    "cylinder": (4.0, lambda occ: occ.addCylinder(0, 0, 0, 0, 0, 20, 10)),
    "ball": (4.0, lambda occ: occ.addSphere(0, 0, 0, 10)),
    "torus": (4.0, lambda occ: occ.addTorus(0, 0, 0, 12, 4)),
    "pipe": (4.0, pipe), "elbow": (3.0, elbow), "shaft": (4.0, shaft), "plate with a hole": (5.0, plate),
    "barrel": (4.0, barrel)}


def written(name, make, folder):
    """Path of the body as a .brep file."""
    path = os.path.join(folder, name.replace(" ", "_") + ".brep")
    gmsh.initialize([], False)
    gmsh.option.setNumber("General.Terminal", 0)
    make(gmsh.model.occ)
    gmsh.model.occ.synchronize()
    gmsh.write(path)
    gmsh.finalize()
    return path

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Round solids as .brep files, made by gmsh in a process, and how far points are off them, by formula."""
import subprocess
import sys

import numpy as np

_MAKE = """
import gmsh, sys
gmsh.initialize([], False)
gmsh.option.setNumber("General.Terminal", 0)
occ = gmsh.model.occ
exec(sys.argv[1])
occ.synchronize()
gmsh.write(sys.argv[2])
"""
SOLIDS = {
    "cylinder": "occ.addCylinder(0, 0, 0, 0, 0, 20, 10)",
    "ball": "occ.addSphere(0, 0, 0, 10)",
    # a barrel: a spline turned about the axis, so that neither its face nor its seam has a closed form
    "barrel": "points = [occ.addPoint(*p) for p in ((0, 0, 0), (8, 0, 0), (11, 0, 10), (8, 0, 20), (0, 0, 20))];"
              "lines = [occ.addLine(points[0], points[1]), occ.addSpline(points[1:4]),"
              " occ.addLine(points[3], points[4]), occ.addLine(points[4], points[0])];"
              "face = occ.addPlaneSurface([occ.addCurveLoop(lines)]);"
              "occ.revolve([(2, face)], 0, 0, 0, 0, 0, 1, 6.283185307179586)"}


def write(name, path):
    """The solid as a .brep file; returns the path as text."""
    subprocess.run([sys.executable, "-c", _MAKE, SOLIDS[name], str(path)], check=True, timeout=60)
    return str(path)


def off(name, points):
    """(n,) how far points are off the boundary of a solid, those of the cylinder off its round side."""
    across = np.hypot(points[:, 0], points[:, 1])
    if name == "ball":
        return np.abs(np.linalg.norm(points, axis=1) - 10)
    return np.abs(across - 10)

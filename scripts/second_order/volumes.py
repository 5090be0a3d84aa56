# SPDX-License-Identifier: LGPL-2.1-or-later
"""Volume and distance from the solid of meshes of order 1 and 2 on round bodies, a line each.

PYTHONPATH=.:workbench PYTHON scripts/second_order/volumes.py [NAME ...]
"""
import resource
import sys
import tempfile

import numpy as np
from bodies import BODIES, written

import hexcon


def bilinear_volume(points, quads):
    """Enclosed by bilinear patches."""
    corners, total, reach = points[quads], 0.0, 1 / np.sqrt(3.0)
    for u in (-reach, reach):
        for v in (-reach, reach):
            value = np.array([(1 - u) * (1 - v), (1 + u) * (1 - v), (1 + u) * (1 + v), (1 - u) * (1 + v)]) / 4
            du, dv = np.array([v - 1, 1 - v, 1 + v, -1 - v]) / 4, np.array([u - 1, -1 - u, 1 + u, 1 - u]) / 4
            place, along, across = (np.einsum("n,qnx->qx", w, corners) for w in (value, du, dv))
            total += (place * np.cross(along, across)).sum() / 3
    return total


def seconds():
    """Of processor time, gmsh's processes included."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(one.ru_utime + one.ru_stime for one in used)


def main(names):
    print("body               size  hexes  volume, order 1   order 2      times  farthest off  reduced  min SJ "
          " seconds")
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            size, make = BODIES[name]
            path = written(name, make, folder)
            for part in (1.0, 0.5):
                started = seconds()
                mesh = hexcon.mesh_solid(path, size * part, order=2)
                told = mesh.report["curved"]
                exact = told["cad_volume"]
                errors = bilinear_volume(mesh.points, mesh.quads) / exact - 1, told["volume"] / exact - 1
                print(f"{name:18} {size * part:4g} {len(mesh.hexes):6d}  {errors[0]:+15.5f} {errors[1]:+10.2e} "
                      f"{abs(errors[0] / errors[1]):9.0f} {told['chord']:13.2g} {told['reduced_count']:8d} "
                      f"{mesh.quality.min:7.3f} {seconds() - started:8.1f}"
                      f"{'' if mesh.certificate.certified else '  NOT CERTIFIED'}", flush=True)


main(sys.argv[1:] or BODIES)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesher of tetrahedra of your own for the inside: here the simplest there is, one point that sees all."""
import numpy as np

import hexcon
import hexcon_native as hn


def one_point(points, triangles):
    """Called with a closed, outward triangulation; returns (new points, tetrahedra), or None where it finds none."""
    centre = points[np.unique(triangles)].mean(axis=0)
    a, b, c = (points[triangles[:, k]] - centre for k in range(3))
    if (np.einsum("ij,ij->i", a, np.cross(b, c)) <= 0).any():
        return None             # the mesher of HexCon's own is tried then
    tetrahedra = np.column_stack([np.full(len(triangles), len(points)), triangles])
    print(f"asked         {len(triangles)} triangles, answered {len(tetrahedra)} tetrahedra")
    return centre[None], tetrahedra


surface = hexcon.example("schneiders")
mesh = hn.mesh(surface.points, surface.quads, "cells", tetrahedralise=one_point)
print(f"mesh          {len(mesh.hexes)} hexes, {mesh.certificate}, {mesh.quality}")

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quadratic tetrahedra of a solid: gmsh's, curved and optimised, straight where they are inverted even so."""
import json
import os
import subprocess

import numpy as np
from static import Model

from hexcon.gmsh_process import gmsh_python

TO_ABAQUS = [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]     # from gmsh's order
EDGES = np.array([(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)])     # on which the nodes 4 to 9 lie
# Where Jacobians are looked at: corners, middles of edges, CalculiX's four integration points; barycentric.
_NEAR, _FAR = 0.5854101966, 0.1381966011
PLACES = np.vstack([np.eye(4), (np.eye(4)[EDGES[:, 0]] + np.eye(4)[EDGES[:, 1]]) / 2,
                    np.full((4, 4), _FAR) + (_NEAR - _FAR) * np.eye(4)])
_GMSH = """
import json, sys
import gmsh, numpy as np
job = json.loads(sys.argv[1])
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.option.setNumber("General.NumThreads", 1)
gmsh.model.occ.importShapes(job["solid"])
gmsh.model.occ.synchronize()
for name in ("MeshSizeMin", "MeshSizeMax"):
    gmsh.option.setNumber("Mesh." + name, job["size"])
gmsh.option.setNumber("Mesh.Optimize", 1)
gmsh.option.setNumber("Mesh.HighOrderOptimize", 2)
gmsh.model.mesh.generate(3)
gmsh.model.mesh.setOrder(2)
tags, points, _ = gmsh.model.mesh.getNodes()
rows = np.zeros(int(max(tags)) + 1, int)
rows[np.array(tags, int)] = np.arange(len(tags))
made = {"points": np.array(points).reshape(-1, 3)}
kinds, _, nodes = gmsh.model.mesh.getElements(3)
made["tetrahedra"] = rows[np.array(nodes[list(kinds).index(11)], int)].reshape(-1, 10)
for name in ("held", "loaded"):
    kinds, _, nodes = gmsh.model.mesh.getElements(2, job[name])
    made[name] = rows[np.array(nodes[list(kinds).index(9)], int)].reshape(-1, 6)
np.savez(job["result"], **made)
"""


def tetrahedra(path, size, held, loaded, folder):
    """Model of C3D10 of a .brep file; held, loaded: 1-based numbers of faces."""
    result = os.path.join(folder, "tetrahedra.npz")
    job = {"solid": path, "result": result, "size": size, "held": held, "loaded": loaded}
    subprocess.run([gmsh_python(), "-c", _GMSH, json.dumps(job)], check=True, stdout=subprocess.DEVNULL)
    with np.load(result) as found:
        points, elements = found["points"], found["tetrahedra"][:, TO_ABAQUS]
        straighten(points, elements)
        return Model(points, elements, "C3D10", found["held"], found["loaded"])


def straighten(points, elements):
    """Middle nodes of elements (n,10) that are inverted somewhere go to the middles of their edges, in place."""
    while (bad := (determinants(points, elements) <= 0).any(axis=1)).any():
        ends = elements[bad][:, EDGES]
        middles = elements[bad][:, 4:]
        before = points[middles]
        points[middles] = points[ends].mean(axis=2)
        if np.array_equal(before, points[middles]):
            raise ValueError("tetrahedra with straight edges are inverted")


def determinants(points, elements):
    """(n,14) of the Jacobian of 10-node tetrahedra, at PLACES."""
    slopes = np.zeros((len(PLACES), 10, 4))     # of the shape functions, along the barycentric coordinates
    for k in range(4):
        slopes[:, k, k] = 4 * PLACES[:, k] - 1
    for k, (a, b) in enumerate(EDGES, 4):
        slopes[:, k, a], slopes[:, k, b] = 4 * PLACES[:, b], 4 * PLACES[:, a]
    along = slopes[:, :, 1:] - slopes[:, :, :1]
    return np.linalg.det(np.einsum("nkx,pkd->npdx", points[elements], along))

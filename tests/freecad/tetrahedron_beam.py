# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cantilever of ten-node tetrahedra (C3D10), by gmsh and ccx alone: what hexes are measured against."""
import io
import json
import os
import subprocess

import numpy as np

from hexcon import calculix
from hexcon.gmsh_process import gmsh_python

# gmsh in a process of its own, as everywhere: nodes, tetrahedra, and the triangles of x = length.
MESHER = """
import json, sys
import gmsh, numpy as np
job = json.loads(sys.argv[1])
length, side, size = job["length"], job["side"], job["size"]
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.model.occ.addBox(0, 0, 0, length, side, side)
gmsh.model.occ.synchronize()
for name in ("MeshSizeMin", "MeshSizeMax"):
    gmsh.option.setNumber("Mesh." + name, size)
gmsh.model.mesh.generate(3)
gmsh.model.mesh.setOrder(2)
near = length * 1e-6
end = gmsh.model.getEntitiesInBoundingBox(length - near, -near, -near, length + near, side + near,
                                          side + near, 2)
tags, xyz, _ = gmsh.model.mesh.getNodes()
rows = np.zeros(int(max(tags)) + 1, int)
rows[np.array(tags, int)] = np.arange(len(tags))
made = {"points": np.array(xyz).reshape(-1, 3)}
for name, dim, tag, kind, width in (("tetrahedra", 3, -1, 11, 10), ("triangles", 2, end[0][1], 9, 6)):
    kinds, _, nodes = gmsh.model.mesh.getElements(dim, tag)
    made[name] = rows[np.array(nodes[list(kinds).index(kind)], int)].reshape(-1, width)
np.savez(job["path"], **made)
"""
TO_ABAQUS = [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]  # gmsh's last two middle nodes are the other way round


def tetrahedra(length, side, size, folder):
    """dict of points (P, 3), tetrahedra (M, 10) in ccx's order, triangles (T, 6) of the loaded end."""
    path = os.path.join(folder, "tetrahedra.npz")
    job = json.dumps({"length": length, "side": side, "size": size, "path": path})
    subprocess.run([gmsh_python(), "-c", MESHER, job], check=True, stdout=subprocess.DEVNULL)
    with np.load(path) as arrays:
        made = dict(arrays)
    made["tetrahedra"] = made["tetrahedra"][:, TO_ABAQUS]
    return made


def end_loads(points, triangles, force):
    """(P,) consistent loads of an even traction: a third of each triangle's on each middle node."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    loads = np.zeros(len(points))
    np.add.at(loads, triangles[:, 3:], areas[:, None] / 3)
    return force * loads / areas.sum()


def end_deflection(length, side, size, force, material, folder):
    """(deflection of the end downwards, its nodes' mean, in mm; tetrahedra; nodes)."""
    made = tetrahedra(length, side, size, folder)
    points, loads = made["points"], end_loads(made["points"], made["triangles"], force)
    out = io.StringIO()
    out.write("*NODE\n")
    for row, point in enumerate(points, 1):
        out.write("%d, %.12e, %.12e, %.12e\n" % (row, *point))
    out.write("*ELEMENT, TYPE=C3D10, ELSET=EALL\n")
    for row, nodes in enumerate(made["tetrahedra"] + 1, 1):
        out.write(f"{row}, {', '.join(map(str, nodes))}\n")
    out.write(f"*MATERIAL, NAME=SOLID\n*ELASTIC\n{material[0]}, {material[1]}\n"
              "*SOLID SECTION, ELSET=EALL, MATERIAL=SOLID\n*BOUNDARY\n")
    for node in np.flatnonzero(np.abs(points[:, 0]) < 1e-6 * length) + 1:
        out.write(f"{node}, 1, 3, 0.0\n")
    out.write("*STEP\n*STATIC\n*CLOAD\n")
    for node in np.flatnonzero(loads):
        out.write("%d, 3, %.12e\n" % (node + 1, -loads[node]))
    out.write("*NODE FILE\nU\n*END STEP\n")
    result = calculix.solve_inp(out.getvalue())
    end = np.unique(made["triangles"])
    deflection = -result.displacements[np.searchsorted(result.node_ids, end + 1), 2].mean()
    return deflection, len(made["tetrahedra"]), len(points)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hexes of the grid beside gmsh's subdivided tetrahedra and OpenFOAM's snappyHexMesh, on five solids.

    PYTHONPATH=.:workbench python3 scripts/grid_beside/mesher_table.py [--body NAME ...] [--result output/meshers.jsonl]

The grid is asked for a size, the others for such that they have as many nodes, if they can. A line for each body:
of each mesh how many cells are hexes, how many of those are not positive at a corner, scaled Jacobian, how far its
boundary points lie from the solid (in sizes), what part of the length of the solid's sharp edges has an edge of the
mesh along it, processor seconds. snappyHexMesh is left out where it is not installed. A body's line of the result
file is kept.
"""
import os
import subprocess
import sys

import numpy as np

sys.path[:0] = [os.path.dirname(os.path.dirname(os.path.abspath(__file__)))]

from bodies import BODIES, made  # noqa: E402
from fem_table import like  # noqa: E402
from fit import distances, share_of_edges  # noqa: E402
from measured import mesher_rows  # noqa: E402
from measuring import processor_seconds, table_of_bodies  # noqa: E402
from snappy import is_installed, snappy  # noqa: E402

import hexcon  # noqa: E402
import hexcon_native as hn  # noqa: E402
from hexcon.femmesh.boundary import boundary_quads  # noqa: E402
from hexcon.femmesh.hexahedron import FACES  # noqa: E402
from hexcon.gmsh_process import gmsh_python  # noqa: E402

# argv: CAD file, size of the tetrahedra, result.
_GMSH = """
import sys
import gmsh, numpy as np
path, size, result = sys.argv[1], float(sys.argv[2]), sys.argv[3]
gmsh.initialize()
for name, value in (("General.Terminal", 0), ("General.NumThreads", 1), ("Mesh.SubdivisionAlgorithm", 2),
                    ("Mesh.MeshSizeMin", size), ("Mesh.MeshSizeMax", size)):
    gmsh.option.setNumber(name, value)
gmsh.model.occ.importShapes(path)
gmsh.model.occ.synchronize()
gmsh.model.mesh.generate(3)
tags, points, _ = gmsh.model.mesh.getNodes()
rows = np.zeros(int(max(tags)) + 1, int)
rows[np.array(tags, int)] = np.arange(len(tags))
kinds, ids, nodes = gmsh.model.mesh.getElements(3)
hexes = rows[np.array(nodes[list(kinds).index(5)], int)].reshape(-1, 8)
np.savez(result, points=np.array(points).reshape(-1, 3), hexes=hexes, others=sum(map(len, ids)) - len(hexes))
"""


class Made:
    """One mesh: points, hexes, how many cells are none, points and edges of its boundary, processor seconds."""

    def __init__(self, points, hexes, others=0, skin=None, edges=None, seconds=0.0):
        self.points, self.hexes, self.others, self.seconds = points, hexes, others, seconds
        if edges is None:
            rows, sides = boundary_quads(hexes, len(points))
            quads = hexes[rows[:, None], FACES[sides]]
            pairs = np.stack([quads, np.roll(quads, 1, axis=1)], axis=2).reshape(-1, 2)
            edges, skin = np.unique(np.sort(pairs, axis=1), axis=0), points
        self.skin, self.edges = skin, edges


def by_grid(path, size):
    start = processor_seconds()
    mesh = hexcon.mesh_solid(path, size, surface_method="grid", threads=1)
    return Made(mesh.points, mesh.hexes, seconds=processor_seconds() - start)


def by_gmsh(path, size, folder):
    result, start = os.path.join(folder, "hexes.npz"), processor_seconds()
    subprocess.run([gmsh_python(), "-c", _GMSH, path, str(size), result], check=True, stdout=subprocess.DEVNULL)
    with np.load(result) as found:
        return Made(found["points"], found["hexes"], int(found["others"]), seconds=processor_seconds() - start)


def by_snappy(shape, size, folder, level):
    start = processor_seconds()
    return Made(**snappy(shape, size, folder, level), seconds=processor_seconds() - start)


def measured(name, folder):
    body = BODIES[name]
    shape, path = made(body, folder)
    grid = by_grid(path, body.size)
    others = {"gmsh, tetrahedra cut in four": (2, lambda size: by_gmsh(path, size, folder))}
    if is_installed():
        others |= {"snappyHexMesh": (0.8, lambda size: by_snappy(shape, size, folder, 0)),
                   "snappyHexMesh, halved at edges": (1, lambda size: by_snappy(shape, size, folder, 1))}
    meshes = {"grid": grid} | {what: like(len(grid.points), build, factor * body.size)
                               for what, (factor, build) in others.items()}
    return {"body": name, "size": body.size,
            "rows": [{"mesher": what, **judged(mesh, shape, body.size)} for what, mesh in meshes.items()]}


def judged(mesh, shape, size):
    scaled = hn.quality(mesh.points, mesh.hexes).scaled_jacobian if len(mesh.hexes) else np.zeros(1)
    off = distances(shape, mesh.skin[np.unique(mesh.edges)])
    return {"cells": len(mesh.hexes) + mesh.others, "hexes": len(mesh.hexes), "nodes": len(mesh.points),
            "bad": int((scaled <= 0).sum()), "min": float(scaled.min()), "mean": float(scaled.mean()),
            "off": float(off.max() / size), "edges": share_of_edges(shape, mesh.skin, mesh.edges, size),
            "seconds": mesh.seconds}


if __name__ == "__main__":
    table_of_bodies(__doc__, BODIES, list(BODIES), "output/meshers.jsonl", measured, mesher_rows)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entry point of the subprocess: every algorithm on the same surface; the caller judges and chooses."""
import sys

import numpy as np
from gmsh_worker import session
from gmsh_worker.fault import WorkerFault

from .fill import fill
from .sizes import size_callback

# name: (Mesh.Algorithm3D, Mesh.OptimizeThreshold). A higher threshold makes HXT take minutes on long triangles.
ALGORITHMS = {"Delaunay": (1, 0.6), "HXT": (10, 0.35)}


def work(job, link):
    """Arrays NAME_points and NAME_tetrahedra, or NAME_fault, for each algorithm that did not crash before."""
    with np.load(job["file"]) as arrays:
        points, triangles = arrays["points"], arrays["triangles"]
    size = size_callback(points, triangles, job["coarsening"])
    result = {}
    for k, (name, (algorithm, threshold)) in enumerate(ALGORITHMS.items()):
        link.progress(name, k / len(ALGORITHMS))
        if not link.risk(name):
            result[name + "_fault"] = "gmsh crashed"
            continue
        try:
            result[name + "_points"], result[name + "_tetrahedra"] = fill(points, triangles, size, algorithm, threshold)
        except Exception as error:      # gmsh raises nothing narrower
            result[name + "_fault"] = str(error) or "gmsh gave up and did not say why"
    if not result:
        raise WorkerFault("TOOL_FAILED", "no algorithm was tried")
    return result


sys.exit(session.run(sys.argv[1], work))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entry point of the subprocess: middle nodes of the boundary put on the CAD, and curved as far as no hex folds."""
import os
import sys

import numpy as np
from gmsh_worker import cad, session

from .boundary_edges import BoundaryEdges
from .carriers_of_solid import CarriersOfSolid
from .curved_fit import curved_fit
from .unfolding import unfolded


def _run(job, link):
    """Load, project, unfold; returns the arrays of result.npz."""
    link.progress("load", 0.0)
    solid = cad.load(job["file"])
    with np.load(os.path.join(os.path.dirname(sys.argv[1]), "mesh.npz")) as given:
        points, hexes, quads, faces = given["points"], given["hexes"], given["quads"], given["faces"]
    carriers = CarriersOfSolid(solid)
    edges = BoundaryEdges(points, hexes, quads, faces)
    link.progress("curve", 0.0)
    places, on = carriers.middles(points[edges.ends[:, 0]], points[edges.ends[:, 1]], edges.faces)
    bend = np.zeros_like(points)
    bend[edges.middle] = places - points[edges.middle]
    found = unfolded(points, hexes, quads, bend, edges.middle, link.progress)
    link.progress("fit", 0.0)
    fit = curved_fit(carriers, found.points, hexes, edges, quads, faces)
    return {"points": found.points, "on": on, "factor": found.factor, "inner": found.inner, "moved": found.moved, **fit}


sys.exit(session.run(sys.argv[1], _run))

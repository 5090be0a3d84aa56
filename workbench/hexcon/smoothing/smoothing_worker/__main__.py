# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entry point of the subprocess: where a mesh's boundary lies on a solid, and the mesh relaxed there."""
import os
import sys

import numpy as np
from gmsh_worker import cad, session
from gmsh_worker.fault import WorkerFault
from gmsh_worker.grid.features import Cad, Features
from gmsh_worker.grid.sliding import FeatureCarriers

import hexcon_native as hn

from .landing import landed

RELAXING = 0.5      # of the time limit: what is best by then is taken


def _run(job, link):
    """Load, land, relax; returns the arrays of result.npz."""
    link.progress("load", 0.0)
    solid = cad.load(job["file"])
    with np.load(os.path.join(os.path.dirname(sys.argv[1]), "mesh.npz")) as given:
        points, hexes, quads = given["points"], given["hexes"], given["quads"]
    edges = points[quads] - points[np.roll(quads, -1, axis=1)]
    features = Features(Cad(solid, float(np.median(np.linalg.norm(edges, axis=2)))))
    link.progress("landing", 0.0)
    on = FeatureCarriers(features)
    found = landed(features, on, points, quads, job["tolerance"])
    _check(found, job["keep"])
    start = points.copy()
    start[found.corner_point] = features.corners[found.corner]
    relaxed = hn.relax(start, hexes, found.carrier_of_point, on.rows, project=on.project, threads=1,
                       budget=RELAXING * job["timeout"], progress=lambda stage, part: link.progress("slide", part))
    return {"points": relaxed, "faces": found.faces, "dimension": found.dimension, "off": found.off,
            "kept": found.strays, "notes": np.array(found.notes, dtype=str)}


def _check(found, keep):
    """Raise NOT_ON_SOLID where points of the boundary lie on nothing, unless they are to be kept and are few."""
    strays, count = found.strays, found.boundary_count
    if not len(strays) or keep and 2 * len(strays) < count:
        return
    raise WorkerFault("NOT_ON_SOLID", f"{len(strays)} of the {count} points of the mesh's boundary (listed) are off "
                      f"the solid, by {found.off[strays].min():.3g} to {found.off[strays].max():.3g}, where at most "
                      f"{found.allowed[strays].min():.3g} to {found.allowed[strays].max():.3g} is taken for nearness",
                      strays)


sys.exit(session.run(sys.argv[1], _run))

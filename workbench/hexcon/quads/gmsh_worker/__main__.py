# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entry point of the subprocess: reads the job, writes result.npz or fault.json beside it."""
import sys

import numpy as np

from . import cad, session
from .blocks import blocks_surface
from .fault import WorkerFault
from .nearness import distances
from .sweep import sweep_surface
from .triangles import triangle_surface
from .whole import whole_surface

MOST_QUADS = 5e6    # more is a slip of the keyboard, and would fill the memory
# The methods whose quads invite a structured mesh, the best first: maker, its refusal, and that in words.
NATURAL = {"sweep": (sweep_surface, "NOT_SWEEPABLE", "not swept"),
           "blocks": (blocks_surface, "NOT_BLOCKS", "not of blocks")}


def _run(job, link):
    """Load, mesh, measure; returns the arrays of result.npz."""
    link.progress("load", 0.0)
    solid = cad.load(job["file"])
    expected = sum(solid.area(f) for f in solid.faces) / job["size"] ** 2
    if expected > MOST_QUADS:
        raise WorkerFault("BAD_OPTION", f"size {job['size']:g} would give about {expected:.2g} quads; at most "
                          f"{MOST_QUADS:.2g} are made")
    mesh, method, notes = _mesh(solid, job, link)
    link.progress("check", 0.0)
    off, gaps = distances(solid, mesh)
    return {"points": mesh["points"], "quads": mesh["quads"], "faces": mesh["faces"], "off_cad": off,
            "cad_gap": gaps, "tolerance": solid.tolerance, "method": method,
            "notes": np.array(notes + mesh["notes"], dtype=str)}


def _mesh(solid, job, link):
    """(mesh, name of the method that made it, notes about the choice)."""
    method, size = job["method"], job["size"]
    if method in NATURAL:
        return _natural(solid, method, size, link), method, []
    if method == "subdivided-triangles":
        return triangle_surface(solid, size, link, job["care"]), method, []
    if method != "auto":
        return whole_surface(solid, size, method, link), method, []
    notes = []
    for name, (_, refusal, word) in NATURAL.items():
        try:
            return _natural(solid, name, size, link), name, notes
        except WorkerFault as fault:
            if fault.code != refusal:
                raise
            notes.append(f"auto: {word}: {fault}")
    # Hexes inside: 3 a quad on triangles, 10 to 22, and worse ones, where there are coarse quads.
    try:
        return triangle_surface(solid, size, link, job["care"]), "subdivided-triangles", notes
    except WorkerFault as fault:
        notes.append(f"auto: no subdivided triangles: {fault}")
    return whole_surface(solid, size, "subdivided", link), "subdivided", notes


def _natural(solid, method, size, link):
    """The mesh by one of NATURAL; WorkerFault with its refusal."""
    make, refusal, _ = NATURAL[method]
    cavities = cad.count_shells(solid) - 1
    if cavities:
        raise WorkerFault(refusal, f"the solid has cavities, {cavities} in number")
    return make(solid, size, link)


sys.exit(session.run(sys.argv[1], _run))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entry point of the subprocess: reads the job, writes result.npz or fault.json beside it."""
import importlib
import sys

import numpy as np

from . import cad, session
from .fault import WorkerFault
from .methods import METHOD_TABLE, tried_by_auto
from .nearness import check_corners, distances
from .short_edges import short_edges, words

MOST_QUADS = 5e6    # more is a slip of the keyboard, and would fill the memory


def _run(job, link):
    """Load, mesh, measure; returns the arrays of result.npz."""
    link.progress("load", 0.0)
    solid = cad.load(job["file"])
    expected = sum(solid.area(f) for f in solid.faces) / job["size"] ** 2
    if expected > MOST_QUADS:
        raise WorkerFault("BAD_OPTION", f"size {job['size']:g} would give about {expected:.2g} quads; at most "
                          f"{MOST_QUADS:.2g} are made")
    check_corners(solid, job["size"])
    mesh, solid, method, notes = _mesh(solid, job, link)
    link.progress("check", 0.0)
    off, gaps = distances(solid, mesh, job["size"])
    return {"points": mesh["points"], "quads": mesh["quads"], "faces": mesh["faces"], "off_cad": off,
            "cad_gap": gaps, "tolerance": solid.tolerance, "method": method,
            "notes": np.array(notes + mesh["notes"], dtype=str),
            **{name: mesh[name] for name in ("hexes",) if name in mesh}}


def _mesh(solid, job, link):
    """(mesh, the Solid that it is of, name of the method that made it, notes about the choice)."""
    if job["method"] != "auto":
        return *_made(METHOD_TABLE[job["method"]], solid, job, link), job["method"], []
    notes, rows = [], tried_by_auto()
    for row in rows:
        try:
            return *_made(row, solid, job, link), row.name, notes
        except WorkerFault as fault:
            if row is rows[-1] or row.refusal not in ("", fault.code):
                raise
            notes.append(f"auto: {row.refused}: {fault}")


def _made(row, solid, job, link):
    """(the mesh by one method of the table, the Solid that it is of)."""
    cavities = 0 if row.cavities else cad.count_shells(solid) - 1
    if cavities:
        raise WorkerFault(row.refusal, f"the solid has cavities, {cavities} in number")
    module, _, function = row.maker.rpartition(".")
    make = getattr(importlib.import_module(f".{module}", __package__), function)
    offered = {"method": row.name, "care": job["care"]}
    short = short_edges(solid, job["size"]) if row.leaves_out else []
    if short:
        told = words(solid, short)
        solid = cad.Solid(solid.volume)
        solid.leave_out(short)
    mesh = make(solid, job["size"], link=link, **{name: offered[name] for name in row.takes})
    if short:
        mesh["notes"].append(told)
    return mesh, solid


sys.exit(session.run(sys.argv[1], _run))

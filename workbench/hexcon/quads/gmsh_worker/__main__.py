# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entry point of the subprocess: reads the job, writes result.npz or fault.json beside it."""
import importlib
import sys

import numpy as np

from . import cad, session, short_edges
from .auto import taken
from .cad_fit import cad_fit
from .chord_sizes import within
from .fault import WorkerFault
from .methods import METHOD_TABLE, VOLUME_ERROR, tried_by_auto
from .nearness import check_corners, distances, put_on_cad
from .wanted_sizes import wanted_sizes

MOST_QUADS = 5e6    # more is a slip of the keyboard, and would fill the memory
# Processor time for one call of gmsh, which does not always end: a part of all, and seconds for each quad expected.
PATIENCE, PATIENCE_OF_QUAD = 0.1, 2e-3


def _run(job, link):
    """Load, mesh, measure; returns the arrays of result.npz."""
    link.progress("load", 0.0)
    solid = cad.load(job["file"])
    expected = solid.exact_area / job["size"] ** 2
    if expected > MOST_QUADS:
        raise WorkerFault("BAD_OPTION", f"size {job['size']:g} would give about {expected:.2g} quads; at most "
                          f"{MOST_QUADS:.2g} are made")
    link.patience = PATIENCE * job["timeout"] + PATIENCE_OF_QUAD * expected
    check_corners(solid, job["size"])
    job["sizes"] = wanted_sizes(solid, job["size"], job["local_sizes"], job["per_turn"])
    return _meshed(solid, job, link)


def _meshed(solid, job, link):
    """The arrays of the mesh by the method that is asked for, or by the one that auto takes."""
    if job["method"] != "auto":
        return _made(METHOD_TABLE[job["method"]], solid, job, link, [])
    notes, rows = [], tried_by_auto()
    if not job["sizes"].even:
        notes = [f"auto: {row.refused}: it follows no local sizes" for row in rows if "sizes" not in row.takes]
        rows = [row for row in rows if "sizes" in row.takes]
    return taken(rows, lambda row, notes: _made(row, solid, job, link, notes), notes, link.settled)


def _made(row, solid, job, link, notes):
    """The arrays of the mesh by one method of the table; notes: about its choice."""
    if "sizes" not in row.takes and not job["sizes"].even:
        raise WorkerFault("BAD_OPTION", f"surface method {row.name} follows no local sizes: "
                          + ", ".join(one.name for one in METHOD_TABLE.values() if "sizes" in one.takes) + " do")
    cavities = 0 if row.cavities else cad.count_shells(solid) - 1
    if cavities:
        raise WorkerFault(row.refusal, f"the solid has cavities, {cavities} in number")
    solid, short = _without_short_edges(solid, job["size"], row.leaves_out)
    module, _, function = row.maker.rpartition(".")
    make = getattr(importlib.import_module(f".{module}", __package__), function)
    offered = {"method": row.name, "care": job["care"], "timeout": job["timeout"]}
    limit = job["volume_error"] or (VOLUME_ERROR if row.spares_volume else 0.0)

    def arrays(mesh):
        return _arrays(solid, mesh, job["size"], row.name, notes + mesh["notes"] + short)
    link.kept_as(arrays)

    def made(size, sizes):
        return make(solid, size, link=link, **{name: {**offered, "sizes": sizes}[name] for name in row.takes})

    try:
        sizes = job["sizes"] if "sizes" in row.takes else None
        mesh = within(limit, solid, job["size"], sizes, made, link.second)
    finally:
        link.over()
    link.progress("check", 0.0)
    mesh["notes"] += [f"local size of {one['where']}: not below {job['size']:g}, so nothing comes of it"
                      for one in job["local_sizes"] if one["size"] >= job["size"]]
    return arrays(mesh)


def _without_short_edges(solid, size, leaves_out):
    """(Solid, notes); leaves_out: the method takes a Solid without some of its edges."""
    short = short_edges.short_edges(solid, size) if leaves_out else []
    told = short_edges.left_out(solid, short) + short_edges.kept(solid, size, short)
    if not short:
        return solid, told
    solid = cad.Solid(solid.volume)
    solid.leave_out(short)
    return solid, told


def _arrays(solid, mesh, size, method, notes):
    """What is handed over: the arrays of result.npz."""
    off, gaps = distances(solid, mesh, size)
    if put_on_cad(solid, mesh, size, off):
        off, gaps = distances(solid, mesh, size)
    return {"points": mesh["points"], "quads": mesh["quads"], "faces": mesh["faces"], "off_cad": off,
            "cad_gap": gaps, "tolerance": solid.tolerance, "method": method, "notes": np.array(notes, dtype=str),
            **cad_fit(solid, mesh), **{name: mesh[name] for name in ("hexes",) if name in mesh}, **_pieces(mesh)}


def _pieces(mesh):
    """The arrays of what the hexes are made of, where the method tells."""
    pieces = mesh.get("pieces", ())
    return {"piece_names": np.array([name for name, _ in pieces], dtype=str),
            "piece_hexes": np.array([count for _, count in pieces], np.int64)} if pieces else {}


sys.exit(session.run(sys.argv[1], _run))

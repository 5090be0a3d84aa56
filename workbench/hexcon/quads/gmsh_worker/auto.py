# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which surface method's mesh auto takes: the first that is made, unless its natural hexes are poor."""
import numpy as np

import hexcon_native as hn

from .fault import WorkerFault
from .smooth import space_quality

POOR = 0.2      # least scaled Jacobian of natural hexes below which the other natural methods are tried, too
MUCH = 1.25     # times the least one so far: what another method's must be to be taken instead


def taken(rows, made, notes, settled):
    """The arrays of the mesh that is taken, its notes with what became of all that was tried.

    rows: of methods.METHOD_TABLE, in their order; made: callable(row, notes) -> arrays of result.npz, raises
    WorkerFault; settled: callable(arrays), called with each mesh after which others are tried. Raises the fault of the
    last row, or the first that is no row's refusal. Cost: of the methods, and linear.
    """
    notes, best = list(notes), None
    for row in rows:
        if best and not row.natural:
            break
        try:
            arrays = made(row, notes)
        except WorkerFault as fault:
            if not best and (row is rows[-1] or row.refusal not in ("", fault.code)):
                raise
            notes.append(f"auto: {row.refused}: {fault}")
            continue
        least = least_scaled_jacobian(arrays)
        if best is None or least > MUCH * best[0]:
            best = least, arrays
        if not row.natural or least >= POOR:
            break
        settled(best[1])
        notes.append(f"auto: {row.label}: a least scaled Jacobian of {least:.2f}, so other methods were tried")
    own = [note for note in best[1]["notes"] if note not in notes]
    return {**best[1], "notes": np.array(notes + own, dtype=str)}


def least_scaled_jacobian(arrays):
    """Of the hexes that came with the quads; where none did, of the quads, which bounds it."""
    if "hexes" in arrays:
        return float(hn.quality(arrays["points"], arrays["hexes"]).min)
    return float(space_quality(arrays["points"], arrays["quads"]).min())

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which hexes share a face, and which faces are bare once some hexes are taken away."""
import numpy as np

from hexcon.femmesh.boundary import face_keys
from hexcon.femmesh.hexahedron import FACES


def neighbours(hexes, n_points):
    """(H,6) int64: the hex across each side (rows of hexahedron.FACES), -1 where there is none.

    hexes (H,8) int, 0-based. A face that more than two hexes claim has none across it. Cost: one
    sort of 6 H keys.
    """
    across = np.full(6 * len(hexes), -1, np.int64)
    if len(hexes):
        keys = face_keys(hexes[:, FACES].reshape(-1, 4), n_points)
        order = np.lexsort((keys[:, 1], keys[:, 0]))
        changes = np.any(np.diff(keys[order], axis=0) != 0, axis=1)
        starts = np.flatnonzero(np.concatenate([[True], changes]))
        pairs = starts[np.diff(np.append(starts, len(order))) == 2]
        one, two = order[pairs], order[pairs + 1]
        across[one], across[two] = two // 6, one // 6
    return across.reshape(-1, 6)


def bare_faces(across, keep):
    """(hex, side) of the faces of the kept hexes with no kept hex across them, two (k,) arrays.

    across (H,6) of neighbours(), keep (H,) bool.
    """
    rows = np.flatnonzero(keep)
    near = across[rows]
    # -1 looks at the last hex, and is masked
    row, side = np.nonzero((near < 0) | ~keep[near])
    return rows[row], side


def edges_of_quads(quads, n_points):
    """(e,2) int64: the edges of the quads (n,4), each once."""
    ends = np.sort(np.stack([quads, np.roll(quads, -1, axis=1)], axis=-1).reshape(-1, 2), axis=1)
    keys = np.unique(ends[:, 0].astype(np.int64) * n_points + ends[:, 1])
    return np.column_stack(np.divmod(keys, n_points))

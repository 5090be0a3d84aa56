# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which hexahedron, and which side of it, lies behind each boundary quad."""
import numpy as np

from hexcon.errors import FaultCode, ToolError

from .hexahedron import FACES


def face_keys(quads, n_points):
    """(n,2) int64: equal for quads of the same four corners, whatever their sequence."""
    s = np.sort(quads.astype(np.int64), axis=1)
    return np.column_stack([s[:, 0] * n_points + s[:, 1], s[:, 2] * n_points + s[:, 3]])


def boundary_quads(hexes, n_points):
    """The faces that only one hexahedron has.

    hexes (H,8+) int, 0-based. Returns (hex_of_quad (n,), side_of_quad (n,)), 0-based rows
    of hexes and of FACES, in rising order. Cost: one sort of 6 H keys.
    """
    if not len(hexes):
        return np.zeros(0, np.int64), np.zeros(0, np.int64)
    keys = face_keys(hexes[:, FACES].reshape(-1, 4), n_points)
    order = np.lexsort((keys[:, 1], keys[:, 0]))
    changes = np.any(np.diff(keys[order], axis=0) != 0, axis=1)
    first = np.concatenate([[True], changes])
    last = np.concatenate([changes, [True]])
    return np.divmod(np.sort(order[first & last]), 6)


def rows_of_faces(faces, wanted, n_points):
    """(k,) the first row of faces (n,4) with the same four corners as each of wanted (k,4); -1: there is none.

    Cost: one sort of n + k keys."""
    keys = np.vstack([face_keys(faces, n_points), face_keys(wanted, n_points)])
    _, key_ids = np.unique(keys, axis=0, return_inverse=True)
    key_ids = key_ids.reshape(-1)
    face_of_key = np.full(key_ids.max(initial=-1) + 1, -1, np.int64)
    # written backwards, so that the first of several faces stays
    face_of_key[key_ids[:len(faces)][::-1]] = np.arange(len(faces))[::-1]
    return face_of_key[key_ids[len(faces):]]


def owners(hexes, quads, n_points):
    """The hexahedron and side behind each given quad.

    hexes (H,8+), quads (n,4) int, 0-based, quads in any sequence of corners.
    Returns (hex_of_quad (n,), side_of_quad (n,)). Where several hexahedra share the quad
    the first one is taken. Raises ToolError(BAD_MESH) naming quads that no hexahedron has.
    Cost: near-linear; only faces with four boundary corners are sorted.
    """
    on_boundary = np.zeros(n_points, bool)
    on_boundary[quads] = True
    candidates = on_boundary[hexes[:, :8]][:, FACES].all(axis=2)
    hex_ids, sides = np.nonzero(candidates)
    found = rows_of_faces(hexes[hex_ids[:, None], FACES[sides]], quads, n_points)
    if (found < 0).any():
        lost = np.flatnonzero(found < 0)
        raise ToolError(
            f"{len(lost)} of {len(quads)} boundary quads are no face of any hexahedron "
            f"(first: quad {lost[0]}); the mesh and its boundary do not belong together",
            FaultCode.BAD_MESH, lost)
    return hex_ids[found], sides[found]

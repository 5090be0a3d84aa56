# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a body can be filled with hexes as a complex, told by its tetrahedra: numpy and Python's whole numbers only,
no code shared with the core.

Erickson (2014): the quads must be even in number, and every closed path of their edges that bounds inside must be
even. That is so if and only if some 1-cocycle modulo 2 of the body is 1 on every edge of a quad (universal
coefficients): a linear system over the field of two elements, one equation a triangle.
"""
import numpy as np


def split_quads(quads):
    """Each quad as two triangles."""
    return np.vstack([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def is_fillable(quads, tetrahedra):
    """quads (n,4) of the boundary, tetrahedra (M,4) whose boundary is split_quads of them."""
    return len(quads) % 2 == 0 and _has_cocycle(quads, np.asarray(tetrahedra, np.int64))


def _has_cocycle(quads, tetrahedra):
    faces = np.unique(np.sort(tetrahedra[:, [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]].reshape(-1, 3), axis=1), axis=0)
    ends = faces[:, [[0, 1], [0, 2], [1, 2]]]
    size = int(tetrahedra.max()) + 1
    keys, number = np.unique(ends.reshape(-1, 2) @ np.array([size, 1]), return_inverse=True)
    sides = np.sort(np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    diagonals = np.sort(quads[:, [0, 2]], axis=1)
    value = np.full(len(keys), -1)
    value[np.searchsorted(keys, sides @ np.array([size, 1]))] = 1
    value[np.searchsorted(keys, diagonals @ np.array([size, 1]))] = 0
    return _is_solvable(number.reshape(-1, 3), value)


def _is_solvable(equations, value):
    """Sums of three unknowns are 0 modulo 2; those with a value of 0 or 1 are known. Rows are whole numbers, bit 0 the
    right side; each pivot is a row's highest bit."""
    pivots = {}
    for triple in equations.tolist():
        row = 0
        for unknown in triple:
            row ^= int(value[unknown]) if value[unknown] >= 0 else 1 << (unknown + 1)
        while row > 1:
            pivot = pivots.setdefault(row.bit_length(), row)
            if pivot == row:
                break
            row ^= pivot
        if row == 1:
            return False
    return True

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shape functions of quads with 4 nodes, and with 8 (VTK_QUADRATIC_QUAD)."""
import numpy as np

_CORNERS = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
_MIDDLES = np.array([(0, -1), (1, 0), (0, 1), (-1, 0)])


def quad_shape(n_nodes, u, v):
    """Values (n,) and derivatives (n,2) at -1 <= u, v <= 1; n_nodes: 4 or 8, corners first."""
    a, b = _CORNERS.T
    p, q = 1 + a * u, 1 + b * v
    values, du, dv = p * q / 4, a * q / 4, b * p / 4
    if n_nodes == 4:
        return values, np.column_stack([du, dv])
    r = a * u + b * v - 1
    corner = (p * q * r / 4, a * q * (r + p) / 4, b * p * (r + q) / 4)
    a, b = _MIDDLES.T
    across, along = 1 + a * u, 1 + b * v
    level = b != 0  # middles of the edges v = -1, 1 carry 1 - u^2
    middle = (np.where(level, (1 - u * u) * along, (1 - v * v) * across) / 2,
              np.where(level, -2 * u * along, (1 - v * v) * a) / 2,
              np.where(level, (1 - u * u) * b, -2 * v * across) / 2)
    values, du, dv = (np.concatenate(pair) for pair in zip(corner, middle))
    return values, np.column_stack([du, dv])

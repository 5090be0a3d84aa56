# SPDX-License-Identifier: LGPL-2.1-or-later
"""Consistent nodal loads of a force spread evenly over the quads of a CAD face."""
import math

import numpy as np

from hexcon.curving.curving_worker.quad_shape import quad_shape
from hexcon.errors import FaultCode, ToolError

_G2 = 1 / np.sqrt(3.0)
_G3 = np.sqrt(0.6)
_RULE = {4: ([-_G2, _G2], [1.0, 1.0]), 8: ([-_G3, 0.0, _G3], [5 / 9, 8 / 9, 5 / 9])}


def node_areas(points, quads):
    """(n,4|8) integral of each node's shape function over its quad; rows sum to the area.

    points (P,3), quads (n,4|8) 0-based. 8-node corners get negative shares: that is right.
    """
    places, weights = _RULE[quads.shape[1]]
    corners = points[quads]
    areas = np.zeros(quads.shape)
    for u, wu in zip(places, weights):
        for v, wv in zip(places, weights):
            values, slopes = quad_shape(quads.shape[1], u, v)
            tangents = np.einsum("nkx,kd->ndx", corners, slopes)
            size = np.linalg.norm(np.cross(tangents[:, 0], tangents[:, 1]), axis=1)
            areas += wu * wv * size[:, None] * values
    return areas


def force_vector(name, force):
    """The force on a named face as (3,) float64. Raises ToolError(BAD_OPTION)."""
    try:
        vector = np.asarray(force, float)
    except (TypeError, ValueError, OverflowError):
        vector = np.empty(0)
    if vector.shape != (3,) or not np.isfinite(vector).all():
        raise ToolError(f"force on {name}: three finite numbers are needed",
                        FaultCode.BAD_OPTION)
    return vector


def pressure_value(name, pressure):
    """The pressure on a named face as a float. Raises ToolError(BAD_OPTION)."""
    try:
        value = float(pressure)
    except (TypeError, ValueError, OverflowError):
        value = math.nan
    if not math.isfinite(value):
        raise ToolError(f"pressure on {name}: a finite number is needed", FaultCode.BAD_OPTION)
    return value


def face_force(elements, name, force):
    """Nodes and loads of a total force (N), spread evenly over the quads that a name means (Elements.quads_of); over
    the nodes of a set that has no whole quad.

    force (3,). Returns (nodes (k,) 0-based sorted, loads (k,3)); the loads sum to the force
    whatever the difference between the quads' area and the CAD face's.
    """
    quads = elements.quads[elements.quads_of(name)]
    if not len(quads):
        nodes = elements.nodes_of(name)
        return nodes, np.outer(np.full(len(nodes), 1.0 / max(len(nodes), 1)), np.asarray(force, float))
    areas = node_areas(elements.points, quads)
    nodes, place = np.unique(quads, return_inverse=True)
    shares = np.bincount(place.reshape(-1), weights=areas.ravel(), minlength=len(nodes))
    return nodes, np.outer(shares / shares.sum(), np.asarray(force, float))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blends along a direction: caps that end along it, in sides which they meet smoothly. Rim and foot fillets, rounds.

As if the corner were sharp, such a cap is level, at the height of its other end, and its sides go on up or down to it.
"""
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from ..layered.roles import Role

SMOOTH = 5.0            # degrees between normals up to which faces meet smoothly


@dataclass(frozen=True)
class Blend:
    """faces: CAD faces that are smooth neighbours; edges: CAD edges in which they meet sides; up: 1 with material
    below, -1 with material above; lid: height of the corner, were it sharp; turn: mean height of the edges; convex:
    whether the corner is."""

    faces: frozenset
    edges: frozenset
    up: int
    lid: float
    turn: float
    convex: bool

    @property
    def reach(self):
        """Height between its ends."""
        return abs(self.lid - self.turn)


def blends(cad, roles, direction):
    """[Blend] of a grid.features.Cad along a direction (3,); roles: {CAD face: Role}. Linear in the triangles."""
    smooth = [e for e in cad.edges if e.left != e.right and max(180.0 - e.least, e.greatest - 180.0) < SMOOTH]
    curved = {f for f, role in roles.items() if role in (Role.UP, Role.DOWN) and cad.carriers[f].kind != "Plane"}
    groups = _joined(curved, [(e.left, e.right) for e in smooth if roles[e.left] is roles[e.right]])
    found = []
    for faces in groups:
        beside = [e for e in smooth if _side_of(e, faces, roles)]
        if beside:
            blend = _blend(cad, faces, beside, roles[min(faces)].value, direction)
            found += [blend] if blend else []
    return found


def _joined(faces, pairs):
    """[set of faces] that hang together by pairs of them, ordered."""
    order = sorted(faces)
    place = {f: k for k, f in enumerate(order)}
    ends = np.array([(place[a], place[b]) for a, b in pairs if a in place and b in place], int).reshape(-1, 2)
    count, group = connected_components(
        coo_matrix((np.ones(len(ends)), ends.T), shape=(len(order),) * 2), directed=False)
    return [{order[k] for k in np.flatnonzero(group == one)} for one in range(count)]


def _side_of(edge, faces, roles):
    for here, there in ((edge.left, edge.right), (edge.right, edge.left)):
        if here in faces and roles[there] is Role.SIDE:
            return there
    return 0


def _blend(cad, faces, beside, up, direction):
    """The Blend, or None where its sides end half way up."""
    shape = cad.tessellation
    height = shape.points[shape.triangles[np.isin(shape.face, list(faces))]].reshape(-1, 3) @ direction
    turn = np.concatenate([e.samples for e in beside]) @ direction
    low, high = float(height.min()), float(height.max())
    below, above = turn.max() < 0.5 * (low + high), turn.min() > 0.5 * (low + high)
    if not (below or above):
        return None
    return Blend(frozenset(faces), frozenset(e.tag for e in beside), up, high if below else low, float(turn.mean()),
                 below == (up > 0))

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a swept hex mesh is made of, found from its hexes alone, and what its surface allows."""
import collections

import numpy as np
from quads_checks import scaled_jacobian

from hexcon.femmesh.hexahedron import CORNERS, FACES

OPPOSITE = (1, 0, 4, 5, 2, 3)  # row of FACES opposite each row

Caps = collections.namedtuple("Caps", "near far rings")  # quad ids (m,), (m,), hexes in a column


class Columns:
    """The hex mesh as a net: through a face into a hex and out of the face opposite."""

    def __init__(self, hexes, quads):
        self.quads = quads.tolist()
        self.sides = collections.defaultdict(list)  # corners of a face -> [(hex, row of FACES)]
        for h, corners in enumerate(hexes[:, :8].tolist()):
            for side, face in enumerate(FACES.tolist()):
                self.sides[frozenset(corners[k] for k in face)].append((h, side))
        self.faces = {side: face for face, both in self.sides.items() for side in both}
        self.quad_of = {frozenset(quad): q for q, quad in enumerate(self.quads)}

    def follow(self, quad):
        """(quad at the other end, hexes passed) of the column that starts in a boundary quad."""
        face, passed = frozenset(self.quads[quad]), []
        hex_, side = self.sides[face][0]
        while True:
            passed.append(hex_)
            face = self.faces[hex_, OPPOSITE[side]]
            onward = [way for way in self.sides[face] if way[0] != hex_]
            if not onward:
                return self.quad_of[face], passed
            hex_, side = onward[0]

    def patches(self):
        """Lists of quads that touch over edges with just two hexes: no rim lies between them."""
        owner = [self.sides[frozenset(quad)][0][0] for quad in self.quads]
        hexes_at, quads_at = collections.defaultdict(set), collections.defaultdict(list)
        for hex_, face in ((way[0], face) for face, ways in self.sides.items() for way in ways):
            hexes_at[hex_].add(face)
        for q, quad in enumerate(self.quads):
            for a, b in zip(quad, quad[1:] + quad[:1]):
                quads_at[frozenset((a, b))].append(q)
        return _parts(len(self.quads), [
            pair for pair in quads_at.values()
            if owner[pair[0]] != owner[pair[1]]
            and hexes_at[owner[pair[0]]] & hexes_at[owner[pair[1]]]])


def _parts(count, links):
    """Lists of the ids 0 .. count - 1 that links join."""
    beside = collections.defaultdict(list)
    for a, b in links:
        beside[a].append(b)
        beside[b].append(a)
    parts, seen = [], set()
    for start in range(count):
        if start in seen:
            continue
        seen.add(start)
        part = [start]
        for item in part:  # grows while it is read
            fresh = [other for other in beside[item] if other not in seen]
            seen.update(fresh)
            part.extend(fresh)
        parts.append(part)
    return parts


def sweeps_of(mesh):
    """Every way in which the hexes are a sweep: a list of Caps (a grid has three)."""
    columns = Columns(mesh.hexes, mesh.quads)
    found, used = [], set()
    for near in columns.patches():
        if near[0] in used:
            continue
        ends, passed = zip(*(columns.follow(quad) for quad in near))
        used.update(ends)
        covered = sorted(h for column in passed for h in column)
        if not set(ends) & set(near) and covered == list(range(len(mesh.hexes))) \
                and len({len(column) for column in passed}) == 1:
            found.append(Caps(np.array(near), np.array(ends), len(passed[0])))
    return found


def worst_cap_quad(mesh, caps):
    """Least scaled Jacobian of the quads of both caps."""
    return scaled_jacobian(mesh.points, mesh.quads[np.concatenate([caps.near, caps.far])]).min()


def corner_bound(mesh):
    """Least scaled Jacobian of the hex corners whose three edges end on the surface: the given
    points alone decide it, and no placement of inner points can better it."""
    corners = mesh.hexes[:, :8]
    here = mesh.points[corners]
    a, b, c = (mesh.points[corners[:, CORNERS[:, k]]] - here for k in range(3))
    lengths = np.prod([np.linalg.norm(edge, axis=2) for edge in (a, b, c)], axis=0)
    values = np.einsum("hkd,hkd->hk", np.cross(a, b), c) / lengths
    surface_points = len(mesh.surface.points)
    fixed = (corners < surface_points) & (corners[:, CORNERS] < surface_points).all(axis=2)
    return values[fixed].min(initial=1.0)

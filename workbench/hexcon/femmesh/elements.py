# SPDX-License-Identifier: LGPL-2.1-or-later
"""One checked view of a mesh, at the order asked for: what every writer starts from."""
import re
from dataclasses import dataclass, field

import numpy as np

import hexcon_native
from hexcon.errors import FaultCode, ToolError
from hexcon.topological import is_topological

from .boundary import boundary_quads, owners
from .hexahedron import FACES_8
from .second_order import lower_order


@dataclass
class Elements:
    """Arrays of one hex mesh, all indices 0-based.

    points (P,3) float64, hexes (H,8|20) int64 VTK order,
    quads (n,4|8) int64 outward counter-clockwise, face_of_quad (n,) int64 1-based CAD
    face, 0 where there is none, hex_of_quad (n,), side_of_quad (n,) rows of hexahedron.FACES,
    topological: the mesh is topology only, and what is written of it should say so
    quad_groups {name: rows of quads} beside the CAD faces, may overlap; node_groups {name: rows of points}
    """

    points: np.ndarray
    hexes: np.ndarray
    quads: np.ndarray
    face_of_quad: np.ndarray
    hex_of_quad: np.ndarray
    side_of_quad: np.ndarray
    topological: bool = False
    quad_groups: dict = field(default_factory=dict)
    node_groups: dict = field(default_factory=dict)

    @property
    def order(self):
        return 2 if self.hexes.shape[1] == 20 else 1

    def face_numbers(self):
        """The CAD face numbers present, rising, without 0."""
        return [int(f) for f in np.unique(self.face_of_quad) if f > 0]

    def named(self):
        """[(number, name, rows of quads)]: "Face3" of each CAD face, numbers rising, then the named groups, which may
        overlap them and each other, numbered on."""
        faces = [(number, f"Face{number}", np.flatnonzero(self.face_of_quad == number))
                 for number in self.face_numbers()]
        first = (faces[-1][0] if faces else 0) + 1
        return faces + [(first + k, name, rows) for k, (name, rows) in enumerate(self.quad_groups.items()) if len(rows)]

    def group_of_quad(self):
        """(n,) int64: each quad in one group: its CAD face, else the first named group that has it, else the number
        after the highest, that of "Boundary"."""
        numbers = self.face_of_quad.copy()
        highest = int(numbers.max(initial=0))
        for number, _, rows in self.named():
            highest = max(highest, number)
            free = rows[numbers[rows] <= 0]
            numbers[free] = number
        return np.where(numbers > 0, numbers, highest + 1)

    def groups(self):
        """[(number, name, rows of quads)] by group_of_quad, numbers rising: every quad is in one."""
        names = {number: name for number, name, _ in self.named()}
        numbers = self.group_of_quad()
        order = np.argsort(numbers, kind="stable")
        found, starts = np.unique(numbers[order], return_index=True)
        return [(number, names.get(number, "Boundary"), rows)
                for number, rows in zip(found.tolist(), np.split(order, starts[1:]))]

    def all_groups(self):
        """named(), and "Boundary" with the quads that are in none of these: every quad is in one, or more."""
        named, inside = self.named(), np.zeros(len(self.quads), bool)
        for _, _, rows in named:
            inside[rows] = True
        rest = np.flatnonzero(~inside)
        return named + [((named[-1][0] if named else 0) + 1, "Boundary", rest)] * bool(len(rest))

    def quads_of_face(self, face_number):
        """Rows of quads on that 1-based CAD face. Raises ToolError(BAD_OPTION) if none."""
        rows = np.flatnonzero(self.face_of_quad == face_number)
        if not len(rows):
            raise ToolError(f"no boundary quad lies on Face{face_number}; {self._known()}", FaultCode.BAD_OPTION)
        return rows

    def nodes_of_face(self, face_number):
        """Sorted 0-based nodes of that CAD face, middle nodes included at order 2."""
        return np.unique(self.quads[self.quads_of_face(face_number)])

    def quads_of(self, name):
        """Rows of the quads that a name means: a group of quads, a CAD face (Face3, FACE3, 3), or quads all of whose
        corners a node set has; none where a node set has no whole quad.

        Capitals do not matter where they decide nothing. Raises ToolError(BAD_OPTION) for an unknown name."""
        found = _named(self.quad_groups, name)
        if found is not None:
            return found
        nodes = _named(self.node_groups, name)
        if nodes is not None:
            return np.flatnonzero(np.isin(self.quads[:, :4], nodes).all(axis=1))
        number = _CAD_FACE.fullmatch(str(name).strip())
        if number is None or int(number.group(1)) < 1:
            raise ToolError(f"{name!r} names no group of the mesh; {self._known()}", FaultCode.BAD_OPTION)
        return self.quads_of_face(int(number.group(1)))

    def nodes_of(self, name):
        """Sorted nodes that a name means, middle nodes included at order 2; see quads_of."""
        nodes = None if _named(self.quad_groups, name) is not None else _named(self.node_groups, name)
        return np.unique(self.quads[self.quads_of(name)]) if nodes is None else self._with_middles(nodes)

    def nodes_of_set(self, name):
        """Nodes of that entry of node_groups, with the middle nodes between them at order 2."""
        return self._with_middles(self.node_groups[name])

    def _with_middles(self, nodes):
        """A node set with the middle nodes between its corners: of whole quads, or of edges where it has none."""
        if self.order == 1 or not len(nodes):
            return np.asarray(nodes, np.int64)
        inside = np.zeros(len(self.points), bool)
        inside[nodes] = True
        corners = inside[self.quads[:, :4]]
        taken = corners.all(axis=1)
        if taken.any():
            return np.union1d(nodes, self.quads[taken])
        edges = corners & np.roll(corners, -1, axis=1)
        return np.union1d(nodes, self.quads[:, 4:][edges])

    def _known(self):
        names = [name for _, name, _ in self.named()] + list(self.node_groups)
        return f"the mesh has {', '.join(names)}" if names else "the mesh has no CAD faces and no named groups"


_CAD_FACE = re.compile(r"(?:face)?0*(\d{1,9})", re.IGNORECASE)


def _named(groups, name):
    """The entry of that name: as written, or the only one with other capitals; None without one."""
    if name in groups:
        return groups[name]
    alike = [key for key in groups if key.upper() == str(name).strip().upper()]
    return groups[alike[0]] if len(alike) == 1 else None


def _bad(message, ids=()):
    return ToolError(message, FaultCode.BAD_MESH, ids)


def _checked(mesh):
    """(points float64, hexes int64) of any mesh-like object, shapes and range checked."""
    points = np.ascontiguousarray(mesh.points, dtype=np.float64)
    hexes = np.asarray(mesh.hexes)
    if points.ndim != 2 or points.shape[1] != 3:
        raise _bad(f"points have shape {points.shape}, (P,3) is needed")
    if hexes.ndim != 2 or hexes.shape[1] not in (8, 20) or not len(hexes):
        raise _bad(f"hexes have shape {hexes.shape}; (H,8) or (H,20) with H > 0 is needed")
    hexes = hexes.astype(np.int64)
    outside = ((hexes < 0) | (hexes >= len(points))).any(axis=1)
    if outside.any():
        raise _bad(f"{outside.sum()} hexahedra name points outside 0..{len(points) - 1}",
                   np.flatnonzero(outside))
    if not np.isfinite(points).all():
        lost = np.flatnonzero(~np.isfinite(points).all(axis=1))
        raise _bad(f"{len(lost)} points are not finite numbers", lost)
    return points, hexes


def _face_numbers(mesh, n):
    """(n,) int64 CAD face of each quad, 0 where unknown."""
    given = getattr(mesh, "face_of_quad", None)
    if given is None:
        return np.zeros(n, np.int64)
    given = np.asarray(given)
    if given.shape != (n,):
        raise _bad(f"face_of_quad has shape {given.shape} for {n} quads")
    if given.dtype == object:
        given = np.array([0 if f is None else f for f in given])
    return given.astype(np.int64)


def _groups_of(mesh, n_quads, n_points):
    """({name: rows of quads}, {name: rows of points}) of a mesh-like object that has .quad_groups, .node_groups."""
    found = []
    for attribute, count in (("quad_groups", n_quads), ("node_groups", n_points)):
        groups = {}
        for name, rows in (getattr(mesh, attribute, None) or {}).items():
            groups[str(name)] = rows = np.unique(np.asarray(rows, np.int64))
            if len(rows) and (rows[0] < 0 or rows[-1] >= count):
                raise _bad(f"group {name!r} has members outside 0..{count - 1}")
        found.append(groups)
    return found


def _without_middles(groups, kept):
    """Node groups of a mesh whose points kept (P',) stay."""
    return {name: np.flatnonzero(np.isin(kept, rows)) for name, rows in groups.items()}


def elements_of(mesh, order=None):
    """Elements of a mesh-like object (.points, .hexes; .quads, .face_of_quad if known).

    order  1, 2 or None for the mesh's own. Where .quads is missing or None the boundary
    is found from the hexahedra. Points 0..P-1 keep their rows when the order rises.
    Raises ToolError: BAD_MESH for broken arrays, BAD_OPTION for another order.
    """
    if order not in (None, 1, 2):
        raise ToolError(f"order {order!r}: 1 (C3D8) or 2 (C3D20R) is possible",
                        FaultCode.BAD_OPTION)
    points, hexes = _checked(mesh)
    given = getattr(mesh, "quads", None)
    if given is None or not len(given):
        hex_ids, sides = boundary_quads(hexes, len(points))
    else:
        given = np.asarray(given)[:, :4].astype(np.int64)
        if given.min() < 0 or given.max() >= len(points):
            raise _bad(f"quads name points outside 0..{len(points) - 1}")
        hex_ids, sides = owners(hexes, given, len(points))
    faces = _face_numbers(mesh, len(hex_ids))
    quad_groups, node_groups = _groups_of(mesh, len(hex_ids), len(points))
    if order == 2 and hexes.shape[1] == 8:
        points, hexes = hexcon_native.raise_order(points, hexes)
        hexes = hexes.astype(np.int64)
    elif order == 1 and hexes.shape[1] == 20:
        points, hexes, kept = lower_order(points, hexes)
        node_groups = _without_middles(node_groups, kept)
    corners = FACES_8 if hexes.shape[1] == 20 else FACES_8[:, :4]
    quads = hexes[hex_ids[:, None], corners[sides]]
    return Elements(points, hexes, quads, faces, hex_ids, sides, is_topological(mesh), quad_groups, node_groups)

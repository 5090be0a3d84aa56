# SPDX-License-Identifier: LGPL-2.1-or-later
"""One checked view of a mesh, at the order asked for: what every writer starts from."""
from dataclasses import dataclass

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
    """

    points: np.ndarray
    hexes: np.ndarray
    quads: np.ndarray
    face_of_quad: np.ndarray
    hex_of_quad: np.ndarray
    side_of_quad: np.ndarray
    topological: bool = False

    @property
    def order(self):
        return 2 if self.hexes.shape[1] == 20 else 1

    def face_numbers(self):
        """The CAD face numbers present, rising, without 0."""
        return [int(f) for f in np.unique(self.face_of_quad) if f > 0]

    def group_of_quad(self):
        """(n,) int64: the CAD face; of quads on none, the number after the highest: every quad is in a group."""
        unnamed = int(self.face_of_quad.max(initial=0)) + 1
        return np.where(self.face_of_quad > 0, self.face_of_quad, unnamed)

    def groups(self):
        """[(number, name, rows of quads)], group_of_quad's numbers rising: "Face3" of CAD face 3, else "Boundary"."""
        numbers = self.group_of_quad()
        order = np.argsort(numbers, kind="stable")
        found, starts = np.unique(numbers[order], return_index=True)
        return [(number, f"Face{number}" if self.face_of_quad[rows[0]] > 0 else "Boundary", rows)
                for number, rows in zip(found.tolist(), np.split(order, starts[1:]))]

    def quads_of_face(self, face_number):
        """Rows of quads on that 1-based CAD face. Raises ToolError(BAD_OPTION) if none."""
        rows = np.flatnonzero(self.face_of_quad == face_number)
        if not len(rows):
            raise ToolError(
                f"no boundary quad lies on Face{face_number}; the mesh has "
                f"{', '.join(f'Face{f}' for f in self.face_numbers()) or 'no CAD faces'}",
                FaultCode.BAD_OPTION)
        return rows

    def nodes_of_face(self, face_number):
        """Sorted 0-based nodes of that CAD face, middle nodes included at order 2."""
        return np.unique(self.quads[self.quads_of_face(face_number)])


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


def elements_of(mesh, order=None):
    """Elements of a mesh-like object (.points, .hexes; .quads, .face_of_quad if known).

    order  1, 2 or None for the mesh's own. Where .quads is missing or None the boundary
    is found from the hexahedra. Points 0..P-1 keep their rows when the order rises.
    Raises ToolError: BAD_MESH for broken arrays, BAD_OPTION for another order.
    """
    if order not in (None, 1, 2):
        raise ToolError(f"order {order!r}: 1 (C3D8) or 2 (C3D20) is possible",
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
    if order == 2 and hexes.shape[1] == 8:
        points, hexes = hexcon_native.raise_order(points, hexes)
        hexes = hexes.astype(np.int64)
    elif order == 1 and hexes.shape[1] == 20:
        points, hexes, _ = lower_order(points, hexes)
    corners = FACES_8 if hexes.shape[1] == 20 else FACES_8[:, :4]
    quads = hexes[hex_ids[:, None], corners[sides]]
    return Elements(points, hexes, quads, faces, hex_ids, sides, is_topological(mesh))

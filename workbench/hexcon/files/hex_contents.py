# SPDX-License-Identifier: LGPL-2.1-or-later
"""The hex mesh in what a file holds, and its groups."""
import re
from types import SimpleNamespace

import numpy as np

from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.boundary import rows_of_faces
from hexcon.femmesh.elements import elements_of

from .contents import NODES

_SOLIDS = ("tetra", "pyramid", "wedge", "polyhedron", "hexahedron24")
_CAD_FACE = re.compile(r"^Face(\d{1,9})$", re.IGNORECASE)


def hexes_of(path, found):
    """(H,8|20) hexes of contents.Contents. Raises ToolError FILE_FORMAT: other solids, both orders, none."""
    others = {kind: len(rows) for kind, rows in found.cells.items() if kind.startswith(_SOLIDS) and len(rows)}
    if others:
        told = ", ".join(f"{count} {kind}" for kind, count in others.items())
        raise ToolError(f"{path}: {told} beside hexahedra; a mesh of hexahedra alone is needed", FaultCode.FILE_FORMAT)
    blocks = [rows for kind, rows in found.cells.items() if kind in ("hexahedron", "hexahedron20", "hexahedron27")
              and len(rows)]
    if not blocks:
        raise ToolError(f"{path}: there are no hexahedra in it", FaultCode.FILE_FORMAT)
    if len({rows.shape[1] for rows in blocks}) != 1:
        raise ToolError(f"{path}: hexahedra of several orders in one mesh", FaultCode.FILE_FORMAT)
    hexes = np.vstack(blocks)
    if hexes.shape[1] == 27:
        _refuse_curved_middles(path, found.points, hexes)
        found.notes.append("27-node hexes: the nodes in the middles of faces and hexes are dropped")
        hexes = hexes[:, :20]
    return hexes


def _refuse_curved_middles(path, points, hexes):
    """Raise where a 27-node hex is another shape than its first 20 nodes say."""
    from hexcon.femmesh.second_order import STRAIGHT, with_centres
    twenty = hexes[:, :20]
    boundary = np.zeros(0, np.int64)
    placed, full, _ = with_centres(points, twenty, boundary, boundary)
    size = np.linalg.norm(np.ptp(points[hexes[:, :8]], axis=1), axis=1)
    nearest = np.full((len(hexes), 7), np.inf)
    for k in range(7):      # in whatever sequence a format has them
        off = np.linalg.norm(points[hexes[:, 20:]] - placed[full[:, 20 + k]][:, None], axis=2)
        nearest = np.minimum(nearest, off)
    bad = np.flatnonzero((nearest > STRAIGHT * size[:, None]).any(axis=1))
    if len(bad):
        raise ToolError(f"{path}: {len(bad)} hexes of 27 nodes (listed) have middle nodes of faces or of the hex "
                        f"elsewhere than "
                        "20-node hexes have them: their shape is not understood", FaultCode.FILE_FORMAT, bad)


def mesh_of(points, hexes, found=None):
    """Mesh-like object: .points, .hexes, .order, .quads, .face_of_quad, .quad_groups, .node_groups, .notes.

    quads (n,4) is the whole boundary, outward; face_of_quad (n,) the numbers of groups of quads called Face<number>;
    quad_groups {name: rows of quads} the other groups that lie on the boundary; node_groups {name: rows of points}.
    Quads of groups that no hex has on the boundary are left out, with a note.
    """
    mesh = SimpleNamespace(points=points, hexes=hexes, order=2 if hexes.shape[1] == 20 else 1, quads=None,
                           face_of_quad=None,
                           report={}, certificate=None, quad_groups={}, node_groups={}, notes=[])
    boundary = elements_of(mesh)
    mesh.quads, mesh.face_of_quad = boundary.quads[:, :4], boundary.face_of_quad.copy()
    if found is not None:
        mesh.notes += found.notes
        quads, nodes, lost = groups_on(mesh.quads, found, len(points))
        mesh.quad_groups, mesh.node_groups = take_cad_faces(quads, mesh.face_of_quad), nodes
        if lost:
            mesh.notes.append(f"{lost} quads of groups are not on the boundary of the hexes, and are left out of them")
    return mesh


def groups_on(quads, found, n_points):
    """({name: rows of quads (n,4)}, {name: rows of points}, number of grouped quads that are none of these).

    Node sets that HexCon writes beside these are left out: NALL, and NAME_NODES of a group of quads. Cost: one sort."""
    by_name, lost = {}, 0
    corners = [found.corners_of(group) for group in found.groups]
    together = rows_of_faces(quads, np.concatenate([np.zeros((0, 4), np.int64), *corners]), n_points)
    for group, rows in zip(found.groups, np.split(together, np.cumsum([len(one) for one in corners])[:-1])):
        lost += int((rows < 0).sum())
        if (rows >= 0).any():
            before = by_name.get(group.name, np.zeros(0, np.int64))
            by_name[group.name] = np.unique(np.concatenate([before, rows[rows >= 0]]))
    told = {"NALL", *(f"{name.upper()}_NODES" for name in by_name)}
    nodes = {}
    for group in found.groups:
        if group.kind == NODES and len(group.rows) and group.name.upper() not in told:
            nodes[group.name] = np.union1d(nodes.get(group.name, np.zeros(0, np.int64)), group.rows).astype(np.int64)
    return by_name, nodes, lost


def take_cad_faces(groups, face_of_quad):
    """Put the numbers of groups Face<number> into face_of_quad (n,); returns the other groups."""
    others = {}
    for name, rows in groups.items():
        match = _CAD_FACE.match(name)
        if match and not face_of_quad[rows].any() and int(match.group(1)) > 0:
            face_of_quad[rows] = int(match.group(1))
        else:
            others[name] = rows
    return others

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hex meshes of others made good: node orders turned, points merged or dropped, hexes untangled."""
from dataclasses import dataclass, field

import numpy as np

import hexcon_native
from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.boundary import face_keys
from hexcon.femmesh.convert import FREECAD_HEX
from hexcon.femmesh.hexahedron import FACES
from hexcon.femmesh.second_order import lower_order
from hexcon.files.contents import FACES as FACES_OF, NODES, Contents, Group
from hexcon.files.hex_contents import mesh_of
from hexcon.quads.seams import collapsed, merged_rows

REVERSED = FREECAD_HEX[:8]      # the same hex with its nodes in the other sense


@dataclass
class Repair:
    """mesh: as files.read_mesh, of order 1;  notes: what was done, in words;  pillows: sheets of hexes laid under the
    boundary;  turned: rows of hexes whose node order was reversed."""

    mesh: object
    notes: list
    pillows: int
    turned: np.ndarray = field(default_factory=lambda: np.zeros(0, np.int64))


def repair_mesh(found, *, pillow="auto", merge_tolerance=None, progress=None):
    """Repair of a mesh as files.read_mesh has it: its boundary keeps its places and its groups.

    Middle nodes of order 2 are dropped (raise the order again when writing); points that no hex uses are dropped; those
    nearer than merge_tolerance become one, without it none; hexes whose nodes go the other way round than their
    neighbours', or all, are turned; then hexcon_native.repair untangles and improves, pillow as there.
    Raises ToolError BAD_OPTION (a tolerance that merges corners of a hex), and HexconError as hexcon_native.repair.
    """
    notes, named = list(found.notes), _Named(found)
    points, hexes = found.points, found.hexes
    if found.order == 2:
        points, hexes, kept = lower_order(points, hexes)
        named.renumber(_places(len(found.points), kept))
    if merge_tolerance:
        hexes = _merged(points, hexes, merge_tolerance, named, notes)
    points, hexes = _packed(points, hexes, named, notes)
    turned = reversed_hexes(points, hexes)
    if len(turned):
        hexes = hexes.copy()
        hexes[turned] = hexes[turned][:, REVERSED]
        notes.append(f"{len(turned)} of {len(hexes)} hexes had their nodes in reversed order, and were turned")
    repaired = hexcon_native.repair(points, hexes, pillow=pillow, progress=progress)
    mesh = mesh_of(repaired.points, repaired.hexes, named.contents(repaired.points))
    mesh.notes = notes
    return Repair(mesh, notes, repaired.pillows, turned)


def _places(count, kept):
    """(count,) new row of each old one, -1 of those that leave."""
    new = np.full(count, -1, np.int64)
    new[kept] = np.arange(len(kept))
    return new


class _Named:
    """Groups by their points, which change their rows."""

    def __init__(self, found):
        faces = {f"Face{number}": np.flatnonzero(found.face_of_quad == number)
                 for number in np.unique(found.face_of_quad[found.face_of_quad > 0]).tolist()}
        self.quads = {name: found.quads[rows][:, :4] for name, rows in {**faces, **found.quad_groups}.items()}
        self.nodes = dict(found.node_groups)

    def renumber(self, new):
        self.quads = {name: new[quads] for name, quads in self.quads.items()}
        self.nodes = {name: np.unique(new[rows][new[rows] >= 0]) for name, rows in self.nodes.items()}

    def contents(self, points):
        groups = [Group(name, FACES_OF, quads) for name, quads in self.quads.items()]
        return Contents(points, {}, groups + [Group(name, NODES, rows) for name, rows in self.nodes.items()])


def _merged(points, hexes, tolerance, named, notes):
    same, count = merged_rows(points, hexes, tolerance)
    broken = collapsed(same[hexes])
    if len(broken):
        raise ToolError(f"a merge tolerance of {tolerance:g} would merge corners of {len(broken)} hexes (listed)",
                        FaultCode.BAD_OPTION, broken)
    if count:
        notes.append(f"{count} points merged with others nearer than {tolerance:g}")
    named.renumber(same)
    return same[hexes]


def _packed(points, hexes, named, notes):
    used, packed = np.unique(hexes, return_inverse=True)
    if len(used) < len(points):
        notes.append(f"{len(points) - len(used)} points that no hex uses were dropped")
    named.renumber(_places(len(points), used))
    return points[used], packed.reshape(hexes.shape).astype(np.int64)


def reversed_hexes(points, hexes):
    """Rows of hexes whose corners are listed the other way round: against their neighbours', or of a whole part whose
    volume is negative so. None of a mesh that cannot be turned at all.

    points (P,3), hexes (H,8+). Cost: one sort of 6 H keys."""
    from scipy.sparse import coo_matrix
    from scipy.sparse.csgraph import connected_components

    count = len(hexes)
    first, second, against = _neighbours(hexes[:, :8], len(points))
    # each hex twice: as it is (row h), and turned (row h + count); two rows hang together if they fit
    rows = np.concatenate([first, first + count])
    columns = np.concatenate([np.where(against, second + count, second), np.where(against, second, second + count)])
    graph = coo_matrix((np.ones(len(rows), np.int8), (rows, columns)), shape=(2 * count, 2 * count))
    _, part = connected_components(graph, directed=False)
    if (part[:count] == part[count:]).any():
        return np.zeros(0, np.int64)
    as_it_is = part[:count] < part[count:]      # one of the two states of a part, the same for all of its hexes
    whole = np.minimum(part[:count], part[count:])
    volumes = np.where(as_it_is, 1.0, -1.0) * _volumes(points, hexes)
    sums = np.bincount(whole, weights=volumes, minlength=2 * count)
    return np.flatnonzero(as_it_is != (sums[whole] >= 0))


def _neighbours(hexes, n_points):
    """Pairs of hexes with a common face: (first (k,), second (k,), against (k,): their corners go round it in one
    sense)."""
    faces = hexes[:, FACES].reshape(-1, 4)
    keys = face_keys(faces, n_points)
    order = np.lexsort((keys[:, 1], keys[:, 0]))
    same = (keys[order][1:] == keys[order][:-1]).all(axis=1)
    a, b = faces[order[:-1][same]], faces[order[1:][same]]
    start = np.argmax(b == a[:, :1], axis=1)
    follows = b[np.arange(len(b)), (start + 1) % 4]
    return order[:-1][same] // 6, order[1:][same] // 6, follows == a[:, 1]


def _volumes(points, hexes):
    """(H,) signed volumes, by the sides' diagonals."""
    centre = points[hexes[:, :8]].mean(axis=1)
    total = np.zeros(len(hexes))
    for face in FACES:
        corners = points[hexes[:, face]] - centre[:, None]
        area = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]) / 2
        total += (area * corners.mean(axis=1)).sum(axis=1) / 3
    return total

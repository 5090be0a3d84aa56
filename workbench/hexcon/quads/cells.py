# SPDX-License-Identifier: LGPL-2.1-or-later
"""From what a mesh file holds to the closed quad surface in it, with its groups."""
from dataclasses import replace

import numpy as np

from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.second_order import STRAIGHT
from hexcon.files.cell_kinds import CORNERS, linear_kind
from hexcon.files.contents import FACES, NODES
from hexcon.files.hex_contents import groups_on, take_cad_faces
from hexcon_native import ErrorCode, HexconError

from . import causes, seams
from .surface import given

# Faces of the volume cells, as corner numbers; their sense is settled by surface.given.
_TRIANGLES = {"tetra": ((0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3)),
              "pyramid": ((0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)),
              "wedge": ((0, 1, 2), (3, 4, 5)), "hexahedron": ()}
_QUADS = {"tetra": (), "pyramid": ((0, 1, 2, 3),),
          "wedge": ((0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)),
          "hexahedron": ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))}


_MIDDLES = ("second-order elements: their mid-side points are dropped; at order 2 those of curved edges of quads come "
            "back")


def surface_of(found, merge_tolerance=None):
    """QuadSurface "given" of files.contents.Contents.

    merge_tolerance  points nearer than this become one, before all else; None: only where the surface is open
                     otherwise, to seams.RELATIVE of its diagonal
    The quad elements are taken if they close; with volume cells present and the quads absent or open, the outer
    faces of the volume cells. Groups of quads on it, and of its points, are its groups.
    Raises ToolError NOT_ALL_QUAD (elements: the triangles), BAD_SHAPE (no cells), BAD_OPTION, and HexconError as
    surface.given, with the cause in words.
    """
    cells, second = _linear(found.cells)
    notes = [*found.notes, *([_MIDDLES] if second else [])]
    merge = seams.Merging(found.points, merge_tolerance)
    volumes = {k: c for k, c in cells.items() if k in _QUADS}
    if "quad" in cells:
        try:
            _refuse_triangles(cells.get("triangle", ()), len(cells["quad"]))
            return _closed(merge, cells["quad"], notes, found)
        except HexconError:
            if not volumes:
                raise
            notes.append("the surface elements do not close by themselves: outer faces of the volume elements taken")
    elif volumes:
        notes.append("no surface elements: outer faces of the volume elements taken")
    else:
        _refuse_triangles(cells.get("triangle", ()), 0)
        raise ToolError("there are neither quads nor volume elements", FaultCode.BAD_SHAPE)
    triangles, quads = outer_faces(volumes)
    _refuse_triangles(triangles, len(quads))
    return _closed(merge, quads, notes, found)


def _linear(cells):
    """({kind of cell_kinds.CORNERS: (k, corners) rows}, whether second-order elements were cut down)."""
    parts, second = {}, False
    for name, rows in cells.items():
        kind, linear = linear_kind(name)
        if kind and len(rows):
            if rows.shape[1] < CORNERS[kind]:
                raise ValueError(f"a {name} with {rows.shape[1]} points")
            second |= not linear
            parts.setdefault(kind, []).append(rows[:, :CORNERS[kind]])
    return {kind: np.concatenate(blocks) for kind, blocks in parts.items()}, second


def outer_faces(volumes):
    """(triangles (t,3), quads (q,4)) that belong to exactly one volume cell."""
    return (_once([c[:, list(f)] for k, c in volumes.items() for f in _TRIANGLES[k]], 3),
            _once([c[:, list(f)] for k, c in volumes.items() for f in _QUADS[k]], 4))


def _once(faces, corners):
    if not faces:
        return np.empty((0, corners), np.int64)
    faces = np.concatenate(faces)
    _, first, counts = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    return faces[np.sort(first[counts == 1])]


def _refuse_triangles(triangles, quads):
    if len(triangles):
        raise ToolError(f"the surface has {len(triangles)} triangles beside {quads} quads; HexCon needs quads only. "
                        "Recombine and subdivide it (gmsh: RefineByQuads), or let hexcon.quads mesh the solid",
                        FaultCode.NOT_ALL_QUAD, range(min(len(triangles), 1000)))


def _closed(merge, quads, notes, found):
    """given(); where the surface is open, once more with points at one place merged, then with the cause in words."""
    same = merge.wanted(quads, notes)
    try:
        return _grouped(given(merge.points, same[quads], notes), same[quads], same, found)
    except HexconError as fault:
        if fault.code is not ErrorCode.NOT_CLOSED or merge.tolerance is not None or not np.isfinite(merge.points).all():
            raise causes.named(fault, merge.points, same[quads]) from fault
        same, told = merge.of_seams(quads)
        if same is None:
            raise causes.named(fault, merge.points, quads) from fault
        try:
            return _grouped(given(merge.points, same[quads], [*notes, told]), same[quads], same, found)
        except HexconError:
            raise causes.named(fault, merge.points, quads) from fault


def _grouped(surface, quads, same, found):
    """The surface with the groups of the file; quads (n,4): those it was made of, by rows of the file's points."""
    points = np.full(len(same), -1, np.int64)
    used = np.unique(quads)
    points[used] = np.arange(len(used))
    cells = {kind: same[rows] for kind, rows in found.cells.items() if rows.size and kind.startswith("quad")}
    groups = [replace(group, rows=same[group.rows]) if group.kind in (FACES, NODES) else group
              for group in found.groups if group.kind in (FACES, NODES) or group.kind in cells]
    moved = replace(found, cells=cells, groups=groups)
    named, nodes, _ = groups_on(quads, moved, len(same))
    surface.middles = _middles(moved, points, found.points)
    surface.quad_groups = take_cad_faces(named, surface.face_of_quad)
    for name, rows in nodes.items():
        rows = points[rows]
        if (rows >= 0).any():
            surface.node_groups[name] = np.unique(rows[rows >= 0])
    return surface


def _middles(found, row_of_point, places):
    """(ends (k,2), places (k,3)) of the edges of 8- and 9-node quads whose middle nodes lie off their middles; None:
    none.

    row_of_point (P,): the surface's row of each point of the file, -1 of none."""
    tables = [found.cells[kind] for kind in ("quad8", "quad9") if kind in found.cells]
    if not tables:
        return None
    quads = np.vstack([table[:, :8] for table in tables])
    ends = np.stack([quads[:, :4], np.roll(quads[:, :4], -1, axis=1)], axis=-1).reshape(-1, 2)
    middle = places[quads[:, 4:].reshape(-1)]
    start, end = places[ends[:, 0]], places[ends[:, 1]]
    curved = np.linalg.norm(middle - (start + end) / 2, axis=1) > STRAIGHT * np.linalg.norm(end - start, axis=1)
    rows = np.sort(row_of_point[ends], axis=1)
    curved &= rows[:, 0] >= 0
    if not curved.any():
        return None
    rows, first = np.unique(rows[curved], axis=0, return_index=True)
    return rows, middle[curved][first]

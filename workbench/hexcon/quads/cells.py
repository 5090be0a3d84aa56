# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a bag of mesh cells to the closed quad surface in it."""
import numpy as np

from hexcon.errors import FaultCode, ToolError
from hexcon.files.cell_kinds import CORNERS
from hexcon_native import ErrorCode, HexconError

from .surface import given

# Faces of the volume cells, as corner numbers; their sense is settled by surface.given.
_TRIANGLES = {"tetra": ((0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3)),
              "pyramid": ((0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)),
              "wedge": ((0, 1, 2), (3, 4, 5)), "hexahedron": ()}
_QUADS = {"tetra": (), "pyramid": ((0, 1, 2, 3),),
          "wedge": ((0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)),
          "hexahedron": ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))}


def surface_from_cells(points, cells, notes=()):
    """QuadSurface "given" from points (P,3) and cells: dict of kind -> (k, corners) point rows.

    The kinds are those of files.cell_kinds.CORNERS.

    The quad elements are taken if they close; with volume cells present and the quads absent or open, the outer
    faces of the volume cells. Coincident points are merged only where the surface is open without.
    Raises ToolError NOT_ALL_QUAD (elements: the triangles), BAD_SHAPE (no cells), and HexconError as surface.given.
    """
    cells = {k: np.asarray(c, np.int64).reshape(-1, CORNERS[k]) for k, c in cells.items() if len(c)}
    for kind, rows in cells.items():
        if len(rows) and (rows.min() < 0 or rows.max() >= len(points)):
            raise ToolError(f"a {kind} names a point that does not exist", FaultCode.FILE_FORMAT)
    notes = list(notes)
    volumes = {k: c for k, c in cells.items() if k in _QUADS}
    if "quad" in cells:
        try:
            _refuse_triangles(cells.get("triangle", ()), len(cells["quad"]))
            return _closed(points, cells["quad"], notes)
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
    return _closed(points, quads, notes)


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


def _closed(points, quads, notes):
    """given(); where the surface is open, once more with coincident points merged."""
    try:
        return given(points, quads, notes)
    except HexconError as fault:
        if fault.code is not ErrorCode.NOT_CLOSED or not np.isfinite(points).all():
            raise
        same = coincident(points)
        if len(np.unique(same)) == len(points):
            raise
        merged = same[quads]
        notes = notes + [f"{len(points) - len(np.unique(same))} points merged with others at the same place"]
        try:
            return given(points, merged, notes)
        except HexconError:
            raise fault from None


def coincident(points):
    """(P,) the first row at the same place as each row, to 1e-9 of the diagonal.

    Rounded to a grid, and to the grid shifted by half a step, so that no pair is lost at a cell's edge.
    """
    points = np.asarray(points, float)
    low = points.min(axis=0)
    step = 2e-9 * max(float(np.linalg.norm(points.max(axis=0) - low)), 1e-300)
    same = np.arange(len(points))
    for shift in np.ndindex(2, 2, 2):
        cell = np.floor((points - low) / step + np.array(shift) / 2.0)
        _, first, inverse = np.unique(cell, axis=0, return_index=True, return_inverse=True)
        lowest = np.full(len(first), len(points))
        np.minimum.at(lowest, inverse.ravel(), same)
        same = np.minimum(same, lowest[inverse.ravel()])
    while not np.array_equal(same, same[same]):
        same = same[same]
    return same

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes that a library reads for us: meshio, VTK, FreeCAD, each in a process of its own."""
from dataclasses import dataclass

import numpy as np

from hexcon.answers import Array, damaged

from . import reading

# The arrays of a mesh on their way back. Blocks of elements follow each other in entries (rows after rows) and tags.
MESH = {"points": Array("f", ("points", 3), finite=False), "kinds": Array("s", ("blocks",)),
        "counts": Array("i", ("blocks",), 0), "widths": Array("i", ("blocks",), 0, 1000),
        "entries": Array("i", ("entries",), 0, "points"), "tags": Array("i", ("rows",)),
        "names": Array("s", ("names",)), "tags_of_names": Array("i", ("names", 2)),
        "boundary_quads": Array("i", ("boundary", 4), 0, "points", optional=True),
        "face_of_quad": Array("i", ("boundary",), optional=True)}


@dataclass
class Cells:
    """A mesh as a file has it, 0-based.

    points  (P,3) float64, perhaps not finite
    blocks  [(kind by meshio's name, rows (k,n) int64 in VTK's order, tags (k,): numbers of groups, 0: none), ...];
            n is 0 for lines, points and polyhedra
    groups  [(name, tag, dimension), ...]
    faces   (quads (q,4), CAD face numbers (q,)) that HexCon wrote beside the cells, or None
    """
    points: np.ndarray
    blocks: list
    groups: list
    faces: tuple | None


def cells_by_meshio(path, progress=None):
    """Cells of .msh .inp .vtk .vtu .obj .mesh, by meshio, or else (.vtk, .vtu) VTK; errors as reading.read."""
    program = "VTK" if path.lower().endswith((".vtk", ".vtu")) else "meshio"
    return _cells("mesh", path, program, progress)


def cells_by_freecad(path, progress=None):
    """Cells of a .med file of hexahedra, by FreeCAD; errors as reading.read."""
    return _cells("med", path, "FreeCAD", progress)


def _cells(reader, path, program, progress):
    found = reading.read(reader, path, MESH, program=program, progress=progress)
    rows, lengths = found["counts"], found["counts"] * found["widths"]
    if lengths.sum() != len(found["entries"]) or rows.sum() != len(found["tags"]):
        raise damaged(program, "its blocks of elements are not as long as they should be")
    blocks = zip(found["kinds"].tolist(), found["widths"].tolist(), rows.tolist(),
                 np.split(found["entries"], np.cumsum(lengths)[:-1]), np.split(found["tags"], np.cumsum(rows)[:-1]))
    faces = (found["boundary_quads"], found["face_of_quad"]) if "face_of_quad" in found else None
    groups = [(name, *tag) for name, tag in zip(found["names"].tolist(), found["tags_of_names"].tolist())]
    return Cells(found["points"], [(k, entries.reshape(n, w), tags) for k, w, n, entries, tags in blocks], groups, faces)

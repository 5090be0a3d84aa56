# SPDX-License-Identifier: LGPL-2.1-or-later
"""The meshio package, whose node order is VTK's."""
import re

import numpy as np

from hexcon.errors import FaultCode, ToolError

from .library import cells_by_meshio

_SOLIDS = {"tetra", "tetra10", "pyramid", "pyramid13", "wedge", "wedge15", "wedge18",
           "hexahedron24", "hexahedron27", "polyhedron"}


def import_meshio(path):
    """The meshio package. Raises ToolError(TOOL_MISSING)."""
    try:
        import meshio
    except ImportError as error:
        raise ToolError(f"{path} needs the Python package meshio (Debian: apt install "
                        "python3-meshio)", FaultCode.TOOL_MISSING) from error
    return meshio


def read_meshio(path, progress=None):
    """(points, hexes, faces) of .msh, .vtu, .vtk, .mesh; see abaqus.read. progress: see reading.read.

    Raises ToolError: FILE_FORMAT, and those of reading.read."""
    return hexes_of_cells(path, cells_by_meshio(path, progress))


def hexes_of_cells(path, cells):
    """(points, hexes, faces) of library.Cells. Raises ToolError(FILE_FORMAT)."""
    found = {"hexahedron": [], "hexahedron20": []}
    for kind, rows, _ in cells.blocks:
        if kind in found:
            found[kind].append(rows)
        elif kind in _SOLIDS or kind.startswith("polyhedron"):
            raise ToolError(f"{path}: {len(rows)} elements of kind {kind}; "
                            "a mesh of hexahedra alone is needed", FaultCode.FILE_FORMAT)
    kinds = [blocks for blocks in found.values() if blocks]
    if len(kinds) != 1:
        raise ToolError(f"{path}: hexahedra of both orders, or none", FaultCode.FILE_FORMAT)
    return cells.points, np.vstack(kinds[0]), _faces(cells)


def _faces(cells):
    """(quads, numbers), or None: what files.vtk writes, or the physical surfaces called
    Face<number> of .msh."""
    if cells.faces is not None:
        return cells.faces
    number = {tag: int(name[4:]) for name, tag, dim in cells.groups
              if dim == 2 and re.match(r"^Face\d{1,9}$", name)}
    quads, numbers = [], []
    for kind, rows, tags in cells.blocks:
        if number and kind in ("quad", "quad8"):
            quads.append(rows[:, :4])
            numbers.append(np.array([number.get(t, 0) for t in tags.tolist()], np.int64))
    return (np.vstack(quads), np.concatenate(numbers)) if quads else None

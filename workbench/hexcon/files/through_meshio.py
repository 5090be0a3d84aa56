# SPDX-License-Identifier: LGPL-2.1-or-later
"""The meshio package, whose node order is VTK's."""
import re

import numpy as np

from hexcon.errors import FaultCode, ToolError

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


def _load(path):
    meshio = import_meshio(path)
    try:
        return meshio.read(path)
    except OSError:
        raise
    except (Exception, SystemExit) as error:  # meshio has many, and ends the process in some
        raise ToolError(f"{path} is not readable: {error}", FaultCode.FILE_FORMAT) from error


def read_meshio(path):
    """(points, hexes, faces) of .msh, .vtu, .vtk, .mesh; see abaqus.read.

    Raises ToolError(FILE_FORMAT)."""
    mesh = _load(path)
    found = {"hexahedron": [], "hexahedron20": []}
    for block in mesh.cells:
        if block.type in found:
            found[block.type].append(np.asarray(block.data, np.int64))
        elif block.type in _SOLIDS or block.type.startswith("polyhedron"):
            raise ToolError(f"{path}: {len(block.data)} elements of kind {block.type}; "
                            "a mesh of hexahedra alone is needed", FaultCode.FILE_FORMAT)
    kinds = [blocks for blocks in found.values() if blocks]
    if len(kinds) != 1:
        raise ToolError(f"{path}: hexahedra of both orders, or none", FaultCode.FILE_FORMAT)
    return np.asarray(mesh.points, float), np.vstack(kinds[0]), _faces(mesh)


def _faces(mesh):
    """(quads, numbers), or None: from the physical surfaces called Face<number> of .msh, or
    from the field data that files.vtk writes."""
    fields = mesh.field_data
    if "boundary_quads" in fields and "face_of_quad" in fields:
        return (np.asarray(fields["boundary_quads"], np.int64).reshape(-1, 4),
                np.asarray(fields["face_of_quad"], np.int64).ravel())
    tags = mesh.cell_data.get("gmsh:physical")
    if not tags:
        return None
    number = {int(tag): int(name[4:]) for name, (tag, dim) in fields.items()
              if dim == 2 and re.match(r"^Face\d+$", name)}
    quads, numbers = [], []
    for block, block_tags in zip(mesh.cells, tags):
        if block.type in ("quad", "quad8"):
            quads.append(np.asarray(block.data, np.int64)[:, :4])
            numbers.append(np.array([number.get(int(t), 0) for t in block_tags]))
    return (np.vstack(quads), np.concatenate(numbers)) if quads else None

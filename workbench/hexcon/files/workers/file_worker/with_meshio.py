# SPDX-License-Identifier: LGPL-2.1-or-later
"""The meshio package, whose node order is VTK's."""
import meshio
import numpy as np

from .mesh import boundary_of, mesh_arrays


def read(path):
    """Arrays of mesh.mesh_arrays. Raises what meshio raises, and SystemExit."""
    mesh = meshio.read(path)
    tags = mesh.cell_data.get("gmsh:physical") or [None] * len(mesh.cells)
    blocks = [(block.type, block.data, block_tags) for block, block_tags in zip(mesh.cells, tags)]
    names = []
    for name, field in mesh.field_data.items():     # of .msh: the tag and the dimension of a group
        field = np.asarray(field)
        if field.shape == (2,) and field.dtype.kind in "iu":
            names.append((str(name), int(field[0]), int(field[1])))
    return mesh_arrays(mesh.points, blocks, names, boundary_of(mesh.field_data))

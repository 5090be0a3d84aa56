# SPDX-License-Identifier: LGPL-2.1-or-later
"""The meshio package, whose node order is VTK's."""
import meshio
import numpy as np

from .mesh import groups_of_fields, joined, mesh_arrays


def read(path):
    """Arrays of mesh.mesh_arrays. Raises what meshio raises, and SystemExit."""
    mesh = meshio.read(path)
    blocks, places = joined([(block.type, block.data) for block in mesh.cells])
    groups = [*_physical(mesh, places), *_sets(mesh, places), *groups_of_fields(mesh.field_data)]
    return mesh_arrays(mesh.points, blocks, groups)


def _physical(mesh, places):
    """Groups of .msh: names by tag and dimension, tags of the cells."""
    names = {}
    for name, field in mesh.field_data.items():
        field = np.asarray(field)
        if field.shape == (2,) and field.dtype.kind in "iu":
            names[int(field[0]), int(field[1])] = str(name)
    for (kind, first), tags in zip(places, mesh.cell_data.get("gmsh:physical") or ()):
        dimension = 2 if kind.startswith(("quad", "triangle")) else 3
        for tag in np.unique(tags).tolist():
            if (tag, dimension) in names:
                yield names[tag, dimension], kind, first + np.flatnonzero(np.asarray(tags) == tag)


def _sets(mesh, places):
    for name, ids in mesh.point_sets.items():
        yield str(name), "nodes", np.asarray(ids)
    for name, by_block in mesh.cell_sets.items():
        if str(name).startswith("gmsh:"):   # of meshio's own making
            continue
        for (kind, first), rows in zip(places, by_block):
            if rows is not None and len(rows):
                yield str(name), kind, first + np.asarray(rows)

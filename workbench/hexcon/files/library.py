# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes that a library reads for us: gmsh, meshio, VTK, FreeCAD, each in a process of its own."""
import numpy as np

from hexcon.answers import Array, damaged

from . import reading
from .contents import FACES, NODES, Contents, Group

# The arrays of a mesh on their way back. Blocks of elements follow each other in entries (rows after rows), groups in
# members (points, corners of faces, or rows of the block whose kind a group names).
MESH = {"points": Array("f", ("points", 3), finite=False), "kinds": Array("s", ("blocks",)),
        "counts": Array("i", ("blocks",), 0), "widths": Array("i", ("blocks",), 0, 1000),
        "entries": Array("i", ("entries",), 0, "points"),
        "group_names": Array("s", ("groups",)), "group_kinds": Array("s", ("groups",)),
        "group_counts": Array("i", ("groups",), 0), "members": Array("i", ("members",), 0), "notes": Array("s", ("notes",))}


def contents_by(reader, path, program, progress=None):
    """contents.Contents of a file by a reader of the file worker; program: who reads, for words. Errors as
    reading.read."""
    found = reading.read(reader, path, MESH, program=program, progress=progress)
    kinds, rows, lengths = found["kinds"].tolist(), found["counts"], found["counts"] * found["widths"]
    if lengths.sum() != len(found["entries"]) or len(set(kinds)) != len(kinds) \
            or found["group_counts"].sum() != len(found["members"]):
        raise damaged(program, "its blocks of elements, or groups, are not as long as they should be")
    blocks = np.split(found["entries"], np.cumsum(lengths)[:-1])
    cells = {kind: block.reshape(count, width)
             for kind, block, count, width in zip(kinds, blocks, rows.tolist(), found["widths"].tolist())}
    members = np.split(found["members"], np.cumsum(found["group_counts"])[:-1])
    groups = [Group(name, kind, ids) for name, kind, ids
              in zip(found["group_names"].tolist(), found["group_kinds"].tolist(), members)]
    for group in groups:
        below = len(found["points"]) if group.kind in (NODES, FACES) else len(cells.get(group.kind, ()))
        if len(group.rows) and group.rows.max() >= below or group.kind == FACES and len(group.rows) % 4:
            raise damaged(program, f"group {group.name!r} names what is not there")
    return Contents(found["points"], cells, groups, [str(note) for note in found["notes"]])

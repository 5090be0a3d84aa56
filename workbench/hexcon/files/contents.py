# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a mesh file holds, whatever its format: what every reader returns, and meshes and surfaces are made from."""
from dataclasses import dataclass, field

import numpy as np

NODES, FACES = "nodes", "faces"     # kinds of groups that are not of cells


@dataclass
class Group:
    """A named group: of points (kind NODES, rows (k,)), of faces by their corners (kind FACES, rows (k,4)), or of cells
    (kind: that of the cells, rows (k,) of Contents.cells)."""

    name: str
    kind: str
    rows: np.ndarray


@dataclass
class Contents:
    """A mesh as a file has it, 0-based.

    points  (P,3) float64
    cells   {kind by meshio's name: (k,n) rows of points, in VTK's order}; n is 0 for lines, points and polyhedra
    groups  [Group, ...]
    notes   what the user should know: units converted, what was passed over
    counts  {name of a kind of elements in the file: how many}, where the reader knows all that there are
    converted  the file told its unit of length, and the points are in mm
    """

    points: np.ndarray
    cells: dict
    groups: list = field(default_factory=list)
    notes: list = field(default_factory=list)
    counts: dict = field(default_factory=dict)
    converted: bool = False

    def corners_of(self, group):
        """(k,4) corners of a group's quads; none for groups of nodes and of what is no quad."""
        if group.kind == FACES:
            return np.asarray(group.rows, np.int64).reshape(-1, 4)
        if group.kind in ("quad", "quad8", "quad9"):
            return self.cells[group.kind][group.rows][:, :4]
        return np.zeros((0, 4), np.int64)

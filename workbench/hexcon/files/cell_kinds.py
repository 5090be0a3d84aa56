# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kinds of cells that a mesh of any file is read as: by their corners."""

CORNERS = {"triangle": 3, "quad": 4, "tetra": 4, "pyramid": 5, "wedge": 6, "hexahedron": 8}


def linear_kind(name):
    """("quad", False) for quad8 and so on; (None, True) for points and lines."""
    for kind in CORNERS:
        if name == kind:
            return kind, True
        if name.startswith(kind) and name[len(kind):].isdigit():
            return kind, False
    return None, True

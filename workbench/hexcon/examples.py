# SPDX-License-Identifier: LGPL-2.1-or-later
"""The small surfaces of the literature, by name. They are read with numpy alone: no meshio, no VTK.

The files are resources/examples/surfaces/*.obj; tests/python/example_surfaces.py makes them.
"""
import os

import numpy as np

from .errors import FaultCode, ToolError
from .quads.surface import given

FOLDER = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))),
                      "resources", "examples", "surfaces")

# What each is and whose problem, in the order in which they are listed.
ABOUT = {
    "schneiders": "Schneiders' pyramid: edges split, 4 quads below and 3 on each side (R. Schneiders)",
    "octahedron": "Quadrilateral octahedron: the tetragonal trapezohedron, one loop (D. Eppstein)",
    "eppstein-16": "Eppstein's cube with sides of 3, 2, 2 and 2 quads, of the size in the paper (D. Eppstein)",
    "eppstein-18": "Eppstein's cube with sides of 3, 3, 3 and 2 quads (D. Eppstein)",
    "eppstein-20": "Eppstein's cube with sides of 4, 3, 3 and 3 quads (D. Eppstein)",
    "eppstein-22": "Eppstein's cube with sides of 4, 4, 4 and 3 quads (D. Eppstein)",
}

__all__ = ["ABOUT", "FOLDER", "example", "example_names"]


def example_names():
    """The names that example knows, a list of str."""
    return list(ABOUT)


def example(name):
    """The example surface of that name, a quads.QuadSurface "given", outward, 1 to 2 units across.

    Raises ToolError: BAD_OPTION for another name (says which there are), FILE_IO where HexCon's folder
    resources is missing.
    """
    if name not in ABOUT:
        raise ToolError(f"there is no example {name!r}; there are {', '.join(ABOUT)}", FaultCode.BAD_OPTION)
    path = os.path.join(FOLDER, f"{name}.obj")
    try:
        with open(path, encoding="utf-8") as stream:
            points, quads = _read_obj(stream)
    except OSError as error:
        raise ToolError(f"cannot read {path}: {error.strerror or error}; HexCon's folder resources belongs beside "
                        "its folder workbench", FaultCode.FILE_IO) from error
    return given(points, quads, [])


def _read_obj(lines):
    """(points (V,3), quads (n,4) 0-based) of the plain .obj that the examples are: only v and f lines count."""
    points, quads = [], []
    for kind, *words in filter(None, map(str.split, lines)):
        if kind == "v":
            points.append([float(word) for word in words])
        elif kind == "f":
            quads.append([int(word) - 1 for word in words])
    return np.array(points), np.array(quads)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quad surfaces: from a solid (gmsh in a subprocess), from a file, from a FreeCAD object."""
from .documents import surface_from_object
from .files import surface_from_file
from .gmsh_worker.methods import METHOD_TABLE, METHODS
from .solids import surface_from_solid
from .surface import QuadSurface

__all__ = ["METHODS", "METHOD_TABLE", "QuadSurface", "surface_from_file", "surface_from_object", "surface_from_solid"]

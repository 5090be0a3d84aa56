# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tetrahedra inside a closed triangulated surface whose triangles are kept (gmsh in a subprocess)."""
from .fill import tetrahedralise

__all__ = ["tetrahedralise"]

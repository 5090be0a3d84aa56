# SPDX-License-Identifier: LGPL-2.1-or-later
"""What runs inside the gmsh subprocess for curved edges: `python -m curving_worker JOB.json`."""

STRAIGHT, ON_FACE, ON_EDGE = 0, 1, 2     # what becomes of the middle of an edge of the boundary

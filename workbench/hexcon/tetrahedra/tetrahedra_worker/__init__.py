# SPDX-License-Identifier: LGPL-2.1-or-later
"""What runs inside the gmsh subprocess for tetrahedra: `python -m tetrahedra_worker JOB.json`.

Only numpy, SciPy, gmsh and the quads' gmsh_worker (session, fault, link) are imported here, nothing of HexCon.
"""

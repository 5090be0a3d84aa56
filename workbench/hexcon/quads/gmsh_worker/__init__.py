# SPDX-License-Identifier: LGPL-2.1-or-later
"""What runs inside the gmsh subprocess: `python -m gmsh_worker JOB.json`.

Only numpy and gmsh are imported here, nothing of HexCon and nothing of FreeCAD: the
interpreter that has gmsh need not be the one HexCon runs in.
"""

# SPDX-License-Identifier: LGPL-2.1-or-later
"""One mesh in every format that needs no FreeCAD, and read back."""
import os
import tempfile

import hexcon
from hexcon.files import READERS, WRITERS, read_mesh

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
mesh = hexcon.mesh_solid(os.path.join(ROOT, "resources", "examples", "box.step"), 5.0)
print(f"{len(mesh.hexes)} hexes, {len(mesh.quads)} quads on {len(set(mesh.face_of_quad.tolist()))} CAD faces")
with tempfile.TemporaryDirectory() as folder:
    for ending in (".inp", ".msh", ".vtu", ".vtk", ".unv"):
        path = os.path.join(folder, "box" + ending)
        hexcon.write(mesh, path)
        read = read_mesh(path)
        size = os.path.getsize(path)
        print(f"{ending}  {size:7d} bytes, read back: {len(read.points)} points, {len(read.hexes)} hexes")
    for ending in (".re2", ".exo", ".specfem3d"):
        hexcon.write(mesh, os.path.join(folder, "box" + ending))
    print(f"for solvers:  {', '.join(sorted(os.listdir(folder)))}")
print(f"written only: {', '.join(sorted(set(WRITERS) - set(READERS)))}")

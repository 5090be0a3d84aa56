# SPDX-License-Identifier: LGPL-2.1-or-later
"""A solid from a STEP file to second-order hexes in a file: python3 solid.py [PART.step [SIZE [OUT]]]"""
import os
import sys
import tempfile

import hexcon

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
part, size, out = (sys.argv[1:] + [None] * 3)[:3]
part = part or os.path.join(ROOT, "resources", "examples", "wedge.step")
mesh = hexcon.mesh_solid(part, float(size or 4), order=2)
print(f"surface       {len(mesh.quads)} quads by {mesh.surface.method}")
for note in mesh.surface.notes:
    print(f"              {note}")
print(f"mesh          {len(mesh.hexes)} hexes of {mesh.hexes.shape[1]} nodes by {mesh.method}, {mesh.quality}")
print(f"certificate   {mesh.certificate}")
print(f"CAD faces     {len(set(mesh.face_of_quad.tolist()))}; quads on each: "
      + ", ".join(f"Face{k} {(mesh.face_of_quad == k).sum()}" for k in sorted(set(mesh.face_of_quad.tolist()))))
with tempfile.TemporaryDirectory() as folder:
    path = out or os.path.join(folder, "part.inp")
    hexcon.write(mesh, path)
    print(f"written       {os.path.basename(path)}, {os.path.getsize(path)} bytes")

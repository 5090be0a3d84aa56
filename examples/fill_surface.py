# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fill a quad surface that is yours: arrays in, arrays out, no other program."""
from grids import box_surface

import hexcon_native as hn

points, quads = box_surface(4, 3, 2)
facts = hn.check_surface(points, quads)
print(f"surface       {facts.n} quads, genus {facts.genus}, {facts.loops}; hexes can fill it: {facts.fillable}")

mesh = hn.mesh(points, quads)
print(f"mesh          {len(mesh.hexes)} hexes by method {mesh.method}, {mesh.quality}")
print(f"certificate   {mesh.certificate}")
kept = mesh.points[:len(points)].tobytes() == points.tobytes()
print(f"your points   the first {len(points)} rows, bit for bit: {kept}")
for line in mesh.report["log"]:
    print(f"tried         {line}")

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prove anybody's hex mesh, or see what is wrong with it, and where."""
from grids import box

import hexcon_native as hn

points, hexes, quads = box(3, 3, 3)
print(f"as it is       {hn.certify(points, hexes, quads)}")

middle = hexes[13][0]           # a corner of the hex in the middle
points[middle] += (0.9, 0.9, 0.9)
found = hn.certify(points, hexes, quads)
print(f"a point pushed {found}")
for hex_id, place in zip(found.nonpositive, found.witnesses):
    print(f"               hex {hex_id}: its Jacobian is not positive at {place.round(3)} of its unit cube")

found = hn.certify(points, hexes[1:], quads)
print(f"a hex missing  boundary exact: {found.boundary_exact}")

# SPDX-License-Identifier: LGPL-2.1-or-later
"""What HexCon refuses, what it says of it, and what can be done."""
import numpy as np
from grids import box_surface

import hexcon_native as hn


def tell(what, call):
    try:
        print(f"{what}: {call()}")
    except hn.HexconError as fault:
        print(f"{what}\n    {fault.code.name}: {fault}")
        print(f"    listed: {fault.code.listed or 'nothing'}: {fault.elements[:8]}")
        print(f"    to do:  {fault.code.advice}")


points, quads = box_surface(3, 3, 3)
tell("a surface with a hole in it", lambda: hn.mesh(points, quads[1:]))

turned = quads.copy()
turned[5] = turned[5, ::-1]
tell("a quad that faces the other way", lambda: hn.mesh(points, turned))

pushed = points.copy()
top = np.flatnonzero((points == (1, 1, 3)).all(axis=1))
pushed[top] -= (0, 0, 4)        # through the bottom
tell("a surface that crosses itself", lambda: hn.mesh(pushed, quads))

tell("a grid, by the method for subdivided surfaces", lambda: hn.mesh(points, quads, "diced"))
tell("an option for another method", lambda: hn.mesh(points, quads, "swept", layers=2))

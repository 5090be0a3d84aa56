# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of a solid as solids of gmsh models of their own: what is outside of boxes, what is inside of one."""
import contextlib

import gmsh

from .. import cad
from ..layered.fault import NotLayered


@contextlib.contextmanager
def outside(path, boxes):
    """[cad.Solid] of what boxes leave of the solid of a file, in a model of their own while they last."""
    with cad.other_model("part"):
        solid = gmsh.model.occ.importShapes(path)
        yield _parts(solid, [tag for box in boxes for tag in box.blocks()], gmsh.model.occ.cut)


@contextlib.contextmanager
def inside(path, box, outline):
    """[cad.Solid] of what lies in a box; outline (n,2): points on its sides at which their faces are split."""
    with cad.other_model("part"):
        solid = gmsh.model.occ.importShapes(path)
        yield _parts(solid, [box.prism(outline, *box.ends)], gmsh.model.occ.intersect)


def _parts(solid, tools, operation):
    try:
        operation(solid, [(3, tag) for tag in tools])
    except Exception as error:      # gmsh raises Exception itself
        raise NotLayered(f"Open CASCADE does not cut it: {error}") from error
    gmsh.model.occ.synchronize()
    return [cad.Solid(tag) for _, tag in gmsh.model.getEntities(3)]

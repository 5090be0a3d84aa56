# SPDX-License-Identifier: LGPL-2.1-or-later
"""A layered solid with blends: its mesh as if corners were sharp, with sheets under them, brought on to the CAD."""
import numpy as np

import hexcon_native as hn

from ..grid.captured import face_pairs
from ..grid.features import EVERY_EDGE, Cad, Features
from ..grid.placement import placed
from ..grid.sheets import insert
from ..grid.sliding import Sliding
from ..layered.extrude import LayeredMesh
from ..layered.fault import NotLayered
from ..layered.roles import PARALLEL, Role
from .find import blends
from .on_cad import captured
from .sharp import SharpStanding
from .skins import skins

LEAST = 0.4             # of the size: blends that reach less far are caps like others,
LEAST_CONVEX = 0.7      # and convex ones, if none of them reaches farther: sheets take more hexes than they are worth
CAPS = (Role.UP, Role.DOWN)
PASSES, MEAN_PASSES = 9, 4      # of hexcon_native.relax


class Blends:
    """Of one roles.Shape, for all directions and sizes."""

    def __init__(self, shape, size):
        self.shape, self.size = shape, size
        self._cad = None

    def along(self, direction, size, steep=PARALLEL):
        """[find.Blend] that reach far enough for elements of a size to be worth it."""
        roles = self.shape.roles(direction, steep)
        if Role.NONE in roles.values() or not any(self._is_curved(f) for f, role in roles.items() if role in CAPS):
            return []
        if self._cad is None:
            self._cad = Cad(self.shape.solid, self.size)
        found = [b for b in blends(self._cad, roles, direction) if b.reach > LEAST * size]
        worth = any(b.convex and b.reach > LEAST_CONVEX * size for b in found)
        return [b for b in found if worth or not b.convex]

    def _is_curved(self, face):
        return self.shape.carriers[face].kind != "Plane"

    def mesh(self, direction, size, link, steep=PARALLEL, field=None):
        """The extrude.LayeredMesh along a direction with its blends by sheets, in place, but for inner points, which
        are not yet at their best. steep, field: as layered_mesh takes them. Raises NotLayered."""
        found = self.along(direction, size, steep)
        mesh = SharpStanding(self.shape, direction, size, steep, found).mesh(link, field=field)
        try:
            return self._on_cad(mesh, found, link)
        except (ValueError, hn.HexconError) as fault:
            raise NotLayered(str(fault)) from fault

    def _on_cad(self, mesh, found, link):
        """The LayeredMesh with sheets under blends, its boundary on the CAD. ValueError where a sheet, or a curve of
        the CAD, finds no way."""
        link.progress("slide", 0.0)
        features = Features(self._cad, EVERY_EDGE)
        rough = captured(mesh, features)
        convex = [b for b in found if b.convex]
        full = _with_skins(rough, skins(mesh, rough, convex, features.patch_of_face))
        sliding = Sliding(full, features)
        points = placed(full, features, sliding)
        points = sliding.relax(points, (True, False), passes=PASSES, mean_passes=MEAN_PASSES, threads=1)
        faces = np.array([features.patches[p].faces[0] for p in full.patch])
        return LayeredMesh(points, full.hexes, full.quads, faces, mesh.rings, mesh.levels, mesh.flat, mesh.plane,
                           mesh.aslant, blends=sum(len(b.faces) for b in found))


def _with_skins(mesh, found):
    """The CapturedMesh with a sheet for each Skin."""
    for number, skin in enumerate(found):
        before = len(mesh.quads), len(mesh.hexes)
        mesh = insert(mesh, skin.pulled, skin.covered)
        for later in found[number + 1:]:
            _extend(later, mesh, *before)
    return mesh


def _extend(skin, mesh, quads, hexes):
    """Tell a Skin of the hexes and the quads that another sheet has brought, which come after so many."""
    _, inner, _ = face_pairs(mesh.hexes, len(mesh.points))
    pairs = np.concatenate([inner, inner[:, ::-1]]) // 6
    pulled = np.zeros(len(mesh.hexes), bool)
    pulled[:hexes] = skin.pulled
    new = pairs[(pairs[:, 0] >= hexes) & (pairs[:, 1] < hexes)]
    pulled[new[skin.pulled[new[:, 1]], 0]] = True
    covered = np.zeros(len(mesh.quads), bool)
    covered[:quads] = skin.covered
    twin = mesh.half_edges.twin // 4
    for q in range(quads, len(mesh.quads)):
        beside = twin[4 * q:4 * q + 4]
        covered[q] = (covered[beside] & (mesh.patch[beside] == mesh.patch[q])).any()
    skin.pulled, skin.covered = pulled, covered & pulled[mesh.under]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Natural hexes in what rooms leave, at twice the size: every one is cut in eight afterwards."""
import time

import hexcon_native as hn

from ..boxed.features import features
from ..boxed.mesh import boxed_mesh
from ..layered.fault import NotLayered
from ..layered.mesh import layered_mesh
from ..layered.roles import Role
from ..layered.tries import DIRECTIONS, POOR, named

TRIED = 2       # directions of a kind
LEAST = 0.1     # scaled Jacobian
FACTORS = (1.0, 0.7)    # of twice the size


def natural(shape, skin, size, link, end):
    """(mesh with points, hexes, quads, faces; words about it) of a part of a solid, in the current gmsh model.

    The first one that is not poor, or the best. Raises NotLayered.
    """
    layered, boxed, told = _directions(shape)
    best = None
    for factor in FACTORS:
        coarse = 2.0 * size * factor
        for word, direction in [("layered", d) for d in layered] + [("boxed", d) for d in boxed]:
            if time.process_time() > end:
                break
            try:
                mesh = layered_mesh(shape, direction, coarse, link) if word == "layered" else \
                    boxed_mesh(shape, skin, direction, coarse, link, end)
            except NotLayered as fault:
                told.append(f"{word} along {named(direction)}: {fault}")
                continue
            mesh.points = hn.optimize(mesh.points, mesh.hexes, rounds=1, target=POOR, threads=1)
            least = hn.quality(mesh.points, mesh.hexes).min
            if least > POOR:
                return mesh, f"{word} along {named(direction)}"
            told.append(f"{word} along {named(direction)}: least scaled Jacobian {least:.3f}")
            if least > LEAST and (best is None or least > best[0]):
                best = least, mesh, f"{word} along {named(direction)}"
    if best is None:
        raise NotLayered("what is beside a room is not natural: " + ("; ".join(told[:4]) or "no time left"))
    return best[1:]


def _directions(shape):
    """(those along which all may be layered, those across which features lie; what stands against others)."""
    plain, across, told = [], [], []
    for direction in shape.directions(DIRECTIONS):
        roles = shape.roles(direction)
        if Role.NONE not in roles.values():
            plain.append(direction)
            continue
        try:
            features(shape, direction, roles)
            across.append(direction)
        except NotLayered as fault:
            told.append(f"along {named(direction)}: {fault}")
    return plain[:TRIED], across[:TRIED], told

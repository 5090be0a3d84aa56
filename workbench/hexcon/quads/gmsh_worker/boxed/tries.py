# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface method boxed: directions and sizes are tried until hexes come out that are certified and good."""
import time

from ..fault import WorkerFault
from ..layered.roles import Role, Shape
from ..layered.tries import judged, least_of, search, surface_of
from .features import features
from .mesh import boxed_mesh
from .whole import Skin

TRIED = 2           # directions
FACTORS = (1.0, 0.62)   # parts of the size
MOST_CROSS = 0.5    # part of the area that features across the layers may have
MOST_FEATURES = 24
SHARE = 0.2         # of the time limit, in processor time: no try is begun then


def boxed_surface(solid, size, link, timeout, care=0):
    """Quads on a solid that is layered but for round holes and bosses across the layers.

    timeout: seconds for all of the surface; care: above 0 another size was tried before, with smaller ones
    Returns a dict of points (V,3), quads (n,4), faces (n,), hexes (H,8) and notes. Raises WorkerFault NOT_BOXED.
    """
    if care:
        raise WorkerFault("NOT_BOXED", "boxes were tried at larger sizes, down to parts of this one")
    begun = time.process_time()
    shape = Shape(solid, size)
    directions, against = least_of(shape, _across, TRIED, "none lies across")
    if not directions:
        raise WorkerFault("NOT_BOXED", f"no direction in which only round holes and bosses lie across: {against}")
    skin = Skin(solid)
    end = begun + SHARE * timeout
    best, faults = search(directions, lambda direction, factor: judged(
        shape, boxed_mesh(shape, skin, direction, size * factor, link, end), direction, factor), end, FACTORS)
    if best is None:
        raise WorkerFault("NOT_BOXED", "; ".join(faults) or "no time left")
    boxes = best.mesh.boxes
    return surface_of(best, faults, "boxed", f"{boxes} box{'es' * (boxes > 1)}, ")


def _across(shape, direction):
    """Part of the area that lies across; None where it is too much, or there is none. Raises NotLayered."""
    roles = shape.roles(direction)
    part = shape.part(f for f, role in roles.items() if role is Role.NONE)
    return part if 0 < len(features(shape, direction, roles)) <= MOST_FEATURES and part < MOST_CROSS else None

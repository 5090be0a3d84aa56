# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface method filled: rooms and sizes are tried until hexes come out that are certified."""
import time

import hexcon_native as hn

from ..boxed.whole import Skin
from ..fault import WorkerFault
from ..layered.fault import NotLayered
from ..layered.roles import Shape
from ..smooth import evenness
from .mesh import filled_mesh
from .rooms import rooms_of

FACTORS = (1.0, 0.7)
LEAST = 0.05        # scaled Jacobian
ROUNDS, TARGET = 1, 0.2     # of improving what is worst; the parts are improved already
SHARE = 0.25        # of the time limit, in processor time: no try is begun then
MOST_ROOMS = 12


def filled_surface(solid, size, link, timeout, care=0):
    """Quads on a solid, of which rooms are filled where round faces meet in ways that no layers have.

    timeout: seconds for all of the surface; care: above 0 another size was tried before
    Returns a dict of points (V,3), quads (n,4), faces (n,), hexes (H,8) and notes. Raises WorkerFault NOT_FILLED.
    """
    if care:
        raise WorkerFault("NOT_FILLED", "rooms were tried at larger sizes, down to parts of this one")
    end = time.process_time() + SHARE * timeout
    shape, skin, told = Shape(solid, size), Skin(solid), []
    for factor in FACTORS:
        for wide in (False, True):
            rooms = rooms_of(shape, factor * size, wide)
            if not rooms or len(rooms) > MOST_ROOMS:
                raise WorkerFault("NOT_FILLED", f"{len(rooms)} places where round faces meet as no layers do")
            if time.process_time() > end:
                break
            try:
                return _judged(filled_mesh(shape, skin, rooms, factor * size, link, end), factor, told)
            except (NotLayered, WorkerFault) as fault:
                told.append(f"{'wide' if wide else 'narrow'} rooms at {factor:g} of the size: {fault}")
    raise WorkerFault("NOT_FILLED", "; ".join(told) or "no time left")


def _judged(mesh, factor, told):
    mesh.points = hn.optimize(mesh.points, mesh.hexes, rounds=ROUNDS, target=TARGET, threads=1)
    proof, quality = hn.certify(mesh.points, mesh.hexes, mesh.quads), hn.quality(mesh.points, mesh.hexes)
    if not proof.certified or quality.min < LEAST:
        raise NotLayered(f"least scaled Jacobian {quality.min:.3f}" if proof.certified else "not certified")
    part = "" if factor == 1.0 else f" at {factor:g} of the size"
    natural = len(mesh.hexes) - mesh.filler_hexes
    methods = " and ".join(sorted(set(mesh.methods)))
    return {"points": mesh.points, "quads": mesh.quads, "faces": mesh.faces, "hexes": mesh.hexes,
            "notes": [f"filled{part}: {', '.join(mesh.parts)}, {natural} hexes; filler {100 * mesh.filler:.0f} % of "
                      f"the volume, {mesh.filler_hexes} hexes by {methods} in {mesh.rooms} "
                      f"room{'s' * (mesh.rooms > 1)}; edges of a quad up to 1 to "
                      f"{1.0 / evenness(mesh.points, mesh.quads).min():.1f}",
                      *(f"filled: {one}" for one in told)]}

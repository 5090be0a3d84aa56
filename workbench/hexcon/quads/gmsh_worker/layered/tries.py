# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface method layered: directions and sizes are tried until hexes come out that are certified and good."""
import time
from dataclasses import dataclass
from functools import partial

import numpy as np

import hexcon_native as hn

from ..blends.mesh import Blends
from ..cad_fit import volume_and_area
from ..fault import WorkerFault
from ..smooth import evenness
from .fault import NotLayered
from .mesh import layered_mesh
from .roles import PARALLEL, Role, Shape
from .slid import slid

DIRECTIONS, TRIED = 12, 3       # directions looked at; those of them that are tried
FACTORS = (1.0, 0.8, 0.62)      # parts of the size
LEAST, POOR, GOOD = 0.15, 0.3, 0.6      # scaled Jacobian: refused below; smaller sizes are tried; nothing else is tried
ASLANT = 1e-3                   # what area of a side counts that is not along a direction, beside that of a cap
ROUNDS = 3                      # of improving the inside here; who fills the surface goes on
HOPELESS = 0.05                 # a direction with a worse scaled Jacobian is not tried with smaller sizes
ENOUGH = 0.7                    # of the scaled Jacobian that corners of the outlines allow: smaller is not better
MOST_SLANTED = 0.6              # part of the area that may lie neither across a direction nor along it
STEEPS = (*np.sin(np.radians((30.0, 50.0))), PARALLEL)  # sines of angles: up to them faces aslant are sides, in turn
SHARE = 0.3                     # of the time limit, in processor time: no try is begun then
MOST_VOLUME = 0.12              # part by which the volume may be off before round faces get more quads


@dataclass
class Layered:
    """mesh: extrude.LayeredMesh with its inner points at their best; volume: relative to the solid's, less 1;
    direction: (3,); factor: part of the size."""

    mesh: object
    quality: object
    certified: bool
    volume: float
    direction: np.ndarray
    factor: float

    @property
    def good(self):
        return self.certified and abs(self.volume) <= MOST_VOLUME and self.quality.min >= LEAST

    def enough(self, least):
        """Whether its worst scaled Jacobian is this, or as good as the outlines allow."""
        return self.quality.min > min(least, ENOUGH * self.mesh.flat.limit)

    @property
    def rank(self):
        """The greater, the better. Quads up to three times as long as wide count as even, as in smooth.merit."""
        worst = min(self.quality.min, 3.0 * float(evenness(self.mesh.points, self.mesh.quads).min()))
        return self.good, min(worst, POOR), self.factor, worst, self.quality.mean


def layered_surface(solid, size, link, timeout, sizes, care=0):
    """Quads on a solid all of whose faces lie across a direction, along it, or are seen from it everywhere.

    timeout: seconds for all of the surface; sizes: SizeField by place, at most `size`
    care: above 0 another size was tried before, with smaller ones
    Returns a dict of points (V,3), quads (n,4), faces (n,), hexes (H,8) and notes. Raises WorkerFault NOT_LAYERED.
    """
    if care:
        raise WorkerFault("NOT_LAYERED", "layers were tried at larger sizes, down to parts of this one")
    begun = time.process_time()
    shape = Shape(solid, size)
    directions, refused = least_of(shape, _slanted, TRIED, "no face has an axis")
    if not directions:
        raise WorkerFault("NOT_LAYERED", "no direction in which every face lies across it, along it, or is seen from "
                          f"it: {refused}")
    blends, told = Blends(shape, size), []
    best, faults = search(directions, lambda direction, factor: _meshed(
        blends, direction, size, factor, link, sizes, told), begun + SHARE * timeout)
    if best is None:
        raise WorkerFault("NOT_LAYERED", "; ".join(told + faults) or "no time left")
    aslant, sheets = best.mesh.aslant, best.mesh.blends
    what = f"{aslant} drafted face{'s' * (aslant > 1)} as sides, " if aslant else ""
    what += f"{sheets} blend{'s' * (sheets > 1)} by sheets, " if sheets else ""
    return surface_of(best, told + faults, "layered", what)


def _meshed(blends, direction, size, factor, link, sizes, told):
    """The Layered along a direction, with faces as sides up to the first of STEEPS with which it is good.

    blends: Blends of the solid: by sheets, or caps where that cannot be had; told: list of words why not
    """
    known, best, fault = [], None, None
    for steep in STEEPS:
        roles = blends.shape.roles(direction, steep)
        if roles in known or Role.NONE in roles.values():
            continue
        known.append(roles)
        for by_sheets in (True, False)[not blends.along(direction, size * factor, steep):]:
            try:
                mesh = (blends.mesh if by_sheets else partial(layered_mesh, blends.shape))(
                    direction, size * factor, link, steep, sizes.scaled(factor))
                if mesh.aslant and not mesh.blends:
                    mesh.points = slid(blends.shape, mesh)
                found = judged(blends.shape, mesh, direction, factor)
            except NotLayered as error:
                words = f"along {named(direction)}, blends by sheets: {error}"
                told += [words] if by_sheets and words not in told else []
                fault = fault or error
                continue
            if best is None or found.rank > best.rank:
                best = found
            if best.good and best.enough(POOR):
                return best
    if best is None:
        raise fault
    return best


def search(directions, attempt, end, factors=FACTORS):
    """(The best Layered, or None; what stands against others, in words).

    attempt: callable (direction, part of the size) -> Layered, may raise NotLayered; end: of processor time
    """
    best, faults, hopeless = None, [], set()
    for factor in factors:
        for number, direction in enumerate(directions):
            if number in hopeless:
                continue
            if time.process_time() > end:
                break
            try:
                found = attempt(direction, factor)
            except NotLayered as fault:
                faults.append(f"along {named(direction)} at {factor:g} of the size: {fault}")
                hopeless |= {number} if fault.faces else set()
                continue
            faults += _shortcomings(found)
            hopeless |= {number} if found.quality.min < HOPELESS else set()
            if found.good and (best is None or found.rank > best.rank):
                best = found
            if best is not None and best.enough(GOOD):
                break
        if best is not None and best.enough(POOR):
            break
    return best, faults


def least_of(shape, part_of, most, otherwise):
    """(At most so many directions, those with the least part of the area; what stands against others, or otherwise).

    part_of: callable (roles.Shape, direction) -> part of the area, None: it is none; NotLayered, with words, the same
    """
    found, against = [], []
    for direction in shape.directions(DIRECTIONS):
        try:
            part = part_of(shape, direction)
        except NotLayered as fault:
            against.append(str(fault))
            continue
        if part is not None:
            found.append((round(part, 6), len(found), direction))
    found.sort(key=lambda row: row[:2])
    return [d for *_, d in found][:most], "; ".join(against[:3]) or otherwise


def _slanted(shape, direction):
    """Part of the area that is of caps not across, and a little for sides not along. Raises NotLayered where there is
    too much of that, or a face hangs over."""
    roles = shape.roles(direction, max(STEEPS))
    bad = [f for f, role in roles.items() if role is Role.NONE]
    slanted = [f for f, n in shape.normals.items() if roles[f] in (Role.UP, Role.DOWN)
               and np.abs(n @ direction).min() < 1.0 - 1e-8]
    part = shape.part(slanted)
    if bad or part > MOST_SLANTED:
        raise NotLayered(f"along {named(direction)} " + ", ".join(f"Face{f}" for f in (bad or slanted)[:8]))
    return part + ASLANT * shape.part(shape.aslant(direction, roles))


def named(direction):
    """A direction in words."""
    k = int(np.argmax(np.abs(direction)))
    if abs(direction[k]) > 1.0 - 1e-8:
        return "xyz"[k]
    return "(" + ", ".join(f"{x:.3g}" for x in direction) + ")"


def judged(shape, mesh, direction, factor):
    """The Layered of an extrude.LayeredMesh, whose inner points it improves."""
    mesh.points = hn.optimize(mesh.points, mesh.hexes, rounds=ROUNDS, target=GOOD, threads=1)
    proof = hn.certify(mesh.points, mesh.hexes, mesh.quads)
    volume = volume_and_area(mesh.points[mesh.quads])[0]
    return Layered(mesh, hn.quality(mesh.points, mesh.hexes), bool(proof.certified), volume / shape.volume - 1.0,
                   direction, factor)


def _shortcomings(found):
    words = []
    if not found.certified:
        words.append("not certified")
    if abs(found.volume) > MOST_VOLUME:
        words.append(f"the volume is {100 * found.volume:+.1f} % off")
    if found.quality.min <= POOR:
        words.append(f"least scaled Jacobian {found.quality.min:.3f}")
    return [f"along {named(found.direction)} at {found.factor:g} of the size: " + ", ".join(words)] if words else []


def surface_of(found, faults, name, what=""):
    """What a maker of surfaces returns, of a Layered; name: of the surface method; what: there is beside layers."""
    mesh = found.mesh
    part = "" if found.factor == 1.0 else f" at {found.factor:g} of the size"
    return {"points": mesh.points, "quads": mesh.quads, "faces": mesh.faces, "hexes": mesh.hexes,
            "pieces": getattr(mesh, "pieces", ()),
            "notes": [f"{name} along {named(found.direction)}{part}: {what}{mesh.levels} levels, {mesh.rings} layers, "
                      f"{len(mesh.hexes)} hexes; volume {100 * found.volume:+.2f} %, edges of a quad up to 1 to "
                      f"{1.0 / evenness(mesh.points, mesh.quads).min():.1f}",
                      *(f"{name}: {fault}" for fault in faults)]}

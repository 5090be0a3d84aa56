# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surface meshes of the whole solid by gmsh that need luck: blossom, subdivided, transfinite."""
import collections

from .colouring import shells_are_even, two_colourable
from .corner_room import corner_room, room_words
from .detail_sizes import detail_sizes
from .fault import WorkerFault
from .generate import collect, generate, is_cut

# gmsh's numbers of Mesh.Algorithm: the frontal one (6) makes the better quads, but leaves triangles at the narrow
# corners of plane triangles whatever the size; Delaunay (5) does so less often.
ALGORITHMS = {"blossom": (6, 5)}
FACTORS = (1.0, 0.97, 1.03, 0.94, 1.06, 0.91, 1.09, 0.88, 1.12)   # of the size, tried until all is well
MORE_FACTORS = (0.985, 1.015, 0.955, 1.045, 0.925, 1.075, 0.895, 1.105)     # where two colours are not enough
SCALES = (2.0, 1.4, 1.0)    # of local sizes, tried after all of these
SMALLER = (0.82, 0.75, 0.7, 0.65, 0.6, 0.55, 0.5)       # of the size, where nothing else has come to quads
LEAST_ROOM = 0.05           # sine of the worst corner
MOST_DEAD = 2       # gmsh's crashes and calls without end on tries that differ in size alone: then other tries have their turn


def whole_surface(solid, size, method, link, sizes=None):
    """dict with points (V,3), quads (n,4), faces (n,), notes.

    Sizes next to the wanted one are tried until all are quads, in even number, with two colours for the points (which
    cells need; where the surface has no handles they exist) and room at every corner; if there is none such, the
    best of those that are quads in even number. link: a Link; sizes: the SizeField wanted, None: of one size.
    Raises WorkerFault NOT_ALL_QUAD, ODD_SURFACE, NOT_TRANSFINITE, TOOL_FAILED.
    """
    best, last, dead = None, None, collections.Counter()
    tries = _tries(method)
    for done, one in enumerate(tries):
        link.progress("mesh", done / len(tries))
        if one.only_for_colours and not (best and not best[0][0]) or dead[one.kind()] >= MOST_DEAD:
            continue
        if best and best[0] >= (True, 0.0) and one.factor < FACTORS[-2]:
            break       # such a small size only for want of anything else
        if not link.risk(f"{method} by {one}"):
            dead[one.kind()] += 1
            last = WorkerFault("TOOL_FAILED",
                               f"gmsh crashed, or did not end, on {method} at every size tried from {size:g} on")
            continue
        try:
            mesh = _tried(solid, size, method, one, sizes)
        except WorkerFault as fault:
            if fault.code == "NOT_TRANSFINITE" and fault.elements:
                raise
            last = fault
            continue
        room = corner_room(mesh["points"], mesh["quads"])
        worth = two_colourable(mesh["quads"]), min(room, LEAST_ROOM)
        if best is None or worth > best[0]:
            best = worth, room, mesh, one, last
            if room > 0.0:
                link.keep(_noted(*best, method, size))
        if worth == (True, LEAST_ROOM):
            break
        last = WorkerFault("ODD_SURFACE", room_words(room) if worth[0] else "two colours were not enough for its points")
    if best is None:
        raise last
    return _noted(*best, method, size)


class _Try:
    """One way to mesh: a factor of the size, gmsh's algorithm, edges of even count, a scale of local sizes or None."""

    def __init__(self, factor, algorithm, even, scale=None, only_for_colours=False):
        self.factor, self.algorithm, self.even, self.scale = factor, algorithm, even, scale
        self.only_for_colours = only_for_colours

    def kind(self):
        """Alike for tries that differ in size alone, and not much."""
        return self.algorithm, self.scale, self.factor in SMALLER

    def __str__(self):
        local = "" if self.scale is None else f", {self.scale:g} times the sizes of curves and gaps"
        return f"factor {self.factor:g}, algorithm {self.algorithm}{local}"


def _tries(method):
    algorithms = ALGORITHMS.get(method, (6,))
    tries = [_Try(factor, algorithm, k > 0) for algorithm in algorithms for k, factor in enumerate(FACTORS)]
    if method == "transfinite":
        return tries
    tries += [_Try(factor, algorithm, True, only_for_colours=True) for algorithm in algorithms for factor in MORE_FACTORS]
    tries += [_Try(factor, 6, True, scale) for scale in SCALES for factor in FACTORS[:5]]
    return tries + [_Try(factor, algorithm, True) for factor in SMALLER for algorithm in algorithms]


def _tried(solid, size, method, one, sizes):
    """The mesh of one try; WorkerFault where it is not all quads, or a shell of it odd."""
    wanted = size * one.factor
    coarse = 2.0 * wanted if method == "subdivided" else wanted
    local = sizes.scaled(coarse / sizes.size) if sizes is not None and not sizes.even else None
    if one.scale is not None:
        local, _ = detail_sizes(solid, coarse, one.scale, local)
    try:
        generate(solid, wanted, method, one.algorithm, one.even, local)
    except WorkerFault:
        raise
    except Exception as error:      # gmsh raises plain Exception
        raise WorkerFault("TOOL_FAILED", f"gmsh: {error}") from error
    triangles, mesh = collect(solid, is_cut(method))
    if triangles:
        raise WorkerFault("NOT_TRANSFINITE" if method == "transfinite" else "NOT_ALL_QUAD",
                          f"{triangles} triangles are left at every size tried from {size:g} on")
    if not shells_are_even(mesh["quads"]):
        raise WorkerFault("ODD_SURFACE", f"the number of quads is odd at every size tried from {size:g} on")
    return mesh


def _noted(worth, room, mesh, one, before, method, size):
    """The mesh with notes about how it came to be."""
    notes = []
    if one.algorithm != 6:
        notes.append(f"{method}: by gmsh's algorithm {one.algorithm}, because 6 found no such surface at any size tried")
    if one.factor != 1.0:
        notes.append(f"{method}: size {size * one.factor:g} instead of {size:g}, because {_reason(before)}")
    if one.scale is not None:
        notes.append(f"{method}: smaller where the solid is curved or narrow, because {_reason(before)}")
    if not worth[0]:
        notes.append(f"{method}: two colours are not enough for the points at any size tried")
    if room < LEAST_ROOM:
        notes.append(f"{method}: {room_words(room)} at every size tried")
    mesh["notes"] = notes + [f"{method}: {len(mesh['quads'])} quads"]
    return mesh


def _reason(fault):
    if fault is None:
        return "that is better"
    if fault.code == "ODD_SURFACE" and not str(fault).startswith("the number"):
        return f"at the one before {fault}"
    return {"ODD_SURFACE": "the one before gave an odd number of quads",
            "TOOL_FAILED": "gmsh failed at the one before"}.get(fault.code, "the one before left triangles")

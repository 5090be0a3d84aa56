# SPDX-License-Identifier: LGPL-2.1-or-later
"""More quads on round faces, where chords cut more of the volume than they may."""
import numpy as np

from .cad_fit import volume_and_area
from .fault import WorkerFault
from .size_field import SizeField
from .wanted_sizes import curved_points

ENOUGH = 1.1        # times what chords may cut: so little too much is not worth another mesh
ROUNDS = 2          # meshes that are made for the sake of chords, at most
SAFE = 0.9          # of the size that would just do, as what chords cut goes with its square
LEAST = 0.25        # of the size: no chord asks for less
EVEN = 0.6          # of the size: down to here elements are made smaller everywhere; splits in two would be too much
MATTERS = 0.2       # of what chords may cut: round faces that cut less at this size, were all as round, stay
MOST_QUADS = 30_000     # of such a mesh, about


def within(limit, solid, size, sizes, make, second):
    """The mesh of make(size, sizes), or one with more quads on round faces where it is off by more than the limit.

    limit: part of the volume, 0: none; sizes: the SizeField wanted, None: the method knows one size only
    make: raises WorkerFault; where another does, the best before is handed on. second: called with the first, before
    """
    best = make(size, sizes)
    first = off = last = _off(solid, best) if limit else 0.0
    factor, how = 1.0, ""
    for round_ in range(ROUNDS):
        if off <= ENOUGH * limit:
            break
        factor = max(SAFE * np.sqrt(limit / last) * factor, LEAST)
        if len(best["quads"]) > MOST_QUADS * factor ** 2:
            break
        second(best)
        try:
            mesh, words = _rounder(solid, size, sizes, make, factor, limit, round_ == 0)
        except WorkerFault:
            break
        last = _off(solid, mesh)
        if last < off:
            best, off, how = mesh, last, words
        if factor <= LEAST:
            break
    if how:
        best["notes"].append(f"{how}, as chords cut {100 * first:.2g} % of the volume at {size:g}")
    return best


def _rounder(solid, size, sizes, make, factor, limit, first):
    """(mesh, what is other about it). The second is split on round faces: a grid has no number of quads between."""
    if sizes is None or (first and factor >= EVEN):
        smaller = sizes and SizeField(factor * size).joined(sizes)
        return make(factor * size, smaller), f"size {factor * size:.3g} instead of {size:g}"
    factor = min(factor, EVEN)
    return make(size, sizes.joined(chord_sizes(solid, size, factor, limit))), f"size {factor * size:.3g} on round faces"


def _off(solid, mesh):
    return abs(abs(volume_and_area(mesh["points"][mesh["quads"]])[0]) / solid.exact_volume - 1.0)


def chord_sizes(solid, size, factor, limit):
    """The SizeField with that part of the size on those round faces of a Solid whose chords matter.

    A strip of width h on a face of curvature k cuts h^3 k / 12: h^2 (k1 + k2) / 12 of each unit of area.
    """
    faces = [f for f in solid.faces if not solid.is_plane(f)]
    area = sum(solid.area(f) for f in faces)
    points, names, name_of = [np.zeros((0, 3))], [], [np.zeros(0, int)]
    for face in faces:
        at, curvature = curved_points(solid, face, factor * size)
        at = at[size ** 2 * curvature / 12.0 * area > MATTERS * limit * solid.exact_volume]
        points.append(at)
        name_of.append(np.full(len(at), len(names)))
        names.append(f"Face{face} is round")
    points = np.concatenate(points)
    return SizeField(size, points, np.full(len(points), factor * size), (), names, np.concatenate(name_of))

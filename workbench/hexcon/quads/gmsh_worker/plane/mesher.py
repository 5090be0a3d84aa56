# SPDX-License-Identifier: LGPL-2.1-or-later
"""The best of several all-quad meshes of a plane region whose boundary points are given."""
from dataclasses import dataclass
from functools import cache

import numpy as np

from .. import paved
from ..link import Link
from ..smooth import evenness, merit, placed, scaled_jacobian
from ..templates import BONUS, GOOD, is_fine, lowest, templated
from .lattice import lattice_plans, lattices_of
from .simple import touching
from .split import split_mesh

LEAST = 0.02        # a mesh with a worse quad is none
FEWEST = 4          # boundary points
PAVED = (("direct", 6), ("halved", 6), ("direct", 5), ("halved", 5))    # road, gmsh's algorithm
ENOUGH = 0.6        # of what the corners allow: gmsh's first mesh this good is taken


class NoPlaneMesh(Exception):
    """No valid quads were found; the words say why."""


@dataclass(frozen=True)
class PlaneMesh:
    """points (m,2), those of the region's boundary first, bit for bit; quads (n,4) counter-clockwise.

    name       of what made it
    low, mean  scaled Jacobian;  limit: what the region's corners allow
    """

    points: np.ndarray
    quads: np.ndarray
    name: str
    low: float
    mean: float
    limit: float

    @property
    def is_fine(self):
        """Whether others need not be tried."""
        return is_fine(self.low, self.mean, evenness(self.points, self.quads).min(), self.limit)

    @property
    def score(self):
        return merit(self.points, self.quads, self.limit) + BONUS * (not self.name.startswith("gmsh"))


def mesh_plane(region, size, link=None, label="region", paving=True):
    """The best PlaneMesh of a PlaneRegion.

    size   wanted edge length, where the boundary leaves a choice
    link   guards calls of gmsh, which may crash; label: what to call this region there; paving: gmsh may be asked
    Templates first; then splits, and gmsh, where none of them comes near what the corners allow. Raises NoPlaneMesh.
    Cost: a few optimisations of n quads each, O(n) an iteration.
    """
    _check(region)
    ones, outline = [[np.ones(len(loop), int) for loop in region.loops]], region.outline(size)
    tried = templated(region.limit, cache(lambda plan: lattices_of(region) if plan is lattice_plans else ones),
                      lambda name, counts, build: judged(region, build(outline, counts, region.boundary), name))
    if lowest(tried) < GOOD * region.limit:
        tried += judged(region, split_mesh(region.loops), "split")
    if paving and lowest(tried) < ENOUGH * region.limit:
        tried += _paved(region, size, link or Link(), label)
    if not tried:
        raise NoPlaneMesh(f"no valid quads in {label} with {len(region.boundary)} boundary points in "
                          f"{len(region.loops)} loops")
    return max(tried, key=lambda mesh: mesh.score)


def _check(region):
    count = len(region.boundary)
    if len(region.loops[0]) < FEWEST or min(len(loop) for loop in region.loops) < 3:
        raise NoPlaneMesh("a loop has fewer points than a quad, or a hole fewer than three")
    if count % 2:
        raise NoPlaneMesh(f"an odd number of boundary points ({count}) bounds no quads")
    if not region.area > 0.0:
        raise NoPlaneMesh("the boundary encloses no area")
    crossed = len(touching(region.loops))
    if crossed:
        raise NoPlaneMesh(f"the boundary's chords cross or touch in {crossed} places: its intervals are long beside a "
                          "narrow wall")


def _paved(region, size, link, label):
    """Meshes of gmsh, until one is good enough."""
    found = []
    for road, algorithm in PAVED:
        if road == "halved" and any(len(loop) % 2 for loop in region.loops):
            continue
        if not link.risk(f"{label} {road} {algorithm}"):
            continue
        build = paved.direct_mesh if road == "direct" else paved.halved_mesh
        try:
            made = build(region.loops, size, algorithm)
        except Exception as error:      # gmsh raises plain Exception; another road may do
            print(f"{label}: {road} {algorithm}: {error}")
            continue
        found += judged(region, made, f"gmsh {road} {algorithm}")
        if lowest(found) > ENOUGH * region.limit:
            break
    return found


def judged(region, made, name):
    """[PlaneMesh] of (points, quads) with its inner points at their best; [] where it is not valid, or None."""
    if made is None or not len(made[1]):
        return []
    points, quads = np.array(made[0], float), np.asarray(made[1])
    count = len(region.boundary)
    if len(points) < count or not _is_whole(region, quads, len(points)):
        return []
    points[:count] = region.boundary
    points = placed(points, quads, np.arange(len(points)) < count, region.limit)
    quality = scaled_jacobian(points, quads)
    if not quality.min() > LEAST:
        return []
    return [PlaneMesh(points, quads, name, float(quality.min()), float(quality.mean()), region.limit)]


def _is_whole(region, quads, count):
    """No directed edge twice, the edges without a partner are those of the boundary, and no point is unused."""
    edges = np.stack([quads, np.roll(quads, -1, axis=1)], -1).reshape(-1, 2).astype(np.int64)
    forth, back = edges @ [count, 1], edges @ [1, count]
    alone = np.sort(forth[~np.isin(forth, back)])
    boundary = np.sort(np.arange(len(region.boundary)) * count + region.after)
    return len(np.unique(forth)) == len(forth) and np.array_equal(alone, boundary) and len(np.unique(quads)) == count

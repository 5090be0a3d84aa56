# SPDX-License-Identifier: LGPL-2.1-or-later
"""The best of several all-quad meshes of a plane region whose boundary points are given."""
from dataclasses import dataclass

import numpy as np

from .. import paved
from ..link import Link
from ..smooth import evenness, merit, placed, scaled_jacobian
from ..templates import IF_POOR, TEMPLATES
from .lattice import lattices_of
from .split import split_mesh

GOOD = 0.75         # a structured mesh this good, as a share of what the corners allow, is taken without gmsh
FINE = 0.75, 0.93, 0.25     # worst as a share, mean, and quads up to four times as long as wide: no other is tried
BONUS = 0.05        # what regular structure is worth, in scaled Jacobian
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
        return self.low > FINE[0] * self.limit and self.mean > FINE[1] and self.even > FINE[2]

    @property
    def even(self):
        """The least of the quads' shortest edges by their longest."""
        return float(evenness(self.points, self.quads).min())

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
    tried, ones, lattices = [], [[np.ones(len(loop), int) for loop in region.loops]], lattices_of(region)
    for name, (_, build) in TEMPLATES.items():
        if name not in IF_POOR or max((mesh.low for mesh in tried), default=0.0) < GOOD * region.limit:
            for counts in lattices if name.startswith("lattice") else ones:
                if not any(mesh.is_fine for mesh in tried):
                    tried += _templated(region, size, name, counts, build)
    if max((mesh.low for mesh in tried), default=0.0) < GOOD * region.limit:
        made = judged(region, split_mesh(region.loops), "split")
        tried += [] if made is None else [made]
    if paving and max((mesh.low for mesh in tried), default=0.0) < ENOUGH * region.limit:
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


def _templated(region, size, name, counts, build):
    """[PlaneMesh] or []."""
    if not _applies(region, name):
        return []
    try:
        made = judged(region, build(region.outline(size), counts, region.boundary), name)
    except (ValueError, IndexError, TypeError):     # a template that asks for other counts
        return []
    return [] if made is None else [made]


def _applies(region, name):
    """Whether a template's mesh may be asked for at all; each plan looks at the same."""
    corners = [len(c) for c in region.corners]
    wanted = {"o-grid": (1, 0), "half o-grid": (1, 2)}
    if name in wanted:
        return (len(region.loops), corners[0]) == wanted[name]
    if name == "ring":
        return len(region.loops) == 2
    return len(region.loops) == 1 or name == "mapped" or name.startswith("lattice")


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
        mesh = judged(region, made, f"gmsh {road} {algorithm}")
        if mesh is not None:
            found.append(mesh)
            if mesh.low > ENOUGH * region.limit:
                break
    return found


def judged(region, made, name):
    """The PlaneMesh of (points, quads) with its inner points at their best; None where it is not valid."""
    if made is None or not len(made[1]):
        return None
    points, quads = np.array(made[0], float), np.asarray(made[1])
    count = len(region.boundary)
    if len(points) < count or not _is_whole(region, quads, len(points)):
        return None
    points[:count] = region.boundary
    points = placed(points, quads, np.arange(len(points)) < count, region.limit)
    quality = scaled_jacobian(points, quads)
    if not quality.min() > LEAST:
        return None
    return PlaneMesh(points, quads, name, float(quality.min()), float(quality.mean()), region.limit)


def _is_whole(region, quads, count):
    """No directed edge twice, the edges without a partner are those of the boundary, and no point is unused."""
    edges = np.stack([quads, np.roll(quads, -1, axis=1)], -1).reshape(-1, 2).astype(np.int64)
    forth, back = edges @ [count, 1], edges @ [1, count]
    alone = np.sort(forth[~np.isin(forth, back)])
    boundary = np.sort(np.arange(len(region.boundary)) * count + region.after)
    return len(np.unique(forth)) == len(forth) and np.array_equal(alone, boundary) and len(np.unique(quads)) == count

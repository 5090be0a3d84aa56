# SPDX-License-Identifier: LGPL-2.1-or-later
"""Choose the best all-quad mesh of a cap outline among the templates and the unstructured roads."""
from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np

from . import paved
from .fault import WorkerFault
from .plane.slid import slid
from .plane_mesh import image
from .smooth import ANGLES, EVEN, POOR, evenness, merit, placed, scaled_jacobian
from .templates import BONUS, GOOD, TEMPLATES, is_fine, lowest, templated

ENOUGH = 0.7       # an unstructured mesh this good ends the search on a large cap
LARGE = 3000       # quads


@dataclass
class CapMesh:
    """One plane mesh on both caps.

    points  (m,2) on the lower cap, the boundary first, loop after loop
    top     (m,2) the same points on the upper cap, in its own plane
    quads   (n,4) counter-clockwise
    shares  of the outline's edges, per loop: see Outline
    limit   what the outline's corners allow
    """
    name: str
    shares: list
    points: np.ndarray
    top: np.ndarray
    quads: np.ndarray
    limit: float

    @property
    def counts(self):
        """list per loop of (k,) intervals of each edge."""
        return [np.array([len(s) for s in loop]) for loop in self.shares]

    def quality(self):
        """(minimum, mean) scaled Jacobian in the planes of both caps."""
        sj = [scaled_jacobian(p, self.quads) for p in (self.points, self.top)]
        return float(np.min(sj)), float(np.mean(sj))

    @cached_property
    def low(self):
        """The minimum of quality."""
        return self.quality()[0]

    @property
    def is_fine(self):
        """Whether others need not be tried."""
        return is_fine(*self.quality(), evenness(self.points, self.quads).min(), self.limit)

    @property
    def score(self):
        """The lesser of both caps'."""
        return min(merit(p, self.quads, self.limit) for p in (self.points, self.top)) + \
            BONUS * (self.name in TEMPLATES)


def mesh_cap(outline, link, label):
    """The best CapMesh of an Outline. link: a Link; label: what to call the cap there.

    Raises WorkerFault NOT_SWEEPABLE if every road ends in an inverted quad.
    """
    tried = templated(outline.limit(), cache(lambda plan: plan(outline)), lambda *one: _tried(outline, *one))
    link.progress("cap", 0.3)
    if lowest(tried) < GOOD * outline.limit():
        _pave(tried, outline, link, label)
    if not tried:
        raise WorkerFault("NOT_SWEEPABLE", "the cap could not be meshed with valid quads")
    return max(tried, key=lambda mesh: mesh.score)


def _pave(tried, outline, link, label):
    """The unstructured roads: all of the first four on a small cap, more only while the best is poor."""
    for k, (road, algorithm, scale) in enumerate(paved.VARIANTS):
        large = any(len(t.quads) > LARGE for t in tried)
        if lowest(tried) > ENOUGH * outline.limit() and (k >= 4 or large):
            return
        if link.risk(f"{label} {road} {algorithm} {scale:g}"):
            tried += _paved(outline, road, algorithm, scale)
        link.progress("cap", 0.3 + 0.5 * (k + 1) / len(paved.VARIANTS))


def _tried(outline, name, counts, build):
    """[CapMesh] of a template."""
    shares = outline.divided(counts)
    made = build(outline, counts, np.concatenate(outline.place(shares)))
    if made is None or not name.startswith("lattice") or outline.spacing is not None:
        return _valid(outline, name, shares, made)
    tried = []
    for weight in (EVEN, ANGLES):       # where even quads are poor, angles alone may do
        own, *moved = slid(outline, shares, *made, weight)
        found = _valid(outline, name, own, moved)
        tried += found
        if lowest(found) > POOR * outline.limit():
            break
    return tried


def _paved(outline, road, algorithm, scale):
    """[CapMesh] of an unstructured road."""
    plan, build = {"halved": (paved.halved_plan, paved.halved_mesh),
                   "direct": (paved.direct_plan, paved.direct_mesh)}[road]
    counts = plan(outline, scale)
    if any(c is None for c in counts):
        return []
    shares = outline.divided(counts)
    try:
        made = build(outline.place(shares), outline.size / scale, algorithm)
    except Exception as error:      # gmsh raises plain Exception; another road may do
        print(f"cap: {road} {algorithm}: {error}")
        return []
    return _valid(outline, f"{road}-{algorithm}-{scale:g}", shares, made)


def _valid(outline, name, shares, made):
    """[CapMesh] of a mesh smoothed on both caps, [] if it is not valid on both."""
    if made is None:
        return []
    points, quads = made
    outline_top = np.concatenate(outline.place_top(shares))
    fixed = np.arange(len(points)) < len(outline_top)
    points = placed(points, quads, fixed, outline.limit())
    top = image(points, quads, outline_top)
    if merit(top, quads, outline.limit()) < merit(points, quads, outline.limit()) - 0.02:
        top = placed(top, quads, fixed, outline.limit())
    cap = CapMesh(name, shares, points, top, quads, outline.limit())
    low, mean = cap.quality()
    print(f"cap: {name}: {len(quads)} quads, scaled Jacobian {low:.3f} to mean {mean:.3f}")
    return [cap] if low > 0.01 and _is_simple(quads) else []


def _is_simple(quads):
    """No directed edge twice: else the mesh is folded over, however good each of its quads looks."""
    edges = np.stack([quads, np.roll(quads, -1, axis=1)], -1).reshape(-1, 2)
    return len(np.unique(edges, axis=0)) == len(edges)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Structured quad meshes of caps with a simple outline.

Each template has plans (Outline -> list of interval counts per loop, empty where it does not apply) and a
mesh (Outline, counts, boundary (Nb,2) -> points, quads; or None, also for counts that are of no plan of it). Points
0..Nb-1 are the boundary, loop after loop.
"""
from functools import partial

import numpy as np

from .outline import even, rounded, with_total
from .plane.lattice import lattice_plans, lattice_template
from .plane_mesh import Builder
from .submap import submap_mesh, submap_plan

GOOD = 0.75     # of what the corners allow: with a mesh this good nothing but templates is tried
FINE = 0.75, 0.93, 0.25     # worst as a share, mean, and quads up to four times as long as wide: no other is tried
BONUS = 0.05    # what regular structure is worth, in scaled Jacobian

# --- midpoint: a convex polygon with n corners becomes n blocks about its middle -------------------

def midpoint_plan(outline):
    """Side counts N_i = s_(i-1) + s_(i+1) from spoke counts s_i >= 1."""
    sides = _convex_sides(outline)
    if sides is None:
        return None
    desired = np.array([outline.desired[0][s].sum() for s in sides])
    n = len(sides)
    matrix = np.zeros((n, n))
    for i in range(n):
        matrix[i, (i - 1) % n] += 1.0
        matrix[i, (i + 1) % n] += 1.0
    spokes = np.maximum(np.rint(np.linalg.lstsq(matrix, desired, rcond=None)[0]), 1).astype(int)
    counts = np.zeros(len(outline.desired[0]), int)
    for i, side in enumerate(sides):
        part = with_total(outline.desired[0][side], outline.least[0][side],
                          spokes[(i - 1) % n] + spokes[(i + 1) % n])
        if part is None:
            return None
        counts[side] = part
    return [counts]


def _convex_sides(outline):
    """Edge numbers per side between 3, 5, 6, 7 or 8 convex corners of a single loop, else None."""
    if len(outline.turn) != 1:
        return None
    corners = outline.corners()
    if len(corners) not in (3, 5, 6, 7, 8) or (outline.turn[0][corners] < 0).any():
        return None
    k = len(outline.turn[0])
    ends = np.append(corners[1:], corners[0] + k)
    return [np.arange(a, b) % k for a, b in zip(corners, ends)]


def midpoint_mesh(outline, counts, boundary):
    sides = _convex_sides(outline)
    spokes = None if sides is None else _spokes(np.array([counts[0][s].sum() for s in sides]))
    if spokes is None:
        return None
    starts = np.concatenate([[0], np.cumsum(counts[0])])
    return midpoint_blocks(boundary, [int(starts[s[0]]) for s in sides], spokes)


def midpoint_blocks(boundary, first, spokes):
    """(points (m,2), quads): one block per corner of an n-gon, between the middles of its sides and a centre.

    boundary  (Nb,2), counter-clockwise: the first points
    first     (n,) the boundary point at the corner where side i starts
    spokes    (n,) intervals from the middle of side i to the centre; side i has spokes[i-1] up to its middle and
              spokes[i+1] after it
    """
    n, total = len(spokes), len(boundary)
    build = Builder(boundary)
    middles = [(first[i] + spokes[(i - 1) % n]) % total for i in range(n)]
    centre = build.add(boundary[middles].mean(axis=0)[None])
    middle = np.concatenate(build.points)[centre[0]]
    arms = []
    for i in range(n):
        t = np.linspace(0.0, 1.0, spokes[i] + 1)[1:-1, None]
        inner = build.add((1 - t) * boundary[middles[i]] + t * middle)
        arms.append(np.concatenate([[middles[i]], inner, centre]))
    for i in range(n):
        before = (i - 1) % n
        along = (first[i] + np.arange(spokes[before] + 1)) % total          # corner -> middle of side i
        back = (first[i] - np.arange(spokes[i] + 1)) % total                 # corner -> middle of side i-1
        build.block(along, arms[i], arms[before], back)
    return build.result()


def _spokes(totals):
    """The spoke counts that belong to side counts; for even n the most even of the solutions."""
    n = len(totals)
    matrix = np.zeros((n, n))
    for i in range(n):
        matrix[i, (i - 1) % n] += 1.0
        matrix[i, (i + 1) % n] += 1.0
    base = np.linalg.lstsq(matrix, totals.astype(float), rcond=None)[0]
    shifts = [np.zeros(n)]
    if n % 4 == 0:      # the system is singular: alternate solutions differ by these
        shifts += [s * np.tile([1, 0, -1, 0], n // 4) + t * np.tile([0, 1, 0, -1], n // 4)
                   for s in (-0.5, 0, 0.5) for t in (-0.5, 0, 0.5)]
    for shift in shifts:
        spokes = np.rint(base + shift).astype(int)
        if (spokes >= 1).all() and np.array_equal(np.rint(matrix @ spokes), totals):
            return spokes
    return None


# --- O-grid: a smooth disk becomes a block in the middle and rings about it ------------------------

def ogrid_plan(outline):
    """A total that is a multiple of four."""
    if not _is_smooth(outline):
        return None
    total = 4 * max(2, int(np.rint(outline.desired[0].sum() / 4)), int(np.ceil(outline.least[0].sum() / 4)))
    counts = with_total(outline.desired[0], outline.least[0], total)
    return None if counts is None else [counts]


def _is_smooth(outline):
    return len(outline.turn) == 1 and not len(outline.corners())


def ogrid_mesh(outline, counts, boundary):
    if not _is_smooth(outline):
        return None
    centre, axes, half = _principal_box(boundary)
    total = len(boundary)
    wide = int(np.clip(np.rint(total / 2 * half[0] / half.sum()), 1, total // 2 - 1))
    high = total // 2 - wide
    corner = _best_shift(boundary, centre, axes, half, wide, high)
    rings = max(1, int(np.rint((half[1] - 0.45 * high * outline.size) / outline.size)))
    core = 0.9 * min(high * outline.size / 2 / half[1], 0.7)
    core = max(core, 0.35)
    build = Builder(boundary)
    around = (corner + np.arange(total)) % total
    cuts = np.array([0, wide, wide + high, 2 * wide + high, total])
    target = _bulged(centre + core * (boundary[around] - centre), cuts)
    spokes = _ring_spokes(build, boundary, around, target, rings)
    inner = spokes[-1]
    sides = np.split(np.append(inner, inner[0]), [wide, wide + high, 2 * wide + high])
    bottom, right = np.append(sides[0], sides[1][0]), np.append(sides[1], sides[2][0])
    top, left = np.append(sides[2], sides[3][0])[::-1], sides[3][::-1]
    build.block(bottom, right, top, left)
    for outer, within in zip(spokes[:-1], spokes[1:]):
        build.quads.append(np.stack([outer, np.roll(outer, -1), np.roll(within, -1), within], -1))
    return build.result()


def _bulged(path, cuts):
    """Draw a smooth path towards the straight lines between its points at `cuts`: corners of about 120 degrees."""
    path = np.concatenate([path, path[:1]]) if cuts[-1] == len(path) else path
    result = path.copy()
    for a, b in zip(cuts[:-1], cuts[1:]):
        t = np.linspace(0.0, 1.0, b - a + 1)[:, None]
        result[a:b + 1] = 0.27 * path[a:b + 1] + 0.73 * ((1 - t) * path[a] + t * path[b])
    return result


def _ring_spokes(build, boundary, around, target, rings):
    """Point numbers of rings 0 (the boundary) .. rings (the target path)."""
    result = [around]
    for k in range(1, rings + 1):
        t = k / rings
        result.append(build.add((1 - t) * boundary[around] + t * target[:len(around)]))
    return result


def _principal_box(boundary):
    """Centre (2,), axes (2,2) rows (long one first), half extents (2,) of a closed outline."""
    after = np.roll(boundary, -1, axis=0)
    weight = np.linalg.norm(after - boundary, axis=1)
    mid = (after + boundary) / 2
    centre = (mid * weight[:, None]).sum(0) / weight.sum()
    d = mid - centre
    values, vectors = np.linalg.eigh((d * weight[:, None]).T @ d)
    axes = vectors[:, ::-1].T
    if values[1] < 1.02 * values[0]:
        axes = np.eye(2)
    if axes[0, 0] * axes[1, 1] - axes[0, 1] * axes[1, 0] < 0:
        axes[1] = -axes[1]
    local = (boundary - centre) @ axes.T
    return centre + (local.max(0) + local.min(0)) / 2 @ axes, axes, (local.max(0) - local.min(0)) / 2


def _best_shift(boundary, centre, axes, half, wide, high):
    """The boundary point to become the lower left corner of the block."""
    local = (boundary - centre) @ axes.T / half
    total = len(boundary)
    corner = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    offset = np.array([0, wide, wide + high, 2 * wide + high])
    fit = sum(np.roll(local, -o, axis=0) @ c for o, c in zip(offset, corner))
    return int(np.argmax(np.rint(fit * 1e9))) % total


# --- half O-grid: an outline with two corners, one side bulging out from a flatter one --------------

def half_ogrid_plan(outline):
    """Base side w + 2a, bulging side w + 2h intervals."""
    sides = _two_sides(outline)
    if sides is None:
        return None
    base, bulge = sides
    flat = max(3, int(np.rint(outline.desired[0][base].sum())), int(outline.least[0][base].sum()))
    round_ = outline.desired[0][bulge].sum()
    arms = _half_arms(flat)
    wide = flat - 2 * arms
    high = max(1, int(np.rint((max(round_, outline.least[0][bulge].sum()) - wide) / 2)))
    counts = np.zeros(len(outline.desired[0]), int)
    for side, total in ((base, flat), (bulge, wide + 2 * high)):
        part = with_total(outline.desired[0][side], outline.least[0][side], total)
        if part is None:
            return None
        counts[side] = part
    return [counts]


def _two_sides(outline):
    """(edge numbers of the flatter side, of the other) between two convex corners, else None."""
    if len(outline.turn) != 1:
        return None
    corners, k = outline.corners(), len(outline.turn[0])
    if len(corners) != 2 or (outline.turn[0][corners] < 0).any():
        return None
    sides = [np.arange(corners[0], corners[1]), np.arange(corners[1], corners[0] + k) % k]
    return sorted(sides, key=lambda side: outline.desired[0][side].sum())


def _half_arms(flat):
    """Rings of a half O-grid over a base of this many intervals."""
    return max(1, int(np.rint(0.22 * flat)))


def half_ogrid_mesh(outline, counts, boundary):
    sides = _two_sides(outline)
    if sides is None:
        return None
    base, bulge = sides
    starts = np.concatenate([[0], np.cumsum(counts[0])])
    total, flat, round_ = len(boundary), int(counts[0][base].sum()), int(counts[0][bulge].sum())
    line = (int(starts[base[0]]) + np.arange(flat + 1)) % total
    arc = (int(starts[bulge[0]]) + np.arange(round_ + 1)) % total
    arms = _half_arms(flat)
    wide = flat - 2 * arms
    high = (round_ - wide) // 2
    if wide < 0 or high < 1:
        return None
    build = Builder(boundary)
    centre = (boundary[line[0]] + boundary[line[-1]]) / 2
    layers = [arc]
    ends = centre + (1.0 - 2.0 * arms / flat) * (boundary[arc] - centre)
    target = _bulged(ends, np.array([0, high, high + wide, round_]))
    for k in range(1, arms + 1):
        t = k / arms
        inner = build.add(((1 - t) * boundary[arc] + t * target)[1:-1])
        layers.append(np.concatenate([[line[flat - k]], inner, [line[k]]]))
    for outer, within in zip(layers[:-1], layers[1:]):
        build.quads.append(np.stack([outer[:-1], outer[1:], within[1:], within[:-1]], -1))
    path = layers[-1]
    build.block(line[arms:flat - arms + 1], path[:high + 1], path[high:high + wide + 1][::-1],
                path[high + wide:][::-1])
    return build.result()


# --- ring: two loops with equal counts, joined by straight lines -----------------------------------

def ring_plan(outline):
    """Equal totals; edge by edge where both loops have the same number of edges."""
    if len(outline.turn) != 2:
        return None
    desired, least = outline.desired, outline.least
    if max(desired[0].sum() / desired[1].sum(), 1.0) > 6.0:
        return None
    if len(desired[0]) == len(desired[1]) > 1:
        shift = _edge_shift(outline)
        pick = (shift - 1 - np.arange(len(desired[0]))) % len(desired[0])     # hole edge over each outer edge
        counts = rounded((desired[0] + desired[1][pick]) / 2, np.maximum(least[0], least[1][pick]))
        if counts.sum() % 2:
            counts[int(np.argmax(desired[0]))] += 1
        inner = np.empty_like(counts)
        inner[pick] = counts
        return [counts, inner]
    total = max((desired[0].sum() + desired[1].sum()) / 2, least[0].sum(), least[1].sum())
    total = 4 * int(np.ceil(total / 4 - 0.4))
    pair = []
    for d, m in zip(desired, least):
        counts = with_total(d * total / d.sum(), m, max(total, 4))
        if counts is None:
            return None
        pair.append(counts)
    return pair


def _edge_shift(outline):
    """s: outer vertex i lies over hole vertex (s - i) mod k."""
    ones = [np.ones(len(d), int) for d in outline.desired]
    outer, inner = outline.place(even(ones))
    k = len(outer)
    costs = [np.linalg.norm(outer - inner[(s - np.arange(k)) % k], axis=1).sum() for s in range(k)]
    return int(np.argmin(costs))


def ring_mesh(outline, counts, boundary):
    n = int(counts[0].sum())
    if len(counts) != 2 or counts[1].sum() != n:
        return None
    outer, inner = boundary[:n], boundary[n:]
    if len(counts[0]) == len(counts[1]) > 1:
        starts = [np.concatenate([[0], np.cumsum(x)])[:-1] for x in counts]
        shift = int(starts[1][_edge_shift(outline)])
    else:
        costs = [np.linalg.norm(outer - inner[(s - np.arange(n)) % n], axis=1).sum() for s in range(n)]
        shift = int(np.argmin(costs))
    over = n + (shift - np.arange(n)) % n
    gap = np.linalg.norm(boundary[over] - outer, axis=1).mean()
    spacing = (np.linalg.norm(np.diff(outer, axis=0), axis=1).mean() +
               np.linalg.norm(np.diff(inner, axis=0), axis=1).mean()) / 2
    rings = max(1, int(np.rint(gap / max(spacing, 0.5 * outline.size))))
    build = Builder(boundary)
    levels = [np.arange(n)]
    for k in range(1, rings):
        t = k / rings
        levels.append(build.add((1 - t) * outer + t * boundary[over]))
    levels.append(over)
    for a, b in zip(levels[:-1], levels[1:]):
        build.quads.append(np.stack([a, np.roll(a, -1), np.roll(b, -1), b], -1))
    return build.result()


def _only(plan):
    """A plan with a list of counts, of one that gives one or None."""
    def plans(outline):
        counts = plan(outline)
        return [] if counts is None else [counts]
    return plans


_LATTICES = {"lattice" + (f", o-grid {' and '.join(rings)}" if rings else ""):
             (lattice_plans, partial(lattice_template, rings=rings))
             for rings in (("holes",), (), ("outer", "holes"), ("outer",))}

# name -> (plans, mesh)
TEMPLATES = {"mapped": (_only(submap_plan), submap_mesh), "midpoint": (_only(midpoint_plan), midpoint_mesh),
             "o-grid": (_only(ogrid_plan), ogrid_mesh), "half o-grid": (_only(half_ogrid_plan), half_ogrid_mesh),
             "ring": (_only(ring_plan), ring_mesh), **_LATTICES}

IF_POOR = {name for name in _LATTICES if "outer" in name}
"""Of them those that are worth a try only where no other is good: a ring along the outline splits its corners."""


def lowest(meshes):
    """The worst scaled Jacobian of the best of meshes, 0 of none."""
    return max((mesh.low for mesh in meshes), default=0.0)


def is_fine(low, mean, even, limit):
    """Whether a mesh need not be compared with others. even: of its least even quad; limit: what the corners allow"""
    return low > FINE[0] * limit and mean > FINE[1] and even > FINE[2]


def templated(limit, plans, attempt):
    """The meshes of templates, which have `low` and `is_fine`, until one is fine.

    limit: what the corners allow; plans: callable (a template's plans) -> list of counts;
    attempt: callable (name, counts, a template's mesh) -> list of meshes
    """
    tried = []
    for name, (plan, build) in TEMPLATES.items():
        if name in IF_POOR and lowest(tried) >= GOOD * limit:
            continue
        for counts in plans(plan):
            made = attempt(name, counts, build)
            tried += made
            if any(mesh.is_fine for mesh in made):
                return tried
    return tried

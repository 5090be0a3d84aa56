# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the paper's methods promise, worked out again from the quads alone: loops, families, sides, counts.

Quads are (n, 4) of a closed surface, all turned alike. No code shared with the core, which only `raised` calls.
"""
import collections
import itertools

import numpy as np
import pytest
from mesh_checker import boundary_faults, conformity_faults, euler, jacobians
from scipy.optimize import Bounds, LinearConstraint, milp
from scipy.sparse import coo_matrix

import hexcon_native as hn

# Hexes on a quad of the paired surface: layers, and then what closes.
ON_PAIRED = {"four-split": 9, "pyramid": 9 + 16, "pyramid-alt": 3 + 16, "geode": 9 + 26 + 8, "geode-alt": 3 + 26 + 8}
# Hexes on a quad of the surface, of which the pairs make three; and one of the pair itself.
ON_GIVEN = {method: 1 + 3 * count for method, count in ON_PAIRED.items()}
ALTERNATIVE = ("pyramid-alt", "geode-alt")
# Points of the unit cube whose mean is a trilinear hex's, of its Jacobian: the volume.
GAUSS = np.array(list(itertools.product((0.5 - 3 ** -0.5 / 2, 0.5 + 3 ** -0.5 / 2), repeat=3)))


def raised(code, *arguments, **options):
    """Elements of the error that hn.mesh raises."""
    with pytest.raises(hn.HexconError) as fault:
        hn.mesh(*arguments, **options)
    assert fault.value.code == hn.ErrorCode[code], fault.value
    assert str(fault.value)
    return fault.value.elements


def volumes(mesh):
    """(H,) of the trilinear hexes: exact, as the Jacobian has degree two in each direction."""
    return jacobians(mesh.points[mesh.hexes], GAUSS).mean(axis=1)


def faults(points, mesh, of_sphere=True):
    """What no mesh of the paper's may have, in words: topology, and the input's points."""
    hexes = mesh.hexes.astype(np.int64)
    found = boundary_faults(hexes, mesh.quads) + conformity_faults(hexes)
    if mesh.points[:len(points)].tobytes() != np.asarray(points, np.float64).tobytes():
        found.append("the first points are not those of the surface")
    if not np.isfinite(mesh.points).all():
        found.append("a point is not finite")
    if len(np.unique(hexes)) != len(mesh.points):
        found.append("a point belongs to no hex")
    if len(np.unique(np.sort(hexes, axis=1), axis=0)) != len(hexes):
        found.append("a hex twice")
    if of_sphere and euler(hexes) != (2 if mesh.method == "four-split" else 1):
        found.append(f"Euler characteristic {euler(hexes)}")
    return found


def paired_surface(mesh, count):
    """The quads that the split layers split in four, (F, 4), of a four-split mesh of `count` quads: the inner ones
    come four by four, each beginning at a corner."""
    corners = mesh.quads[count:, 0].reshape(-1, 4)
    middles = mesh.quads[count:].reshape(-1, 4, 4)
    assert (middles[:, :, 3] == np.roll(middles[:, :, 1], -1, axis=1)).all()    # edge middles, in turn
    assert (middles[:, :, 2] == middles[:, :1, 2]).all()                        # one centre
    return corners


# ----------------------------------------------------------------------------------------- loops

def dual_loops(quads):
    """[(quad, side by which it is entered), ...] of every loop, in the order of quads and of their sides 0 and 1."""
    quads = np.asarray(quads).tolist()
    other = {(quad[k], quad[(k + 1) % 4]): (q, k) for q, quad in enumerate(quads) for k in range(4)}
    found, seen = [], set()
    for start in itertools.product(range(len(quads)), (0, 1)):
        loop, (q, side) = [], start
        while (q, side % 2) not in seen:
            seen.add((q, side % 2))
            loop.append((q, side))
            out = (side + 2) % 4
            q, side = other[quads[q][(out + 1) % 4], quads[q][out]]
        if loop:
            found.append(loop)
    return found


def self_crossings(quads):
    """Quads that a loop passes twice, ascending."""
    return sorted({q for loop in dual_loops(quads)
                   for q, count in collections.Counter(q for q, _ in loop).items() if count == 2})


def families(loops):
    """Number of each loop's family: 0 and 1 if that will do, else the first free one, loop by loop."""
    passing = collections.defaultdict(set)
    for number, loop in enumerate(loops):
        for q, _ in loop:
            passing[q].add(number)
    crossing = collections.defaultdict(set)
    for a, b in map(sorted, passing.values()):    # two each: no loop crosses itself
        crossing[a].add(b)
        crossing[b].add(a)
    return _two(crossing, len(loops)) or _first_free(crossing, len(loops))


def _two(crossing, count):
    found = {}
    for root in range(count):
        if root in found:
            continue
        found[root], left = 0, [root]
        while left:
            a = left.pop()
            for b in crossing[a]:
                if b not in found:
                    found[b] = 1 - found[a]
                    left.append(b)
                elif found[b] == found[a]:
                    return None
    return [found[k] for k in range(count)]


def _first_free(crossing, count):
    found = []
    for loop in range(count):
        taken = {found[other] for other in crossing[loop] if other < loop}
        found.append(next(k for k in itertools.count() if k not in taken))
    return found


def crossed_edges(quads, loops, family_of_loop, family):
    """Edges (low, high) that the loops of a family cross."""
    return {tuple(sorted((int(quads[q][side]), int(quads[q][(side + 1) % 4]))))
            for loop, of in zip(loops, family_of_loop) if of == family for q, side in loop}


def sides(quads, crossed):
    """{point: 0 or 1}, another one at the two ends of crossed edges alone; None if there are none."""
    near = collections.defaultdict(set)
    for quad in np.asarray(quads).tolist():
        for k in range(4):
            near[quad[k]].add(quad[k - 1])
            near[quad[k - 1]].add(quad[k])
    root = min(near)
    found, left = {root: 0}, [root]
    while left:
        a = left.pop()
        for b in near[a]:
            side = found[a] ^ ((min(a, b), max(a, b)) in crossed)
            if b not in found:
                found[b] = side
                left.append(b)
            elif found[b] != side:
                return None
    return found


def layer_counts(quads, alternative=False):
    """Hexes of every split layer: 3 on each part of a crossed quad, 2 to the left and 1 to the right; alternatively 1
    on those crossed and to the left. Left is the side that takes fewer hexes."""
    loops = dual_loops(quads)
    family_of_loop, parts, found = families(loops), np.ones(len(quads), np.int64), []
    for family in range(max(family_of_loop) + 1):
        crossing = [q for loop, of in zip(loops, family_of_loop) if of == family for q, _ in loop]
        hit = np.isin(np.arange(len(quads)), crossing)
        side_of = sides(quads, crossed_edges(quads, loops, family_of_loop, family))
        side = np.array([side_of[int(quad[0])] for quad in quads])
        uneven = min(parts[~hit & (side == left)].sum() for left in (0, 1))
        whole = 0 if alternative else 1
        found.append(int((1 if alternative else 3) * parts[hit].sum() + whole * parts[~hit].sum() + uneven))
        parts[hit] *= 2
    assert (parts == 4).all()
    return found


# ----------------------------------------------------------------------------------------- pairs

def neighbours(quads):
    """{(low quad, high quad): number of edges they share}."""
    first, found = {}, collections.Counter()
    for q, quad in enumerate(np.asarray(quads).tolist()):
        for k in range(4):
            a, b = quad[k - 1], quad[k]
            if (b, a) in first:
                found[tuple(sorted((first[b, a], q)))] += 1
            first[a, b] = q
    return found


def paired_quads(quads, pairs):
    """The surface under two hexes on each pair, by figure 2 of the paper: quads (F, 4), six a pair, then those of no
    pair; and the quad that each of them is, -1 for those of pairs. Quads of a pair share one edge."""
    quads = np.asarray(quads).tolist()
    found, source, new = [], [], itertools.count(1 + max(map(max, quads)))
    for one, two in pairs:
        p, r = quads[one], quads[two]
        k, j = next((k, j) for k in range(4) for j in range(4) if (p[k], p[k - 3]) == (r[j - 3], r[j]))
        v2, v5, v4, v1 = (p[(k + i) % 4] for i in range(4))
        v3, v6 = r[(j + 2) % 4], r[(j + 3) % 4]
        v7, v8, v9, v10 = (next(new) for _ in range(4))
        found += [(v1, v2, v7, v8), (v7, v2, v3, v8), (v1, v8, v9, v4), (v8, v3, v6, v9), (v4, v9, v10, v5),
                  (v9, v6, v5, v10)]
        source += [-1] * 6
    free = sorted(set(range(len(quads))) - {int(q) for pair in pairs for q in pair})
    return np.array(found + [quads[q] for q in free]), np.array(source + free)


def can_pair_across_single_edges(quads):
    """Whether all quads can be paired with quads with which they share one edge only."""
    pairs = np.array([pair for pair, shared in neighbours(quads).items() if shared == 1]).reshape(-1, 2)
    if len(pairs) == 0:
        return False
    once = coo_matrix((np.ones(pairs.size), (pairs.ravel(), np.repeat(np.arange(len(pairs)), 2))),
                      shape=(len(quads), len(pairs)))
    best = milp(-np.ones(len(pairs)), constraints=LinearConstraint(once, 0, 1), integrality=1, bounds=Bounds(0, 1))
    assert best.success
    return bool(2 * round(-best.fun) == len(quads))

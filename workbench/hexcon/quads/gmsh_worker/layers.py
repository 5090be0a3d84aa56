# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many layers of hexes lie along each face of a solid that is cut into one block per corner.

The block at the corner of faces a, b, c has as many hexes across as each of them has layers. So one number per face
settles all: an edge that ends on faces a and b has layers[a] + layers[b] intervals, and so has every line beside it;
from the middle of an edge to the centre of a face run as many as the face across that edge has layers.
"""
from itertools import combinations

import numpy as np

from .outline import least_count

ARM_WEIGHT = 0.5        # of a line from an edge's middle to a face's centre, against an edge as long
LARGE = 60              # faces above which only neighbours are changed together


def layer_counts(solid, sides, size):
    """dict face -> layers >= 1, for edges as near to `size` as such numbers allow.

    sides: of corner_sides. A descent from the rounded ideal by single steps, and by steps of two faces at once.
    """
    faces = sorted(sides)
    member, desired, weight, least = _lines(solid, sides, size, {f: k for k, f in enumerate(faces)})
    ideal = np.linalg.lstsq(member * weight[:, None], desired * weight, rcond=None)[0]
    layers = np.maximum(np.rint(ideal), 1).astype(int)
    steps = _steps(member)

    def cost(counts):
        intervals = member @ counts
        too_few = np.maximum(least - intervals, 0).sum()
        return 1e6 * too_few + (weight * np.log(intervals / desired) ** 2).sum()

    best = cost(layers)
    while True:
        tries = [layers + step for step in steps if (layers + step).min() >= 1]
        costs = [cost(t) for t in tries]
        if not tries or min(costs) >= best - 1e-12 * max(best, 1.0):
            return {f: int(n) for f, n in zip(faces, layers)}
        best, layers = min(costs), tries[int(np.argmin(costs))]


def thirds(side_list, k):
    """(face on which side k of a face starts, face on which it ends): those across the sides before and after it."""
    return side_list[k - 1][1], side_list[(k + 1) % len(side_list)][1]


def _lines(solid, sides, size, row):
    """Edges and arms: (member (m,F) of layers that add up, desired (m,) intervals, weight (m,), least (m,))."""
    lines, seen = [], set()
    for around in sides.values():
        middles = np.array([solid.edge_points(e, [0.5])[0] for e, _ in around])
        arms = np.linalg.norm(middles - middles.mean(axis=0), axis=1)
        for k, (edge, across) in enumerate(around):
            lines.append(([row[across]], arms[k], ARM_WEIGHT * arms[k], 1))
            if abs(edge) not in seen:
                seen.add(abs(edge))
                length = solid.length(edge)
                lines.append(([row[f] for f in thirds(around, k)], length, length,
                              least_count(solid.turning(edge), False)))
    member = np.zeros((len(lines), len(row)))
    for k, line in enumerate(lines):
        np.add.at(member[k], line[0], 1.0)
    lengths, weight, least = (np.array([line[k] for line in lines]) for k in (1, 2, 3))
    return member, np.maximum(lengths / size, 0.05), weight, least


def _steps(member):
    """Changes worth a try: one face by one, two faces by one each, in either sense."""
    count = member.shape[1]
    unit = np.eye(count, dtype=int)
    pairs = list(combinations(range(count), 2))
    if count > LARGE:
        linked = {tuple(np.flatnonzero(m)) for m in member}
        pairs = [p for p in pairs if p in linked]
    steps = [s * unit[k] for k in range(count) for s in (1, -1)]
    return steps + [s * unit[a] + t * unit[b] for a, b in pairs for s in (1, -1) for t in (1, -1)]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pairs that remove the self-crossings: the transitioned surface, built quad by quad, has none; few pairs, and the
fewest on small surfaces."""
import functools

import numpy as np
import pytest
import surfaces as make
from quadrangulations import all_quadrangulations, random_quadrangulation

import hexcon_native as hn


def transitioned(quads, pairs):
    """The quads after the paired transition: six for each pair, of quads that share one edge; four points more."""
    rows, fresh = quads.tolist(), int(quads.max()) + 1
    left = set(range(len(rows))) - set(np.ravel(pairs).tolist())
    after = [rows[k] for k in sorted(left)]
    for one, two in np.asarray(pairs).tolist():
        sides = {(rows[two][k - 1], rows[two][k]): k for k in range(4)}
        [k] = [k for k in range(4) if (rows[one][k], rows[one][k - 1]) in sides]
        v2, v5, v4, v1 = (rows[one][(k + i) % 4] for i in (-1, 0, 1, 2))
        k = sides[v5, v2]
        v3, v6 = rows[two][(k + 1) % 4], rows[two][(k + 2) % 4]
        v7, v8, v9, v10 = range(fresh, fresh + 4)
        fresh += 4
        after += [[v1, v2, v7, v8], [v7, v2, v3, v8], [v1, v8, v9, v4], [v8, v3, v6, v9], [v4, v9, v10, v5],
                  [v9, v6, v5, v10]]
    return np.array(after)


def self_crossings(quads):
    """Quads that one loop passes twice, by walking."""
    rows = quads.tolist()
    place = {(row[k - 1], row[k]): (q, k) for q, row in enumerate(rows) for k in range(4)}
    assert len(place) == 4 * len(rows)
    loop_of = {}
    for start in place.values():
        (q, k), number = start, len(loop_of)
        while (q, k % 2) not in loop_of:
            loop_of[q, k % 2] = number
            k = (k + 2) % 4
            q, k = place[rows[q][k], rows[q][k - 1]]
    return sum(loop_of[q, 0] == loop_of[q, 1] for q in range(len(rows)))


def few_pairs(quads):
    """The core's pairs, checked."""
    pairs = hn.pairing(quads, fewest=True)
    assert pairs.dtype == np.int32 and pairs.shape == (len(pairs), 2)
    assert len(np.unique(pairs)) == pairs.size and (pairs[:, 0] < pairs[:, 1]).all()
    assert (np.diff(pairs[:, 0]) > 0).all()
    after = transitioned(quads, pairs)
    assert len(after) == len(quads) + 4 * len(pairs)
    assert self_crossings(after) == 0
    assert all(len(np.unique(loop)) == len(loop) for loop in hn.loops(after))
    return pairs


def matchings(edges, size, first=0, used=frozenset()):
    """Every set of `size` disjoint edges."""
    if size == 0:
        yield ()
        return
    for k in range(first, len(edges)):
        if used.isdisjoint(edges[k]):
            for rest in matchings(edges, size - 1, k + 1, used | set(edges[k])):
                yield (edges[k], *rest)


def fewest_by_trying(quads):
    edges = sorted({tuple(sorted(pair)) for pair in neighbours(quads)})
    size = 0
    while not any(self_crossings(transitioned(quads, pairs)) == 0 for pairs in matchings(edges, size)):
        size += 1
    return size


def neighbours(quads):
    of_edge = {}
    for q, row in enumerate(quads.tolist()):
        for k in range(4):
            of_edge.setdefault(frozenset((row[k - 1], row[k])), []).append(q)
    return of_edge.values()


@functools.lru_cache
def small():
    return [quads for n, found in all_quadrangulations(12).items() if n % 2 == 0 for quads in found]


def test_fewest():
    """Nothing is better, on every quadrangulation of a convex polyhedron with an even number of quads up to twelve."""
    for quads in small():
        assert len(few_pairs(quads)) == fewest_by_trying(quads)


@pytest.mark.parametrize("n", [20, 60])
def test_random(n):
    """A good part of the pairs is spared."""
    few = [len(few_pairs(random_quadrangulation(np.random.default_rng(seed), n))) for seed in range(2)]
    assert max(few) < 0.6 * n / 2


def test_nothing_crosses_itself():
    points, quads = make.box(4, 5, 6)
    assert hn.pairing(quads, fewest=True).shape == (0, 2)
    assert hn.pairing(quads, points, fewest=True).shape == (0, 2)


def test_larger():
    """Beyond the size where every attempt is made; two parts, one without self-crossings; stray ids."""
    rng = np.random.default_rng(1)
    crossed, (_, box) = random_quadrangulation(rng, 400), make.box(25, 25, 30)
    quads = np.vstack([crossed, box + crossed.max() + 1])
    pairs = few_pairs(quads)
    assert 0 < len(pairs) < 2400 and self_crossings(quads) > 0
    assert hn.pairing(quads + 10 ** 6, fewest=True).tobytes() == pairs.tobytes()


def test_faults():
    quads = random_quadrangulation(np.random.default_rng(0), 9)
    assert self_crossings(quads) > 0
    with pytest.raises(hn.HexconError) as fault:
        hn.pairing(quads, fewest=True)
    assert fault.value.code == hn.ErrorCode.ODD
    quads = random_quadrangulation(np.random.default_rng(0), 30)
    with pytest.raises(hn.HexconError) as fault:
        hn.pairing(quads, fewest=True, progress=lambda stage, fraction: False)
    assert fault.value.code == hn.ErrorCode.CANCELLED

# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sign of the Jacobian of hexes of 20 nodes with small integer coordinates, exactly; shares no code with the core.

By monomials: the serendipity shape functions on [0, 1]^3 have integer coefficients, so the determinant has, and its
Bernstein coefficients times 1000. int64 where that is enough, Python's integers for the bisection of what is left.
"""
from fractions import Fraction
from math import comb

import numpy as np

CORNERS = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)])
ENDS = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))
LARGEST = 24        # |coordinate| with which int64 is enough
BOXES = 400


def _times(a, b):
    """Product of two polynomials with coefficients at [i, j, k]."""
    out = np.zeros(np.array(a.shape) + b.shape - 1, object)
    for at, value in np.ndenumerate(a):
        if value:
            out[at[0]:at[0] + b.shape[0], at[1]:at[1] + b.shape[1], at[2]:at[2] + b.shape[2]] += value * b
    return out


def _linear(axis, constant, slope):
    out = np.zeros([2 if axis == k else 1 for k in range(3)], object)
    out[0, 0, 0] = constant
    out[tuple(1 if axis == k else 0 for k in range(3))] = slope
    return out


def _shape_functions():
    """(20,3,3,3) integer coefficients of r^i s^j t^k."""
    found = np.zeros((20, 3, 3, 3), np.int64)

    def put(n, polynomial):
        found[n, :polynomial.shape[0], :polynomial.shape[1], :polynomial.shape[2]] = polynomial.astype(np.int64)
    for n, corner in enumerate(CORNERS):
        sides = [_linear(k, 1 - c, 2 * c - 1) for k, c in enumerate(corner.tolist())]
        last = np.zeros((2, 2, 2), object)      # 1 - 2 (distance from the corner along each axis)
        last[0, 0, 0] = 1 - 2 * int(corner.sum())
        for k, c in enumerate(corner.tolist()):
            last[tuple(int(k == m) for m in range(3))] = 2 * (2 * c - 1)
        put(n, _times(_times(_times(sides[0], sides[1]), sides[2]), last))
    for e, (a, b) in enumerate(ENDS):
        axis = int(np.flatnonzero(CORNERS[a] != CORNERS[b])[0])
        polynomial = np.array([[[4]]], object)
        for k in range(3):
            if k == axis:
                polynomial = _times(polynomial, _times(_linear(k, 0, 1), _linear(k, 1, -1)))
            else:
                polynomial = _times(polynomial, _linear(k, 1 - int(CORNERS[a][k]), 2 * int(CORNERS[a][k]) - 1))
        put(8 + e, polynomial)
    return found


_SHAPES = _shape_functions()
# Bernstein coefficients of degree 5, times 10, of the monomials
_TO_BERNSTEIN = np.array([[10 * comb(i, k) // comb(5, k) for k in range(6)] for i in range(6)], np.int64)


def _convolved(a, b, out_shape):
    """Products of polynomials of many hexes, (n, i, j, k) each."""
    out = np.zeros((len(a), *out_shape), a.dtype)
    for i, j, k in np.ndindex(*b.shape[1:]):
        out[:, i:i + a.shape[1], j:j + a.shape[2], k:k + a.shape[3]] += a * b[:, i, j, k][:, None, None, None]
    return out


def coefficients(nodes):
    """(n,6,6,6) int64: 1000 times the Bernstein coefficients of the determinants; nodes (n,20,3) integers."""
    nodes = np.asarray(nodes, np.int64)
    assert np.abs(nodes).max() <= LARGEST
    maps = np.einsum("pnc,nijk->cpijk", nodes, _SHAPES)     # [coordinate][hex]
    powers = np.arange(1, 3)
    slopes = [[maps[c][:, 1:] * powers[:, None, None], maps[c][:, :, 1:] * powers[:, None],
               maps[c][:, :, :, 1:] * powers] for c in range(3)]
    total = np.zeros((len(nodes), 6, 6, 6), np.int64)
    for a, b, c, sign in ((0, 1, 2, 1), (1, 2, 0, 1), (2, 0, 1, 1), (0, 2, 1, -1), (2, 1, 0, -1), (1, 0, 2, -1)):
        pair = _convolved(slopes[b][1], slopes[c][2], (5, 4, 4))
        total += sign * _convolved(pair, slopes[a][0], (6, 6, 6))
    for axis in (1, 2, 3):
        total = np.moveaxis(np.tensordot(total, _TO_BERNSTEIN, axes=([axis], [1])), -1, axis)
    return total


def _halves(box, axis):
    """De Casteljau at 1/2, times 32."""
    rows = [np.moveaxis(box, axis, 0)[k] * 32 for k in range(6)]
    low, high = [rows[0]], [rows[5]]
    while len(rows) > 1:
        rows = [(a + b) // 2 for a, b in zip(rows, rows[1:])]     # exact: five halvings of a multiple of 32
        low.append(rows[0])
        high.append(rows[-1])
    return [np.moveaxis(np.array(half, object), 0, axis) for half in (low, high[::-1])]


def _sign(box):
    """1, -1, or 0 where bisection comes to no end, of one hex."""
    boxes, depth = [(box.astype(object), 0)], 0
    for _ in range(BOXES):
        if not boxes:
            return 1
        box, depth = boxes.pop()
        if min(box[::5, ::5, ::5].ravel()) <= 0:
            return -1
        if min(box.ravel()) <= 0:
            boxes += [(half, depth + 1) for half in _halves(box, depth % 3)]
    return 0


def signs(nodes):
    """(n,) 1: positive on the whole closed hex, -1: somewhere not, 0: not told. nodes (n,20,3) small integers."""
    found = coefficients(nodes)
    flat = found.reshape(len(found), -1)
    answer = np.where(flat.min(axis=1) > 0, 1, 0)
    answer[found[:, ::5, ::5, ::5].reshape(len(found), -1).min(axis=1) <= 0] = -1
    for n in np.flatnonzero(answer == 0):
        answer[n] = _sign(found[n])
    return answer


def value(nodes, place):
    """The determinant at local coordinates, exactly; nodes (20,3) and place (3,) of any doubles."""
    powers = [[Fraction(float(x)) ** k for k in range(3)] for x in place]
    slopes = [[0] + [k * Fraction(float(x)) ** (k - 1) for k in (1, 2)] for x in place]
    rows = []
    for axis in range(3):
        by = [slopes[k] if k == axis else powers[k] for k in range(3)]
        weights = [sum(int(c) * by[0][i] * by[1][j] * by[2][k] for (i, j, k), c in np.ndenumerate(shape) if c)
                   for shape in _SHAPES]
        rows.append([sum(w * Fraction(float(x)) for w, x in zip(weights, column)) for column in np.asarray(nodes).T])
    (a, b, c), (d, e, f), (g, h, i) = rows
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


def random_hexes(rng, count):
    """(count,20,3) integer nodes of several kinds: little and much bent, nearly flat, with middle nodes near quarters,
    far inside, flat edges, corners folded."""
    size = rng.integers(1, 5, count) * 4
    nodes = np.empty((count, 20, 3), np.int64)
    nodes[:, :8] = CORNERS[None] * size[:, None, None]
    kind = rng.integers(0, 6, count)
    shake = np.array([0, 1, 2, 1, 3, 0])[kind]
    nodes[:, :8] += rng.integers(-3, 4, (count, 8, 3)).clip(-shake[:, None, None], shake[:, None, None])
    flat = kind == 3
    nodes[flat, :, 2] = (nodes[flat, :, 2] > size[flat, None] // 2).astype(int)
    for e, (a, b) in enumerate(ENDS):
        nodes[:, 8 + e] = (nodes[:, a] + nodes[:, b]) // 2
    bow = np.array([1, 1, 2, 1, 4, 0])[kind]
    nodes[:, 8:] += rng.integers(-4, 5, (count, 12, 3)).clip(-bow[:, None, None], bow[:, None, None]) * \
        (rng.random((count, 12, 1)) < 0.4)
    quarter = np.flatnonzero(kind == 5)          # a middle node at a quarter of its edge: a double root, or nearly
    for n in quarter:
        e = rng.integers(0, 12)
        a, b = nodes[n, ENDS[e][0]], nodes[n, ENDS[e][1]]
        nodes[n, 8 + e] = (3 * a + b) // 4
    return nodes.clip(-LARGEST, LARGEST)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quality of plane quad meshes, and moving interior points to raise it.

points (m,2) float64, quads (n,4) int, counter-clockwise. Cost is linear in n per iteration.
"""
import numpy as np
from scipy.optimize import minimize

_TINY = 1e-300
EVEN = 0.3      # weight of aspect ratios beside angles
ANGLES = EVEN / 30.0    # the same where angles are to rule
DONE = 1e-5     # of the energy: a step that gains less is the last; 1e-9 takes 2.6 times as many and gains 0.001
POOR = 0.7      # of what the corners allow: below it angles alone are looked at, too


def corners(points, quads):
    """Per quad and corner: edge vectors to the next and to the previous point, and their cross product."""
    p = points[quads]
    a = np.roll(p, -1, axis=1) - p
    b = np.roll(p, 1, axis=1) - p
    return a, b, a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def scaled_jacobian(points, quads):
    """(n,) minimum over the corners of sine of the corner angle; negative where inverted."""
    a, b, det = corners(points, quads)
    scale = np.sqrt((a * a).sum(-1) * (b * b).sum(-1))
    return (det / np.maximum(scale, _TINY)).min(axis=1)


def evenness(points, quads):
    """(n,) shortest edge of each quad by its longest."""
    p = points[quads]
    length = np.linalg.norm(np.roll(p, -1, axis=1) - p, axis=2)
    return length.min(axis=1) / np.maximum(length.max(axis=1), _TINY)


def merit(points, quads, limit):
    """What a plane mesh is worth: from its worst and its mean scaled Jacobian, the worst also bounded by how even the
    quads are: those up to three times as long as wide count as square.

    limit: the scaled Jacobian that the outline's corners allow
    """
    quality = scaled_jacobian(points, quads)
    worst = min(float(quality.min()), max(limit, 0.05) * 3.0 * float(evenness(points, quads).min()))
    return 0.65 * worst + 0.35 * float(quality.mean())


def space_quality(points, quads):
    """(n,) the same for quads in space, points (m,3), about each quad's own normal."""
    p = points[quads]
    normal = np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1])
    normal /= np.maximum(np.linalg.norm(normal, axis=1), _TINY)[:, None]
    a, b = np.roll(p, -1, axis=1) - p, np.roll(p, 1, axis=1) - p
    scale = np.sqrt((a * a).sum(-1) * (b * b).sum(-1))
    return (np.einsum("nkd,nd->nk", np.cross(a, b), normal) / np.maximum(scale, _TINY)).min(axis=1)


def optimise(points, quads, fixed, budget=4_000_000, slides=None, even=EVEN):
    """Points (m,2) with the worst scaled Jacobian raised; never worse than given. fixed (m,) bool.

    slides: (rows (k,), directions (k,2) unit) of fixed points that may move along a line.
    even: weight of aspect ratios, in their square, to the end; 0: they fade away

    A descent on sum (1/sine)^p plus a little for aspect ratio, p rising, so that the worst corners
    come to rule; an inverted start is untangled by the regularised determinant first.
    budget: corner evaluations allowed, about one second for 4e6.
    """
    free = np.flatnonzero(~fixed)
    if not len(free) and slides is None:
        return points
    slides = slides if slides is not None else (np.empty(0, int), np.empty((0, 2)))
    rounds = int(np.clip(budget / (4 * len(quads)) / 6, 12, 120))
    best, best_key = points, _key(points, quads)
    current = points
    for power, aspect in ((1, 1.0), (2, 0.3), (4, 0.1), (8, 0.03), (12, 0.01)):
        for _ in range(4):
            current = _descend(current, quads, free, slides, power, max(aspect, even), 2 if even else 1, rounds)
            if scaled_jacobian(current, quads).min() > 0.01:
                break
        key = _key(current, quads)
        if key > best_key:
            best, best_key = current, key
        if key[0] < 0.01:
            break
    return best


def placed(points, quads, fixed, limit):
    """optimise with even quads in mind; where the worst is far from `limit`, with it alone: the better by merit."""
    best = optimise(points, quads, fixed)
    if scaled_jacobian(best, quads).min() < POOR * limit:
        best = max(best, optimise(best, quads, fixed, even=ANGLES), key=lambda p: merit(p, quads, limit))
    return best


def _key(points, quads):
    sj = scaled_jacobian(points, quads)
    return min(0.01, float(sj.min())), 0.75 * float(sj.min()) + 0.25 * float(sj.mean())


def _descend(points, quads, free, slides, power, aspect, square, rounds):
    """L-BFGS from SciPy on the free coordinates and the ways along slides, in units of the mean quad so that its first
    step fits."""
    det = corners(points, quads)[2]
    size = float(np.abs(det).mean())
    valid = det.min() > 1e-3 * size
    eps = 1e-3 * size if valid else max(1e-3 * size, -0.5 * float(det.min()))   # never 0: line searches need
    reference = 1.0 / max(scaled_jacobian(points, quads).min(), 0.05) if valid else 1.0     # finite values
    unit, (rows, ways), split = np.sqrt(size), slides, 2 * len(free)

    def moved(x):
        result = points.copy()
        result[free] = x[:split].reshape(-1, 2) * unit
        result[rows] += x[split:, None] * ways * unit
        return result

    def value(x):
        e, g = _energy(moved(x), quads, power if valid else 1, aspect, square if valid else 1, eps, reference)
        return e, np.concatenate([g[free].ravel(), (g[rows] * ways).sum(axis=1)]) * unit

    start = np.concatenate([points[free].ravel() / unit, np.zeros(len(rows))])
    found = minimize(value, start, jac=True, method="L-BFGS-B",
                     options={"maxiter": rounds, "maxcor": 8, "maxls": 30, "ftol": DONE, "gtol": 1e-9})
    return moved(found.x)


def _energy(points, quads, power, aspect, square, eps, reference):
    """(value, gradient (m,2)) of sum ((|a||b|/chi)/reference)^power + aspect ((|a|^2+|b|^2)/(2 chi))^square.

    chi is the smooth positive part of the determinant, all but the determinant itself where that is above eps.
    """
    a, b, det = corners(points, quads)
    root = np.sqrt(det * det + eps * eps)
    chi, dchi = 0.5 * (det + root), 0.5 * (1.0 + det / np.maximum(root, _TINY))
    aa, bb = (a * a).sum(-1), (b * b).sum(-1)
    la, lb = np.sqrt(np.maximum(aa, _TINY)), np.sqrt(np.maximum(bb, _TINY))
    sine = la * lb / chi
    term = (sine / reference) ** power
    ratio = (aa + bb) / (2.0 * chi)
    shape = aspect * ratio ** square
    slope = square * aspect * ratio ** (square - 1) / chi
    e_det = -(power * term + square * shape) / chi * dchi
    e_a = (power * term / np.maximum(aa, _TINY) + slope)[..., None] * a
    e_b = (power * term / np.maximum(bb, _TINY) + slope)[..., None] * b
    e_a = e_a + e_det[..., None] * np.stack([b[..., 1], -b[..., 0]], -1)
    e_b = e_b + e_det[..., None] * np.stack([-a[..., 1], a[..., 0]], -1)
    per_corner = np.roll(e_a, 1, axis=1) + np.roll(e_b, -1, axis=1) - e_a - e_b
    flat, ids = per_corner.reshape(-1, 2), quads.ravel()
    gradient = np.stack([np.bincount(ids, flat[:, k], minlength=len(points)) for k in range(2)], 1)
    return float(term.sum() + shape.sum()), gradient

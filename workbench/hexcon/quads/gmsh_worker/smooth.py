# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quality of plane quad meshes, and moving interior points to raise it.

points (m,2) float64, quads (n,4) int, counter-clockwise. Cost is linear in n per iteration.
"""
import numpy as np

_TINY = 1e-300


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


def space_quality(points, quads):
    """(n,) the same for quads in space, points (m,3), about each quad's own normal."""
    p = points[quads]
    normal = np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1])
    normal /= np.maximum(np.linalg.norm(normal, axis=1), _TINY)[:, None]
    a, b = np.roll(p, -1, axis=1) - p, np.roll(p, 1, axis=1) - p
    scale = np.sqrt((a * a).sum(-1) * (b * b).sum(-1))
    return (np.einsum("nkd,nd->nk", np.cross(a, b), normal) / np.maximum(scale, _TINY)).min(axis=1)


def optimise(points, quads, fixed, budget=4_000_000):
    """Points (m,2) with the worst scaled Jacobian raised; never worse than given. fixed (m,) bool.

    A descent on sum (1/sine)^p plus a little for aspect ratio, p rising, so that the worst corners
    come to rule; an inverted start is untangled by the regularised determinant first.
    budget: corner evaluations allowed, about one second for 4e6.
    """
    free = np.flatnonzero(~fixed)
    if not len(free):
        return points
    rounds = int(np.clip(budget / (4 * len(quads)) / 6, 12, 120))
    best, best_key = points, _key(points, quads)
    current = points
    for power, aspect in ((1, 1.0), (2, 0.3), (4, 0.1), (8, 0.03), (12, 0.01)):
        for _ in range(4):
            current = _descend(current, quads, free, power, aspect, rounds)
            if scaled_jacobian(current, quads).min() > 0.01:
                break
        key = _key(current, quads)
        if key > best_key:
            best, best_key = current, key
        if key[0] < 0.01:
            break
    return best


def _key(points, quads):
    sj = scaled_jacobian(points, quads)
    return min(0.01, float(sj.min())), 0.75 * float(sj.min()) + 0.25 * float(sj.mean())


def _descend(points, quads, free, power, aspect, rounds):
    """L-BFGS with a backtracking line search; memory 8."""
    det = corners(points, quads)[2]
    size = float(np.abs(det).mean())
    eps = 0.0 if det.min() > 1e-3 * size else max(1e-3 * size, -0.5 * float(det.min()))
    floor = scaled_jacobian(points, quads).min() if eps == 0.0 else None
    reference = 1.0 / max(floor, 0.05) if floor is not None else 1.0

    def value(x):
        moved = points.copy()
        moved[free] = x.reshape(-1, 2)
        e, g = _energy(moved, quads, power if eps == 0.0 else 1, aspect, eps, reference)
        return e, g[free].ravel()

    x = points[free].ravel()
    e, g = value(x)
    steps, changes = [], []
    length = np.sqrt(size)
    for _ in range(rounds):
        d = -_two_loop(g, steps, changes)
        slope = float(d @ g)
        if slope >= 0:
            steps, changes = [], []
            d, slope = -g, -float(g @ g)
        t = min(1.0, 0.3 * length / max(float(np.abs(d).max()), _TINY))
        for _ in range(20):
            e_new, g_new = value(x + t * d)
            if e_new <= e + 1e-4 * t * slope:
                break
            t *= 0.4
        else:
            break
        s, y = t * d, g_new - g
        if float(s @ y) > 1e-14 * float(y @ y):
            steps, changes = steps[-7:] + [s], changes[-7:] + [y]
        done = e - e_new < 1e-7 * abs(e)
        x, e, g = x + s, e_new, g_new
        if done:
            break
    result = points.copy()
    result[free] = x.reshape(-1, 2)
    return result


def _two_loop(g, steps, changes):
    q, alphas = g.copy(), []
    for s, y in zip(reversed(steps), reversed(changes)):
        alpha = float(s @ q) / float(s @ y)
        alphas.append(alpha)
        q -= alpha * y
    if steps:
        q *= float(steps[-1] @ changes[-1]) / float(changes[-1] @ changes[-1])
    for (s, y), alpha in zip(zip(steps, changes), reversed(alphas)):
        q += (alpha - float(y @ q) / float(s @ y)) * s
    return q


def _energy(points, quads, power, aspect, eps, reference):
    """(value, gradient (m,2)) of sum ((|a||b|/chi)/reference)^power + aspect (|a|^2+|b|^2)/(2 chi).

    chi is the determinant, or for eps > 0 its smooth positive part.
    """
    a, b, det = corners(points, quads)
    if eps == 0.0 and det.min() <= 0.0:
        return np.inf, np.zeros_like(points)
    root = np.sqrt(det * det + eps * eps)
    chi, dchi = 0.5 * (det + root), 0.5 * (1.0 + det / np.maximum(root, _TINY))
    aa, bb = (a * a).sum(-1), (b * b).sum(-1)
    la, lb = np.sqrt(np.maximum(aa, _TINY)), np.sqrt(np.maximum(bb, _TINY))
    sine = la * lb / chi
    term = (sine / reference) ** power
    shape = aspect * (aa + bb) / (2.0 * chi)
    e_det = -(power * term + shape) / chi * dchi
    e_a = (power * term / np.maximum(aa, _TINY) + aspect / chi)[..., None] * a
    e_b = (power * term / np.maximum(bb, _TINY) + aspect / chi)[..., None] * b
    e_a = e_a + e_det[..., None] * np.stack([b[..., 1], -b[..., 0]], -1)
    e_b = e_b + e_det[..., None] * np.stack([-a[..., 1], a[..., 0]], -1)
    per_corner = np.roll(e_a, 1, axis=1) + np.roll(e_b, -1, axis=1) - e_a - e_b
    flat, ids = per_corner.reshape(-1, 2), quads.ravel()
    gradient = np.stack([np.bincount(ids, flat[:, k], minlength=len(points)) for k in range(2)], 1)
    return float(term.sum() + shape.sum()), gradient

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Any plane region into quads by splitting it again and again, until four or six points are left round each part.

After Talbert and Parkinson, Development of an automatic, two-dimensional finite element mesh generator using
quadrilateral elements and Bezier curve boundary definition (1990); what a split costs is as in Sarrate and Huerta,
Efficient unstructured quadrilateral mesh generation (2000): the angles it makes, how its length divides, its length.
"""
import numpy as np

ANGLE, FIT, LONG = 0.55, 0.25, 0.2      # weights of what a split costs
MOST = 400          # points of a loop of which all pairs are looked at; of longer ones every second, third ...
HIDDEN = 1e9        # cost of a split that is none
LOOKED_AT = 4000    # of the cheapest splits it is asked whether they are free
EPS = 1e-9


def split_mesh(loops):
    """(points (m,2), those of the loops first; quads (n,4)) or None where no split is found.

    loops: as region.PlaneRegion has them. Some n^2 log n of the boundary's points n for each split.
    """
    work = _Parts(loops)
    try:
        todo = [work.without_holes()]
        while todo:
            loop = todo.pop()
            if len(loop) <= 6:
                work.close(loop)
            else:
                todo += work.split(loop)
    except _NoSplit:
        return None
    return np.array(work.points), np.array(work.quads)


class _NoSplit(Exception):
    pass


class _Parts:
    """points: list of (2,); loops are lists of their ids, counter-clockwise, on which an id may come twice."""

    def __init__(self, loops):
        self.points = [p for loop in loops for p in np.asarray(loop, float)]
        self.quads, ids = [], np.split(np.arange(len(self.points)), np.cumsum([len(loop) for loop in loops])[:-1])
        self._loops = [list(map(int, i)) for i in ids]
        steps = np.concatenate([np.linalg.norm(np.roll(p, -1, axis=0) - p, axis=1) for p in loops])
        self._spacing = float(steps.mean())

    def without_holes(self):
        """One loop, joined with each hole by a path there and back."""
        outer, holes = self._loops[0], self._loops[1:]
        while holes:
            best, p, sides = None, self._at(outer), [self._at(hole) for hole in holes]
            for h, q in enumerate(sides):
                cost = _costs(p, q)
                i, j = next(_seen(cost, p, q, [p, *sides]), (None, None))
                if i is not None and (best is None or cost[i, j] < best[0]):
                    best = cost[i, j], h, i, j
            if best is None:
                raise _NoSplit
            _, h, i, j = best
            hole = holes.pop(h)
            hole = hole[j:] + hole[:j]
            path = self._path(outer[i], hole[0], self._steps(outer, i, hole, 0))
            outer = outer[:i + 1] + path + hole + [hole[0]] + path[::-1] + outer[i:]
        return outer

    def split(self, loop):
        """Both parts of a loop of more than six points."""
        n, p = len(loop), self._at(loop)
        every = max(1, int(np.ceil(n / MOST)))
        rows = np.arange(0, n, every)
        cost = _costs(p[rows], p, rows)
        apart = (np.arange(n)[None] - rows[:, None]) % n
        ids = np.array(loop)
        cost[(apart < 3) | (apart > n - 3) | (ids[rows][:, None] == ids[None])] = np.inf
        for a, j in _seen(cost, p[rows], p, [p]):
            i, j = sorted((int(rows[a]), j))
            steps = self._steps(loop, i, loop, j, (j - i) % 2)
            if j - i + steps < 4 or n - (j - i) + steps < 4 or max(j - i, n - (j - i)) + steps >= n:
                continue
            path = self._path(loop[i], loop[j], steps)
            return [loop[i:j + 1] + path[::-1], loop[:i + 1] + path + loop[j:]]
        raise _NoSplit

    def close(self, loop):
        """The quads of four or six points."""
        if len(loop) == 4:
            self.quads.append(loop)
            return
        if len(loop) != 6:
            raise _NoSplit
        ways = [[[loop[k], loop[k + 1], loop[k + 2], loop[(k + 3) % 6]],
                 [loop[(k + 3) % 6], loop[(k + 4) % 6], loop[(k + 5) % 6], loop[k]]] for k in range(3)]
        worst = [min(_quality(self._at(q)) for q in way) for way in ways]
        if max(worst) < 0.35 and len(set(loop)) == 6:
            middle = len(self.points)
            self.points.append(self._at(loop).mean(0))
            stars = [[[loop[(k + 2 * m) % 6], loop[(k + 2 * m + 1) % 6], loop[(k + 2 * m + 2) % 6], middle]
                      for m in range(3)] for k in (0, 1)]
            ways += stars
            worst += [min(_quality(self._at(q)) for q in way) for way in stars]
            if int(np.argmax(worst)) < 3:
                self.points.pop()
        self.quads += ways[int(np.argmax(worst))]

    def _at(self, ids):
        return np.array([self.points[k] for k in ids])

    def _steps(self, one, i, other, j, parity=None):
        """Intervals of a path, of the given parity."""
        length = np.linalg.norm(self.points[one[i]] - self.points[other[j]])
        near = [self._near(one, i), self._near(other, j)]
        wanted = length / max(0.5 * np.mean(near) + 0.5 * min(np.mean(near), self._spacing), 1e-300)
        if parity is None:
            return max(1, int(np.rint(wanted)))
        return max(2 - parity, parity + 2 * int(np.rint((wanted - parity) / 2)))

    def _near(self, loop, k):
        """Mean length of the steps to a point and from it."""
        here, n = self.points[loop[k]], len(loop)
        return sum(np.linalg.norm(here - self.points[loop[j % n]]) for j in (k - 1, k + 1)) / 2

    def _path(self, a, b, steps):
        """New ids between two points."""
        start = len(self.points)
        for k in range(1, steps):
            self.points.append(self.points[a] + (self.points[b] - self.points[a]) * (k / steps))
        return list(range(start, start + steps - 1))


def _quality(p):
    """Least sine of a quad's corners, negative where it is turned over."""
    a, b = np.roll(p, -1, axis=0) - p, np.roll(p, 1, axis=0) - p
    cross = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return float((cross / np.maximum(np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1), 1e-300)).min())


def _costs(from_, to, rows=None):
    """(n,m) what a straight split from each of n points to each of m costs; HIDDEN and more where it begins outside.

    rows: which of `to` the points from_ are, where both are one loop; else `to` is a hole, and both are whole loops
    """
    same = rows is not None
    d = to[None] - from_[:, None]
    length = np.linalg.norm(d, axis=2)
    heading = np.arctan2(d[..., 1], d[..., 0])
    whole = to if same else from_
    cost = ANGLE * _angle_cost(whole, rows if same else np.arange(len(from_)), heading)
    cost = np.maximum(cost, ANGLE * _angle_cost(to, np.arange(len(to)), np.arctan2(-d[..., 1], -d[..., 0]).T).T)
    steps = np.linalg.norm(np.roll(whole, -1, axis=0) - whole, axis=1).mean()
    count = length / max(steps, 1e-300)
    cost += FIT * np.minimum(np.abs(count - np.maximum(np.rint(count), 1.0)), 1.0)
    cost += LONG * length / max(np.ptp(whole, axis=0).max(), 1e-300)
    cost[length <= EPS] = HIDDEN
    return cost


def _angle_cost(loop, rows, heading):
    """(n,m) how far the two angles that a split makes at points of a loop are from right ones; HIDDEN outside."""
    ahead, back = np.roll(loop, -1, axis=0) - loop, np.roll(loop, 1, axis=0) - loop
    first, last = (np.arctan2(v[rows, 1], v[rows, 0]) for v in (ahead, back))
    whole = (last - first) % (2 * np.pi)
    whole = np.where(whole < 1e-9, 2 * np.pi, whole)
    one = (heading - first[:, None]) % (2 * np.pi)
    two = whole[:, None] - one
    right = np.pi / 2
    parts = [np.abs(x - right * np.maximum(np.rint(x / right), 1.0)) / right for x in (one, two)]
    return np.where(two > 1e-6, np.maximum(*parts) + 0.3 * np.minimum(*parts), HIDDEN)


def _seen(cost, from_, to, loops):
    """Pairs (i, j) in the order of their costs, of those points that see each other past the sides of loops."""
    sides = np.concatenate([np.stack([p, np.roll(p, -1, axis=0)], 1) for p in loops])
    scale = np.ptp(sides.reshape(-1, 2), axis=0).max()
    order = np.argsort(cost, axis=None, kind="stable")
    order = order[:np.searchsorted(cost.ravel()[order], HIDDEN)][:LOOKED_AT]
    for some in np.array_split(order, max(1, len(order) // 32)):
        i, j = np.unravel_index(some, cost.shape)
        free = ~_crossed(from_[i], to[j], sides, scale).any(1)
        yield from zip(i[free].tolist(), j[free].tolist())


def _crossed(a, to, sides, scale):
    """(m,s) whether lines, each from a point of a to one of `to`, meet sides; those with an end in either do not."""
    p, q, a, to = sides[None, :, 0], sides[None, :, 1], a[:, None], to[:, None]
    d, e = to - a, q - p
    det = d[..., 0] * e[..., 1] - d[..., 1] * e[..., 0]
    flat = np.abs(det) < 1e-14 * scale ** 2
    det = np.where(flat, 1.0, det)
    r = p - a
    t = (r[..., 0] * e[..., 1] - r[..., 1] * e[..., 0]) / det
    u = (r[..., 0] * d[..., 1] - r[..., 1] * d[..., 0]) / det
    hit = ~flat & (t > -1e-9) & (t < 1 + 1e-9) & (u > -1e-9) & (u < 1 + 1e-9)
    tol = 1e-9 * scale
    own = (np.abs(p - a).max(-1) < tol) | (np.abs(q - a).max(-1) < tol)
    other = (np.abs(p - to).max(-1) < tol) | (np.abs(q - to).max(-1) < tol)
    return hit & ~own & ~other

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where rays through a triangulated solid are inside it."""
import numpy as np

PAIRS = 2_000_000     # rays times triangles looked at in one go
SHIFT = 1e-7          # of the extent: how far a ray is moved that meets the triangles an odd number of times
ROUNDED = 1e-10       # of the extent: rays nearer than this to one another are one


class SolidRays:
    """Rays along +z through closed triangles, for any number of bodies and cavities.

    points (V, 3) float64, triangles (T, 3) 0-based, in any orientation. Triangles of neighbouring faces need not share
    point ids, but must share coordinates. A ray through an edge or a point of the triangles is moved aside symbolically
    (Edelsbrunner and Muecke, Simulation of Simplicity, 1990), so that it meets one of the triangles there.
    Cost: O(T + bins) to make; a ray looks at the triangles of its bin, of which there are about T.
    """

    def __init__(self, points, triangles):
        corners = np.asarray(points, float)[np.asarray(triangles)]
        self._extent = max(float(np.ptp(corners.reshape(-1, 3), axis=0).max()), 1e-300) if len(corners) else 1.0
        a, b, c = (corners[:, k, :2] for k in range(3))
        upright = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) == (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
        self._corners = corners[~upright]
        self._bin_triangles()

    def lengths(self, xy, low, high):
        """(S,) how much of the piece from z = low (S,) to high (S,) of the ray through xy (S, 2) is inside."""
        unit = ROUNDED * self._extent
        whole = np.rint(np.asarray(xy, float) / unit)
        order = np.lexsort((whole[:, 1], whole[:, 0]))
        first = np.ones(len(whole), bool)
        first[1:] = (np.diff(whole[order], axis=0) != 0).any(axis=1)
        ray = np.empty(len(whole), int)
        ray[order] = np.cumsum(first) - 1
        owner, z = self._even_hits(whole[order[first]] * unit)
        if not len(z):
            return np.zeros(len(whole))
        return np.maximum(_inside_below(owner, z, ray, high) - _inside_below(owner, z, ray, low), 0)

    def _bin_triangles(self):
        """Bins of equal size in x and y, and the triangles whose box meets each."""
        count = len(self._corners)
        self._side = int(np.clip(np.sqrt(count), 1, 1024))
        flat = self._corners[:, :, :2].reshape(-1, 2)
        self._origin = flat.min(axis=0) if count else np.zeros(2)
        self._step = np.maximum(np.ptp(flat, axis=0) if count else np.ones(2), 1e-300) / self._side
        low, high = self._bin(self._corners[:, :, :2].min(axis=1)), self._bin(self._corners[:, :, :2].max(axis=1))
        width = high - low + 1
        which, place = _repeated(width[:, 0] * width[:, 1])
        column = low[which, 0] + place // width[which, 1]
        row = low[which, 1] + place % width[which, 1]
        bins = column * self._side + row
        order = np.argsort(bins, kind="stable")
        self._of_bin = which[order]
        self._start = np.searchsorted(bins[order], np.arange(self._side ** 2 + 1))

    def _bin(self, xy):
        return np.clip(((xy - self._origin) / self._step).astype(int), 0, self._side - 1)

    def _even_hits(self, xy):
        """(rays (M,), z (M,)) where rays (R, 2) meet triangles: by ray, then z; an even number for every ray."""
        ray, z = self._hits(xy)
        for attempt in range(3):
            odd = np.flatnonzero(np.bincount(ray, minlength=len(xy)) % 2)
            if not len(odd):
                return ray, z
            moved = xy[odd] + SHIFT * self._extent * (attempt + 1) * np.array([0.618, 0.414])
            more_ray, more_z = self._hits(moved)
            keep = ~np.isin(ray, odd)
            ray, z = np.concatenate([ray[keep], odd[more_ray]]), np.concatenate([z[keep], more_z])
            order = np.lexsort((z, ray))
            ray, z = ray[order], z[order]
        last = np.flatnonzero(np.append(ray[1:] != ray[:-1], True)) if len(ray) else np.zeros(0, int)
        odd = np.bincount(ray, minlength=len(xy))[ray[last]] % 2 == 1
        return np.delete(ray, last[odd]), np.delete(z, last[odd])      # the triangles have a hole there

    def _hits(self, xy):
        bins = self._bin(xy)
        bins = bins[:, 0] * self._side + bins[:, 1]
        counts = self._start[bins + 1] - self._start[bins]
        ends = np.cumsum(counts)
        found, done = [], 0
        while done < len(xy):
            before = ends[done - 1] if done else 0
            upto = max(done + 1, int(np.searchsorted(ends, before + PAIRS)))
            which, place = _repeated(counts[done:upto])
            which += done
            triangle = self._of_bin[self._start[bins[which]] + place]
            hit, z = _crossings(self._corners[triangle], xy[which])
            found.append((which[hit], z))
            done = upto
        ray = np.concatenate([f[0] for f in found]) if found else np.zeros(0, int)
        z = np.concatenate([f[1] for f in found]) if found else np.zeros(0)
        order = np.lexsort((z, ray))
        return ray[order], z[order]


def _repeated(counts):
    """(rows, places): row k counts[k] times, with 0, 1, 2 ... beside it."""
    rows = np.repeat(np.arange(len(counts)), counts)
    return rows, np.arange(len(rows)) - np.repeat(np.cumsum(counts) - counts, counts)


def _crossings(corners, xy):
    """(whether the ray through xy[k] meets triangle k, z of those that do)."""
    sides, weights = [], []
    for k in range(3):
        a, b = corners[:, (k + 1) % 3, :2], corners[:, (k + 2) % 3, :2]
        turned = (a[:, 0] > b[:, 0]) | ((a[:, 0] == b[:, 0]) & (a[:, 1] > b[:, 1]))
        low, high = np.where(turned[:, None], b, a), np.where(turned[:, None], a, b)
        d = high - low
        value = d[:, 0] * (xy[:, 1] - low[:, 1]) - d[:, 1] * (xy[:, 0] - low[:, 0])
        left = (value > 0) | ((value == 0) & (d[:, 1] <= 0))        # moved by (e, e^2) where it lies on the line
        sides.append(left ^ turned)
        weights.append(np.where(turned, -value, value))
    hit = (sides[0] == sides[1]) & (sides[1] == sides[2])
    weights = np.stack(weights, axis=1)[hit]
    area = weights.sum(axis=1)
    height = corners[hit, :, 2]
    with np.errstate(divide="ignore", invalid="ignore"):
        z = (weights * height).sum(axis=1) / area
    return hit, np.clip(np.where(np.isfinite(z), z, height.mean(axis=1)), height.min(axis=1), height.max(axis=1))


def _inside_below(owner, z, ray, at):
    """(S,) length inside below z = at on a ray, but for a number that belongs to the ray."""
    low, extent = z.min(), max(float(np.ptp(z)), 1e-300)

    def key(rays, heights):
        return rays + 0.25 + 0.5 * np.clip((heights - low) / extent, -0.1, 1.1)
    below = np.searchsorted(key(owner, z), key(ray, at))
    whole = np.concatenate([[0.0], np.cumsum(z[1::2] - z[::2])])
    return whole[below // 2] + np.where(below % 2 == 1, np.maximum(at - z[np.maximum(below - 1, 0)], 0), 0)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long intervals along the pieces of an arrangement may be, by place.

At most the size; shorter where regions are narrow, so that points on either side are not far past each other; shorter
where the size field has it over any of the CAD edges that a piece stands for.
"""
import numpy as np
from scipy.spatial import cKDTree

from ..size_field import SizeField
from ..spacing import Spacing, length_of
from .arrangement import OUTSIDE
from .heights import source_points

STATIONS = 8        # along each size of a piece,
FEWEST, MOST = 8, 400
OPPOSITE = -0.8     # cosine between normals of two sides of a narrow place
BESIDE = 0.5        # of the width: how far past each other two places may be that face one another
WALL = 0.75         # sizes: both sides of what is narrower are to be divided alike,
MOSTLY = 0.7        # where so much of each lies over against the other
WIDEST = 1.2        # sizes from which on nothing counts as narrow
NARROWEST = 0.12    # of the size: no intervals shorter than this are made for the sake of narrow regions


class PieceSizes:
    """pieces: numbers in the arrangement, those of regions `used`.

    alike: list of {row of a piece: 1 or -1}, sums of intervals that are to be 0: both sides of a narrow wall
    """

    def __init__(self, arrangement, pieces, used, size, field=None):
        """field: SizeField, None: the size everywhere."""
        self._size, self._shares, self._places, self._own = size, [], [], []
        for c in pieces:
            piece = arrangement.pieces[c]
            count = int(np.clip(np.ceil(STATIONS * length_of(piece.line) / size), FEWEST, MOST))
            shares = np.arange(count + 1) / count
            self._shares.append(shares)
            self._places.append(piece.at(shares))
            self._own.append(_by_field(piece, shares, size, field))
        self._widths, self.alike = _widths(arrangement, pieces, set(used), self._places, size)

    def along(self, part, widths=None):
        """[Spacing] of the pieces. part: of all sizes; widths: longest interval, in widths of a region beside it."""
        narrow = self._narrow(part, widths) if widths else (lambda k: np.inf)
        return [Spacing(shares, places, np.minimum(part * own, narrow(k)))
                for k, (shares, places, own) in enumerate(zip(self._shares, self._places, self._own))]

    def _narrow(self, part, widths):
        """Callable (row of a piece) -> sizes at its stations."""
        size = part * self._size
        sizes = np.maximum(widths * np.concatenate(self._widths), NARROWEST * self._size)
        field = SizeField(size, _in_space(np.concatenate(self._places)), np.minimum(sizes, size))
        return lambda k: field(_in_space(self._places[k]))


def _in_space(places):
    return np.concatenate([places, np.zeros((len(places), 1))], axis=1)


def _by_field(piece, shares, size, field):
    """(n,) sizes by the field over all edges of a piece."""
    least = np.full(len(shares), size)
    for source in piece.sources if field is not None and not field.even else ():
        least = np.minimum(least, field(source_points(piece, source, shares)))
    return least


def _widths(arrangement, pieces, used, places, size):
    """(Per piece (n,) how far it is to the other side of a region, infinite where that is more than WIDEST sizes; what
    is to be divided alike, as PieceSizes has it)."""
    alike, found = [], [np.full(len(p), np.inf) for p in places]
    sides = {}
    for k, c in enumerate(pieces):
        for region, sign in ((arrangement.pieces[c].left, 1.0), (arrangement.pieces[c].right, -1.0)):
            if region != OUTSIDE and region in used:
                sides.setdefault(region, []).append((k, sign))
    for region in sorted(sides):
        rows = [k for k, _ in sides[region]]
        ends = np.concatenate([np.tile((*arrangement.pieces[pieces[k]].ends, k), (len(places[k]), 1)) for k in rows])
        widths, over = _across(np.concatenate([places[k] for k in rows]), ends,
                         np.concatenate([sign * _normals(places[k]) for k, sign in sides[region]]),
                         np.concatenate([_spacing(places[k]) for k in rows]), WIDEST * size)
        for k, own in zip(rows, np.split(widths, np.cumsum([len(places[k]) for k in rows])[:-1])):
            found[k] = np.minimum(found[k], own)
        over[widths > WALL * size] = -1
        alike += _alike(ends[:, 2], np.where(over < 0, -1, ends[over, 2]))
    return found, alike


def _alike(piece, over):
    """Of the stations of a region: numbers of their pieces, and of those over against them, or -1."""
    stations = dict(zip(*np.unique(piece, return_counts=True)))
    pairs, counts = np.unique(np.stack([piece, over], axis=1)[over >= 0], axis=0, return_counts=True)
    near = {}
    for (k, j), count in zip(pairs.tolist(), counts.tolist()):
        if k != j and count >= MOSTLY * stations[k]:
            near.setdefault(j, []).append(k)
    seen = {k: sum(counts[pairs[:, 0] == k]) for k in near}
    return [{j: 1, **{k: -1 for k in ones}} for j, ones in sorted(near.items())
            if seen[j] >= MOSTLY * stations[j] and not (len(ones) == 1 and j > ones[0] and j in near.get(ones[0], ()))]


def _spacing(line):
    return np.full(len(line), length_of(line) / (len(line) - 1))


def _normals(line):
    """(n,2) unit, to the left."""
    way = np.gradient(line, axis=0)
    way = way / np.maximum(np.linalg.norm(way, axis=1), 1e-300)[:, None]
    return np.stack([-way[:, 1], way[:, 0]], axis=1)


def _across(points, ends, normals, spacing, most):
    """((n,) distance along the normal to what faces a point from the other side, (n,) which point does, or -1).

    ends (n,3): both vertices of a point's piece, and the piece: pieces that meet are no sides of a narrow place, as
    small intervals do not help in a cusp; normals: into the region
    """
    width, over = np.full(len(points), np.inf), np.full(len(points), -1)
    i, j = cKDTree(points).query_pairs(most, output_type="ndarray").T
    meet = (ends[i][:, [0, 0, 1, 1]] == ends[j][:, [0, 1, 0, 1]]).any(1) & (ends[i, 2] != ends[j, 2])
    facing = ((normals[i] * normals[j]).sum(1) < OPPOSITE) & ~meet
    i, j = i[facing], j[facing]
    a, b = np.r_[i, j], np.r_[j, i]
    way = points[b] - points[a]
    deep = (way * normals[a]).sum(1)
    beside = np.abs(way[:, 0] * normals[a][:, 1] - way[:, 1] * normals[a][:, 0])
    facing = (deep > 0.0) & (beside < np.maximum(BESIDE * deep, np.maximum(spacing[a], spacing[b])))
    a, b, deep = a[facing], b[facing], deep[facing]
    order = np.lexsort((b, np.round(deep, 9), a))
    first = order[np.unique(a[order], return_index=True)[1]]
    width[a[first]], over[a[first]] = deep[first], b[first]
    return width, over

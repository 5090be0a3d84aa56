# SPDX-License-Identifier: LGPL-2.1-or-later
"""The levels of a layered solid: sheets of nodes that columns have in common.

The ends of columns that continue one another over a piece are one level, and so are plane caps of one height. A level
goes on through material: over every piece into the column beyond, where that is open at its height. So columns with a
wall between them have their nodes there in common. Level edges between two sides make levels, too.
"""
from dataclasses import dataclass, field

import numpy as np

from .fault import NotLayered
from .heights import MIDDLES
from .roles import Role

_RIM = 2    # in place of 0 and 1, the ends of a column: the number before it is that of a rim


@dataclass
class Rim:
    """Level edges between two sides round a column, at one height. edges: of (piece, source)."""

    column: int
    height: float
    edges: list = field(default_factory=list)


class Levels:
    """Ends are (column, 0 low or 1 high), or (number of a Rim, _RIM).

    stacks: per column the levels upwards, its own ends included; nominal: level -> mean height.

    near: levels of caps in one column that differ by less become one sheet, where no wall needs both
    """

    def __init__(self, arrangement, columns, heights, solid, roles, equal, near=0.0):
        self._pieces, self._columns, self._heights, self._solid = arrangement.pieces, columns, heights, solid
        self._equal = equal
        self._root = {(k, e): (k, e) for k in range(len(columns)) for e in (0, 1)}
        of_region = {}
        for k, c in enumerate(columns):
            of_region.setdefault(c.region, []).append(k)
        self._beside = [(c, of_region.get(a, []), of_region.get(b, [])) for c, a, b in arrangement.neighbours()]
        self._of_piece = {c: left + right for c, left, right in self._beside}
        self._rims = self._rims_round(roles)
        self._root |= {(k, _RIM): (k, _RIM) for k in range(len(self._rims))}
        self._members = {x: {x} for x in self._root}
        self._walls = set()
        self._join_continuous()
        self._join_equal()
        self.stacks = self._spread()
        if near:
            self._join_near(near)

    def level(self, end):
        """The level of an end."""
        while self._root[end] != end:
            end = self._root[end]
        return end

    def ends_of(self, level):
        """Ends of columns (column, 0 or 1) that are of a level."""
        return sorted(x for x in self._members[level] if x[1] != _RIM)

    def rims_of(self, level):
        """(piece, source) of level edges between sides that are of a level."""
        return [edge for k, e in sorted(self._members[level]) if e == _RIM for edge in self._rims[k].edges]

    def _rims_round(self, roles):
        """[Rim] of edges between two sides, in the columns whose material they bound."""
        found = {}
        for c, left, right in self._beside:
            for source in self._pieces[c].sources:
                faces = set(self._solid.faces_of[source[0].edge])
                z = self._heights.of_source(c, source)
                if len(faces) < 2 or any(roles[f] is not Role.SIDE for f in faces) or np.ptp(z) > self._equal:
                    continue
                for k in left + right:
                    low, high = self._over(c, (k, 0)), self._over(c, (k, 1))
                    if (low < z - self._equal).all() and (z + self._equal < high).all():
                        self._rim(found.setdefault(k, []), k, float(z.mean())).edges.append((c, source))
        return [rim for of_column in found.values() for rim in of_column]

    def _rim(self, rims, column, height):
        for rim in rims:
            if abs(rim.height - height) < self._equal:
                return rim
        rims.append(Rim(column, height))
        return rims[-1]

    def _column(self, end):
        return self._rims[end[0]].column if end[1] == _RIM else end[0]

    def _caps(self, ends):
        return {self._columns[k].cap(e) for k, e in ends if e != _RIM}

    def _join(self, x, y):
        a, b = sorted((self.level(x), self.level(y)))
        if a != b:
            self._root[b] = a
            self._members[a] |= self._members.pop(b)

    def _apart(self, x, y):
        """Whether a column ends in both, or a wall joins them."""
        a, b = self._members[self.level(x)], self._members[self.level(y)]
        if set(map(self._column, a)) & set(map(self._column, b)):
            return True
        small, large = sorted((a, b), key=len)
        return any((p, q) in self._walls or (q, p) in self._walls for p in small for q in large) \
            if len(small) * len(large) < 4 * len(self._walls) else \
            any((p in a and q in b) or (p in b and q in a) for p, q in self._walls)

    def _over(self, c, end):
        """(3,) heights of an end over MIDDLES of a piece."""
        return self._heights.over_piece(c, self._columns[end[0]].cap(end[1]))

    def _join_continuous(self):
        for c, left, right in self._beside:
            for a in left:
                for b in right:
                    if self._meet(c, a, b):
                        for e in (0, 1):
                            self._join_over(c, (a, e), (b, e))
                            self._walls.add(((a, e), (b, 1 - e)))

    def _meet(self, c, a, b):
        """Whether two columns have material in common over a piece."""
        low = np.maximum(self._over(c, (a, 0)), self._over(c, (b, 0)))
        high = np.minimum(self._over(c, (a, 1)), self._over(c, (b, 1)))
        return bool((high - low > self._equal).any())

    def _join_over(self, c, x, y):
        caps = [self._columns[k].cap(e) for k, e in (x, y)]
        shared = any(set(caps) <= set(self._solid.faces_of[s[0].edge]) for s in self._pieces[c].sources)
        if caps[0] == caps[1] or shared or np.abs(self._over(c, x) - self._over(c, y)).max() < self._equal:
            self._join(x, y)
        else:
            self._walls.add((x, y))

    def _join_equal(self):
        plane = [x for x in self._root if self._flat(x)]
        plane.sort(key=lambda x: (self._height(x), x))
        for x, y in zip(plane, plane[1:]):
            if self._height(y) - self._height(x) < self._equal and not self._apart(x, y):
                self._join(x, y)

    def _flat(self, end):
        if end[1] == _RIM:
            return True
        cap = self._columns[end[0]].cap(end[1])
        return self._heights.is_level(cap)

    def _height(self, end):
        if end[1] == _RIM:
            return self._rims[end[0]].height
        return self._heights.middle(self._columns[end[0]].cap(end[1]))

    def _nominal(self):
        found = {}
        for level, ends in self._members.items():
            found[level] = float(np.mean([self._height(x) for x in sorted(ends)]))
        return found

    def _spread(self):
        """The stacks; sets nominal. Levels that turn out to be one on the way are joined, and all begins again."""
        while True:
            self.nominal = self._nominal()
            has = [{self.level((k, 0)), self.level((k, 1))} for k in range(len(self._columns))]
            for n, rim in enumerate(self._rims):
                has[rim.column].add(self.level((n, _RIM)))
            if self._spread_all(has):
                return [self._stack(k, levels) for k, levels in enumerate(has)]

    def _spread_all(self, has):
        beside = [[] for _ in self._columns]
        for c, left, right in self._beside:
            for a in left:
                for b in right:
                    if a != b:
                        beside[a].append((c, b))
                        beside[b].append((c, a))
        todo = [(k, level) for k, levels in enumerate(has) for level in sorted(levels)]
        while todo:
            k, level = todo.pop()
            for c, other in beside[k]:
                if level in has[other]:
                    continue
                z = self._at(c, k, level)
                low, high = self._over(c, (other, 0)), self._over(c, (other, 1))
                for end, value in ((0, low), (1, high)):
                    if np.abs(z - value).max() < self._equal:
                        self._join_met(level, self.level((other, end)), c)
                        return False
                if (z > low).all() and (z < high).all():
                    has[other].add(level)
                    todo.append((other, level))
                elif (z > low).any() and (z < high).any():
                    raise NotLayered("a level leaves the material: a ramp ends on a wall",
                                     [self._columns[other].low, self._columns[other].high])
        return True

    def _join_met(self, one, other, c):
        if self._apart(one, other):
            raise NotLayered("two levels that a wall joins meet elsewhere",
                             self._caps(self._members[one] | self._members[other]))
        self._join(one, other)

    def _at(self, c, column, level):
        """(3,) heights of a level that a column has, over MIDDLES of a piece."""
        for k in self.beside(c):
            for e in (0, 1):
                if self.level((k, e)) == level:
                    return self._over(c, (k, e))
        return np.full(len(MIDDLES), self.nominal[level])

    def beside(self, c):
        """Columns on either side of a piece of the arrangement; none where it has one region on both."""
        return self._of_piece.get(c, [])

    def _stack(self, k, levels):
        low, high = self.level((k, 0)), self.level((k, 1))
        if low == high:
            raise NotLayered("a column begins and ends in one level: a wedge",
                             [self._columns[k].low, self._columns[k].high])
        return [low, *sorted(levels - {low, high}, key=lambda x: self.nominal[x]), high]

    def _join_near(self, near):
        """Join levels of one column that are near each other, the nearest first; each changes what spreads."""
        while True:
            pairs = {}
            for stack in self.stacks:
                for a, b in zip(stack[:-1], stack[1:]):
                    gap = self.nominal[b] - self.nominal[a]
                    if gap < near and not self._apart(a, b):
                        pairs[tuple(sorted((a, b)))] = gap
            if not pairs:
                return
            self._join(*min(pairs, key=lambda p: (pairs[p], p)))
            self.stacks = self._spread()

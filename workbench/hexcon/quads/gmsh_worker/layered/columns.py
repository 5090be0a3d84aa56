# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which stretches of height hold material over each region of an arrangement: columns, from a cap up to a cap."""
from dataclasses import dataclass

from .arrangement import OUTSIDE, inner_point
from .fault import NotLayered
from .roles import Role


@dataclass(frozen=True)
class Column:
    """Of a region: low and high are the caps (CAD faces) that it stands between."""

    region: int
    low: int
    high: int

    def cap(self, end):
        return self.high if end else self.low


def columns(arrangement, roles, solid, heights):
    """[Column], region after region, each from the lowest up. Raises NotLayered."""
    made = []
    for r, caps in enumerate(_caps_over(arrangement, roles, solid)):
        if not caps:
            continue
        point = inner_point(arrangement, arrangement.regions[r])
        ordered = sorted(caps, key=lambda f: float(heights.of_face(f, point[None])[0]))
        kinds = [roles[f] for f in ordered]
        if len(kinds) % 2 or any(k is not (Role.UP if n % 2 else Role.DOWN) for n, k in enumerate(kinds)):
            raise NotLayered(f"material does not lie between caps: {_names(ordered)}", ordered)
        made += [Column(r, low, high) for low, high in zip(ordered[::2], ordered[1::2])]
    return made


def _names(faces):
    return ", ".join(f"Face{f}" for f in faces[:8])


def _caps_over(arrangement, roles, solid):
    """Per region the set of caps that lie over it: to step over a cap's edge is to leave or enter it.

    So it takes no look at places, however thin a region is. Linear.
    """
    beside = [[] for _ in arrangement.regions]
    around = []
    for c, left, right in arrangement.neighbours():
        for here, there in ((left, right), (right, left)):
            (around if here == OUTSIDE else beside[here]).append((c, there))
    toggles = [_toggles(p, roles, solid) for p in arrangement.pieces]
    over = {OUTSIDE: frozenset()}
    todo = [OUTSIDE]
    while todo:
        here = todo.pop()
        for c, there in (around if here == OUTSIDE else beside[here]):
            caps = over[here] ^ toggles[c]
            if there not in over:
                over[there] = caps
                todo.append(there)
            elif over[there] != caps:
                bad = over[there] ^ caps
                raise NotLayered(f"outlines do not close in the plane: {_names(sorted(bad))}", bad)
    return [over.get(r, frozenset()) for r in range(len(arrangement.regions))]


def _toggles(piece, roles, solid):
    caps = frozenset()
    for curve, _, _ in piece.sources:
        faces = solid.faces_of[curve.edge]
        if faces[0] != faces[1]:
            caps ^= frozenset(f for f in faces if roles[f] in (Role.UP, Role.DOWN))
    return caps

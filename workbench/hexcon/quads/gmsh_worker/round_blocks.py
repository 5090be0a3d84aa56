# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quads of round solids: o-grids on the caps of a chain of faces and rings between them; a cube's grid on a ball."""
import numpy as np

from .fault import WorkerFault
from .meridians import Meridians, apex_of, pole_of
from .plane_mesh import grid_quads
from .rims import aligned

FEWEST = 2                  # quads across a cap's inner square, and so a quarter of a rim
FLAT, ROUND = 0.6, 0.5      # share of the way from the pole to the rim that the square takes on a disc, on a half ball
REENTRANT, SHARP = np.sin(np.radians(20.0)), np.cos(np.radians(155.0))      # at a rim; see _check_rims
SAMPLES = 32                # meridians on which lengths are measured


def round_surface(solid, chain, size):
    """dict with points, quads, faces, notes. chain: of rims.chain_of.

    Raises WorkerFault NOT_BLOCKS where the solid is reentrant or too sharp at a rim.
    """
    if not chain.rims:
        return _ball(solid, size)
    rims = aligned(solid, chain.rims)
    caps = [_Cap(solid, chain.faces[0], rims[0]), _Cap(solid, chain.faces[-1], rims[-1])]
    across = _across(rims, caps, size)
    mesh = _Rings(solid, chain, rims, 4 * across, size)
    depth = [cap.depth(size) for cap in caps]
    if all(solid.is_plane(cap.face) for cap in caps):
        depth = [max(1, int(np.rint(np.mean(depth))))] * 2      # alike, and so a sweep from one to the other
    mesh.close(caps, across, np.maximum(np.rint(depth), 1).astype(int))
    result = mesh.result()
    _check_rims(result, mesh.rim_numbers, chain)
    result["notes"] = [f"blocks: o-grids of {across} x {across} quads in the middle of Face{chain.faces[0]} and "
                       f"Face{chain.faces[-1]}, {4 * across} quads round"]
    return result


def _ball(solid, size):
    """k x k quads at equal angles on each side of a cube about the middle."""
    face = solid.faces[0]
    box = np.array(solid.box()).reshape(2, 3)
    centre, half = box.mean(axis=0), np.ptp(box, axis=0) / 2
    count = max(FEWEST, int(np.rint(np.sqrt(solid.area(face) / 6.0) / size)))
    grid = np.indices((count + 1,) * 3).reshape(3, -1).T
    shell = ((grid == 0) | (grid == count)).any(axis=1)
    number = np.cumsum(shell) - 1
    ways = np.tan((grid[shell] / count - 0.5) * np.pi / 2)
    points = centre + half * ways / np.linalg.norm(ways, axis=1)[:, None]
    ids = number.reshape((count + 1,) * 3)
    quads = np.concatenate([grid_quads(np.take(ids, end, axis))[:, ::1 if (end > 0) ^ (axis == 1) else -1]
                            for axis in range(3) for end in (0, count)])
    return {"points": solid.project(2, face, points), "quads": quads, "faces": np.full(len(quads), face),
            "notes": [f"blocks: {count} x {count} quads on each of the six sides of the ball"]}


def _across(rims, caps, size):
    """Quads across the inner squares: the mean of what the rims and the squares of the caps want.

    Even where a cap has a point, as a cone has: a vertex of the square is to lie there.
    """
    steps = np.arange(720) / 720
    wanted = [_length(rim(steps)) / 4.0 / size for rim in rims]
    wanted += [2.0 * cap.inner * cap.length / size for cap in caps]
    across = max(FEWEST, int(np.rint(np.exp(np.mean(np.log(wanted))))))
    return across + across % 2 if any(cap.is_pointed() for cap in caps) else across


def _length(closed):
    return float(np.linalg.norm(closed - np.roll(closed, 1, axis=0), axis=1).sum())


class _Cap:
    """A face with one rim: its meridians from the pole, their mean length, and where its inner square ends."""

    def __init__(self, solid, face, rim):
        self.face, self.rim, self.solid = face, rim, solid
        steps = np.arange(SAMPLES) / SAMPLES
        points = rim(steps)
        self.pole = apex_of(solid, face) if self.is_pointed() else pole_of(solid, face, points)
        self.length = float(Meridians(solid, face, self.pole, points).lengths.mean())
        fullness = self.length / (_length(points) / (2 * np.pi))
        self.inner = float(np.interp(fullness, [1.0, np.pi / 2], [FLAT, ROUND]))

    def is_pointed(self):
        return self.solid.type_of(self.face) == "Cone"

    def depth(self, size):
        """Wanted rings between the inner square and the rim."""
        return (1.0 - 1.08 * self.inner) * self.length / size

    def points(self, across, rings):
        """(m,3) the points of the o-grid, in the order of _o_grid."""
        turn, share = _o_grid(across, rings, self.inner)
        ways = Meridians(self.solid, self.face, self.pole, self.rim(turn))
        return ways.at(share)


def _o_grid(across, rings, inner):
    """(turn (m,), share (m,)): place round the rim and on the way from pole to rim of every point of an o-grid but its
    rim: rings - 1 rings of 4 * across points from the rim inwards, then the (across + 1)^2 points of the square.

    The square is a cube's side seen from its middle, at equal angles, its first corner at the start of the rim.
    """
    around = np.arange(4 * across) / (4 * across)
    offset = (around * 8.0) % 2.0 - 1.0                     # -1 to 1 along each side of the square
    outline = _square_share(offset, np.ones_like(offset), inner)
    turn, share = [], []
    for ring in range(1, rings):
        turn.append(around)
        share.append(1.0 + (outline - 1.0) * ring / rings)
    line = np.linspace(-1.0, 1.0, across + 1)
    x, y = (g.ravel() for g in np.meshgrid(line, line))
    tangent = np.tan(np.pi / 4 * np.stack([x, y]))
    turn.append((np.arctan2(tangent[1], tangent[0]) + 3 * np.pi / 4) / (2 * np.pi) % 1.0)
    share.append(_square_share(x, y, inner))
    return np.concatenate(turn), np.concatenate(share)


def _square_share(x, y, inner):
    """Distance from the pole of a place of the square -1..1; inner at the middle of a side."""
    return inner * np.arctan(np.hypot(np.tan(np.pi / 4 * x), np.tan(np.pi / 4 * y))) / (np.pi / 4)


class _Rings:
    """The points and quads of the walls, ring after ring, to be closed by two caps."""

    def __init__(self, solid, chain, rims, around, size):
        self.solid, self.around = solid, around
        turn = np.arange(around) / around
        self.points, self.quads, self.faces, self.count = [], [], [], 0
        self.rim_numbers = [self._add(rims[0](turn))]
        for face, lower, upper in zip(chain.faces[1:-1], rims, rims[1:]):
            ways = Meridians(solid, face, lower(turn), upper(turn))
            rings = max(1, int(np.rint(ways.lengths.mean() / size)), ways.least())
            levels = [self.rim_numbers[-1]]
            levels += [self._add(ways.at(np.full(around, ring / rings))) for ring in range(1, rings)]
            levels.append(self._add(upper(turn)))
            self.rim_numbers.append(levels[-1])
            for low, high in zip(levels, levels[1:]):
                self._ring(low, high, face)

    def _add(self, points):
        self.points.append(points)
        self.count += len(points)
        return np.arange(self.count - len(points), self.count)

    def _keep(self, quads, face):
        self.quads.append(quads)
        self.faces.append(np.full(len(quads), face))

    def _ring(self, low, high, face):
        self._keep(np.stack([low, np.roll(low, -1), np.roll(high, -1), high], -1), face)

    def close(self, caps, across, rings):
        """The o-grids of the caps: the first below the first rim, the second above the last."""
        for cap, depth, rim, turned in zip(caps, rings, (self.rim_numbers[0], self.rim_numbers[-1]), (True, False)):
            ids = self._add(cap.points(across, depth))
            square = ids[-(across + 1) ** 2:].reshape(across + 1, across + 1)
            outline = np.concatenate([square[0, :-1], square[:-1, -1], square[-1, :0:-1], square[:0:-1, 0]])
            levels = [rim, *ids[:-(across + 1) ** 2].reshape(-1, self.around), outline]
            for outer, within in zip(levels, levels[1:]):
                self._ring(*((within, outer) if turned else (outer, within)), cap.face)
            self._keep(grid_quads(square)[:, ::-1 if turned else 1], cap.face)

    def result(self):
        """points, quads, faces; outward."""
        points, quads = np.concatenate(self.points), np.concatenate(self.quads)
        p = points[quads] - points.mean(axis=0)
        volume = (np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1]) * p.mean(axis=1)).sum()
        return {"points": points, "quads": quads if volume > 0 else quads[:, ::-1],
                "faces": np.concatenate(self.faces)}


def _check_rims(mesh, rim_numbers, chain):
    """Raises WorkerFault NOT_BLOCKS where quads meet at a rim in more than 200 degrees, or in less than 25."""
    corners = mesh["points"][mesh["quads"]]
    normal = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    middle = corners.mean(axis=1)
    for rim, below, above in zip(rim_numbers, chain.faces, chain.faces[1:]):
        on_rim = np.isin(mesh["quads"], rim).sum(axis=1) == 2
        sides = [np.flatnonzero(on_rim & (mesh["faces"] == f)) for f in (below, above)]
        first, second = (s[np.argsort(_place(mesh["quads"][s], rim))] for s in sides)
        way = middle[second] - mesh["points"][rim]
        rise = (normal[first] * way).sum(axis=1) / np.linalg.norm(way, axis=1)
        if rise.mean() > REENTRANT or ((normal[first] * normal[second]).sum(axis=1)).mean() < SHARP:
            word = "reentrant" if rise.mean() > REENTRANT else "too sharp"
            raise WorkerFault("NOT_BLOCKS", f"the solid is {word} between Face{below} and Face{above}", [below, above])


def _place(quads, rim):
    """Where along the rim each quad with one edge on it stands."""
    place = np.full(quads.max() + 1, -1)
    place[rim] = np.arange(len(rim))
    first, second = np.sort(place[quads], axis=1)[:, 2:].T
    return np.where((first == 0) & (second == len(rim) - 1), second, first)

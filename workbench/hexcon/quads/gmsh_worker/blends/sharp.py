# SPDX-License-Identifier: LGPL-2.1-or-later
"""A layered solid as if the corners that blends round off were sharp; what is the blends' there is known."""
import numpy as np

from ..layered.heights import MIDDLES, Heights
from ..layered.mesh import NEAR, Standing
from ..layered.roles import Role


class SharpHeights(Heights):
    """Heights with blends level, at their lids.

    turn_of: per blend the height from which a wall is the blend's; to be set once the levels are known
    """

    def __init__(self, shape, plane, arrangement, blends):
        super().__init__(shape, plane, arrangement)
        self.turn_of = {blend: blend.turn for blend in blends}
        self._blend = {f: blend for blend in blends for f in blend.faces}

    def of_face(self, face, xy, near=None):
        if face not in self._blend:
            return super().of_face(face, xy, near)
        return np.full(len(np.reshape(xy, (-1, 2))), self._blend[face].lid)

    def middle(self, face):
        return self._blend[face].lid if face in self._blend else super().middle(face)

    def over_piece(self, c, face):
        if face not in self._blend:
            return super().over_piece(c, face)
        return np.full(len(MIDDLES), self._blend[face].lid)

    def is_level(self, face):
        return face in self._blend or super().is_level(face)

    def edges_of(self, face):
        return set() if face in self._blend else super().edges_of(face)

    def wall_ends(self, edge, height, roles):
        """[(CAD face, its heights)] of the walls that end at an edge, whose heights (n,) are given: between a blend's
        edge and its lid the wall is the blend's; walls that it cuts off go on to the lid."""
        faces = self._shape.solid.faces_of[edge]
        beside = sorted(f for f in faces if f in self._blend)
        found = [(f, height) for f in set(faces) if roles[f] is Role.SIDE]
        if not beside or not found:
            return found
        blend = self._blend[beside[0]]
        lid, turn = (np.full(len(height), z) for z in (blend.lid, self.turn_of[blend]))
        if edge not in blend.edges:
            return [(face, lid) for face, _ in found]
        return [(face, turn) for face, _ in found] + [(beside[0], turn), (beside[0], lid)]


class SharpStanding(Standing):
    """A Standing with blends taken for sharp corners."""

    def __init__(self, shape, direction, size, steep, blends):
        self._blends = blends
        super().__init__(shape, direction, size, steep)
        self._turns = self._placed_turns()

    def _heights(self):
        return SharpHeights(self.shape, self.plane, self.arrangement, self._blends)

    def _placed_turns(self):
        """Ascending heights at which layers must end, those of levels aside; sets where walls become blends."""
        levels = np.array(sorted(self.levels.nominal.values()))
        turns, near = [], NEAR * self.size
        for blend in sorted(self._blends, key=lambda b: b.turn):
            gap = np.abs(levels - blend.turn)
            if gap.min() < min(near, blend.reach / 2):
                turn = float(levels[gap.argmin()])
            elif turns and blend.turn - turns[-1] < min(near, blend.reach / 2):
                turn = turns[-1]
            else:
                turn = blend.turn
                turns.append(turn)
            self.heights.turn_of[blend] = turn
        return turns

    def stops_between(self, low, high):
        low, high = self.levels.nominal[low], self.levels.nominal[high]
        return (np.array([low, *(t for t in self._turns if low < t < high), high]) - low) / (high - low)

    def walls_over(self, c, heights):
        ends = {}
        for source in self.arrangement.pieces[c].sources:
            for face, z in self.heights.wall_ends(source[0].edge, heights(source), self.roles):
                ends.setdefault(face, []).append(z)
        found = []
        for face, rows in ends.items():
            rows.sort(key=lambda row: row.mean())
            found += [(face, low, high) for low, high in zip(rows[::2], rows[1::2])]
        return found

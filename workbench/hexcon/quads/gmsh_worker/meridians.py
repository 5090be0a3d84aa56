# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ways over a CAD face from one set of points to another, divided by their length."""
import numpy as np

from .outline import TURN_OPEN

SAMPLES = 33        # along each way on a curved face


class Meridians:
    """Straight lines put onto the face, one for each of k points.

    start    (3,) or (k,3); end (k,3): points of the face
    lengths  (k,)
    """

    def __init__(self, solid, face, start, end):
        self.solid, self.face = solid, face
        count = 2 if solid.is_plane(face) else SAMPLES
        t = np.linspace(0.0, 1.0, count)[None, :, None]
        start = np.broadcast_to(start, end.shape)
        self.paths = (1 - t) * start[:, None] + t * end[:, None]
        inner = self.paths[:, 1:-1]
        self.paths[:, 1:-1] = solid.project(2, face, inner).reshape(inner.shape)
        steps = np.linalg.norm(np.diff(self.paths, axis=1), axis=2)
        self._arc = np.concatenate([np.zeros((len(end), 1)), np.cumsum(steps, axis=1)], axis=1)
        self.lengths = self._arc[:, -1]

    def at(self, share):
        """(k,3) the points of the face at shares (k,) of each way's length."""
        made = np.empty((len(self.paths), 3))
        for k, (path, arc) in enumerate(zip(self.paths, self._arc)):
            made[k] = [np.interp(share[k] * arc[-1], arc, path[:, axis]) for axis in range(3)]
        return self.solid.project(2, self.face, made)

    def least(self):
        """Fewest intervals that still follow the ways' turning."""
        way = np.diff(self.paths, axis=1)
        way = way / np.maximum(np.linalg.norm(way, axis=2, keepdims=True), 1e-300)
        turning = np.arccos(np.clip((way[:, 1:] * way[:, :-1]).sum(axis=2), -1.0, 1.0)).sum(axis=1)
        return max(1, int(np.ceil(turning.max(initial=0.0) / TURN_OPEN - 0.05)))


def pole_of(solid, face, rim):
    """(3,) the point of a cap that lies over the middle of its rim (m,3).

    Where a cap bulges, a point far out over the middle is nearest to its top, and one on the other side to its rim.
    """
    centre = rim.mean(axis=0)
    ring = rim - centre
    normal = np.cross(ring, np.roll(ring, -1, axis=0)).sum(axis=0)
    normal /= np.linalg.norm(normal)
    far = 3.0 * solid.diagonal
    tops = solid.project(2, face, np.stack([centre + far * normal, centre - far * normal]))
    clear = [np.linalg.norm(rim - top, axis=1).min() for top in tops]
    return tops[int(np.argmax(clear))]


def apex_of(solid, face):
    """(3,) the end of a cone's seam that is on no other edge. gmsh does not project points far from a cone."""
    seams = {abs(e) for e in solid.boundary[face] if solid.faces_of[abs(e)] == [face, face]}
    others = {v for e, ends in solid.ends.items() if e not in seams for v in ends}
    return solid.vertex[next(v for e in sorted(seams) for v in solid.ends[e] if v not in others)]

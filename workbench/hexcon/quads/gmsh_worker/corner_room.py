# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much room the worst corner of a quad surface leaves for a hex."""
import numpy as np

GOOD = 0.2      # sine of some 11.5 degrees: surfaces with less are tried again


def corner_room(points, quads):
    """Least sine of all corners' angles, each seen along its quad's mean normal: 0 or less where no hex can stand.

    -3 where the quads do not close: an edge that is not in two of them, a point twice in one; -2 where two quads have
    two edges in common. points (V,3), quads (n,4). O(n log n).
    """
    if not _closed(quads):
        return -3.0
    if _doubled(quads):
        return -2.0
    return float(corner_sines(points, quads).min())


def room_words(room):
    """A corner_room in words."""
    if room < -2.5:
        return "the quads do not close"
    if room < -1.5:
        return "two quads have two edges in common"
    return f"the worst corner of a quad has a sine of {room:.2f}"


def corner_sines(points, quads):
    """(n,4): sine of each corner's angle, negative beyond 180 degrees."""
    p = points[quads]
    normal = np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1])
    after, before = np.roll(p, -1, axis=1) - p, np.roll(p, 1, axis=1) - p
    cross = np.cross(after, before)
    lengths = np.linalg.norm(after, axis=2) * np.linalg.norm(before, axis=2)
    sine = np.linalg.norm(cross, axis=2) / np.maximum(lengths, 1e-300)
    return np.where(np.einsum("qkd,qd->qk", cross, normal) > 0.0, sine, -sine)


def _edge_keys(quads):
    a, b = np.sort(np.stack([quads, np.roll(quads, -1, axis=1)], axis=-1).reshape(-1, 2), axis=1).T.astype(np.int64)
    return a * (int(quads.max()) + 1) + b


def _closed(quads):
    ranked = np.sort(quads, axis=1)
    if (ranked[:, 1:] == ranked[:, :-1]).any():
        return False
    return bool((np.unique(_edge_keys(quads), return_counts=True)[1] == 2).all())


def _doubled(quads):
    """Whether two quads share two edges. The quads close."""
    keys = _edge_keys(quads)
    owners = np.sort((np.argsort(keys, kind="stable") // 4).reshape(-1, 2), axis=1)
    return len(np.unique(owners, axis=0)) < len(owners)

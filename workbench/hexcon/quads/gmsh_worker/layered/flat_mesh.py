# SPDX-License-Identifier: LGPL-2.1-or-later
"""One quad mesh of all regions of an arrangement that hold material."""
from dataclasses import dataclass

import numpy as np

from ..outline import CORNER
from ..plane.mesher import NoPlaneMesh, mesh_plane
from ..plane.region import PlaneRegion
from ..plane.wishes import wishes
from .divisions import divide, ideal_counts
from .fault import NotLayered

ATTEMPTS = ((1.0, False), (1.0, True), (0.88, False), (0.8, True))     # (part of the size, every piece even)
ENOUGH = 0.6        # of what corners allow, in the worst quad: with it no other attempt is made


@dataclass
class FlatMesh:
    """nodes (n,2): vertices of the arrangement first; on_piece: piece -> ids along it, ends included; quads: region ->
    (k,4), counter-clockwise; worst, mean: scaled Jacobian; share: the worst beside what its region's corners allow;
    limit: the least of those."""

    nodes: np.ndarray
    on_piece: dict
    quads: dict
    worst: float
    mean: float
    share: float
    limit: float


def flat_mesh(arrangement, used, size, link, fixed=None):
    """The FlatMesh of regions. fixed: as mesh.Standing.mesh takes it. Raises NotLayered."""
    pieces = sorted({c for r in used for loop in arrangement.regions[r].loops for c, _ in loop})
    outlines = {r: _Outline(arrangement, arrangement.regions[r].loops) for r in used}
    held = {k: n for k, c in enumerate(pieces) if fixed and (n := fixed(arrangement.pieces[c]))}
    best, fault = None, None
    for part, even in ATTEMPTS:
        try:
            counts = _counts(arrangement, pieces, outlines, size * part, even, held)
            made = _meshed(arrangement, pieces, outlines, counts, size, link)
        except (NotLayered, NoPlaneMesh) as error:
            fault = error
            continue
        if best is None or made.share > best.share + 0.05:
            best = made
        if best.share > ENOUGH:
            break
    if best is None:
        raise NotLayered(str(fault))
    return best


class _Outline:
    """loops: begun at a corner where there is one; turns: per loop and piece, radians to the left at its start."""

    def __init__(self, arrangement, loops):
        self.loops, self.turns = [], []
        for loop in loops:
            lines = [arrangement.pieces[c].line if f else arrangement.pieces[c].line[::-1] for c, f in loop]
            into = [np.arctan2(*(line[-1] - line[-2])[::-1]) for line in lines]
            out = [np.arctan2(*(line[1] - line[0])[::-1]) for line in lines]
            bend = [_bend(line) for line in lines]
            turns = np.array([(out[k] - into[k - 1] - bend[k] / 2 - bend[k - 1] / 2 + np.pi) % (2 * np.pi) - np.pi
                              for k in range(len(loop))])
            corners = np.flatnonzero(np.abs(turns) > CORNER)
            first = int(corners[0]) if len(corners) else 0
            self.loops.append(loop[first:] + loop[:first])
            self.turns.append(np.roll(turns, -first))


def _bend(line):
    """Radians by which a line's first segments turn: half of it lies before its first chord."""
    if len(line) < 3:
        return 0.0
    d = np.diff(line[:3], axis=0)
    return float(np.arctan2(d[0, 0] * d[1, 1] - d[0, 1] * d[1, 0], d[0] @ d[1]))


def _counts(arrangement, pieces, outlines, size, even, held):
    """{piece: intervals}. held: row of a piece -> its number."""
    row_of = {c: k for k, c in enumerate(pieces)}
    ideal, least = ideal_counts([arrangement.pieces[c] for c in pieces], size)
    for k, n in held.items():
        ideal[k], least[k] = n, n
    rows = [({k: 1}, 2, None) for k in range(len(pieces)) if k not in held] if even else []
    for outline in outlines.values():
        rows += _rows([[row_of[c] for c, _ in loop] for loop in outline.loops], outline.turns, ideal)
    return dict(zip(pieces, divide(ideal, least, rows, held).tolist()))


def _rows(loops, turns, ideal):
    """What a region wishes, as divide takes it."""
    rows = []
    for wish in wishes(turns, [ideal[loop] for loop in loops]):
        terms = {}
        for (loop, edge), factor in wish.terms.items():
            terms[loops[loop][edge]] = terms.get(loops[loop][edge], 0) + factor
        rows.append((terms, wish.multiple, None if wish.hard else wish.weight))
    return rows


def _meshed(arrangement, pieces, outlines, counts, size, link):
    nodes = [arrangement.vertices]
    total, on_piece, lines = len(arrangement.vertices), {}, {}
    for c in pieces:
        piece, n = arrangement.pieces[c], counts[c]
        line = piece.at(np.arange(n + 1) / n)
        line[0], line[-1] = arrangement.vertices[list(piece.ends)]
        on_piece[c] = np.concatenate([[piece.ends[0]], total + np.arange(n - 1), [piece.ends[1]]])
        nodes.append(line[1:-1])
        lines[c] = line
        total += n - 1
    quads, worst, means, share, limit = {}, 1.0, [], 1.0, 1.0
    for r, outline in outlines.items():
        ids, turns = _divided(outline, on_piece)
        flat = np.concatenate(nodes)
        made = mesh_plane(PlaneRegion([flat[i] for i in ids], turns), size, link, f"region {r}")
        inner = total + np.arange(len(made.points) - sum(map(len, ids)))
        quads[r] = np.concatenate([*ids, inner])[made.quads]
        nodes.append(made.points[len(made.points) - len(inner):])
        total += len(inner)
        worst, share = min(worst, made.low), min(share, made.low / max(made.limit, 0.2))
        limit = min(limit, made.limit)
        means.append((made.mean, len(made.quads)))
    mean, weight = np.array(means).T
    return FlatMesh(np.concatenate(nodes), on_piece, quads, worst, float(mean @ weight / weight.sum()), share, limit)


def _divided(outline, on_piece):
    """(ids of the points of each loop, turns at each)."""
    ids, turns = [], []
    for loop, turn in zip(outline.loops, outline.turns):
        parts = [(on_piece[c] if f else on_piece[c][::-1])[:-1] for c, f in loop]
        ids.append(np.concatenate(parts))
        turns.append(np.concatenate([np.concatenate([[t], np.zeros(len(p) - 1)]) for t, p in zip(turn, parts)]))
    return ids, turns

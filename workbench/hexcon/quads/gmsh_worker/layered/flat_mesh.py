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
from .piece_sizes import PieceSizes

# (part of the size, every piece even, longest interval beside a narrow place, in widths of it)
ATTEMPTS = ((1.0, False, 3.0), (1.0, True, 3.0), (0.88, True, 2.0), (0.8, False, 1.2), (1.0, False, None))
CRASHES = 6         # of gmsh, after which it is not asked any more
PAVED = 2           # attempts that are made again with gmsh, where none is good enough without
ALIKE = 3.0         # weight of both sides of a narrow wall being divided alike
ENOUGH = 0.6        # of what corners allow, in the worst quad: with it no other attempt is made


@dataclass
class FlatMesh:
    """nodes (n,2): vertices of the arrangement first; on_piece: piece -> ids along it, ends included; stops: piece ->
    shares of its length at which they lie; quads: region -> (k,4), counter-clockwise; worst, mean: scaled Jacobian;
    share: the worst beside what its region's corners allow; limit: the least of those."""

    nodes: np.ndarray
    on_piece: dict
    stops: dict
    quads: dict
    worst: float
    mean: float
    share: float
    limit: float


def flat_mesh(arrangement, used, size, link, fixed=None, field=None):
    """The FlatMesh of regions. fixed, field: as mesh.Standing.mesh takes them. Raises NotLayered."""
    pieces = sorted(set().union(*(arrangement.regions[r].pieces for r in used)))
    outlines = {r: _Outline(arrangement, arrangement.regions[r].loops) for r in used}
    held = {k: n for k, c in enumerate(pieces) if fixed and (n := fixed(arrangement.pieces[c]))}
    regions = _Regions(arrangement, outlines, size, link)
    sizes = PieceSizes(arrangement, pieces, used, size, field)
    best, fault = None, None
    # gmsh takes its time, and each of its crashes begins all of the surface again
    gmsh_may = [(True, ATTEMPTS[:PAVED])] if len(link.avoid) <= CRASHES else []
    for paving, attempts in [(False, ATTEMPTS), *gmsh_may]:
        for part, even, widths in attempts:
            try:
                spacing = sizes.along(part, widths)
                counts = _counts(arrangement, pieces, outlines, spacing, sizes.alike, even, held)
                made = regions.meshed(_stops(pieces, spacing, counts, held), paving)
            except (NotLayered, NoPlaneMesh) as error:
                fault = error
                continue
            if best is None or made.share > best.share + 0.05:
                best = made
            if best.share > ENOUGH:
                return best
    if best is None:
        raise NotLayered(str(fault))
    return best


class _Outline:
    """loops: begun at a corner where there is one; turns: per loop and piece, radians to the left at its start; ways:
    radians of straight pieces' directions, NaN of curved ones."""

    def __init__(self, arrangement, loops):
        self.loops, self.turns, self.ways = [], [], []
        for loop in loops:
            lines = [arrangement.pieces[c].line if f else arrangement.pieces[c].line[::-1] for c, f in loop]
            into = [np.arctan2(*(line[-1] - line[-2])[::-1]) for line in lines]
            out = [np.arctan2(*(line[1] - line[0])[::-1]) for line in lines]
            bend = [_bend(line) for line in lines]
            # what chords turn by is less than half a turn even in a cusp
            turns = np.array([(out[k] - into[k - 1] + np.pi) % (2 * np.pi) - np.pi - bend[k] / 2 - bend[k - 1] / 2
                              for k in range(len(loop))])
            corners = np.flatnonzero(np.abs(turns) > CORNER)
            first = int(corners[0]) if len(corners) else 0
            self.loops.append(loop[first:] + loop[:first])
            self.turns.append(np.roll(turns, -first))
            self.ways.append(np.roll([o if len(line) == 2 else np.nan for o, line in zip(out, lines)], -first))


def _bend(line):
    """Radians by which a line's first segments turn: half of it lies before its first chord."""
    if len(line) < 3:
        return 0.0
    d = np.diff(line[:3], axis=0)
    return float(np.arctan2(d[0, 0] * d[1, 1] - d[0, 1] * d[1, 0], d[0] @ d[1]))


def _stops(pieces, spacing, counts, held):
    """{piece: shares of its length}; even ones where a neighbour gives their number."""
    return {c: np.arange(counts[c] + 1) / counts[c] if k in held else own.stops(counts[c])
            for k, (c, own) in enumerate(zip(pieces, spacing))}


def _counts(arrangement, pieces, outlines, spacing, alike, even, held):
    """{piece: intervals}. spacing: list of Spacing; alike: as PieceSizes has it; held: row of a piece -> its number."""
    row_of = {c: k for k, c in enumerate(pieces)}
    ideal, least = ideal_counts([arrangement.pieces[c] for c in pieces], [own.wanted for own in spacing])
    for k, n in held.items():
        ideal[k], least[k] = n, n
    rows = [(terms, 0, ALIKE) for terms in alike]
    for outline in outlines.values():
        rows += _rows([[row_of[c] for c, _ in loop] for loop in outline.loops], outline, ideal)
    return dict(zip(pieces, divide(ideal, least, rows, held, 2 if even else 1).tolist()))


def _rows(loops, outline, ideal):
    """What a region wishes, as divide takes it."""
    rows = []
    for wish in wishes(outline.turns, [ideal[loop] for loop in loops], outline.ways):
        terms = {}
        for (loop, edge), factor in wish.terms.items():
            terms[loops[loop][edge]] = terms.get(loops[loop][edge], 0) + factor
        rows.append((terms, wish.multiple, None if wish.hard else wish.weight))
    return rows


class _Regions:
    """Meshes of all regions for divided pieces; what was made is kept, and what failed is tried first."""

    def __init__(self, arrangement, outlines, size, link):
        self._arrangement, self._outlines, self._size, self._link = arrangement, outlines, size, link
        self._order, self._known = list(outlines), {}

    def meshed(self, stops, paving):
        """The FlatMesh. stops: {piece: shares}; paving: gmsh may be asked. Raises NoPlaneMesh."""
        nodes, on_piece = self._on_pieces(stops)
        made = {}
        for r in list(self._order):
            try:
                made[r] = self._region(r, nodes, on_piece, stops, paving)
            except NoPlaneMesh:
                self._order.remove(r)
                self._order.insert(0, r)
                raise
        return self._assembled(made, nodes, on_piece, stops)

    def _on_pieces(self, stops):
        vertices = self._arrangement.vertices
        nodes, on_piece, total = [vertices], {}, len(vertices)
        for c, shares in stops.items():
            piece, inner = self._arrangement.pieces[c], len(shares) - 2
            on_piece[c] = np.concatenate([[piece.ends[0]], total + np.arange(inner), [piece.ends[1]]])
            nodes.append(piece.at(shares[1:-1]))
            total += inner
        return np.concatenate(nodes), on_piece

    def _region(self, r, nodes, on_piece, stops, paving):
        key = r, paving, tuple(stops[c].tobytes() for loop in self._outlines[r].loops for c, _ in loop)
        if key not in self._known:
            ids, turns = _divided(self._outlines[r], on_piece)
            try:
                self._known[key] = mesh_plane(PlaneRegion([nodes[i] for i in ids], turns), self._size, self._link,
                                              f"region {r}", paving)
            except NoPlaneMesh as fault:
                self._known[key] = fault
        if isinstance(self._known[key], NoPlaneMesh):
            raise self._known[key]
        return self._known[key]

    def _assembled(self, made, nodes, on_piece, stops):
        points, quads, total = [nodes], {}, len(nodes)
        for r, outline in self._outlines.items():
            ids = np.concatenate(_divided(outline, on_piece)[0])
            inner = made[r].points[len(ids):]
            quads[r] = np.concatenate([ids, total + np.arange(len(inner))])[made[r].quads]
            points.append(inner)
            total += len(inner)
        meshes = list(made.values())
        return FlatMesh(np.concatenate(points), on_piece, stops, quads, min(m.low for m in meshes),
                        float(np.average([m.mean for m in meshes], weights=[len(m.quads) for m in meshes])),
                        min(m.low / max(m.limit, 0.2) for m in meshes), min(m.limit for m in meshes))


def _divided(outline, on_piece):
    """(ids of the points of each loop, turns at each)."""
    ids, turns = [], []
    for loop, turn in zip(outline.loops, outline.turns):
        parts = [(on_piece[c] if f else on_piece[c][::-1])[:-1] for c, f in loop]
        ids.append(np.concatenate(parts))
        turns.append(np.concatenate([np.concatenate([[t], np.zeros(len(p) - 1)]) for t, p in zip(turn, parts)]))
    return ids, turns

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the pairs of cap faces between which a solid can be swept, from its topology alone.

A *column* is what stands on one run of cap edges: one side face, or several stacked ones, each
bounded by a lower front, a right lateral chain, an upper front and a left lateral chain.
"""
from dataclasses import dataclass, field

import numpy as np

from .fault import WorkerFault


class _No(Exception):
    """This pair of faces is no pair of caps; the text says why."""


@dataclass
class Column:
    """Signed edges run left to right in fronts, upwards in left and right."""
    faces: list = field(default_factory=list)    # side faces, lowest first
    fronts: list = field(default_factory=list)   # len(faces) + 1 lists of signed edges
    left: list = field(default_factory=list)
    right: list = field(default_factory=list)


@dataclass
class Sweep:
    bottom: int              # cap A
    top: int                 # cap B
    loops: list              # per loop of cap A: list of Columns, cyclic, each starting where the last ended
    levels: int              # lateral chains have 1 or `levels` edges


def candidates(solid, most=12):
    """Sweeps of the solid, best first, at most `most`. Raises WorkerFault NOT_SWEEPABLE, with the reason, if none."""
    holed = [f for f in solid.faces if len(solid.loops[f]) > 1]
    if len(holed) > 2:
        raise WorkerFault("NOT_SWEEPABLE", f"{len(holed)} faces have holes; a sweep has two such faces "
                          "at most, its caps", holed)
    found, why = [], "no two faces have boundaries that match"
    for a, b in _pairs(solid, holed):
        if solid.area(b) > solid.area(a):
            a, b = b, a
        try:
            found.append(_walk(solid, a, b))
        except _No as reason:
            why = str(reason)
    if not found:
        raise WorkerFault("NOT_SWEEPABLE", f"no pair of cap faces joined by side faces was found ({why})"
                          + _hint(solid))
    found.sort(key=lambda s: _rank(solid, s), reverse=True)
    return found[:most]


def _hint(solid):
    """Advice where a plane face was left in pieces, as unrefined unions have them."""
    for around in solid.faces_of.values():
        if around[0] != around[1] and all(solid.is_plane(f) for f in around):
            normals = [solid.plane_normal(f) for f in around]
            if abs(normals[0] @ normals[1]) > 1.0 - 1e-9:
                return (f"; Face{around[0]} and Face{around[1]} are parts of one plane face: "
                        "refining the shape (Part, Refine shape) may make a sweep of it")
    return ""


def _pairs(solid, holed):
    """Pairs of faces with equal counts of loops and edges, no shared edge, and no seam."""
    edges = {f: {abs(e) for e in solid.boundary[f]} for f in solid.faces}
    groups = {}
    for f in solid.faces:
        signature = (len(solid.loops[f]), len(edges[f]))
        if len(edges[f]) == len(solid.boundary[f]) and len(edges[f]) <= len(solid.faces) * 4:
            groups.setdefault(signature, []).append(f)
    for group in groups.values():
        for i, a in enumerate(group):
            for b in group[i + 1:]:
                if not edges[a] & edges[b] and set(holed) <= {a, b}:
                    yield a, b


def _walk(solid, a, b):
    """The Sweep from face a to face b; raises _No."""
    used = {a, b}
    loops = [_loop_columns(solid, loop, a, b, used) for loop in solid.loops[a]]
    if len(used) != len(solid.faces):
        raise _No(f"faces {sorted(set(solid.faces) - used)[:5]} touch no column between the caps")
    tops = [abs(e) for columns in loops for c in columns for e in c.fronts[-1]]
    if sorted(tops) != sorted(abs(e) for e in solid.boundary[b]):
        raise _No("the columns do not end on all edges of the second cap")
    counts = {len(chain) for columns in loops for c in columns for chain in (c.left, c.right)}
    counts |= {len(c.faces) for columns in loops for c in columns}
    if len(counts - {1}) > 1:
        raise _No("side faces are stacked in columns of different heights")
    return Sweep(a, b, loops, max(counts))


def _loop_columns(solid, loop, a, b, used):
    """Columns over one loop of cap a."""
    own = {abs(e) for e in solid.boundary[a]}
    at_vertex = _edges_at(solid)
    standing = [bool(at_vertex[solid.start(e)] - own) for e in loop]
    if any(len(at_vertex[solid.start(e)] - own) > 1 for e in loop):
        raise _No(f"more than one side edge leaves a vertex of face {a}")
    if not any(standing):
        raise _No(f"no side edge leaves face {a}")
    first = standing.index(True)
    loop, standing = loop[first:] + loop[:first], standing[first:] + standing[:first]
    runs = []
    for e, new in zip(loop, standing):
        runs.append([e]) if new else runs[-1].append(e)
    columns = [_column(solid, run, a, b, used) for run in runs]
    for here, after in zip(columns, columns[1:] + columns[:1]):
        if [abs(e) for e in here.right] != [abs(e) for e in after.left]:
            raise _No("neighbouring side faces do not share their lateral edges")
    return columns


def _edges_at(solid):
    """vertex -> set of its edges; kept on the solid, because every pair of faces asks."""
    if not hasattr(solid, "edges_at"):
        solid.edges_at = {}
        for e, (v, w) in solid.ends.items():
            solid.edges_at.setdefault(v, set()).add(e)
            solid.edges_at.setdefault(w, set()).add(e)
    return solid.edges_at


def _column(solid, run, a, b, used):
    """Climb from a run of edges of cap a to cap b."""
    column = Column(fronts=[list(run)])
    below = a
    while True:
        front = column.fronts[-1]
        face = _across(solid, front, below)
        if face in used:
            raise _No(f"face {face} would be used twice")
        used.add(face)
        right, up, left = _split(solid, face, front, b)
        column.faces.append(face)
        column.fronts.append([-e for e in reversed(up)])
        column.right += right
        column.left += [-e for e in reversed(left)]
        if all(b in solid.faces_of[abs(e)] for e in up):
            break
        below = face
    if len(column.fronts[0]) != len(column.fronts[-1]):
        raise _No("the two caps have different numbers of edges over one side face")
    return column


def _across(solid, front, below):
    """The one face on the other side of all edges of a front."""
    faces = set()
    for e in front:
        around = solid.faces_of[abs(e)]
        faces |= {around[1] if around[0] == below else around[0]}
    if len(faces) != 1:
        raise _No("several side faces stand on cap edges without a side edge between them")
    return faces.pop()


def _split(solid, face, front, b):
    """(right, upper, left) signed edges of a side face, in the order of its loop after the front."""
    if len(solid.loops[face]) != 1:
        raise _No(f"side face {face} has holes")
    loop = solid.loops[face][0]
    names = [abs(e) for e in loop]
    if any(names.count(abs(e)) != 1 for e in front):
        raise _No(f"face {face} meets a cap in a seam")
    if loop[names.index(abs(front[0]))] != front[0]:
        loop = [-e for e in reversed(loop)]
        names = [abs(e) for e in loop]
    at = names.index(abs(front[0]))
    loop, names = loop[at:] + loop[:at], names[at:] + names[:at]
    n = len(front)
    if names[:n] != [abs(e) for e in front]:
        raise _No(f"the edges of a front are not consecutive in face {face}")
    rest = loop[n:]
    on_top = [b in solid.faces_of[abs(e)] for e in rest]
    if not any(on_top):
        if len(rest) != 3 or n != 1:
            raise _No(f"side face {face} does not have four sides")
        return rest[:1], rest[1:2], rest[2:]
    i, j = on_top.index(True), len(rest) - on_top[::-1].index(True)
    if not all(on_top[i:j]) or i == 0 or j == len(rest):
        raise _No(f"side face {face} does not run from cap to cap")
    return rest[:i], rest[i:j], rest[j:]


def _rank(solid, sweep):
    """Larger is better: holes, planar congruent caps, the more complex cap, straight equal sides."""
    a, b = sweep.bottom, sweep.top
    areas = solid.area(b), solid.area(a)
    laterals = [c.left for loop in sweep.loops for c in loop]
    lengths = np.array([sum(solid.length(e) for e in chain) for chain in laterals])
    return (len(sweep.loops),
            solid.is_plane(a) + solid.is_plane(b),
            round(areas[0] / max(areas[1], 1e-300), 2),
            len(solid.boundary[a]) != 4,
            len(solid.boundary[a]),
            all(solid.is_line(abs(e)) for chain in laterals for e in chain),
            -sweep.levels,
            float(lengths.min() / lengths.max()),
            areas[0])

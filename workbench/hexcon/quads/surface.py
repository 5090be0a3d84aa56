# SPDX-License-Identifier: LGPL-2.1-or-later
"""A closed quad surface, and the checks every road to one must pass. Plain numpy."""
from dataclasses import dataclass, field

import numpy as np

from hexcon.errors import FaultCode, ToolError

FARTHEST = 1e100    # of a coordinate; its cube is still a number


@dataclass
class QuadSurface:
    """A closed surface of quads.

    points        (V,3) float64, every one used by a quad
    quads         (n,4) int64, 0-based, counter-clockwise seen from outside
    face_of_quad  (n,) int64: 1-based number of the CAD face (Face3 -> 3), 0 where there is no CAD
    method        the method that made it: "sweep", "blocks", "subdivided", ..., or "given"
    notes         what the user should know: other sizes tried, why `auto` did not sweep, ...
    size          wanted edge length that it was made with; 0: it was not made from a solid
    tried         how many surfaces of meshing.strategy.TRIES were tried before this one
    hexes         None, or a proposal as hexcon_native.mesh takes it: the hexes that the method has in mind inside the
                  quads, (H,8) int64, or (places of the points inside, hexes)
    """
    points: np.ndarray
    quads: np.ndarray
    face_of_quad: np.ndarray
    method: str
    notes: list = field(default_factory=list)
    size: float = 0.0
    tried: int = 0
    hexes: "np.ndarray | tuple | None" = None


def edges_of(quads):
    """(4n,2) directed edges, edge k of quad q in row 4 q + k."""
    return np.stack([quads, np.roll(quads, -1, axis=1)], axis=-1).reshape(-1, 2)


def edges_along(quads, path):
    """(k,2) those steps of a closed path of points, the last to the first included, that are edges of the quads."""
    path = np.asarray(path, np.int64).reshape(-1)
    steps = np.column_stack([path, np.roll(path, -1)])
    known = np.unique(np.sort(edges_of(quads), axis=1), axis=0)
    size = int(max(known.max(), path.max(initial=0))) + 1
    keys = np.sort(steps, axis=1) @ np.array([size, 1])
    return steps[np.isin(keys, known @ np.array([size, 1]))]


def edge_partners(quads):
    """(4n,) row of edges_of that holds the same edge of the other quad.

    Raises ToolError BAD_SHAPE, with the quads at fault, where an edge is not in exactly two quads.
    """
    edges = np.sort(edges_of(quads), axis=1)
    keys = edges[:, 0] * (int(quads.max()) + 1) + edges[:, 1]
    order = np.argsort(keys, kind="stable")
    ranked = keys[order]
    pairs = len(ranked) % 2 == 0 and (ranked[::2] == ranked[1::2]).all() and (ranked[2::2] != ranked[:-2:2]).all()
    if not pairs:
        _, inverse, counts = np.unique(keys, return_inverse=True, return_counts=True)
        bad = np.unique(np.flatnonzero(counts[inverse] != 2) // 4)
        raise ToolError(f"the surface is not closed: {int((counts != 2).sum())} edges are not in exactly two quads",
                        FaultCode.BAD_SHAPE, bad)
    partner = np.empty(len(keys), np.int64)
    partner[order[::2]], partner[order[1::2]] = order[1::2], order[::2]
    return partner


def orient(points, quads):
    """Quads (n,4) turned consistently, with their normals out of the solid: into the cavity, where a component lies
    inside an odd number of others.

    Returns (quads, number of bodies, number of cavities). Raises ToolError BAD_SHAPE if not closed or not orientable.
    Cost: linear, in numpy passes that grow with the breadth of the surface, and with the number of components round
    each other.
    """
    partner = edge_partners(quads)
    edges = edges_of(quads)
    against = edges[:, 0] == edges[partner, 0]          # both run the same way: one must turn
    turn = np.full(len(quads), -1, np.int8)
    component = np.empty(len(quads), np.int64)
    components = 0
    while (turn < 0).any():
        _flood(int(np.argmax(turn < 0)), partner, against, turn, component, components)
        components += 1
    wrong = (turn[np.arange(len(edges)) // 4] ^ turn[partner // 4]) != against
    if wrong.any():
        raise ToolError("the surface cannot be oriented", FaultCode.BAD_SHAPE, np.unique(np.flatnonzero(wrong) // 4))
    quads = np.where(turn[:, None] == 1, quads[:, ::-1], quads)
    cavity = _cavities(points, quads, component, components)
    volume = np.bincount(component, _volumes(points, quads), minlength=components)
    wrong = (volume < 0) != cavity
    cavities = int(cavity.sum())
    return np.where(wrong[component][:, None], quads[:, ::-1], quads), components - cavities, cavities


def _cavities(points, quads, component, components):
    """(components,) bool: those inside an odd number of others."""
    depth = np.zeros(components, np.int64)
    if components == 1:
        return depth > 0
    order = np.argsort(component, kind="stable")
    parts = np.split(quads[order], np.cumsum(np.bincount(component))[:-1])
    low, high = (np.array([getattr(points[part], limit)(axis=(0, 1)) for part in parts]) for limit in ("min", "max"))
    for k, part in enumerate(parts):
        inside = (low >= low[k]).all(axis=1) & (high <= high[k]).all(axis=1)
        inside[k] = False
        for other in np.flatnonzero(inside):
            depth[other] += _winds_round(points[part], points[parts[other][0, 0]])
    return depth % 2 == 1


def _winds_round(corners, point):
    """Whether a shell of quads (n,4,3) winds round a point, by solid angles (Van Oosterom and Strackee 1983)."""
    arms = corners - point
    arms /= np.linalg.norm(arms, axis=2)[:, :, None]
    half = 0.0
    for ids in ((0, 1, 2), (0, 2, 3)):
        a, b, c = (arms[:, i] for i in ids)
        pairs = [(a * b).sum(axis=1), (b * c).sum(axis=1), (c * a).sum(axis=1)]
        half += np.arctan2((a * np.cross(b, c)).sum(axis=1), 1.0 + sum(pairs)).sum()
    return abs(half) > np.pi


def _flood(seed, partner, against, turn, component, number):
    """Spread the sense of one quad over its component, ring by ring."""
    turn[seed] = 0
    component[seed] = number
    ring = np.array([seed])
    while len(ring):
        rows = (ring[:, None] * 4 + np.arange(4)).ravel()
        other = partner[rows] // 4
        fresh = turn[other] < 0
        other, rows = other[fresh], rows[fresh]
        turn[other] = turn[rows // 4] ^ against[rows]
        component[other] = number
        ring = np.unique(other)


def _volumes(points, quads):
    """(n,) signed volume of the pyramid from the middle over each quad (mean of its two triangulations)."""
    p = points[quads] - points.mean(axis=0)
    half = np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1]) / 2.0
    return (half * p.mean(axis=1)).sum(axis=1) / 3.0


def given(points, quads, notes):
    """A QuadSurface "given": unused points dropped, closed, turned outward with a note.

    points (V,3), quads (n,4). An odd number of quads or several parts are left for the core to judge.
    Raises ToolError BAD_SHAPE (not closed, not orientable, a repeated vertex, NaN).
    """
    points, before = _packed(points, quads)
    quads = orient(points, before)[0]
    turned = int((quads != before).any(axis=1).sum())
    if turned:
        notes = [*notes, "all quads faced inward and were turned" if turned == len(quads)
                 else f"{turned} quads were oriented against the others, or inward, and were turned"]
    return QuadSurface(points, np.ascontiguousarray(quads), np.zeros(len(quads), np.int64), "given", list(notes))


def finished(points, quads, faces, method, notes, hexes=None):
    """The QuadSurface of one solid: unused points dropped, closed, outward, even, of one body, which may have cavities.

    points (V,3), quads (n,4), faces (n,), hexes (H,8) or None: a proposal, whose ids that no quad has are points
    inside, at their places where all of them are rows of points. Raises ToolError BAD_SHAPE (not closed, not orientable,
    a repeated vertex, NaN, several bodies) or ODD_SURFACE.
    """
    hexes = None if hexes is None else _packed_proposal(points, quads, hexes)
    points, quads = _packed(points, quads)
    quads, bodies, _ = orient(points, quads)
    if bodies > 1:
        raise ToolError(f"the surface bounds {bodies} separate bodies; one is needed", FaultCode.BAD_SHAPE)
    if len(quads) % 2:
        raise ToolError(f"the number of quads is odd ({len(quads)}): no hexahedral mesh has such a boundary",
                        FaultCode.ODD_SURFACE)
    return QuadSurface(points, np.ascontiguousarray(quads), np.asarray(faces, np.int64), method, list(notes),
                       hexes=hexes)


def _packed_proposal(points, quads, hexes):
    """The proposal with ids as _packed numbers the quads' points, then those inside, ascending."""
    hexes, outer = np.asarray(hexes, np.int64), np.unique(quads)
    inner = np.setdiff1d(hexes, outer)
    names = np.concatenate([outer, inner])
    order = np.argsort(names, kind="stable")
    hexes = order[np.searchsorted(names[order], hexes)]
    return (np.asarray(points, np.float64)[inner], hexes) if (inner < len(points)).all() else hexes


def _packed(points, quads):
    """points (V,3) float64 and quads (n,4) int64, checked one by one, without unused points."""
    points, quads = np.asarray(points, np.float64), np.asarray(quads, np.int64)
    if not len(quads):
        raise ToolError("there are no quads", FaultCode.BAD_SHAPE)
    if not np.isfinite(points).all():
        raise ToolError("a point is not finite", FaultCode.BAD_SHAPE, np.flatnonzero(~np.isfinite(points).all(axis=1)))
    far = (np.abs(points) > FARTHEST).any(axis=1)
    if far.any():
        raise ToolError(f"a point is farther than {FARTHEST:g} from the origin: volumes could not be computed",
                        FaultCode.BAD_SHAPE, np.flatnonzero(far))
    ranked = np.sort(quads, axis=1)
    repeated = (ranked[:, 1:] == ranked[:, :-1]).any(axis=1)
    if repeated.any():
        raise ToolError("a quad names one point twice", FaultCode.BAD_SHAPE, np.flatnonzero(repeated))
    used, packed = np.unique(quads, return_inverse=True)
    return points[used], packed.reshape(-1, 4).astype(np.int64)

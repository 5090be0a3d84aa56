# SPDX-License-Identifier: LGPL-2.1-or-later
"""A closed quad surface, and the checks every road to one must pass: those of the core."""
from dataclasses import dataclass, field

import numpy as np

import hexcon_native
from hexcon.errors import FaultCode, ToolError
from hexcon_native import ErrorCode, HexconError

from .fit import Fit


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
    pieces        ((name, how many), ...) of what those hexes are made of, one after the other; () where none are told
    quad_groups   {name: rows of quads} that the surface was given with, beside CAD faces; they may overlap
    node_groups   {name: rows of points}
    middles       None, or (ends (k,2), places (k,3)) of the curved edges of 8-node quads that it was given with
    fit           None, or how well the quads fit the solid that they were made on
    """
    points: np.ndarray
    quads: np.ndarray
    face_of_quad: np.ndarray
    method: str
    notes: list = field(default_factory=list)
    size: float = 0.0
    tried: int = 0
    hexes: "np.ndarray | tuple | None" = None
    quad_groups: dict = field(default_factory=dict)
    node_groups: dict = field(default_factory=dict)
    middles: "tuple | None" = None
    fit: Fit | None = None
    pieces: tuple = ()


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

    Raises HexconError NOT_CLOSED, with the quads at fault, where an edge is not in exactly two quads.
    """
    edges = np.sort(edges_of(quads), axis=1)
    keys = edges[:, 0] * (int(quads.max()) + 1) + edges[:, 1]
    order = np.argsort(keys, kind="stable")
    ranked = keys[order]
    pairs = len(ranked) % 2 == 0 and (ranked[::2] == ranked[1::2]).all() and (ranked[2::2] != ranked[:-2:2]).all()
    if not pairs:
        _, inverse, counts = np.unique(keys, return_inverse=True, return_counts=True)
        bad = np.unique(np.flatnonzero(counts[inverse] != 2) // 4)
        raise HexconError(f"the surface is not closed: {int((counts != 2).sum())} edges are not in exactly two quads",
                          ErrorCode.NOT_CLOSED, bad)
    partner = np.empty(len(keys), np.int64)
    partner[order[::2]], partner[order[1::2]] = order[1::2], order[::2]
    return partner


def given(points, quads, notes):
    """A QuadSurface "given": unused points dropped, closed, turned outward with a note.

    points (V,3), quads (n,4), in any sense. An odd number of quads or several parts are left for the core to judge.
    Raises HexconError, as hexcon_native.orient; ids of points are rows of the given ones.
    """
    points, before = _packed(points, quads)
    quads, _, _ = _oriented(points, before, quads)
    turned = int((quads != before).any(axis=1).sum())
    if turned:
        notes = [*notes, "all quads faced inward and were turned" if turned == len(quads)
                 else f"{turned} quads were oriented against the others, or inward, and were turned"]
    return QuadSurface(points, quads, np.zeros(len(quads), np.int64), "given", list(notes))


def finished(points, quads, faces, method, notes, hexes=None):
    """The QuadSurface of one solid: unused points dropped, closed, outward, even, of one body, which may have cavities.

    points (V,3), quads (n,4), faces (n,), hexes (H,8) or None: a proposal, whose ids that no quad has are points
    inside, at their places where all of them are rows of points. Raises ToolError BAD_SHAPE (several bodies) or
    ODD_SURFACE, and HexconError as given.
    """
    hexes = None if hexes is None else _packed_proposal(points, quads, hexes)
    points, packed = _packed(points, quads)
    quads, bodies, _ = _oriented(points, packed, quads)
    if bodies > 1:
        raise ToolError(f"the surface bounds {bodies} separate bodies; one is needed", FaultCode.BAD_SHAPE)
    if len(quads) % 2:
        raise ToolError(f"the number of quads is odd ({len(quads)}): no hexahedral mesh has such a boundary",
                        FaultCode.ODD_SURFACE)
    return QuadSurface(points, quads, np.asarray(faces, np.int64), method, list(notes),
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
    """(points (V,3) float64, quads (n,4) int64) without unused points."""
    points, quads = np.asarray(points, np.float64), np.asarray(quads, np.int64)
    used, packed = np.unique(quads, return_inverse=True)
    return points[used], packed.reshape(-1, 4).astype(np.int64)


def _oriented(points, packed, quads):
    """hexcon_native.orient, its ids of points those of the quads before they were packed."""
    try:
        turned, bodies, cavities = hexcon_native.orient(points, packed)
    except HexconError as fault:
        if fault.code in (ErrorCode.NOT_FINITE, ErrorCode.NON_MANIFOLD_VERTEX):
            fault.elements = np.unique(quads)[fault.elements].tolist()
        raise
    return turned.astype(np.int64), bodies, cavities

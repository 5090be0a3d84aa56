# SPDX-License-Identifier: LGPL-2.1-or-later
"""What points of a boundary slide on, as the core takes it."""
import operator
import typing

import numpy as np

from .errors import HexconError
from .tables import CARRIERS, ErrorCode


class Carrier(typing.NamedTuple):
    """A point, a curve or a surface; CARRIERS tells which fields count for its kind.

    kind    a name of CARRIERS
    origin, axis, across   three numbers each, of any length but 0
    sizes   up to two numbers: radii, a half angle in radians, where a line or an arc ends
    tag     what `project` is told, an integer
    Surfaces go on without end: a plane is a whole plane; so do lines and circles that are given no end.
    """

    kind: str
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0)
    axis: tuple[float, float, float] = (0.0, 0.0, 1.0)
    across: tuple[float, float, float] = (1.0, 0.0, 0.0)
    sizes: tuple[float, ...] = ()
    tag: int = 0


class Facets(typing.NamedTuple):
    """Triangles near the surfaces of carriers, which tell where each piece of a carrier counts.

    points     (n, 3): corners of triangles
    triangles  (m, 3) int: rows of points
    carriers   (m,) int: rows of the carriers they are of, and pieces (m,) int: which of its pieces. Every piece of such
               a carrier has some, and is a surface in closed form, or of kind "facets"
    normals    None, or (m, 3, 3): of the surface at the corners of each, of any length but 0, either way round; kind
               "facets" needs them
    """

    points: typing.Any
    triangles: typing.Any
    carriers: typing.Any
    pieces: typing.Any
    normals: typing.Any = None


def packed_facets(facets, starts):
    """What the core takes of Facets, or of None; starts: as packed gives them. Raises HexconError WRONG_SHAPE,
    INDEX_OUT_OF_RANGE."""
    if facets is None:
        return np.zeros(0), np.zeros(0, np.int32), np.zeros(0, np.int32), np.zeros(0)
    try:
        points, triangles = np.asarray(facets.points, float), np.asarray(facets.triangles)
        carriers, pieces = np.asarray(facets.carriers), np.asarray(facets.pieces)
        count = len(triangles)
        normals = np.ones((count, 3, 3)) if facets.normals is None else np.asarray(facets.normals, float)
        ids = np.concatenate([triangles.ravel(), carriers.ravel(), pieces.ravel()])
    except Exception as fault:
        raise HexconError(f"facets must be hexcon_native.Facets: {type(fault).__name__}: {fault}",
                          ErrorCode.BAD_ARGUMENT) from fault
    shapes = points.shape[1:] == (3,) and triangles.shape == (count, 3) and carriers.shape == pieces.shape == (count,)
    if not shapes or normals.shape != (count, 3, 3) or (ids.size and ids.dtype.kind not in "iu"):
        raise HexconError("facets: points (n, 3), triangles (m, 3), carriers (m,) and pieces (m,) of integers, normals "
                          "(m, 3, 3) or None are needed", ErrorCode.WRONG_SHAPE)
    most = np.append(np.diff(starts), 0)
    bad = (carriers < 0) | (carriers >= len(starts) - 1) | (pieces < 0)
    bad |= pieces >= most[np.where(bad, -1, carriers)] if count else False
    bad |= (triangles < 0).any(axis=1) | (triangles >= len(points)).any(axis=1)
    if bad.any():
        raise HexconError(f"{int(bad.sum())} facets (listed) name points, carriers or pieces that do not exist",
                          ErrorCode.INDEX_OUT_OF_RANGE, np.flatnonzero(bad)[:1000])
    return (np.ascontiguousarray(points), np.ascontiguousarray(triangles, np.int32),
            np.ascontiguousarray(np.asarray(starts)[carriers] + pieces, np.int32) if count else np.zeros(0, np.int32),
            np.ascontiguousarray(normals))


ROW = np.dtype([("kind", np.int32), ("tag", np.int32), ("origin", np.float64, 3), ("axis", np.float64, 3),
                ("across", np.float64, 3), ("sizes", np.float64, 2)], align=True)
"""hexcon_carrier of the C API."""


def _row(carrier):
    number, _, _ = CARRIERS[carrier.kind]
    first, second = (*carrier.sizes, 0.0, 0.0)[:2]
    return (number, operator.index(carrier.tag), tuple(carrier.origin), tuple(carrier.axis), tuple(carrier.across),
            (first, second))


def packed(carriers):
    """(starts, pieces) of carriers: each a Carrier, or a list of them of which the nearest counts."""
    starts, rows = [0], []
    for number, given in enumerate(carriers):
        pieces = [given] if isinstance(given, Carrier) else given
        try:
            rows += [np.array(_row(piece), ROW) for piece in pieces]
        except Exception as fault:  # no Carrier, no such kind, or fields of the caller's own making
            raise HexconError(f"carrier {number} must be a hexcon_native.Carrier, or a list of them, of a kind in "
                              f"{', '.join(CARRIERS)}: {type(fault).__name__}: {fault}",
                              ErrorCode.BAD_ARGUMENT, [number]) from fault
        starts.append(len(rows))
    return np.array(starts, np.int32), np.array(rows, ROW)

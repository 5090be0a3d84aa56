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

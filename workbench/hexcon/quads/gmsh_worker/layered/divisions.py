# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many intervals each piece of an arrangement gets: an integer program for all of them together.

Near length / size, enough for what a piece turns, even round every loop; and where it costs little as the plane
mesher's structures want it: equal on opposite sides, equal on both rims of a ring.
"""
import numpy as np

from ..outline import LARGEST
from ..program import Program
from .fault import NotLayered

ROUND, LEAST_ROUND = np.radians(30.0), 8    # turn of an interval of a full circle; fewest intervals of a small one
OPEN = np.radians(45.0)                     # of an arc
SECONDS, GAP = 10.0, 0.02                   # limits of the program: time, and how far from the best
FAR = 1e5                                   # more intervals than any sum of them is off


def ideal_counts(pieces, wanted):
    """((n,) float ideal numbers, (n,) int least ones) of pieces. wanted (n,): intervals by their lengths."""
    turning = np.array([_turning(p.line) for p in pieces])
    least = np.maximum(np.ceil(turning / OPEN - 0.05), 1).astype(int)
    for k, piece in enumerate(pieces):
        if piece.closed:
            fine = int(np.ceil(turning[k] / ROUND - 0.05))
            least[k] = max(3, min(fine, max(LEAST_ROUND, int(wanted[k]))))
    return np.maximum(wanted, least), least


def _turning(line):
    d = np.diff(line, axis=0)
    if len(d) < 2:
        return 0.0
    d = d / np.maximum(np.linalg.norm(d, axis=1, keepdims=True), 1e-300)
    return float(np.arccos(np.clip((d[1:] * d[:-1]).sum(1), -1, 1)).sum() * len(d) / (len(d) - 1))


def divide(ideal, least, rows, held=(), step=1):
    """(n,) int numbers of intervals.

    rows: of (terms: {piece: coefficient}, multiple, weight): the sum of terms is to be a multiple, or 0 where that is
          0; weight: what one off costs, beside 1 / sqrt(n) for one off n by length; None: it must hold
    held: those whose number is their ideal one; step: all others are multiples of it
    Raises NotLayered where the hard ones cannot hold.
    """
    program = Program(FAR)
    high = np.maximum(4.0 * ideal + 8, least + 8)
    high[list(held)] = least[list(held)]
    steps = np.full(len(ideal), step)
    steps[list(held)] = 1
    few = np.maximum(least, np.floor(ideal / LARGEST))      # wishes do not make intervals much longer than the size
    few[list(held)] = least[list(held)]
    for low, most, by in zip(few, high, steps):
        program.column(float(np.ceil(low / by)), float(np.ceil(most / by)))
    for k, wanted in enumerate(ideal):
        program.near({k: float(steps[k])}, wanted, 1.0)
    for terms, multiple, weight in rows:
        terms = {k: int(factor * steps[k]) for k, factor in terms.items()}
        if multiple and not any(factor % multiple for factor in terms.values()):
            continue
        if multiple:
            terms[program.column(-FAR, FAR)] = -multiple
        if weight is None:
            program.row(terms, 0, 0)
        else:
            program.near(terms, 0, weight)
    found = program.solved(len(ideal), time_limit=SECONDS, mip_rel_gap=GAP)
    if found is None:
        raise NotLayered("no numbers of intervals fit together")
    return steps * found

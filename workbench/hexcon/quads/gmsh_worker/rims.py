# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recognise a round solid: a cap, walls one after another, a cap, joined by smooth closed rims; or one face, a ball.

Cylinders, cones and their frusta, capsules, lenses, half balls, barrels, drums.
"""
from dataclasses import dataclass

import numpy as np

from .outline import CORNER

NEARLY_BEST = 1e-3          # a fit of two rims this near to the best is taken, if it joins their first vertices


@dataclass
class Chain:
    """faces: cap, walls ..., cap. rims: len(faces) - 1 lists of signed edges, each a closed loop."""
    faces: list
    rims: list


def chain_of(solid):
    """The Chain of a solid, or None if it is none. A ball has one face and no rims."""
    loops = {f: _free_loops(solid, f) for f in solid.faces}
    caps = [f for f in solid.faces if loops[f] is not None and len(loops[f]) == 1]
    if len(solid.faces) == 1:
        return Chain(list(solid.faces), []) if _is_ball(solid, loops[solid.faces[0]]) else None
    if len(caps) != 2 or any(r is None or len(r) not in (1, 2) for r in loops.values()):
        return None
    chain = _walk(solid, loops, caps)
    if chain is None or not all(_is_smooth(solid, rim) for rim in chain.rims):
        return None
    return chain


def _is_ball(solid, loops):
    """Poles at both ends of its seams; a torus' seams are closed."""
    return loops == [] and all(a != b for a, b in solid.ends.values())


def _free_loops(solid, face):
    """Closed loops of the edges of a face that are no seams; None where they do not close."""
    names = [abs(e) for e in solid.boundary[face]]
    left = [e for e in solid.boundary[face] if names.count(abs(e)) == 1]
    loops = []
    while left:
        loop = [left.pop(0)]
        while solid.end(loop[-1]) != solid.start(loop[0]):
            after = next((e for e in left if solid.start(e) == solid.end(loop[-1])), None)
            if after is None:
                return None
            left.remove(after)
            loop.append(after)
        loops.append(loop)
    return loops


def _walk(solid, loops, caps):
    """From one cap over the rims to the other; None where a rim is shared by more than two faces."""
    faces, rims = [caps[0]], [loops[caps[0]][0]]
    while True:
        rim = {abs(e) for e in rims[-1]}
        across = {f for e in rim for f in solid.faces_of[e]} - {faces[-1]}
        if len(across) != 1 or across & set(faces):
            return None
        faces.append(across.pop())
        others = [r for r in loops[faces[-1]] if {abs(e) for e in r} != rim]
        if len(others) == len(loops[faces[-1]]):
            return None
        if not others:
            return Chain(faces, rims) if len(faces) == len(solid.faces) else None
        rims.append(others[0])


def _is_smooth(solid, rim):
    """No corner between two of its edges."""
    return all(np.arccos(np.clip(solid.tangent(a, at_end=True) @ solid.tangent(b), -1, 1)) < CORNER
               for a, b in zip(rim, rim[1:] + rim[:1]))


def rim_points(solid, rim, fractions):
    """(m,3) points at fractions (m,) of the arc length round a rim, from its first vertex."""
    lengths = np.array([solid.length(e) for e in rim])
    starts = np.concatenate([[0.0], np.cumsum(lengths)])
    at = (np.asarray(fractions, float) % 1.0) * starts[-1]
    owner = np.clip(np.searchsorted(starts, at, side="right") - 1, 0, len(rim) - 1)
    points = np.empty((len(at), 3))
    for k, edge in enumerate(rim):
        mine = owner == k
        if mine.any():
            points[mine] = solid.edge_points(edge, (at[mine] - starts[k]) / lengths[k])
    return points


def aligned(solid, rims):
    """The rims as callables fractions -> points, all turning the same way about the chain, meridian by meridian.

    A rim starts at its first vertex if that fits the rim before it, else wherever it fits best.
    """
    steps = np.arange(720) / 720
    made = [lambda t: rim_points(solid, rims[0], t)]
    for rim in rims[1:]:
        made.append(_turned(solid, rim, made[-1](steps), steps))
    return made


def _turned(solid, rim, before, steps):
    """Callable fractions -> points of a rim, with the sense and the start that go best with the rim before."""
    best = None
    ahead = before - before.mean(axis=0)
    for sense in (1.0, -1.0):
        points = rim_points(solid, rim, sense * steps)
        arms = points - points.mean(axis=0)
        spectrum = np.conj(np.fft.fft(ahead, axis=0)) * np.fft.fft(arms, axis=0)
        fit = np.real(np.fft.ifft(spectrum.sum(axis=1)))
        shift = 0 if fit[0] > fit.max() - NEARLY_BEST * abs(fit.max()) else int(np.argmax(fit))
        if best is None or fit[shift] > best[0]:
            best = fit[shift], sense, shift / len(steps)
    _, sense, start = best
    return lambda t: rim_points(solid, rim, sense * (np.asarray(t, float) + start))


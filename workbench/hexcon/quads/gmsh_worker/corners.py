# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recognise a solid whose every corner is one of a cube: three edges, three faces."""
import numpy as np

from .fault import WorkerFault

SHARPEST, FLATTEST = 10.0, 168.0        # degrees between two edges of a face; nearer to 0 or 180 quads are no use


def corner_sides(solid):
    """dict face -> list of (signed edge, face across it), round the face, each edge starting where the last ended.

    Raises WorkerFault NOT_BLOCKS, naming the face or the vertex that is another.
    """
    sides = {f: _sides(solid, f) for f in solid.faces}
    for vertex, (edges, faces) in sorted(_around(solid).items()):
        if edges != 3 or len(faces) != 3:
            raise WorkerFault("NOT_BLOCKS", f"Vertex{vertex} has {edges} edges and {len(faces)} faces; blocks meet "
                              "where there are three of each", faces)
    for face in solid.faces:
        _check_angles(solid, face)
    return sides


def _sides(solid, face):
    loops = solid.loops[face]
    if len(loops) != 1:
        raise WorkerFault("NOT_BLOCKS", f"Face{face} has a hole; blocks need faces with one outline", [face])
    loop = loops[0]
    if len(loop) < 3 or len({abs(e) for e in loop}) < len(loop):
        raise WorkerFault("NOT_BLOCKS", f"Face{face} has fewer than three corners, or a seam, and the solid is no "
                          "ball, cylinder, cone or capsule", [face])
    ends_meet = all(solid.end(e) == solid.start(after) for e, after in zip(loop, loop[1:] + loop[:1]))
    if not ends_meet:
        raise WorkerFault("NOT_BLOCKS", f"the edges of Face{face} do not follow each other", [face])
    return [(e, _across(solid, e, face)) for e in loop]


def _check_angles(solid, face):
    loop = solid.loops[face][0]
    for before, edge in zip(loop[-1:] + loop[:-1], loop):
        cosine = -solid.tangent(before, at_end=True) @ solid.tangent(edge)
        angle = np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0)))
        if not SHARPEST <= angle <= FLATTEST:
            raise WorkerFault("NOT_BLOCKS", f"Face{face} has a corner of {angle:.0f} degrees at "
                              f"Vertex{solid.start(edge)}; blocks need {SHARPEST:.0f} to {FLATTEST:.0f}", [face])


def _across(solid, edge, face):
    first, second = solid.faces_of[abs(edge)]
    return second if first == face else first


def _around(solid):
    """vertex -> [number of its edges, set of their faces]."""
    found = {}
    for edge, ends in solid.ends.items():
        for vertex in ends:
            entry = found.setdefault(vertex, [0, set()])
            entry[0] += 1
            entry[1].update(solid.faces_of[edge])
    return found

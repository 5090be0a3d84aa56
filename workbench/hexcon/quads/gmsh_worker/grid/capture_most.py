# SPDX-License-Identifier: LGPL-2.1-or-later
"""Capture of as many of a solid's features as find room: smooth edges, and slivers, are given up a few at a time."""
from .capture import capture
from .captured import NotCaptured
from .features import SMOOTH, Features

ROUNDS = 8              # how often features are given up
FIRST_TRIES, TRIES = 5, 2   # placements of corners before anything is given up, and afterwards
NARROW = 0.4            # of the elements' size: a patch of less mean width is a sliver


def capture_most(features, points, hexes, h):
    """(CapturedMesh, the Features it has): those given, without edges that find no path and need not have one.

    h: size of the elements. Raises NotCaptured where what fails has neither a smooth edge nor a sliver.
    """
    for number in range(ROUNDS):
        try:
            return capture(features, points, hexes, FIRST_TRIES if number == 0 else TRIES), features
        except NotCaptured as fault:
            soft = _smooth_edges(features, fault) or _borders_of_slivers(features, fault, h)
            if not soft:
                raise
            features = Features(features.cad, features.smooth, features.soft | soft)
    return capture(features, points, hexes, TRIES), features


def _curves(features, fault):
    """Curves that a fault is about."""
    return [c for k, c in enumerate(features.curves)
            if k in fault.curves or {c.start, c.end} & set(fault.corners) or {c.left, c.right} & set(fault.patches)]


def _smooth_edges(features, fault):
    """CAD edges, where all edges were to be captured, that are smooth."""
    return {e for c in _curves(features, fault) for e in c.edges
            if max(abs(features.edges[e].least - 180.0), abs(features.edges[e].greatest - 180.0)) <= SMOOTH}


def _borders_of_slivers(features, fault, h):
    """CAD edges between slivers at a fault and their neighbours."""
    near = {p for c in _curves(features, fault) for p in (c.left, c.right)}
    return {e for e in features.slivers(h, NARROW) if near & {
        int(features.patch_of_face[f]) for f in (features.edges[e].left, features.edges[e].right)}}

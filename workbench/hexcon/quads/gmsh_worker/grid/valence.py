# SPDX-License-Identifier: LGPL-2.1-or-later
"""Boundary vertices with as many edges as a corner has curves.

A sheet round the one hex under a quad makes two quads of it at each of its vertices, so one edge more there. Where that
hex has more than one quad at the vertex, a sheet under the one quad moves the others back to a new vertex, which has
one edge more.
"""
import numpy as np

from .captured import CapturedMesh
from .corner_places import embedded
from .sheets import insert
from .skin import Skin

SPARE = 2               # edges more than curve ends that are made, at most
OFF = 0.25              # cosine of the angle between an edge and the curve that takes it: less is far off


def with_valence(points, hexes, wanted):
    """(points, hexes) with a vertex for each corner that has an edge for each curve's end; old points keep their ids.

    wanted: [(vertex, Ends of the corner that is to take it)]. At most five hexes for each edge that is made.
    """
    for vertex, ends in wanted:
        for _ in range(len(ends.ends)):
            skin = Skin(points, hexes)
            v = int(np.searchsorted(skin.vertices, vertex))
            if has_edges(skin, v, ends) or skin.valence[v] >= len(ends.ends) + SPARE:
                break
            points, hexes, vertex = _one_more(points, hexes, skin, v, ends)
    return points, hexes


def has_edges(skin, v, ends):
    """Whether a vertex has an edge for each end, none of them far off its direction."""
    directions = ends.directions(0.7 * skin.scale[v])
    _, found = embedded(ends, directions, skin.directions(v))
    return found is not None and bool(((directions * skin.directions(v)[found]).sum(axis=1) > OFF).all())


def _one_more(points, hexes, skin, v, ends):
    """(points, hexes, the vertex that has one edge more)."""
    quads, wish = _sectors(skin, v, ends)
    none, n = np.zeros(0, int), len(skin.quads)
    mesh = CapturedMesh(points, hexes, skin.quads, np.zeros(n, int), skin.under, np.zeros((0, 2), int), none, none)
    alone = np.bincount(skin.under[quads], minlength=len(hexes))[skin.under[quads]] == 1
    pulled, covered = np.ones(len(hexes), bool), np.zeros(n, bool)
    if not alone.any():
        covered[quads[min(range(len(quads)), key=lambda k: wish[k])]] = True
        mesh = insert(mesh, pulled, covered)
        place = np.searchsorted(np.sort(skin.quads[covered][0]), skin.vertices[v])
        return mesh.points, mesh.hexes, len(points) + int(place)
    pulled[:] = False
    pulled[skin.under[quads[max(np.flatnonzero(alone), key=lambda k: wish[k])]]] = True
    mesh = insert(mesh, pulled, covered)
    return mesh.points, mesh.hexes, int(skin.vertices[v])


def _sectors(skin, v, ends):
    """Quads at v, and how much each wants to be two: by the curve ends in its sector, then by its angle."""
    h = np.array(skin.outgoing(v))
    arms = skin.points[skin.half_edges.head[h]] - skin.points[v]
    arms /= np.linalg.norm(arms, axis=1)[:, None]
    width = np.arccos(np.clip((arms * np.roll(arms, -1, axis=0)).sum(axis=1), -1, 1))
    middle = arms + np.roll(arms, -1, axis=0)
    middle /= np.maximum(np.linalg.norm(middle, axis=1), 1e-9)[:, None]
    inside = (ends.directions(0.7 * skin.scale[v]) @ middle.T).argmax(axis=1)
    count = np.bincount(inside, minlength=len(h))
    return h // 4, [(int(count[k]), round(float(width[k]), 6), -k) for k in range(len(h))]

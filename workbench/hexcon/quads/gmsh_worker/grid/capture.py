# SPDX-License-Identifier: LGPL-2.1-or-later
"""The CAD's corners, curves and patches on the boundary of a hex mesh: each once, or a fault that says which not.

Corners take vertices, curves paths of edges between them, patches what lies between the paths. What is found is
checked: each patch one piece with the CAD's Euler characteristic.
"""
import numpy as np
from scipy.spatial import cKDTree

from .captured import CapturedMesh, NotCaptured, edge_keys
from .corner_places import CornerPlaces
from .routes import STRAY, Band, Routes
from .skin import Skin
from .valence import has_edges, with_valence

DIRECTION = 0.5         # weight of a normal beside a distance of one edge length, where patches are guessed
TRIES = 6               # placements of corners


def capture(model, points, hexes, tries=TRIES):
    """A CapturedMesh of hexes (H, 8) whose boundary lies near the model's faces. Raises NotCaptured.

    tries: placements of corners. Where a corner has more curves than any vertex near it has edges, hexes are put in.
    Cost: O(H log H), and paths within bands about the curves, times the rounds of negotiation.
    """
    skin = Skin(points, hexes)
    guess = guessed_patches(model, skin)
    places = CornerPlaces(model, skin, guess)
    vertex = places.placed()
    lacking = [k for k, ends in enumerate(places.ends) if ends.ends and not has_edges(skin, int(vertex[k]), ends)]
    if lacking:
        points, hexes = with_valence(points, hexes, [(int(skin.vertices[vertex[k]]), places.ends[k]) for k in lacking])
        skin = Skin(points, hexes)
        guess = guessed_patches(model, skin)
        places = CornerPlaces(model, skin, guess)
        vertex = None
    paths, vertex = _routed(model, skin, guess, places, vertex, tries)
    return _captured(model, skin, guess, points, hexes, vertex, paths)


def guessed_patches(model, skin):
    """(n,) patch that each quad of the skin is nearest to, in place and direction."""
    step = 0.25 * float(np.median(skin.scale))
    samples, normals, patch = _samples(model, step)
    scale = float(np.median(skin.scale))
    tree = cKDTree(np.hstack([samples / scale, DIRECTION * normals]))
    _, rows = tree.query(np.hstack([skin.centres / scale, DIRECTION * skin.normals]))
    return patch[rows]


def _samples(model, step):
    """Points all over the model's triangles, about `step` apart, with normals and patches."""
    tri = model.points[model.triangles]
    length = np.linalg.norm(model.normals, axis=1)
    side = np.clip(np.ceil(np.sqrt(length / 2) / step), 1, 45).astype(int)
    which = np.repeat(np.arange(len(tri)), side ** 2)
    place = np.arange(len(which)) - np.repeat(np.cumsum(side ** 2) - side ** 2, side ** 2)
    u, v = (place // side[which] + 0.5) / side[which], (place % side[which] + 0.5) / side[which]
    over = u + v > 1
    u[over], v[over] = 1 - u[over], 1 - v[over]
    t = tri[which]
    found = t[:, 0] + u[:, None] * (t[:, 1] - t[:, 0]) + v[:, None] * (t[:, 2] - t[:, 0])
    normals = model.normals[which] / np.maximum(length[which], 1e-300)[:, None]
    return found, normals, np.asarray(model.patch_of_face)[model.triangle_face[which]]


def _routed(model, skin, guess, places, vertex, tries):
    """(paths, vertex of each corner) of the first placement of corners with paths for all curves."""
    fault = None
    bands = [Band(model, skin, guess, c) for c in range(len(model.curves))]
    for _ in range(tries):
        vertex = places.placed() if vertex is None else vertex
        try:
            paths = Routes(model, skin, guess, bands, places, vertex).negotiated()
            _check_nearness(model, skin, bands, paths)
            return paths, vertex
        except NotCaptured as found:
            fault = fault or found
            near = set(found.corners) | {k for c in found.curves for k in (model.curves[c].start, model.curves[c].end)}
            near.discard(-1)
            if not near:
                break
            for k in near:
                places.blame(k, int(vertex[k]))
            vertex = None
    raise fault


def _check_nearness(model, skin, bands, paths):
    for c, path in paths.items():
        band, curve = bands[c], model.curves[c]
        far = band.gap[band.row_of[path]].max()
        along = curve.sampled(np.linspace(0, curve.length, 33))
        gap, at = cKDTree(skin.points[path]).query(along)
        if far > STRAY or (gap / skin.scale[path][at]).max() > STRAY + 0.4:
            raise NotCaptured("curve", f"the path of curve {c} strays {far:.1f} edge lengths from it: "
                              "smaller elements are needed there", along[16], curves=[c])


def _captured(model, skin, guess, points, hexes, vertex, paths):
    n = len(skin.points)
    curve_of = np.full(len(skin.edge_of), -1)
    side = np.full(len(skin.edge_of), -1)                  # patch on the left of a half-edge of a curve
    for c, path in paths.items():
        h = skin.half_edges.find(path[:-1], path[1:])
        back = skin.half_edges.twin[h]
        curve_of[h] = curve_of[back] = c
        side[h], side[back] = model.curves[c].left, model.curves[c].right
    piece, count = skin.pieces(curve_of >= 0)
    patch = _patch_of_pieces(model, skin, guess, piece, count, side)[piece]
    _check_topology(model, skin, patch)
    h = np.flatnonzero((curve_of >= 0) & (skin.half_edges.tail < skin.half_edges.head))
    h = h[np.argsort(edge_keys(skin.half_edges.tail[h], skin.half_edges.head[h], n))]
    edges = np.sort(skin.vertices[np.stack([skin.half_edges.tail[h], skin.half_edges.head[h]], axis=1)], axis=1)
    return CapturedMesh(points, hexes, skin.quads, patch, skin.under, edges, curve_of[h], skin.vertices[vertex])


def _patch_of_pieces(model, skin, guess, piece, count, side):
    """(count,) patch of each piece. Raises NotCaptured unless pieces and patches are one to one."""
    h = np.flatnonzero(side >= 0)
    votes = np.unique(np.stack([piece[h // 4], side[h]], axis=1), axis=0)
    out = np.full(count, -1)
    for k, p in votes.tolist():
        if out[k] >= 0:
            raise NotCaptured("patch", f"nothing parts patches {out[k]} and {p}", skin.centres[piece == k].mean(axis=0),
                              patches=[out[k], p])
        out[k] = p
    for k in np.flatnonzero(out < 0):                      # no curve bounds it: a ball, a torus
        out[k] = np.bincount(guess[piece == k]).argmax()
    owned = np.bincount(out, minlength=len(model.patches))
    if (owned != 1).any():
        p = int(np.flatnonzero(owned != 1)[0])
        where = skin.centres[out[piece] == p].mean(axis=0) if owned[p] else None
        raise NotCaptured("patch", f"patch {p} has {owned[p]} pieces instead of one", where,
                          patches=np.flatnonzero(owned != 1))
    return out


def _check_topology(model, skin, patch):
    tail, n = skin.half_edges.tail, len(skin.points)
    of_half = np.repeat(patch, 4)
    vertices = np.unique(of_half.astype(np.int64) * n + tail) // n
    edges = np.unique(of_half.astype(np.int64) * (2 * len(patch)) + skin.edge_of) // (2 * len(patch))
    size = len(model.patches)
    vertices, edges, quads = (np.bincount(x, minlength=size) for x in (vertices, edges, patch))
    euler = vertices - edges + quads
    for p, one in enumerate(model.patches):
        if euler[p] != one.euler:
            raise NotCaptured("topology", f"patch {p} has Euler characteristic {euler[p]}, not {one.euler}: "
                              "smaller elements are needed there", skin.centres[patch == p].mean(axis=0), patches=[p])

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Canonical polyhedra: convex, with plane faces; every edge touches the unit sphere, the mean of the touching points
is 0.

Every 3-connected planar graph has one (Koebe, Andreev, Thurston), unique up to turns and mirror images. The way here:
circles in the plane for points and faces, orthogonal where they meet, by the convex functional of Bobenko and
Springborn; up to the sphere by the inverse stereographic map; there, the hyperbolic motion that centres the touching
points. One edge's touching point lies at infinity in the plane: its two points and its two faces are straight
lines, the sides of a rectangle.

Points and motions are in Minkowski coordinates (t, x, y, z): a touching point is light-like, and a point
(x, y, z) / t outside the sphere stands for the circle that bounds what is seen from there.
"""
import numpy as np
from quad_figures import edge_lengths
from quadrangulations import random_quadrangulation
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import spsolve


def canonical_polyhedron(faces):
    """Points (V, 3) of the canonical polyhedron with these faces: sequences of points 0 .. V - 1, turned alike,
    counter-clockwise from outside.

    The graph must be simple, planar and 3-connected. Raises RuntimeError if the circles are not found.
    """
    graph = _Graph(faces)
    far = max(graph.left, key=lambda edge: graph.size[edge[0]] + graph.size[edge[1]])
    radii = _radii(graph, far)
    circles, touching = _centred(*_lifted(*_layout(graph, far, radii), radii))
    points = circles[:, 1:] / circles[:, :1]
    turned = _volume(points, graph.faces) < 0
    return points * [1, 1, -1] if turned else points


def random_polyhedron(rng, n, evenness=0.0, most_ratio=1e4):
    """(points (n + 2, 3), quads (n, 4)): random_quadrangulation(rng, n, evenness) as a canonical polyhedron; again
    while the longest edge is more than most_ratio times the shortest.

    Of 200 quads the ratio is mostly 1e3 to 1e5 (evenness 0), or 100 to 1000 (evenness 2); from 1e7 on, quads with the
    shortest edges are no longer plane and convex to within rounding.
    """
    for _ in range(200):
        quads = random_quadrangulation(rng, n, evenness)
        points = canonical_polyhedron(quads)
        lengths = edge_lengths(points, quads)
        if lengths.max() <= most_ratio * lengths.min():
            return points, quads
    raise RuntimeError("none of 200 is even enough; give a greater most_ratio or evenness")


class _Graph:
    """faces as lists; left {(a, b): face left of the edge}; after {(a, b): next point of that face};
    size list of the points' degrees."""

    def __init__(self, faces):
        self.faces = [[int(v) for v in face] for face in faces]
        self.left, self.after = {}, {}
        for number, face in enumerate(self.faces):
            for a, b, c in zip(face, face[1:] + face[:1], face[2:] + face[:2]):
                self.left[a, b], self.after[a, b] = number, c
        self.size = np.bincount([a for a, _ in self.left]).tolist()

    def around(self, point, first):
        """(neighbour, face between it and the next one), clockwise from `first`."""
        b = first
        while True:
            yield b, self.left[b, point]
            b = self.after[b, point]
            if b == first:
                return


def _volume(points, faces):
    """Six times the volume."""
    return sum(np.linalg.det(points[[face[0], face[k], face[k + 1]]])
               for face in faces for k in range(1, len(face) - 1))


# ------------------------------------------------------------------------------- circles in the plane

def _radii(graph, far):
    """(V + F,) radii of the points' and the faces' circles; infinite for the four that are lines.

    Every circle's kites fill the angle around it: sum of 2 atan(other radius / own) = 2 pi. Newton's method for the
    logarithms; the functional is convex, a step is halved while the slope at its end rises again by
    more than half of what it fell at the start.
    """
    points = len(graph.size)
    total = points + len(graph.faces)
    pairs = np.array([(a, points + f) for (a, _), f in graph.left.items()])
    lines = np.array([*far, points + graph.left[far], points + graph.left[far[::-1]]])
    straight = np.isin(pairs, lines)
    wanted = 2 * np.pi - np.pi * np.bincount(pairs[straight[:, ::-1]], minlength=total)
    number = np.full(total, -1)
    free = np.setdiff1d(np.arange(total), lines)
    number[free] = np.arange(len(free))
    logarithms = _minimise(number[pairs[~straight.any(axis=1)]], wanted[free])
    radii = np.full(total, np.inf)
    radii[free] = np.exp(logarithms)
    return radii


def _minimise(pairs, wanted):
    """(n,) logarithms of radii, mean 0; pairs (m, 2) are orthogonal, wanted (n,) the angles of each."""
    one, two = pairs.T
    rho = np.zeros(len(wanted))

    def slope(rho):
        angle = 2 * np.arctan(np.exp(rho[two] - rho[one]))
        return wanted - np.bincount(one, angle, len(rho)) - np.bincount(two, np.pi - angle, len(rho))

    now = slope(rho)
    for _ in range(200):
        weight = 1 / np.cosh(rho[two] - rho[one])
        entries = np.concatenate([weight, weight, -weight, -weight])
        rows, columns = np.concatenate([one, two, one, two]), np.concatenate([one, two, two, one])
        hessian = coo_matrix((entries, (rows, columns)), (len(rho),) * 2).tocsc()
        step = np.append(spsolve(hessian[:-1, :-1], -now[:-1]), 0.0)
        step *= 5.0 / max(5.0, np.abs(step).max())
        short = 1.0
        while slope(rho + short * step) @ step > 0.5 * abs(now @ step) + 1e-13 and short > 1e-6:
            short /= 2
        rho = rho + short * step
        rho -= rho.mean()
        now = slope(rho)
        if np.abs(now).max() < 1e-13 or np.abs(short * step).max() < 1e-14:
            break
    if not np.abs(now).max() < 1e-9:
        raise RuntimeError(f"no circle packing: angles are off by {np.abs(now).max():.2g}")
    return rho


def _layout(graph, far, radii):
    """Complex numbers in the plane: {point: centre}, {edge (low, high): touching point}, {far point: normal}.

    Circle by circle outward from the largest; the touching points around each by their angles.
    """
    points = len(graph.size)
    start = int(np.where(np.isfinite(radii[:points]), radii[:points], 0).argmax())
    center, heading = {start: 0j}, {start: (next(b for a, b in graph.left if a == start), 0.0)}
    queue, touch, normal = [start], {}, {}
    for a in queue:
        first, angle = heading[a]
        for b, face in graph.around(a, first):
            out = np.exp(1j * angle)
            touch[_key(a, b)] = center[a] + radii[a] * out
            if b in far:
                normal[b] = out
            elif b not in center:
                center[b] = center[a] + (radii[a] + radii[b]) * out
                heading[b] = a, angle + np.pi
                queue.append(b)
            angle -= np.pi if np.isinf(radii[points + face]) else 2 * np.arctan(radii[points + face] / radii[a])
    return center, touch, normal


def _lifted(center, touch, normal, radii):
    """circles (V, 4) and touching points (E, 4), in Minkowski coordinates; the plane's middle goes to the south pole,
    half of the touching points to the southern half."""
    flat = np.array(list(touch.values()))
    middle = complex(np.median(flat.real), np.median(flat.imag))
    scale = np.median(np.abs(flat - middle))
    circles = np.empty((len(center) + len(normal), 4))
    for v, place in center.items():
        circles[v] = _circle((place - middle) / scale, radii[v] / scale)
    for v, out in normal.items():
        foot = next(place for edge, place in touch.items() if v in edge)
        circles[v] = _line(out, (foot - middle) / scale)
    flat = (flat - middle) / scale
    square = np.abs(flat) ** 2
    touching = np.column_stack([square + 1, 2 * flat.real, 2 * flat.imag, square - 1])
    return circles, np.vstack([touching, [1, 0, 0, 1]])


def _key(a, b):
    return (a, b) if a < b else (b, a)


def _circle(center, radius):
    power = abs(center) ** 2 - radius ** 2
    return np.array([power + 1, 2 * center.real, 2 * center.imag, power - 1]) / (2 * radius)


def _line(normal, foot):
    """The line through `foot`, at right angles to `normal`, seen from the other side."""
    distance = (np.conj(normal) * foot).real
    return np.array([distance, normal.real, normal.imag, distance])


# -------------------------------------------------------------------------------------- on the sphere

def _centred(circles, touching):
    """Both under the hyperbolic motion that brings the mean of the touching points to 0: Newton's method for the
    point with the least sum of distances to the ideal points."""
    for _ in range(100):
        touching = touching / touching[:, :1]
        sphere = touching[:, 1:]
        total = sphere.sum(axis=0)
        step = np.linalg.solve(len(sphere) * np.eye(3) - sphere.T @ sphere, total)
        length = np.linalg.norm(step)
        if length < 1e-15:
            break
        motion = _boost(step / length, min(length, 1.0))
        circles, touching = circles @ motion, touching @ motion
    return circles, touching


def _boost(direction, rapidity):
    """(4, 4), symmetric: takes what lies at `rapidity` in this direction to the centre."""
    c, s = np.cosh(rapidity), np.sinh(rapidity)
    motion = np.eye(4)
    motion[0, 0] = c
    motion[0, 1:] = motion[1:, 0] = -s * direction
    motion[1:, 1:] += (c - 1) * np.outer(direction, direction)
    return motion

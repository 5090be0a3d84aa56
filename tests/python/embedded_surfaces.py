# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces that are known to cross and touch themselves nowhere, for a reason other than a test of
their quads against each other: each says which."""
import numpy as np
from cell_surfaces import sphere, zonohedron
from surfaces import annulus, box, diced_hull, o_grid, prism, random_cap, relaxed, upright


def sees_all(points, quads, center):
    """Proved up to rounding: every place of every patch is seen from the centre, so rays from there
    meet the surface once. det(P, Pu, Pv) of a bilinear patch has degree 1 in u and in v: its four
    corner values decide."""
    corners = points[quads] - center
    edges = np.roll(corners, -1, axis=1) - corners
    values = np.einsum("nij,nij->ni", corners, np.cross(edges, -np.roll(edges, 1, axis=1)))
    size = np.abs(corners).max() * (edges ** 2).sum(axis=2).max()
    return (values > 1e-9 * size).all()


def star(rng, n, roughness):
    """A sphere whose radii vary."""
    points, quads = sphere(n)
    waves = rng.normal(size=(4, 3)) * 2
    radius = 1 + roughness * (np.cos(points @ waves.T).mean(axis=1) + 0.3 * rng.uniform(-1, 1, len(points)))
    return points * radius[:, None], quads


def star_surfaces(count, seed=0):
    """The rays from a centre meet each once."""
    rng = np.random.default_rng(seed)
    while count:
        points, quads = star(rng, int(rng.integers(2, 7)), rng.uniform(0, 0.7))
        points = points @ (np.eye(3) + rng.uniform(-0.3, 0.3, (3, 3)))
        if sees_all(points, quads, np.zeros(3)):
            count -= 1
            yield points, quads


def thin_walls(count, seed=1):
    """Two like surfaces about a centre that sees both, one 1e-9 to 1e-2 farther out: a ray meets the
    inner one first."""
    rng = np.random.default_rng(seed)
    for points, quads in star_surfaces(count, seed):
        inner = points * (1 - 10.0 ** -rng.uniform(2, 9))
        yield np.vstack([points, inner]), np.vstack([quads, quads[:, ::-1] + len(points)])


def convex_surfaces(count, seed=2):
    """Faces of convex bodies, whole or diced in their planes, moved by rounding at most."""
    rng = np.random.default_rng(seed)
    for i in range(count):
        if i % 2:
            yield zonohedron(rng, int(rng.integers(3, 7)))
        else:
            yield diced_hull(rng.normal(size=(int(rng.integers(6, 20)), 3)))


def stacked_surfaces(count, seed=3):
    """Prisms over plane caps, sheared and twisted level by level: heights tell places apart between
    levels, and plane caps within one. Thin ones: 1e-9 of their width high."""
    rng = np.random.default_rng(seed)
    for i in range(count):
        cap = (o_grid(int(rng.integers(1, 4)), 2), annulus(int(rng.integers(5, 12)), 2),
               relaxed(random_cap(rng, 5)), box(1, 1, 1) and annulus(9, 1, 0.2))[i % 4]
        levels = np.arange(int(rng.integers(1, 5)) + 1.0)
        height, lean = 10.0 ** -rng.uniform(0, 9), rng.uniform(-0.5, 0.5, 2)
        yield prism(cap, levels, lambda t, xy: upright(t * height, xy + lean * t))


def anywhere(surface, rng):
    """Turned, scaled by 1e-6 to 1e9, and moved by up to a few of its sizes."""
    points, quads = surface
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    turn[:, 0] *= np.sign(np.linalg.det(turn))
    size = np.abs(points).max()
    return (points @ turn + rng.uniform(-2, 2, 3) * size) * 10.0 ** rng.uniform(-6, 9), quads

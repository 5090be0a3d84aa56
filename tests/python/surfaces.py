# SPDX-License-Identifier: LGPL-2.1-or-later
"""Test surfaces made by formula: caps, prisms over them, and surfaces that no sweep fills.

A cap is (points (P, 2), quads (n, 4)), counter-clockwise; a surface is (points (V, 3), quads).
"""
import numpy as np
from scipy.spatial import ConvexHull, Delaunay

# ------------------------------------------------------------------------------------------- caps


def used_only(points, quads):
    """Drop points that no quad uses."""
    ids, numbers = np.unique(quads, return_inverse=True)
    return points[ids], numbers.reshape(np.shape(quads))


def grid(nx, ny, keep=None):
    """nx * ny unit squares; `keep` (ny, nx) bool: those that exist."""
    y, x = np.mgrid[0:ny + 1, 0:nx + 1]
    points = np.column_stack([x.ravel(), y.ravel()]).astype(float)
    first = (np.arange(ny)[:, None] * (nx + 1) + np.arange(nx)).ravel()
    quads = first[:, None] + np.array([0, 1, nx + 2, nx + 1])
    return used_only(points, quads if keep is None else quads[np.asarray(keep, bool).ravel()])


def picture(*rows):
    """A cap drawn in characters: '#' is a square."""
    return grid(len(rows[0]), len(rows), [[c == "#" for c in row] for row in rows])


def annulus(sectors, width=1, inner=1.0, outer=2.0):
    angle = 2 * np.pi * np.arange(sectors) / sectors
    radii = np.linspace(inner, outer, width + 1)
    points = (radii[:, None, None] * np.column_stack([np.cos(angle), np.sin(angle)])).reshape(-1, 2)
    j, i = (a.ravel() for a in np.mgrid[0:width, 0:sectors])
    after = (i + 1) % sectors
    quads = np.column_stack([j * sectors + i, (j + 1) * sectors + i,
                             (j + 1) * sectors + after, j * sectors + after])
    return points, quads


def o_grid(n, layers):
    """A disc: n * n squares in the middle, `layers` rings of 4 n quads around them."""
    points, quads = grid(n, n)
    points = points - n / 2
    rim = [i for i in range(n)] + [(n + 1) * i + n for i in range(n)] \
        + [(n + 1) * n + n - i for i in range(n)] + [(n + 1) * (n - i) for i in range(n)]
    angle = -0.75 * np.pi + 2 * np.pi * np.arange(4 * n) / (4 * n)
    circle = np.column_stack([np.cos(angle), np.sin(angle)]) * n
    rings = [points[rim] + t * (circle - points[rim]) for t in np.arange(1, layers + 1) / layers]
    ids = np.vstack([rim, len(points) + np.arange(4 * n * layers).reshape(layers, 4 * n)])
    around = np.roll(ids, -1, axis=1)
    outer = np.stack([ids[:-1], ids[1:], around[1:], around[:-1]], axis=2).reshape(-1, 4)
    return np.vstack([points, *rings]), np.vstack([quads, outer])


def diced(points, triangles):
    """Three quads a triangle: its edges split, its centre joined to the middles."""
    points, triangles = np.asarray(points, float), np.asarray(triangles)
    ends = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2)
    pairs, middle = np.unique(np.sort(ends.reshape(-1, 2), axis=1), axis=0, return_inverse=True)
    middle = len(points) + middle.reshape(-1, 3)
    center = len(points) + len(pairs) + np.arange(len(triangles))
    quads = [np.column_stack([triangles[:, i], middle[:, i], center, middle[:, i - 1]])
             for i in range(3)]
    return (np.vstack([points, points[pairs].mean(axis=1), points[triangles].mean(axis=1)]),
            np.vstack(quads))


def random_cap(rng, size, holes=0):
    """A diced random triangulation of a convex polygon about `size` edges wide, with triangles
    taken out as holes that do not touch."""
    row, column = np.mgrid[-size:size + 1, -size:size + 1].reshape(2, -1)
    lattice = np.column_stack([column + row / 2, row * 0.75 ** 0.5])
    inside = lattice[np.linalg.norm(lattice, axis=1) < size / 2 - 0.6]
    inside = inside + rng.uniform(-0.2, 0.2, inside.shape)
    sides = int(3 * size)
    angle = 2 * np.pi * (np.arange(sides) + rng.uniform(-0.2, 0.2, sides)) / sides
    mesh = Delaunay(np.vstack([size / 2 * np.column_stack([np.cos(angle), np.sin(angle)]), inside]))
    blocked = set(_rim_points(mesh.simplices))
    kept = np.ones(len(mesh.simplices), bool)
    for t in rng.permutation(len(kept)):
        if holes and not blocked & set(mesh.simplices[t]):
            kept[t] = False
            holes -= 1
            near = np.isin(mesh.simplices, mesh.simplices[t]).any(axis=1)
            blocked |= set(mesh.simplices[near].ravel())
    assert holes == 0, "no room for so many holes"
    return used_only(*diced(mesh.points, mesh.simplices[kept]))


def _rim_points(cells):
    ends = np.stack([cells, np.roll(cells, -1, axis=1)], axis=2).reshape(-1, 2)
    pairs, count = np.unique(np.sort(ends, axis=1), axis=0, return_counts=True)
    return np.unique(pairs[count == 1])


def relaxed(cap, rounds=20):
    """Inner points moved to the mean of their neighbours: no sliver of a random cap remains."""
    points, quads = cap[0].copy(), cap[1]
    ends = np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2)
    free = np.setdiff1d(np.arange(len(points)), _rim_points(quads))
    ends = np.unique(np.vstack([ends, ends[:, ::-1]]), axis=0)
    degree = np.bincount(ends[:, 0], minlength=len(points))[:, None]
    for _ in range(rounds):
        total = np.zeros_like(points)
        np.add.at(total, ends[:, 0], points[ends[:, 1]])
        points[free] = (total / degree)[free]
    return points, quads


# ---------------------------------------------------------------------------------------- surfaces

def prism(cap, levels, place):
    """Sides of len(levels) - 1 rings between two caps. place(t, xy) -> xyz, t in levels."""
    flat, quads = cap
    size, rings = len(flat), len(levels) - 1
    points = np.vstack([place(t, flat) for t in levels])
    ends = np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2)
    known = {tuple(e) for e in ends.tolist()}
    rim = np.array([e for e in ends.tolist() if (e[1], e[0]) not in known])
    sides = [np.column_stack([rim + size * k, rim[:, ::-1] + size * (k + 1)])
             for k in range(rings)]
    return used_only(points, np.vstack([quads[:, ::-1], quads + size * rings, *sides]))


def box(nx, ny, nz):
    return prism(grid(nx, ny), np.arange(nz + 1.0), upright)


def upright(t, xy):
    return np.column_stack([xy, np.full(len(xy), t)])


def permuted(surface, rng):
    """The same surface under other numbers, quads starting anywhere."""
    points, quads = surface
    numbers = rng.permutation(len(points))
    moved = np.empty_like(points)
    moved[numbers] = points
    turn = (rng.integers(0, 4, len(quads))[:, None] + np.arange(4)) % 4
    return moved, numbers[np.take_along_axis(quads, turn, axis=1)][rng.permutation(len(quads))]


def canonical(surface):
    """The same surface under the numbers that the core gives it, as hexcon_native.mesh says: worked out anew."""
    points, quads = surface
    low = points.min(axis=0)
    side = (points - low).max()
    cells = ((points - low) / (side or 1.0) * (2 ** 21 - 1)).astype(np.int64).tolist()

    def place_on_curve(v):
        return sum(((cells[v][axis] >> bit) & 1) << (3 * bit + axis) for bit in range(21) for axis in range(3))
    order = sorted(range(len(points)), key=lambda v: (place_on_curve(v), *points[v]))
    ranks = np.empty(len(points), int)
    ranks[order] = np.arange(len(points))
    turned = [np.roll(quad, -int(np.argmin(quad))).tolist() for quad in ranks[quads]]
    return points[order], np.array(sorted(turned))


def turn_edge(surface, quad):
    """The first edge of a quad turned by one corner in the hexagon of its two quads: a closed
    surface with as many quads, and loops that run elsewhere."""
    points, quads = surface[0], surface[1].copy()
    a, b, c, d = quads[quad]
    starts = np.argwhere((quads == b) & (np.roll(quads, -1, axis=1) == a))
    other, side = starts[0]
    e, f = quads[other, (side + 2) % 4], quads[other, (side + 3) % 4]
    quads[quad], quads[other] = (c, d, a, e), (e, f, b, c)
    return points, quads


def diced_hull(points):
    """The convex hull's triangles, diced."""
    hull = ConvexHull(points)
    triangles = hull.simplices.copy()
    normal = np.cross(points[triangles[:, 1]] - points[triangles[:, 0]],
                      points[triangles[:, 2]] - points[triangles[:, 0]])
    inward = (normal * hull.equations[:, :3]).sum(axis=1) < 0
    triangles[inward] = triangles[inward][:, ::-1]
    return used_only(*diced(points, triangles))


def tetrahedron():
    return diced_hull(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]]))


def schneiders_pyramid():
    """All edges split, 4 quads on the base, 3 on each triangle."""
    points, quads = diced([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0], [0, 0, 1.4], [0, 0, 0]],
                          [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])
    middle = {tuple(p): i for i, p in enumerate(points.tolist())}
    base = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    for i, (x, y) in enumerate(base):
        before, after = base[i - 1], base[(i + 1) % 4]
        quad = [middle[(x, y, 0.0)], middle[((x + before[0]) / 2, (y + before[1]) / 2, 0.0)],
                5, middle[((x + after[0]) / 2, (y + after[1]) / 2, 0.0)]]
        quads = np.vstack([quads, quad])
    return points, quads

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces of natural hex meshes that are no sweeps: simple polytopes cut about their middles, and grids
with random sheets put in.

A polytope is (points (V, 3), faces: lists of ids, counter-clockwise seen from outside), three edges a corner.
"""
import itertools

import numpy as np
from mesh_checker import EDGES, FACES
from scipy.spatial import ConvexHull
from surfaces import used_only

import hexcon_native as hn

# --------------------------------------------------------------------------------------- polytopes


def polar(normals):
    """The polytope of the half-spaces normal . x <= 1; one face a row, in general position."""
    hull = ConvexHull(normals)
    points = hull.equations[:, :3] / -hull.equations[:, 3:]
    faces = []
    for v, normal in enumerate(normals):
        ids = np.flatnonzero((hull.simplices == v).any(axis=1))
        across = np.cross(normal, [1, 0, 0] if abs(normal[0]) < 0.5 * np.linalg.norm(normal) else [0, 1, 0])
        off = points[ids] - points[ids].mean(axis=0)
        angle = np.arctan2(off @ np.cross(normal, across) / np.linalg.norm(normal), off @ across)
        faces.append(ids[np.argsort(angle)].tolist())
    return points, faces


def random_polytope(rng, faces):
    """Tangent planes of a sphere at points that are spread out: no very short edges."""
    normals = rng.normal(size=(faces, 3))
    for _ in range(200):
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        off = normals[:, None] - normals
        square = (off ** 2).sum(axis=2) + np.eye(faces)
        normals = normals + 0.3 / faces * (off / square[:, :, None] ** 1.5).sum(axis=1) / np.sqrt(faces)
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    return polar(normals + 0.15 / np.sqrt(faces) * rng.normal(size=normals.shape))


def tetrahedron():
    return polar(np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1.0]]))


def wedge():
    angle = 2 * np.pi * np.arange(3) / 3
    sides = np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
    return polar(np.vstack([sides, [0, 0, 1], [0, 0, -1]]))


def chamfered_box():
    """A box with one edge and one corner, not of that edge, cut off."""
    sides = np.vstack([np.eye(3), -np.eye(3)])
    return polar(np.vstack([sides, [0.65, 0.65, 0], np.array([-1, -1, -1]) / 2.4]))


def dodecahedron():
    golden = (1 + 5 ** 0.5) / 2
    return polar(np.array([np.roll([0, a, b * golden], turn)
                           for turn in range(3) for a in (1, -1) for b in (1, -1)]))


def midpoint_subdivision(polytope, s=1):
    """Every face cut about its middle, s * s quads at each of its corners: the boundary of s^3 hexes a corner."""
    corners, faces = polytope
    points, quads = [], []
    t = np.arange(s + 1) / s
    for face in faces:
        middle = corners[face].mean(axis=0)
        for before, here, after in zip(face[-1:] + face[:-1], face, face[1:] + face[:1]):
            a, b, c, d = corners[here], (corners[here] + corners[after]) / 2, middle, \
                (corners[here] + corners[before]) / 2
            u, v = (g[:, :, None] for g in np.meshgrid(t, t, indexing="ij"))
            first = len(points)
            points.extend(((1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c + (1 - u) * v * d).reshape(-1, 3))
            quads.extend(first + (s + 1) * i + j + np.array([0, s + 1, s + 2, 1])
                         for i, j in itertools.product(range(s), repeat=2))
    points = np.array(points)
    _, number, names = np.unique(np.round(points, 9) + 0.0, axis=0, return_index=True, return_inverse=True)
    return points[number], names.reshape(-1)[np.array(quads)]


# ------------------------------------------------------------------------------------------ sheets

def boundary(points, hexes):
    """The surface of a hex mesh, quads outward."""
    return used_only(points, quads_of(hexes))


def grid_mesh(nx, ny, nz):
    z, y, x = np.mgrid[0:nz + 1, 0:ny + 1, 0:nx + 1]
    points = np.column_stack([x.ravel(), y.ravel(), z.ravel()]).astype(float)
    z, y, x = (a.ravel() for a in np.mgrid[0:nz, 0:ny, 0:nx])
    first = x + (nx + 1) * (y + (ny + 1) * z)
    square = np.array([0, 1, nx + 2, nx + 1])
    return points, first[:, None] + np.concatenate([square, square + (nx + 1) * (ny + 1)])


def insert_sheet(points, hexes, inside):
    """A layer of hexes between those `inside` (bool) and the others, whose points are drawn inward; None where
    that has no place to go."""
    sides = hexes[:, FACES].reshape(-1, 4)
    _, number = np.unique(np.sort(sides, axis=1), axis=0, return_inverse=True)
    number = number.reshape(-1)
    owner = np.repeat(inside, 6)
    count = np.bincount(number)
    mixed = (count == 2) & (np.bincount(number, owner) == 1)
    between = sides[owner & mixed[number]]              # outward from those inside
    moving = np.unique(between)
    copy = np.full(len(points), -1)
    copy[moving] = len(points) + np.arange(len(moving))
    outside = np.unique(sides[count[number] == 1])
    ends = hexes[inside][:, EDGES].reshape(-1, 2)
    ends = np.unique(np.vstack([ends, ends[:, ::-1]]), axis=0)
    ends = ends[(copy[ends[:, 0]] >= 0) & (copy[ends[:, 1]] < 0)]
    on_surface = np.isin(ends, outside)
    ends = ends[on_surface[:, 1] | ~on_surface[:, 0]]
    degree = np.bincount(ends[:, 0], minlength=len(points))[moving]
    if not len(moving) or (degree == 0).any():
        return None
    total = np.zeros_like(points)
    np.add.at(total, ends[:, 0], points[ends[:, 1]])
    drawn = (points[moving] + total[moving] / degree[:, None]) / 2
    moved = hexes.copy()
    moved[inside] = np.where(copy[hexes[inside]] >= 0, copy[hexes[inside]], hexes[inside])
    layer = np.hstack([copy[between], between])         # VTK: from the inner face to the outer one
    return np.vstack([points, drawn]), np.vstack([moved, layer])


def random_sheets(rng, count):
    """A hex mesh: a small grid with up to `count` sheets put in, each about the hexes near a random place."""
    points, hexes = grid_mesh(*rng.integers(2, 5, 3))
    for _ in range(10 * count):
        if not count:
            break
        center = points[hexes].mean(axis=1)
        at = center[rng.integers(len(center))] + rng.normal(size=3) * 0.3
        if rng.random() < 0.5:                          # on one side of a plane
            away = (center - at) @ rng.normal(size=3)
            inside = away < np.quantile(away, rng.uniform(0.2, 0.8))
        else:                                           # near a point
            inside = np.linalg.norm(center - at, axis=1) < rng.uniform(0.8, 2.2)
        made = insert_sheet(points, hexes, inside)
        if made is not None and is_ball(*made):
            points, hexes = made
            count -= 1
    return points, hexes


def is_ball(points, hexes):
    """A proper mesh whose surface is a sphere."""
    surface_points, quads = boundary(points, hexes)
    try:
        proved = hn.certify(points, hexes, quads_of(hexes))
    except hn.HexconError:
        return False
    return proved.conforming and proved.proper and len(surface_points) == len(quads) + 2


def quads_of(hexes):
    """Faces in one hex only, ids as in the mesh."""
    sides = hexes[:, FACES].reshape(-1, 4)
    _, number, count = np.unique(np.sort(sides, axis=1), axis=0, return_inverse=True, return_counts=True)
    return sides[count[number.reshape(-1)] == 1]

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hex meshes made by formula, for tests that must not depend on the mesher."""
from types import SimpleNamespace

import numpy as np


def block(nx, ny, nz, size=(1.0, 1.0, 1.0)):
    """Mesh of a box at the origin, order 1, with FreeCAD's face numbers of Part::Box:
    1 x=0, 2 x=max, 3 y=0, 4 y=max, 5 z=0, 6 z=max."""
    x, y, z = (np.linspace(0, length, n + 1) for length, n in zip(size, (nx, ny, nz)))
    k, j, i = np.meshgrid(z, y, x, indexing="ij")
    points = np.column_stack([i.ravel(), j.ravel(), k.ravel()])

    def node(a, b, c):
        return a + (nx + 1) * (b + (ny + 1) * c)
    c, b, a = (t.ravel() for t in np.meshgrid(
        np.arange(nz), np.arange(ny), np.arange(nx), indexing="ij"))
    hexes = np.column_stack([node(a + p, b + q, c + r) for p, q, r in (
        (0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
        (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))])
    mesh = SimpleNamespace(points=points, hexes=hexes, order=1, report={}, certificate=None)
    mesh.quads, mesh.face_of_quad = _sides(mesh, size)
    return mesh


def _sides(mesh, size):
    """Outward boundary quads, found by their plane."""
    corner_lists = [(0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4),
                    (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7)]
    quads, faces = [], []
    for number, corners in enumerate(corner_lists, 1):
        axis, high = divmod(number - 1, 2)
        sides = mesh.hexes[:, corners]
        flat = mesh.points[sides][:, :, axis]
        on = np.abs(flat - (size[axis] if high else 0.0)).max(axis=1) < 1e-9
        quads.append(sides[on])
        faces += [number] * int(on.sum())
    return np.vstack(quads), np.array(faces)


def distorted(mesh, amount, seed=1, keep=("x", "y", "z0")):
    """Points moved by up to amount (mm) in each direction; boundary points keep to the
    planes named: x and y both planes, z0 the lower one. The top moves as well."""
    rng = np.random.default_rng(seed)
    low, high = mesh.points.min(axis=0), mesh.points.max(axis=0)
    move = rng.uniform(-amount, amount, mesh.points.shape)
    for axis, name in enumerate("xyz"):
        at_low, at_high = mesh.points[:, axis] == low[axis], mesh.points[:, axis] == high[axis]
        if name in keep or name + "0" in keep:
            move[at_low, axis] = 0
        if name in keep:
            move[at_high, axis] = 0
    moved = SimpleNamespace(**vars(mesh))
    moved.points = mesh.points + move
    return moved


def cylinder(n, layers, radius, height):
    """Mesh of a cylinder about z: n x n quads in the disc. face_of_quad: 1 side, 2 bottom,
    3 top, as in Part::Cylinder of FreeCAD 0.20."""
    mesh = block(n, n, layers, (2.0, 2.0, height))
    p = mesh.points[:, :2] - 1
    s = np.abs(p).max(axis=1)
    r = np.linalg.norm(p, axis=1)
    to_circle = np.divide(s, r, out=np.ones_like(s), where=r > 0)
    mesh.points[:, :2] = radius * p * ((1 - s) * 0.75 + s * to_circle)[:, None]
    mesh.face_of_quad = np.array([0, 1, 1, 1, 1, 2, 3])[mesh.face_of_quad]
    return mesh

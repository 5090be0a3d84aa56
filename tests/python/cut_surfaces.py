# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces of bodies with holes through them, made by formula."""
import numpy as np
from sheet_surfaces import boundary


def torus(around, across, radius=3.0):
    """A ring of radius `radius` with a round section of radius 1: around * across quads."""
    u = 2 * np.pi * np.arange(around) / around
    return tube(np.column_stack([radius * np.cos(u), radius * np.sin(u), 0 * u]), across, 1.0)


def knot(around, across, p=2, q=3):
    """A torus knot, of genus 1 like a ring: p times round the axis, q times round the core."""
    t = 2 * np.pi * np.arange(around) / around
    width = 2 + np.cos(q * t)
    return tube(np.column_stack([width * np.cos(p * t), width * np.sin(p * t), 1.2 * np.sin(q * t)]), across, 0.33)


def tube(line, across, radius):
    """Round a closed line; its rows do not turn on the way."""
    ahead = np.roll(line, -1, axis=0) - np.roll(line, 1, axis=0)
    ahead /= np.linalg.norm(ahead, axis=1)[:, None]
    side = np.zeros_like(line)
    side[0] = np.cross(ahead[0], [0.0, 0.0, 1.0])
    for i in range(len(line)):
        step = side[i - 1] - ahead[i] * (side[i - 1] @ ahead[i]) if i else side[0]
        side[i] = step / np.linalg.norm(step)
    last = side[-1] - ahead[0] * (side[-1] @ ahead[0])
    turned = np.arctan2(last @ np.cross(ahead[0], side[0]), last @ side[0])
    angle = 2 * np.pi * (np.arange(across) + 0.5) / across - turned * np.arange(len(line))[:, None] / len(line)
    round_ = np.cos(angle)[..., None] * side[:, None] + np.sin(angle)[..., None] * np.cross(ahead, side)[:, None]
    i, j = (a.ravel() for a in np.mgrid[:len(line), :across])
    k, m = (i + 1) % len(line), (j + 1) % across
    quads = np.column_stack([i * across + j, i * across + m, k * across + m, k * across + j])
    return (line[:, None] + radius * round_).reshape(-1, 3), quads


def cells(filled):
    """Unit cubes where `filled` (nz, ny, nx) is: their surface, and how many there are."""
    filled = np.asarray(filled, bool)
    shape = np.array(filled.shape) + 1
    z, y, x = np.nonzero(filled)
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    hexes = np.stack([((z + k) * shape[1] + y + j) * shape[2] + x + i for i, j, k in corners], axis=1)
    grid = np.mgrid[:shape[0], :shape[1], :shape[2]][::-1]
    return boundary(grid.reshape(3, -1).T.astype(float), hexes), len(hexes)


def plate(holes, finer=1):
    """A plate two cells thick with a row of holes."""
    row = np.arange(2 * holes + 1) % 2 == 0
    flat = np.stack([np.ones_like(row), row, np.ones_like(row)])
    return cells(np.repeat(flat.repeat(finer, 0).repeat(finer, 1)[None], 2, axis=0))


def drilled_cube(finer=1):
    """A cube with three tunnels that meet in its middle: genus 5."""
    cube = np.ones((3, 3, 3), bool)
    cube[1, 1, :] = cube[1, :, 1] = cube[:, 1, 1] = False
    return cells(cube.repeat(finer, 0).repeat(finer, 1).repeat(finer, 2))


def random_lattice(rng, size=3):
    """Bars between the nodes of a grid, a random half of them beyond a spanning tree."""
    nodes = 2 * size - 1
    filled = np.zeros((nodes, nodes, nodes), bool)
    filled[::2, ::2, ::2] = True
    for axis in range(3):
        at = np.argwhere(np.ones([size - 1 if i == axis else size for i in range(3)], bool)) * 2
        at[:, axis] += 1
        along = at if axis == 0 else at[(at[:, :axis] == 0).all(axis=1) | (rng.random(len(at)) < 0.4)]
        filled[tuple(along.T)] = True
    return cells(filled)

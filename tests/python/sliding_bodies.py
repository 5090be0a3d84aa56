# SPDX-License-Identifier: LGPL-2.1-or-later
"""Grids of hexes in bent coordinates, and what each of their boundary points slides on."""
import numpy as np

import hexcon_native as hn

RIGHT = np.pi / 2


def grid(n):
    """(coordinates (P, 3) in 0 .. 1, hexes, sides (P, 3): 0 or 2 on the boundary, 1 inside)."""
    steps = np.arange(n + 1)
    whole = np.array(np.meshgrid(steps, steps, steps, indexing="ij")).reshape(3, -1).T
    low = whole[(whole < n).all(axis=1)]
    corners = low[:, None] + [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    return whole / n, corners @ [(n + 1) ** 2, n + 1, 1], 1 - (whole == 0) + (whole == n)


def cube(u):
    """The unit cube as it is."""
    return u.copy()


def cube_carrier(sides):
    middle, outer = sides / 2, sides != 1
    if outer.sum() == 3:
        return hn.Carrier("point", middle)
    return hn.Carrier("plane" if outer.sum() == 1 else "line", middle, outer if outer.sum() == 1 else ~outer)


def pipe(u):
    """A quarter of a pipe with radii 1 and 2."""
    return np.stack([(1 + u[:, 0]) * np.cos(RIGHT * u[:, 1]), (1 + u[:, 0]) * np.sin(RIGHT * u[:, 1]), u[:, 2]], axis=1)


def pipe_carrier(sides):
    outer, radius = sides != 1, 1 + sides[0] / 2
    start = np.array([(radius, 0, 0), (0, 0, 0), (0, radius, 0)][sides[1]]) + [0, 0, sides[2] / 2]
    out = (1, 0, 0) if sides[1] == 0 else (0, 1, 0)
    if outer.all():
        return hn.Carrier("point", start)
    if outer[0] and outer[1]:
        return hn.Carrier("line", start, (0, 0, 1))
    if outer[1]:
        return hn.Carrier("line", start, out) if outer[2] else hn.Carrier("plane", (0, 0, 0), out[1::-1] + (0,))
    if outer[0]:
        return hn.Carrier("circle" if outer[2] else "cylinder", (0, 0, sides[2] / 2), (0, 0, 1), sizes=(radius,))
    return hn.Carrier("plane", (0, 0, sides[2] / 2), (0, 0, 1))


def shell(u):
    """An eighth of a shell between spheres of radii 2 and 3, without its pole."""
    radius, angle, polar = 2 + u[:, 0], RIGHT * u[:, 1], 1.5 - u[:, 2]
    out = np.sin(polar)
    return radius[:, None] * np.stack([out * np.cos(angle), out * np.sin(angle), np.cos(polar)], axis=1)


def shell_carrier(sides):
    radius, polar = 2 + sides[0] / 2, 1.5 - sides[2] / 2
    outer, out = sides != 1, np.array([(1, 0), (0, 0), (0, 1)][sides[1]])
    slanted = np.append(out * np.sin(polar), np.cos(polar))
    if outer.all():
        return hn.Carrier("point", radius * slanted)
    if outer[0] and outer[1]:
        return hn.Carrier("circle", (0, 0, 0), (*out[::-1], 0), sizes=(radius,))
    if outer[0] and outer[2]:
        return hn.Carrier("circle", (0, 0, radius * np.cos(polar)), (0, 0, 1), sizes=(radius * np.sin(polar),))
    if outer[1] and outer[2]:
        return hn.Carrier("line", (0, 0, 0), slanted)
    if outer[0]:
        return hn.Carrier("sphere", (0, 0, 0), sizes=(radius,))
    if outer[1]:
        return hn.Carrier("plane", (0, 0, 0), (*out[::-1], 0))
    return hn.Carrier("cone", (0, 0, 0), (0, 0, 1), sizes=(polar,))


def bend(u):
    """A quarter of the wall of a pipe bent about the z axis by a quarter."""
    radius, tube, angle = 1 + u[:, 0], RIGHT * u[:, 1], RIGHT * (1 - u[:, 2])
    out = 4 + radius * np.cos(tube)
    return np.stack([out * np.cos(angle), out * np.sin(angle), radius * np.sin(tube)], axis=1)


def bend_carrier(sides):
    radius, outer = 1 + sides[0] / 2, sides != 1
    height, ring = (radius, 4) if sides[1] == 2 else (0, 4 + radius)
    way = np.array([(0, 1, 0), (0, 0, 0), (1, 0, 0)][sides[2]])
    if outer.all():
        return hn.Carrier("point", ring * way + [0, 0, height])
    if outer[0] and outer[1]:
        return hn.Carrier("circle", (0, 0, height), (0, 0, 1), sizes=(ring,))
    if outer[0] and outer[2]:
        return hn.Carrier("circle", 4 * way, way[[1, 0, 2]], sizes=(radius,))
    if outer[1] and outer[2]:
        return hn.Carrier("line", 4 * way, way if sides[1] == 0 else (0, 0, 1))
    if outer[0]:
        return hn.Carrier("torus", (0, 0, 0), (0, 0, 1), sizes=(4, radius))
    if outer[2]:
        return hn.Carrier("plane", (0, 0, 0), way[[1, 0, 2]])
    return hn.Carrier("cylinder", (0, 0, 0), (0, 0, 1), sizes=(4,)) if sides[1] == 2 else hn.Carrier("plane")


BODIES = {"cube": (cube, cube_carrier), "pipe": (pipe, pipe_carrier), "shell": (shell, shell_carrier),
          "bend": (bend, bend_carrier)}


def body(name, n):
    """(points, hexes, carrier_of_point, carriers) of n^3 hexes."""
    place, carrier = BODIES[name]
    u, hexes, sides = grid(n)
    carriers, numbers = [], {(1, 1, 1): -1}
    for side in map(tuple, np.unique(sides, axis=0)):
        if side not in numbers:
            numbers[side] = len(carriers)
            carriers.append(carrier(np.array(side)))
    return place(u), hexes, np.array([numbers[side] for side in map(tuple, sides)]), carriers

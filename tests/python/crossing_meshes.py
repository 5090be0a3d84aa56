# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hex meshes that cover space twice somewhere, and their near relatives that do not.

A mesh is (points (P, 3), hexes (H, 8)) in VTK order; every hex is of positive volume by construction
unless a family says otherwise, so only its boundary can tell that it overlaps.
"""
import numpy as np

from hexcon.femmesh.boundary import boundary_quads
from hexcon.femmesh.hexahedron import FACES


def block(nx, ny, nz):
    """Unit cubes; points at x + (nx + 1) (y + (ny + 1) z)."""
    z, y, x = (axis.ravel() for axis in np.mgrid[0:nz + 1, 0:ny + 1, 0:nx + 1])
    points = np.column_stack([x, y, z]).astype(float)
    z, y, x = (axis.ravel() for axis in np.mgrid[0:nz, 0:ny, 0:nx])
    row, sheet = nx + 1, (nx + 1) * (ny + 1)
    first = x + row * y + sheet * z
    corners = np.array([0, 1, row + 1, row, sheet, sheet + 1, sheet + row + 1, sheet + row])
    return points, first[:, None] + corners


def merged(points, hexes, same):
    """With point i drawn together with point same[i] <= i."""
    used, numbers = np.unique(np.asarray(same)[hexes], return_inverse=True)
    return points[used], numbers.reshape(-1, 8)


def bent(turn, steps, radius=3.0, rise=0.0, cells=2):
    """A bar of square section (side 2) bent round z by `turn` radians, rising by `rise` a turn."""
    points, hexes = block(cells, steps, cells)
    angle = points[:, 1] / steps * turn
    far = radius + 2 * points[:, 0] / cells - 1
    height = 2 * points[:, 2] / cells - 1 + rise * angle / (2 * np.pi)
    return np.column_stack([far * np.cos(angle), far * np.sin(angle), height]), hexes


def wound_ring(turns, steps, wobble=0.0, cells=2):
    """A closed ring that goes `turns` times round z before it closes, its section moved out and in
    by `wobble` once on its whole way."""
    points, hexes = block(cells, steps, cells)
    same = np.arange(len(points))
    last = points[:, 1] == steps
    same[last] = np.flatnonzero(points[:, 1] == 0)
    angle = points[:, 1] / steps * 2 * np.pi
    far = 3 + 2 * points[:, 0] / cells - 1 + wobble * np.cos(angle)
    height = 2 * points[:, 2] / cells - 1 + wobble * np.sin(angle)
    around = angle * turns
    return merged(np.column_stack([far * np.cos(around), far * np.sin(around), height]), hexes, same)


def branched_ring(turns, steps, inner=0.0):
    """Hexes round an edge (inner 0) or a hole, `turns` times 360 degrees before the first meets the
    last: round the edge the mesh is branched."""
    points, hexes = block(2, steps, 1)
    angle, far = points[:, 1] / steps * turns * 2 * np.pi, inner + points[:, 0]
    places = np.column_stack([far * np.cos(angle), far * np.sin(angle), points[:, 2]])
    same = np.arange(len(points))
    last = points[:, 1] == steps
    same[last] = np.flatnonzero(points[:, 1] == 0)
    if inner == 0:
        places, hexes = _around_edge(places, points, hexes, same, steps, turns)
        return places, hexes
    return merged(places, hexes, same)


def _around_edge(places, points, hexes, same, steps, turns):
    """The innermost ring as hexes of four corners each round: two sectors a hex."""
    assert steps % 2 == 0
    keep = hexes[points[hexes[:, 0], 0] >= 1]
    axis = [np.flatnonzero((points[:, 0] == 0) & (points[:, 1] == 0) & (points[:, 2] == z))[0] for z in (0, 1)]
    at = {tuple(p): i for i, p in enumerate(points.astype(int).tolist())}
    inner = [[axis[z] if corner is None else at[(1, corner, z)] for z in (0, 1) for corner in (None, k, k + 1, k + 2)]
             for k in range(0, steps, 2)]
    for z, centre in enumerate(axis):
        places[centre] = (0, 0, z)
    return merged(places, np.vstack([keep, inner]), same)


def arms(gap, cells=3):
    """A C of unit cubes whose arms end `gap` apart: below zero they overlap, at zero they touch."""
    points, hexes = block(5, cells, 5)
    centre = points[hexes].mean(axis=1)
    kept = (centre[:, 0] < 1) | (centre[:, 2] < 1) | (centre[:, 2] > 4) | \
        ((centre[:, 0] > 4) & (centre[:, 2] < 2)) | ((centre[:, 0] > 4) & (centre[:, 2] > 3))
    points, hexes = merged(points, hexes[kept], np.arange(len(points)))
    tip = points[:, 0] > 3.5
    upper, lower = tip & (points[:, 2] == 3), tip & (points[:, 2] == 2)
    points[upper, 2], points[lower, 2] = 2.5 + gap / 2, 2.5 - gap / 2
    return points, hexes


def two(first, second):
    """Side by side in one file, nothing shared."""
    return (np.vstack([first[0], second[0]]), np.vstack([first[1], second[1] + len(first[0])]))


def moved(mesh, by):
    return mesh[0] + np.asarray(by, float), mesh[1]


def overlapping():
    """(name, mesh): each covers some place twice, or touches itself."""
    unit = block(2, 2, 2)
    yield "bar bent by 450 degrees", bent(np.radians(450), 40)
    yield "bar bent by 361 degrees", bent(np.radians(361), 72)
    yield "bar bent by 720 degrees", bent(np.radians(720), 64)
    yield "spring lower than its wire", bent(np.radians(540), 48, rise=1.3)
    yield "spring as high as its wire", bent(np.radians(540), 48, rise=2.0)
    yield "spring a hair lower", bent(np.radians(540), 48, rise=2.0 - 1e-9)
    yield "thick spring", bent(np.radians(400), 40, radius=1.5, rise=0.4)
    for turns in (2, 3):
        yield f"ring wound {turns} times", wound_ring(turns, 20 * turns)
        yield f"ring wound {turns} times, wobbling", wound_ring(turns, 20 * turns, 0.3)
        yield f"edge wound {turns} times", branched_ring(turns, 8 * turns)
        yield f"hole wound {turns} times", branched_ring(turns, 12 * turns, inner=1.0)
    yield "hole wound twice, odd sectors", branched_ring(2, 23, inner=0.5)
    for gap in (0.0, -1e-12, -1e-6, -0.1, -0.6):
        yield f"arms {gap} apart", arms(gap)
    yield "coincident blocks", two(unit, unit)
    yield "coincident hexes", two(block(1, 1, 1), block(1, 1, 1))
    yield "blocks with a common face", two(unit, moved(unit, (2, 0, 0)))
    yield "blocks with half a common face", two(unit, moved(unit, (2, 0.5, 0.25)))
    yield "blocks with a common edge", two(unit, moved(unit, (2, 2, 0)))
    yield "blocks with part of an edge", two(unit, moved(unit, (2, 2, 0.5)))
    yield "blocks with a common corner", two(unit, moved(unit, (2, 2, 2)))
    yield "corner on a face", two(unit, _on_corner((1.3, 0.7, 2.0)))
    yield "corner on an edge", two(unit, _on_corner((1.3, 2.0, 2.0)))
    yield "corner in a face by 1e-12", two(unit, _on_corner((1.3, 0.7, 2.0 - 1e-12)))
    yield "block in a block", two(block(3, 3, 3), moved(block(1, 1, 1), (1.25, 1.25, 1.25)))
    yield "block crossing a block", two(block(3, 3, 3), moved(unit, (2.3, 2.4, 2.6)))
    yield "bar through a block", two(block(3, 3, 3), moved(block(1, 1, 9), (1.2, 1.3, -3.1)))
    yield "cross of two bars", two(moved(block(9, 1, 1), (-4, 0.1, 0.2)), moved(block(1, 1, 9), (0, 0, -4)))
    yield "two rings linked too tightly", two(wound_ring(1, 24), _upright(wound_ring(1, 24), 3.9))
    yield "block in a hollow too small", two(_hollow(), moved(unit, (1.6, 1.5, 1.5)))
    yield "block that fills a hollow", two(_hollow(), moved(unit, (1.0, 1.0, 1.0)))
    yield "bent sheets crossing", two(_sheet(0.0), _sheet(0.0, swap=True))
    yield "bent sheets touching", two(_sheet(0.0), _sheet(0.5))


def apart():
    """(name, mesh): relatives that cover every place once."""
    unit = block(2, 2, 2)
    yield "bar bent by 350 degrees", bent(np.radians(350), 40)
    yield "spring higher than its wire", bent(np.radians(540), 48, rise=2.05)
    yield "spring a hair higher", bent(np.radians(540), 48, rise=2.0 + 1e-9)
    yield "ring", wound_ring(1, 24)
    yield "wobbling ring", wound_ring(1, 24, 0.3)
    yield "edge", branched_ring(1, 8)
    yield "hole", branched_ring(1, 12, inner=0.5)
    for gap in (1e-12, 1e-9, 1e-3, 0.4):
        yield f"arms {gap} apart", arms(gap)
    yield "blocks a hair apart", two(unit, moved(unit, (2 + 1e-12, 0, 0)))
    yield "corner a hair over a face", two(unit, _on_corner((1.3, 0.7, 2.0 + 1e-12)))
    yield "linked rings", two(wound_ring(1, 24), _upright(wound_ring(1, 24), 3.0))
    yield "block in a hollow", two(_hollow(), (unit[0] * 0.4 + 1.6, unit[1]))
    yield "block that nearly fills a hollow", two(_hollow(), ((unit[0] - 1) * (1 - 1e-10) + 2, unit[1]))
    yield "bent sheets", two(_sheet(0.0), _sheet(0.5 + 1e-9))


def _on_corner(place):
    """A cube that stands on one corner there."""
    points, hexes = block(1, 1, 1)
    turn = np.linalg.qr(np.column_stack([(1, 1, 1), (1, -1, 0), (1, 1, -2)]))[0]
    turn *= np.sign(turn[:, 0].sum())
    if np.linalg.det(turn) < 0:
        turn[:, 2] *= -1
    upright = points @ turn[:, [1, 2, 0]]          # the diagonal goes up
    upright -= upright[np.argmin(upright[:, 2])]
    places = upright + place
    places[np.argmin(upright[:, 2])] = place
    return places, hexes


def _upright(mesh, by):
    """Turned so that its axis lies along x, and moved along y."""
    points, hexes = mesh
    return np.column_stack([points[:, 2], points[:, 1] + by, -points[:, 0]]), hexes


def _hollow():
    points, hexes = block(4, 4, 4)
    centre = points[hexes].mean(axis=1)
    return merged(points, hexes[(np.abs(centre - 2) > 1).any(axis=1)], np.arange(len(points)))


def _sheet(height, swap=False):
    """A saddle of one layer, 0.5 thick; its upper face has the form of its lower one."""
    points, hexes = block(4, 4, 1)
    x, y = (points[:, 0] - 2) / 2, (points[:, 1] - 2) / 2
    rise = x * y * (-1 if swap else 1)
    return np.column_stack([x, y, 0.5 * points[:, 2] + rise + height]), hexes


def surface_of(mesh):
    """(points in use, outward quads)"""
    points, hexes = mesh
    of_hex, side = boundary_quads(hexes, len(points))
    used, quads = np.unique(np.take_along_axis(hexes[of_hex], FACES[side], axis=1), return_inverse=True)
    return points[used], quads.reshape(-1, 4)


def boundary_of(mesh):
    """Outward quads with the ids of the mesh."""
    points, hexes = mesh
    of_hex, side = boundary_quads(hexes, len(points))
    return np.take_along_axis(hexes[of_hex], FACES[side], axis=1)

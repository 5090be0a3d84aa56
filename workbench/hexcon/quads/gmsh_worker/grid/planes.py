# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tensor grid: planes on faces across its axes and on squares in small round holes, even steps between them."""
import gmsh
import numpy as np

NEAR = 0.12             # of the size: planes closer than this are one, that with most area
SMALL = 1.6             # of the size: radius up to which a round face gets a square of cells of its own
SQUARE = 0.78           # of the radius: half the side of that square, which is nearly as large as the circle
ROOM = 0.3              # of the size or the radius: how far from other planes those of a small round face must be,
ROOM_MIDDLE = 0.45      # and of the size: the one through the middle of a larger one
_ALONG = 1e-5           # of the cosine: an axis that is along the grid's
_FULL_TURN = 0.97 * 2.0 * np.pi


def planes_of(features, frame, h):
    """Three ascending arrays of planes in the frame's coordinates, a cell of size h farther out than the solid.

    features: a Features; frame (3, 3) rows; h: wanted edge length
    """
    points = features.points @ frame.T
    hard, soft = _plane_faces(features.cad, frame), _round_faces(features.cad, frame, h)
    return [_planes(points[:, k].min(), points[:, k].max(), hard[k], soft[k], h) for k in range(3)]


def _planes(low, high, hard, soft, h):
    found = _merged(hard, NEAR * h)
    for end in (low, high):     # a curved end: a plane that touches it
        if not any(abs(end - m) < NEAR * h for m in found):
            found.append(end)
    found.sort()
    for value, room in soft:
        if found[0] < value < found[-1] and min(abs(value - m) for m in found) > room:
            found = sorted([*found, value])
    out = [found[0] - h, found[0]]
    for a, b in zip(found, found[1:]):
        out += np.linspace(a, b, max(1, int(round((b - a) / h))) + 1)[1:].tolist()
    return np.array([*out, out[-1] + h])


def _merged(weighted, near):
    """Offsets of [(offset, area)], those closer than near joined at the one with most area."""
    groups = []
    for value, area in sorted(weighted):
        if groups and value - groups[-1][-1][0] < near:
            groups[-1].append((value, area))
        else:
            groups.append([(value, area)])
    return [max(g, key=lambda one: one[1])[0] for g in groups]


def _along(axis, frame):
    """Which of the frame's axes an axis is along, or None."""
    a = np.abs(frame @ axis)
    k = int(a.argmax())
    return k if a[k] > 1.0 - _ALONG else None


def _plane_faces(cad, frame):
    """For each axis [(offset, area)] of plane faces across it."""
    found = [[], [], []]
    for face, carrier in cad.carriers.items():
        if carrier.kind == "Plane" and (k := _along(carrier.axis, frame)) is not None:
            found[k].append((float(frame[k] @ carrier.origin), cad.solid.area(face)))
    return found


def _round_faces(cad, frame, h):
    """For each axis [(offset, room it needs)]: squares in small round holes and bosses, the middles of large ones."""
    turns = {}
    for face, carrier in cad.carriers.items():
        if carrier.kind != "Cylinder" or (k := _along(carrier.axis, frame)) is None:
            continue
        centre = frame @ carrier.origin
        centre[k] = 0.0
        key = (k, *np.round(np.append(centre, carrier.radius) / (1e-6 * cad.solid.diagonal)).astype(int).tolist())
        turn, _, _ = turns.get(key, (0.0, None, 0.0))
        turns[key] = (turn + _turn(face), centre, carrier.radius)
    found = [[], [], []]
    for (k, *_), (turn, centre, r) in sorted(turns.items()):
        if turn < _FULL_TURN:
            continue
        for j in {0, 1, 2} - {k}:
            if r < SMALL * h:
                found[j] += [(centre[j] + side * SQUARE * r, ROOM * min(h, r)) for side in (-1, 1)]
            else:
                found[j].append((centre[j], ROOM_MIDDLE * h))
    return [sorted(one) for one in found]


def _turn(face):
    low, high = gmsh.model.getParametrizationBounds(2, face)
    return high[0] - low[0]

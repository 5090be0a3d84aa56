# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small picture for each surface method: a body as it leaves it, drawn by QPainter from a few formulas.

Bodies are lists of quads or triangles in space, seen from a corner, the far ones first.
"""
import numpy as np
from PySide import QtCore, QtGui

WIDTH, HEIGHT = 44, 34
SCALE = 3       # drawn larger, then made smaller: thin lines stay even
VIEW = np.array([[0.72, -0.69, 0.0], [0.33, 0.34, 0.88]])   # to the right and up; the eye looks along its cross
EYE = np.cross(VIEW[0], VIEW[1])
LIGHT = np.array([-0.25, -0.5, 0.83])
FILL, LINE = (242, 193, 78), (29, 43, 58)


def _grid(place, m, n):
    """Quads (m*n, 4, 3) of a patch place(u, v), u and v from 0 to 1."""
    u, v = np.linspace(0, 1, m + 1), np.linspace(0, 1, n + 1)
    at = np.array([[place(a, b) for b in v] for a in u], float)
    return np.stack([at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]], axis=2).reshape(-1, 4, 3)


def _box(low, high, counts):
    """The six sides of a box in quads."""
    low, size = np.array(low, float), np.subtract(high, low)
    sides = []
    for axis in range(3):
        first, second = (axis + 1) % 3, (axis + 2) % 3
        for end in (0.0, 1.0):
            def place(u, v, axis=axis, first=first, second=second, end=end):
                at = np.zeros(3)
                at[axis], at[first], at[second] = end, *((u, v) if end else (v, u))
                return low + size * at
            pair = (counts[first], counts[second]) if end else (counts[second], counts[first])
            sides.append(_grid(place, *pair))
    return np.concatenate(sides)


def _turned(profile, around, rows=None):
    """A profile [(radius, height), ...] turned round z."""
    profile = np.array(profile, float)

    def place(u, v):
        at = v * (len(profile) - 1)
        k = min(int(at), len(profile) - 2)
        radius, height = profile[k] + (at - k) * (profile[k + 1] - profile[k])
        return radius * np.cos(2 * np.pi * u), radius * np.sin(2 * np.pi * u), height
    return _grid(place, around, rows or len(profile) - 1)


def _sweep():
    """A bent bar: a cap of quads carried along an arc."""
    def place(u, v, radius):
        angle = np.pi / 2 * (1.75 + v)
        return radius * np.cos(angle), radius * np.sin(angle), 0.8 * u
    outer = _grid(lambda u, v: place(1 - u, v, 2.0), 2, 6)
    top = _grid(lambda u, v: place(1.0, v, 1.2 + 0.8 * u), 2, 6)
    cap = _grid(lambda u, v: place(u, 0.0, 2.0 - 0.8 * v), 2, 2)
    return np.concatenate([outer, top, cap])


def _disc(radius, height, around=8):
    """An o-grid: a square of quads in a ring."""
    def square(u, v):
        return 0.45 * radius * (2 * u - 1), 0.45 * radius * (2 * v - 1), height
    half = around // 4

    def ring(u, v):
        side, part = int(min(u * 4, 3.999)), u * 4 - int(min(u * 4, 3.999))
        corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)]) * 0.45 * radius
        inner = corners[side] + part * (corners[side + 1] - corners[side])
        angle = np.pi / 2 * (side + part) - 3 * np.pi / 4
        at = inner + v * (radius * np.array([np.cos(angle), np.sin(angle)]) - inner)
        return at[0], at[1], height
    return np.concatenate([_grid(square, half, half), _grid(lambda u, v: ring(1 - u, v), around, 1)])


def _blocks():
    return np.concatenate([_turned([(1, 0), (1, 0.7), (1, 1.4)], 12), _disc(1, 1.4, 12)])


def _revolved():
    return np.concatenate([_turned([(1.25, 0), (1.25, 0.5), (0.6, 0.5), (0.6, 1.0), (0.6, 1.5)], 12), _disc(0.6, 1.5)])


def _plate():
    return _box((0, 0, 0), (2.4, 1.8, 0.5), (4, 3, 1))


def _layered():
    boss = _turned([(0.5, 0.5), (0.5, 0.9), (0.5, 1.3)], 10) + [1.2, 0.9, 0]
    return np.concatenate([_plate(), boss, _disc(0.5, 1.3) + [1.2, 0.9, 0]])


def _boxed():
    """A block with a round boss across its layers."""
    block = _box((0, 0, 0), (2.0, 1.4, 1.5), (4, 3, 3))
    boss = np.concatenate([_turned([(0.5, 0), (0.5, 0.4), (0.5, 0.8)], 12), _disc(0.5, 0.8)])
    return np.concatenate([block, boss[:, ::-1, [2, 0, 1]] * [-1, 1, 1] + [0, 0.7, 0.75]])


def _filled():
    """Two pipes that meet."""
    standing = np.concatenate([_turned([(0.6, 0), (0.6, 0.6), (0.6, 1.2), (0.6, 1.8)], 12), _disc(0.6, 1.8)])
    lying = np.concatenate([_turned([(0.5, 0), (0.5, 0.5), (0.5, 1.0), (0.5, 1.5)], 12), _disc(0.5, 1.5)])
    return np.concatenate([standing, lying[:, ::-1, [2, 0, 1]] * [-1, 1, 1] + [-0.3, 0, 0.9]])


def _rough():
    """What a grid takes up: even quads, bent on to the body."""
    def place(u, v):
        x, y = 2 * u - 1, 2 * v - 1
        return 1.1 * x * np.sqrt(1 - y * y / 2), 1.1 * y * np.sqrt(1 - x * x / 2), 0.0
    top = _grid(place, 5, 5)
    top[..., 2] = 0.55 + 0.5 * np.exp(-(top[..., 0] ** 2 + top[..., 1] ** 2))
    ring = np.array([place(u, v)[:2] for u, v in [(k / 5, 0) for k in range(5)] + [(1, k / 5) for k in range(5)]
                     + [(1 - k / 5, 1) for k in range(5)] + [(0, 1 - k / 5) for k in range(5)]])
    heights = 0.55 + 0.5 * np.exp(-(ring ** 2).sum(axis=1))
    walls = []
    for k in range(20):
        a, b = ring[k], ring[(k + 1) % 20]
        for low, high in ((-0.4, 0.15), (0.15, 1.0)):
            ends = [low, low, heights[(k + 1) % 20] if high == 1.0 else high, heights[k] if high == 1.0 else high]
            walls.append([(*p, z) for p, z in zip((a, b, b, a), ends)])
    return np.concatenate([top, np.array(walls)])


def _subdivided_triangles():
    """A cube of triangles, each cut into three quads."""
    found = []
    for quad in _box((0, 0, 0), (1.5, 1.5, 1.5), (2, 2, 2)):
        for corners in (quad[[0, 1, 2]], quad[[0, 2, 3]]):
            middle, middles = corners.mean(axis=0), (corners + np.roll(corners, -1, axis=0)) / 2
            found += [[corners[k], middles[k], middle, middles[k - 1]] for k in range(3)]
    return np.array(found)


def _subdivided():
    """Quads and triangles, each cut about its middle."""
    quads = _box((0, 0, 0), (1.5, 1.5, 1.5), (4, 4, 2))
    return quads + 0.05 * np.sin(9 * quads[..., [1, 2, 0]]) * (quads % 1.5 > 0)


def _blossom():
    quads = _box((0, 0, 0), (1.5, 1.5, 1.5), (3, 3, 3))
    return quads + 0.14 * np.sin(7 * quads[..., [2, 0, 1]] + 1) * (quads % 1.5 > 0)


def _transfinite():
    def bent(quads):
        moved = quads.copy()
        moved[..., 2] += 0.25 * np.sin(1.6 * quads[..., 0])
        return moved
    return bent(_box((0, 0, 0), (2.2, 1.4, 0.9), (5, 3, 2)))


def _auto():
    return np.concatenate([_box((0, 0, 0), (2.2, 1.6, 0.4), (4, 3, 1)),
                           _box((0, 0, 0.4), (0.5, 1.6, 1.5), (1, 3, 2))])


# by the names of hexcon.quads.METHOD_TABLE
BODIES = {"auto": _auto, "sweep": _sweep, "blocks": _blocks, "revolved": _revolved, "layered": _layered,
          "boxed": _boxed, "filled": _filled, "grid": _rough, "subdivided": _subdivided,
          "subdivided-triangles": _subdivided_triangles, "blossom": _blossom, "transfinite": _transfinite}


def picture(name):
    """A QPixmap of the method's body; None for a method that has none."""
    return _drawn(BODIES[name]()) if name in BODIES else None


def _drawn(polygons):
    normals = np.cross(polygons[:, 2] - polygons[:, 0], polygons[:, 3] - polygons[:, 1])
    normals /= np.linalg.norm(normals, axis=1)[:, None] + 1e-30
    seen = normals @ EYE > 1e-6
    polygons, normals = polygons[seen], normals[seen]
    flat = polygons @ VIEW.T
    low, high = flat.min(axis=(0, 1)), flat.max(axis=(0, 1))
    scale = SCALE * min((WIDTH - 4) / (high - low)[0], (HEIGHT - 4) / (high - low)[1])
    places = (flat - (low + high) / 2) * scale * [1, -1] + [SCALE * WIDTH / 2, SCALE * HEIGHT / 2]
    image = QtGui.QImage(SCALE * WIDTH, SCALE * HEIGHT, QtGui.QImage.Format_ARGB32_Premultiplied)
    image.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(image)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.setPen(QtGui.QPen(QtGui.QColor(*LINE), 0.9 * SCALE))
    depth = polygons.mean(axis=1) @ EYE
    for k in np.argsort(depth):
        light = 0.55 + 0.45 * max(0.0, float(normals[k] @ LIGHT))
        painter.setBrush(QtGui.QColor(*(round(part * light) for part in FILL)))
        painter.drawPolygon(QtGui.QPolygonF([QtCore.QPointF(*at) for at in places[k].tolist()]))
    painter.end()
    return QtGui.QPixmap.fromImage(image.scaled(WIDTH, HEIGHT, QtCore.Qt.IgnoreAspectRatio,
                                                QtCore.Qt.SmoothTransformation))

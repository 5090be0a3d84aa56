# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small surfaces of the literature on hexes for a given quad surface, with their own flat sides.

A surface is (points (V, 3), quads (n, 4)), quads counter-clockwise seen from outside. Schneiders' pyramid, the
quadrilateral octahedron, and Eppstein's cubes: one quad outside (z = 0), two diced triangles inside (z = 1), and four
sides of 2, 3 or 4 quads that neighbouring cubes share by the colours of the outer corners.
"""
import itertools

import numpy as np
from surfaces import schneiders_pyramid

# A side lies between a black and a white upright; the black one has a middle M, its upper edge a middle E:
# the hexagon Ob, M, Ib, E, Iw, Ow. Its points by (way from black to white, height).
_HEXAGON = {"Ob": (0, 0), "M": (0, 0.5), "Ib": (0, 1), "E": (0.5, 1), "Iw": (1, 1), "Ow": (1, 0)}
_INNER = {"C": (0.5, 0.5), "X": (1 / 6, 0.6), "Y": (1 / 6, 0.45)}
# Fillings, clockwise where black is left. "2ob": split by the edge Ob E, and so on.
SIDES = {
    "2ob": (("Ob", "M", "Ib", "E"), ("Ob", "E", "Iw", "Ow")),
    "2m": (("M", "Ib", "E", "Iw"), ("Ob", "M", "Iw", "Ow")),
    "2ib": (("Ob", "M", "Ib", "Ow"), ("Ib", "E", "Iw", "Ow")),
    "3": (("Ob", "M", "C", "Ow"), ("M", "Ib", "E", "C"), ("C", "E", "Iw", "Ow")),
    "4": (("Ob", "M", "X", "Y"), ("M", "Ib", "E", "X"), ("X", "E", "Iw", "Y"), ("Ob", "Y", "Iw", "Ow")),
}
_CORNERS = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])    # 0 and 2 are black


def quadrilateral_octahedron():
    """The tetragonal trapezohedron: 8 plane kites about two poles, 10 points. No face doublet, no flat corner."""
    angle, low = np.pi / 4 * np.arange(8), 3 - 8 ** 0.5
    ring = np.column_stack([np.cos(angle), np.sin(angle), np.where(np.arange(8) % 2, -low, low)])
    upper = [[0, 2 + i, 3 + i, 2 + (i + 2) % 8] for i in range(0, 8, 2)]
    lower = [[1, 2 + (i + 2) % 8, 2 + (i + 1) % 8, 2 + i] for i in range(1, 8, 2)]
    return np.vstack([[0, 0, 1], [0, 0, -1], ring]), np.array(upper + lower)


def eppsteins_cube(sides, diagonal="white"):
    """Unit cube of 7 quads and those of `sides`: four keys of SIDES, for the sides 0-1, 1-2, 2-3, 3-0.

    diagonal  colour of the inner corners that both diced triangles have
    The number of quads is even if the sides have an odd number. Of sides with 3 and 4 quads only, there is no face
    doublet and no flat corner. Every side with two quads has flat corners, which no hex can fill: "2ob" at M,
    "2m" at E, "2ib" at both. Where both sides at a black upright have but one quad at M ("2ob" or "2ib"), those two
    quads are a face doublet.
    """
    places, quads = {}, [[("O", 0), ("O", 3), ("O", 2), ("O", 1)]]
    for k, (x, y) in enumerate(_CORNERS):
        places["O", k], places["I", k] = (x, y, 0), (x, y, 1)
    for k, kind in enumerate(sides):
        quads += _side(places, k, kind)
    quads += _inner_face(places, 1 if diagonal == "white" else 0)
    number = {label: i for i, label in enumerate(places)}
    return np.array(list(places.values()), float), np.array([[number[v] for v in quad] for quad in quads])


def _side(places, k, kind):
    """Quads, as labels, of the side from corner k to the next; their points go to `places`."""
    black, white = (k, (k + 1) % 4) if k % 2 == 0 else ((k + 1) % 4, k)
    label = {"Ob": ("O", black), "Ib": ("I", black), "Ow": ("O", white), "Iw": ("I", white), "M": ("M", black),
             "E": ("E", k), "C": ("C", k), "X": ("X", k), "Y": ("Y", k)}
    found = []
    for quad in SIDES[kind]:
        for name in quad:
            way, height = {**_HEXAGON, **_INNER}[name]
            place = _CORNERS[black] + way * (_CORNERS[white] - _CORNERS[black])
            places.setdefault(label[name], (*place, height))
        found.append([label[name] for name in (quad[::-1] if black == k else quad)])
    return found


def _inner_face(places, first):
    """Quads of the two triangles whose common edge joins the inner corners first and first + 2."""
    places["N", 0] = (0.5, 0.5, 1)
    found = []
    for k in (first + 1, first + 3):
        corner, after, before = k % 4, (k + 1) % 4, (k - 1) % 4
        center = ("G", corner)
        places[center] = (*_CORNERS[[corner, after, before]].mean(axis=0), 1)
        found += [[("I", corner), ("E", corner), center, ("E", before)],
                  [("I", after), ("N", 0), center, ("E", corner)],
                  [("I", before), ("E", before), center, ("N", 0)]]
    return found


def eppsteins_cubes():
    """Yields (name, points, quads): all even ones whose sides with 2 quads are split alike, once up to symmetry.

    52, with 16, 18, 20 or 22 quads. The names tell the sides: "cube_20_4333_white", "cube_16_2223_ob_black". Those
    with 20 quads and no 2, and those with 22, have neither face doublets nor flat corners; 16 quads without a face
    doublet need the split "2m".
    """
    for counts in itertools.product("234", repeat=4):
        if sum(map(int, counts)) % 2 == 0 or counts != max(_turned(counts)):
            continue
        for split, diagonal in itertools.product(("ob", "m", "ib"), ("white", "black")):
            if "2" not in counts and split != "ob":
                continue
            points, quads = eppsteins_cube([c + split if c == "2" else c for c in counts], diagonal)
            middle = f"{split}_" if "2" in counts else ""
            yield f"cube_{len(quads)}_{''.join(counts)}_{middle}{diagonal}", points, quads


def _turned(sides):
    """The sides under the four symmetries that keep the colours."""
    a, b, c, d = sides
    return (a, b, c, d), (c, d, a, b), (d, c, b, a), (b, a, d, c)


def paper_surfaces():
    """Yields (name, points, quads): all of this file, 8 to 22 quads."""
    yield "schneiders_pyramid", *schneiders_pyramid()
    yield "quadrilateral_octahedron", *quadrilateral_octahedron()
    yield from eppsteins_cubes()

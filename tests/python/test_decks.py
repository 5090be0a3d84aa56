# SPDX-License-Identifier: LGPL-2.1-or-later
"""Abaqus and CalculiX decks, as people have them: what is read, and what is refused by name and line."""
import numpy as np
import pytest
from deck_texts import BOX, GRID, HEXES, OUTER, SHELL, elements, nodes, with_middles
from quad_figures import volume_of

from hexcon.errors import FaultCode, HexconError
from hexcon.files import read_mesh
from hexcon.labels import Labels
from hexcon.quads import surface_from_file


def part(mesh, name="A", more=""):
    return f"*Part, name={name}\n{mesh}{more}*End Part\n"


def assembly(*instances, more=""):
    return "*Assembly, name=As\n" + "".join(instances) + more + "*End Assembly\n"


def instance(data="", name="A-1", of="A"):
    return f"*Instance, name={name}, part={of}\n{data}*End Instance\n"


def crlf(text):
    return text.replace("\n", "\r\n")


CYLINDER = np.array([(r, a, z) for z in (0, 15, 30) for a in (0, 30, 60) for r in (5, 10, 15)], float)
ROUND = np.column_stack([CYLINDER[:, 0] * np.cos(np.radians(CYLINDER[:, 1])),
                         CYLINDER[:, 0] * np.sin(np.radians(CYLINDER[:, 1])), CYLINDER[:, 2]])
_SPHERICAL = np.column_stack([np.linalg.norm(GRID, axis=1), np.degrees(np.arctan2(GRID[:, 1], GRID[:, 0])),
                              np.degrees(np.arctan2(GRID[:, 2], np.hypot(GRID[:, 0], GRID[:, 1])))])
_PLANE = nodes(GRID[:9]) + "*NSET, NSET=LOW, GENERATE\n1, 9, 1\n"
_TWO_ENDS = nodes(GRID[[0, 2, 6, 8, 18, 20, 24, 26]], form="{}, {:g}, {:g}, {:g}")
_NGEN = "*NODE\n1,0,0,0\n3,10,0,0\n7,0,20,0\n9,10,20,0\n19,0,0,30\n21,10,0,30\n25,0,20,30\n27,10,20,30\n" \
        "*NGEN\n1,3,1\n7,9,1\n19,21,1\n25,27,1\n*NGEN\n1,7,3\n2,8,3\n3,9,3\n19,25,3\n20,26,3\n21,27,3\n" \
        "*NGEN\n" + "".join(f"{k},{k + 18},9\n" for k in range(1, 10))
_GAP = part(nodes(first=101) + elements(shift=101))

# name: (deck, hexes, volume, lowest corner)
DECKS = {
    "plain": (BOX, 8, 6000, (0, 0, 0)),
    "two node blocks": (nodes(GRID[:10]) + nodes(GRID[10:], 11) + elements(), 8, 6000, (0, 0, 0)),
    "element blocks of two types": (nodes() + elements(HEXES[:4], "C3D8R") + elements(HEXES[4:], "c3d8i", 5), 8, 6000,
                                    (0, 0, 0)),
    "lower case, tabs": (BOX.lower().replace(", ", ",\t"), 8, 6000, (0, 0, 0)),
    "CRLF": (crlf(BOX), 8, 6000, (0, 0, 0)),
    "blanks around all": (BOX.replace(",", " , ").replace("*ELEMENT", "*ELEMENT ").replace("TYPE=", "TYPE = "), 8,
                          6000, (0, 0, 0)),
    "BOM": ("\ufeff" + BOX, 8, 6000, (0, 0, 0)),
    "trailing commas": (BOX.replace("\n", ",\n").replace("*NODE,", "*NODE"), 8, 6000, (0, 0, 0)),
    "D exponents": (nodes(form="{}, {:.6E}, {:.6E}, {:.6E}").replace("E+", "D+") + elements(), 8, 6000, (0, 0, 0)),
    "zeros left out": (BOX.replace(", 0\n", ",\n").replace(", 0, 0,\n", ",\n"), 8, 6000, (0, 0, 0)),
    "comments anywhere": (BOX.replace("\n", "\n** a comment, with = and ,\n"), 8, 6000, (0, 0, 0)),
    "card over two lines": (nodes() + elements(head="*ELEMENT,\n** between\n TYPE={},\n ELSET=E"), 8, 6000, (0, 0, 0)),
    "last card with a comma": (BOX + "*NSET, NSET=A,", 8, 6000, (0, 0, 0)),
    "wrapped elements": (BOX.replace("10, 11, 14, 13\n", "\n10, 11, 14, 13\n", 1), 8, 6000, (0, 0, 0)),
    "SC8R": (nodes() + elements(kind="SC8R"), 8, 6000, (0, 0, 0)),
    "DC3D8": (nodes() + elements(kind="DC3D8"), 8, 6000, (0, 0, 0)),
    "beside lines and points": (BOX + "*ELEMENT, TYPE=T3D2\n90, 1, 2\n*ELEMENT, TYPE=MASS, ELSET=M\n91, 1\n", 8, 6000,
                                (0, 0, 0)),
    "steps after it": (BOX + "*MATERIAL, NAME=M\n*ELASTIC\n210000, 0.3\n*STEP\n*STATIC\n*CLOAD\n1, 1, 2.\n*END "
                             "STEP\n", 8, 6000,
                       (0, 0, 0)),
    "a part, no instance": (part(BOX), 8, 6000, (0, 0, 0)),
    "an instance": (part(BOX) + assembly(instance()), 8, 6000, (0, 0, 0)),
    "an instance moved": (part(BOX) + assembly(instance("100., 0., 0.\n")), 8, 6000, (100, 0, 0)),
    "an instance moved and turned": (part(BOX) + assembly(instance("100., 0., 0.\n100., 0., 0., 100., 0., 1., "
        "90.\n")), 8, 6000,
                                     (80, 0, 0)),
    "two instances of one part": (part(BOX) + assembly(instance(), instance("50.,\n", "A-2")), 16, 12000, (0, 0, 0)),
    "numbers that restart": (part(BOX) + part(BOX, "B") + assembly(instance(), instance("0, 50\n", "B-1", "B")), 16,
                             12000, (0, 0, 0)),
    "an assembly's own node": (part(BOX) + assembly(instance(), more="*Node\n1, -3., -3., -3.\n*Nset, nset=RP\n1,\n"),
                               8, 6000,
                               (0, 0, 0)),
    "numbers with gaps": (_GAP + assembly(instance()), 8, 6000, (0, 0, 0)),
    "mesh in the instance": (part("") + assembly(instance(BOX)), 8, 6000, (0, 0, 0)),
    "cylinder": (nodes(CYLINDER, head="*NODE, SYSTEM=C") + elements(), 8, None, None),
    "sphere": (nodes(_SPHERICAL, head="*NODE, SYSTEM=S", form="{}, {:.12g}, {:.12g}, {:.12g}") + elements(), 8, 6000,
               (0, 0, 0)),
    "a system of axes": ("*SYSTEM\n100, 0, 0, 100, 1, 0\n99, 0, 0\n" + BOX, 8, 6000, (80, 0, 0)),
    "a system that moves": ("*SYSTEM\n1, 2, 3\n" + BOX, 8, 6000, (1, 2, 3)),
    "NGEN": (_NGEN + elements(), 8, 6000, (0, 0, 0)),
    "ELGEN": (nodes() + elements(HEXES[:1]) + "*ELGEN\n1, 2, 1, 1, 2, 3, 2, 2, 9, 4\n", 8, 6000, (0, 0, 0)),
    "NCOPY": (_PLANE + "*NCOPY, CHANGE NUMBER=9, OLD SET=LOW, SHIFT, MULTIPLE=2\n0, 0, 15\n\n" + elements(), 8, 6000,
              (0, 0, 0)),
    "NCOPY mirrored": (nodes(GRID[9:18]) + "*NSET, NSET=S, GENERATE\n1, 9\n" + nodes(GRID[18:], 10)
                       + "*NCOPY, CHANGE NUMBER=20, OLD SET=S, REFLECT=POINT\n5, 10, 15\n"
                       + elements(HEXES[:4], shift=1), 4, 3000, (0, 0, 15)),
    "ELCOPY": (nodes() + elements(HEXES[:4], more=", ELSET=LOW") + "*ELCOPY, ELEMENT SHIFT=4, OLD SET=LOW, SHIFT "
        "NODES=9\n", 8, 6000,
               (0, 0, 0)),
}


def write(tmp_path, text, name="deck.inp", encoding="utf-8"):
    (tmp_path / name).write_bytes(text.encode(encoding))
    return tmp_path / name


@pytest.mark.parametrize("name", DECKS)
def test_hexes_of_a_deck(tmp_path, name):
    text, count, volume, low = DECKS[name]
    found = read_mesh(write(tmp_path, text))
    assert len(found.hexes) == count
    used = found.points[np.unique(found.hexes)]
    if volume is None:
        assert np.allclose(used, ROUND)
        return
    assert np.isclose(volume_of(found.points, found.quads), volume) and np.allclose(used.min(axis=0), low, atol=1e-9)
    assert sum(found.counts[kind] for kind in found.counts if "8" in kind) == count


@pytest.mark.parametrize("kind", ["S4", "S4R", "S4R5", "S4RSW", "CPS4", "CPE4R", "CAX4", "M3D4R", "R3D4", "SFM3D4",
                                  "DS4", "CPS8R", "S8",
                                  "S8R5", "CPE8", "CAX8R", "M3D8", "S9R5", "M3D9"])
def test_kinds_of_quads(tmp_path, kind):
    points, rows = with_middles(OUTER)
    if "9" in kind:
        points, rows = np.vstack([points, points[rows[:, :4]].mean(axis=1)]), np.hstack([rows, np.arange(24)[:, None]
        + len(points)])
    rows = rows[:, :int(next(c for c in kind.replace("3D", "") if c in "489"))]
    surface = surface_from_file(write(tmp_path, nodes(points) + elements(rows, kind)))
    assert len(surface.quads) == 24 and len(surface.points) == 26 and np.isclose(volume_of(surface.points,
        surface.quads), 6000)


def test_the_same_reader_for_all(tmp_path):
    """Two instances of shells, one turned, beside each other: one surface of two parts, in its place."""
    path = write(tmp_path, part(SHELL) + assembly(instance("100., 0., 0.\n100., 0., 0., 101., 0., 0., 90.\n")))
    surface = surface_from_file(path)
    assert np.allclose(surface.points.min(axis=0), (100, -30, 0)) and np.isclose(volume_of(surface.points,
        surface.quads), 6000)


INCLUDED = {
    "data lines alone": ({"n.txt": nodes().split("\n", 1)[1]}, "*NODE\n*INCLUDE, INPUT=n.txt\n" + elements()),
    "more data in the middle": ({"e.txt": elements(HEXES[4:], first=5).split("\n", 1)[1]},
                                nodes() + elements(HEXES[:4]) + "*INCLUDE, INPUT=e.txt\n*NSET, NSET=A\n1\n"),
    "beside it": ({"rest.inp": elements(HEXES[4:], first=5)}, nodes() + elements(HEXES[:4]) + "*INCLUDE, "
        "INPUT=rest.inp\n"),
    "quoted, with a blank": ({"the rest.inp": elements(HEXES[4:], first=5)},
                             nodes() + elements(HEXES[:4]) + '*INCLUDE, INPUT="the rest.inp"\n'),
    "nested, in folders": ({"sub/a.inp": nodes() + "*INCLUDE, INPUT=b.inp\n", "sub/b.inp": elements()}, "*INCLUDE, "
        "INPUT=sub/a.inp\n"),
    "from the deck's folder": ({"sub/a.inp": nodes() + "*INCLUDE, INPUT=sub/b.inp\n", "sub/b.inp": elements()},
                               "*INCLUDE, INPUT=sub/a.inp\n"),
    "data of a card": ({"n.txt": nodes().split("\n", 1)[1], "e.txt": elements().split("\n", 1)[1]},
                       "*NODE, INPUT=n.txt\n*ELEMENT, TYPE=C3D8, INPUT=e.txt\n")}


@pytest.mark.parametrize("name", INCLUDED)
def test_what_is_included(tmp_path, name):
    others, text = INCLUDED[name]
    (tmp_path / "sub").mkdir()
    for other, content in others.items():
        (tmp_path / other).write_text(content, encoding="ascii")
    found = read_mesh(write(tmp_path, text))
    assert len(found.hexes) == 8 and np.isclose(volume_of(found.points, found.quads), 6000)


# name: (deck, code, words of the refusal)
REFUSED = {
    "a file that is not there": (BOX + "*INCLUDE, INPUT=gone.inp\n", FaultCode.FILE_IO, ("line 38", "gone.inp")),
    "itself": (BOX + "*INCLUDE, INPUT=deck.inp\n", FaultCode.FILE_FORMAT, ("includes itself",)),
    "a kind not known": (BOX + "*ELEMENT, TYPE=XYZ8\n99, 1,2,3,4\n", FaultCode.FILE_FORMAT, ("line 38", "XYZ8")),
    "a user's element": (BOX + "*ELEMENT, TYPE=U1\n99, 1,2,3,4\n", FaultCode.FILE_FORMAT, ("line 38", "U1")),
    "NFILL": (BOX + "*NFILL\nA, B, 3, 1\n", FaultCode.FILE_FORMAT, ("NFILL", "line 38")),
    "parameters": ("*PARAMETER\na = 3\n" + BOX, FaultCode.FILE_FORMAT, ("PARAMETER", "line 1")),
    "a system not known": (BOX.replace("*NODE", "*NODE, SYSTEM=Q"), FaultCode.FILE_FORMAT, ("SYSTEM=Q", "line 1")),
    "too few nodes": (nodes() + elements() + "*ELEMENT, TYPE=C3D8\n9, 1, 2, 3\n", FaultCode.FILE_FORMAT, ("line 39",
        "C3D8")),
    "a node that is not there": (BOX.replace("8, 14,", "8, 9914,"), FaultCode.FILE_FORMAT, ("9914",)),
    "an element twice": (BOX + elements(HEXES[:1]), FaultCode.FILE_FORMAT, ("more than once", "1")),
    "no number": (BOX.replace("2, 5, 0, 0", "2, five, 0, 0"), FaultCode.FILE_FORMAT, ("line 3", "five")),
    "tetrahedra beside": (BOX + "*ELEMENT, TYPE=C3D4\n99, 1, 2, 4, 10\n", FaultCode.FILE_FORMAT, ("1 tetra",)),
    "hexes of both orders": (BOX + "*ELEMENT, TYPE=C3D20\n99, " + ", ".join(map(str, range(1, 21))) + "\n",
                             FaultCode.FILE_FORMAT,
                             ("orders",)),
    "a part that is not there": (assembly(instance(of="B")), FaultCode.FILE_FORMAT, ("B", "line 2")),
    "UTF-16": (None, FaultCode.FILE_FORMAT, ("UTF-16",)),
    "nodes alone": (nodes(), FaultCode.FILE_FORMAT, ("no quads or volume elements",)),
    "copies turned inside out": (nodes() + elements(HEXES[:4], more=", ELSET=LOW")
                                 + "*ELCOPY, ELEMENT SHIFT=4, OLD SET=LOW, SHIFT NODES=9, REFLECT\n",
                                 FaultCode.FILE_FORMAT, ("REFLECT",)),
    "generated of nothing": (nodes() + "*ELGEN\n7, 2, 1, 1\n", FaultCode.FILE_FORMAT, ("line 29", "7")),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_refused_by_name(tmp_path, name):
    text, code, words = REFUSED[name]
    path = write(tmp_path, BOX, encoding="utf-16") if text is None else write(tmp_path, text)
    with pytest.raises(HexconError) as caught:
        read_mesh(path)
    assert caught.value.code is code and all(word in str(caught.value) for word in ("deck.inp", *words)), caught.value


def test_sets_and_surfaces(tmp_path):
    """Of all forms; each with its right quads and nodes."""
    side = "*ELSET, ELSET=low\n1, 2\n3, 4,\n*SURFACE, NAME=Bottom\nlow, S1\n*SURFACE, NAME=Mixed\n8, S2\n1, S1\n"
    sets = "*NSET, NSET=corner\n1\n*NSET, NSET=row, GENERATE\n1, 3\n*NSET, NSET=both\nCORNER, Row\n" \
           "*NSET, NSET=of_low, ELSET=low\n*SURFACE, NAME=points, TYPE=NODE\nrow\n"
    found = read_mesh(write(tmp_path, BOX + side + sets))
    assert {name: len(rows) for name, rows in found.quad_groups.items()} == {"Bottom": 4, "Mixed": 2}
    assert (found.points[found.quads[found.quad_groups["Bottom"]]][..., 2] == 0).all()
    assert {name: len(rows) for name, rows in found.node_groups.items()} == {"corner": 1, "row": 3, "both": 3,
        "of_low": 18, "points": 3}


def test_sets_of_instances(tmp_path):
    """Named in the part, and in the assembly by instance; the same numbers mean other nodes."""
    deck = part(BOX, more="*Nset, nset=low, generate\n 1, 9, 1\n*Elset, elset=first\n 1\n*Surface, name=top\n 8, S2\n")
    deck += assembly(instance(), instance("50., 0., 0.\n", "A-2"), more="*Nset, nset=one, instance=A-2\n 1\n"
                     "*Elset, elset=_s, internal, instance=A-2\n 1, 2\n*Surface, type=ELEMENT, name=face\n_s, S1\n"
                     "*Nset, nset=dotted\nA-1.low, A-2.1\n")
    found = read_mesh(write(tmp_path, deck))
    assert found.points[found.node_groups["one"]].tolist() == [[50, 0, 0]]
    assert len(found.node_groups["low"]) == 18 and len(found.node_groups["dotted"]) == 10
    assert len(found.quad_groups["top"]) == 2 and len(found.quad_groups["face"]) == 2
    assert (found.points[found.quads[found.quad_groups["face"]]][..., 0] >= 50).all()


def test_groups_of_a_surface(tmp_path):
    """Element sets of shells and node sets are groups of the surface."""
    sets = "*ELSET, ELSET=Load\n1, 2\n*NSET, NSET=Hold, GENERATE\n1, 9\n*NSET, NSET=inner\n14\n"
    surface = surface_from_file(write(tmp_path, SHELL + sets))
    assert surface.quad_groups["Load"].tolist() == [0, 1] and "inner" not in surface.node_groups
    assert (surface.points[surface.node_groups["Hold"]][:, 2] == 0).all() and len(surface.node_groups["Hold"]) == 9


def test_latin_1(tmp_path):
    found = read_mesh(write(tmp_path, "*HEADING\n L\u00e4nge in mm\n" + BOX + "*NSET, NSET=Fl\u00e4che\n1\n",
                            encoding="latin-1"))
    assert len(found.hexes) == 8 and "Fl\u00e4che" in found.node_groups


def test_numbers_of_a_file_stand_for_rows():
    """In any order, sparse, with some twice: the last row counts, for elements and for members of groups alike."""
    labels = Labels([7, 3, 10 ** 12, 3, -4])
    assert labels.rows_of([[3, 7], [-4, 10 ** 12]]).tolist() == [[3, 0], [4, 2]]
    assert labels.known([5, 3, 8, 7, 3]).tolist() == [3, 0, 3] and not len(labels.known([]))
    with pytest.raises(ValueError, match="number 8 is named"):
        labels.rows_of([3, 8])
    assert not len(Labels([]).known([1, 2]))

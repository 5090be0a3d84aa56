# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checking the loads of the deck that FreeCAD wrote, and putting them right.

FreeCAD spreads a force by mesh area / CAD area, so on a curved or round face the nodal
loads do not sum to the force (8 % short on a circle of 9 edges), and at order 2 with
straight edges it finds no quads of a curved face at all and writes no load, silently.
"""
import io
import os
import re

import numpy as np

from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.hexahedron import FACES
from hexcon.labels import rows_of

from .deck import face_number, write_forces, write_pressures

_TOLERANCE = 1e-6


def _cards(text):
    """[keyword, lines] of each part of a deck; comments stay with the card before them."""
    cards = [["", []]]
    for line in text.splitlines(keepends=True):
        if line.startswith("*") and not line.startswith("**"):
            cards.append([line.split(",")[0].strip().upper(), []])
        cards[-1][1].append(line)
    return cards


def _data(lines):
    return [line.split(",") for line in lines[1:]
            if line.strip() and not line.startswith("*")]


def nodal_loads(text, node_ids):
    """(P,3) sum of a deck's *CLOAD forces on each node of node_ids (P,). Raises ToolError TOOL_FAILED for other nodes."""
    rows = np.array([row for keyword, lines in _cards(text) if keyword == "*CLOAD"
                     for row in _data(lines)])
    loads = np.zeros((len(node_ids), 3))
    if len(rows):
        try:
            nodes = rows_of(node_ids, rows[:, 0].astype(np.int64))
        except ValueError as error:
            raise ToolError(f"FreeCAD's deck loads a node that the mesh has not: {error}", FaultCode.TOOL_FAILED) from error
        np.add.at(loads, (nodes, rows[:, 1].astype(np.int64) - 1), rows[:, 2].astype(float))
    return loads


def check_held(cards):
    """Raise TOOL_FAILED where a *BOUNDARY names a node set that is not in the deck, or empty; or where there is none."""
    sizes = {}
    for keyword, lines in cards:
        if keyword == "*NSET":
            name = lines[0].upper().partition("NSET=")[2].split(",")[0].strip()
            sizes[name] = sizes.get(name, 0) + sum(bool(word.strip()) for row in _data(lines) for word in row)
    held = {row[0].strip().upper() for keyword, lines in cards if keyword == "*BOUNDARY" for row in _data(lines)}
    empty = sorted(name for name in held if not name.isdigit() and not sizes.get(name))
    if empty or not held:
        raise ToolError("FreeCAD's deck holds nothing" + "".join(f": its node set {name} has no nodes" for name in empty[:1])
                        + "; the mesh may not lie on the faces of the solid", FaultCode.TOOL_FAILED)


def _loaded_faces(cards):
    """Sorted (element, face label) of every *DLOAD."""
    return sorted((int(row[0]), row[1].strip()) for keyword, lines in cards
                  if keyword == "*DLOAD" for row in _data(lines))


def _side_labels(cards, elements, node_ids, hex_ids):
    """(6,) the deck's face label (1..6) of each side of our hexahedra.

    FreeCAD writes the eight corners in another sequence than VTK's (0.20: backwards), so
    its S1 is our S2 and so on. The sequence is read from the deck, not taken for granted.
    """
    lines = next(lines for keyword, lines in cards if keyword == "*ELEMENT"
                 and "C3D" in lines[0].upper())
    numbers = [int(n) for row in _data(lines[:4]) for n in row if n.strip()]
    ours = node_ids[elements.hexes[np.flatnonzero(hex_ids == numbers[0])[0], :8]].tolist()
    sequence = [ours.index(number) for number in numbers[1:9]]
    label = {frozenset(sequence[c] for c in face): k + 1
             for k, face in enumerate(FACES.tolist())}
    return np.array([label[frozenset(face)] for face in FACES.tolist()])


def _forces_agree(got, right, elements, force):
    """Whether the nodal loads sum to the right force, in all and over each face's nodes."""
    size = sum(np.linalg.norm(f) for f in force.values())
    groups = [slice(None)] + [elements.nodes_of_face(face_number(name)) for name in force]
    return all(np.abs((got - right)[group].sum(axis=0)).max() <= _TOLERANCE * size
               for group in groups)


def correct_loads(path, elements, force, pressure, node_ids, hex_ids):
    """Compare the loads in FreeCAD's deck with those asked for; rewrite what is wrong.

    path      the .inp file;  node_ids (P,), hex_ids (H,): its numbers of our rows
    force, pressure  as in deck.static_deck
    Returns (notes, (3,) sum of the nodal loads now in the deck). Raises ToolError TOOL_FAILED where nothing is held.
    """
    with open(path, encoding="utf-8") as stream:
        text = stream.read()
    cards, notes = _cards(text), []
    check_held(cards)
    new = io.StringIO()
    write_forces(new, elements, force, node_ids)
    got, right = nodal_loads(text, node_ids), nodal_loads(new.getvalue(), node_ids)
    if not _forces_agree(got, right, elements, force):
        cards = _replace(cards, "*CLOAD", new.getvalue())
        notes.append(f"nodal loads of FreeCAD sum to {got.sum(axis=0).round(6).tolist()} N, "
                     f"{right.sum(axis=0).round(6).tolist()} N was asked for: replaced by "
                     "consistent loads")
    new = io.StringIO()
    if pressure:
        sides = _side_labels(cards, elements, node_ids, hex_ids)
        write_pressures(new, elements, pressure, hex_ids, sides)
    wanted, found = _loaded_faces(_cards(new.getvalue())), _loaded_faces(cards)
    if not set(wanted) <= set(found):
        cards = _replace(cards, "*DLOAD", new.getvalue())
        notes.append(f"FreeCAD found {len(set(found) & set(wanted))} of {len(wanted)} "
                     "element faces under pressure: replaced")
    text = "".join("".join(lines) for _, lines in cards)
    if notes:
        with open(path + ".part", "w", encoding="utf-8") as stream:
            stream.write(text)
        os.replace(path + ".part", path)
    return notes, nodal_loads(text, node_ids).sum(axis=0)


def _replace(cards, keyword, text):
    """Drop the cards of that keyword (not their comments) and put text before the output
    requests of the step."""
    kept = [[k, lines if k != keyword else
             [line for line in lines if line.startswith("**")]] for k, lines in cards]
    place = next(i for i, (k, _) in enumerate(kept)
                 if k in ("*NODE FILE", "*EL FILE", "*END STEP"))
    return kept[:place] + [[keyword, [text]]] + kept[place:]


def name_element_type(path, name):
    """Write the type of element over that which FreeCAD has written for the hexes."""
    with open(path, encoding="utf-8") as stream:
        text = stream.read()
    named = re.sub(r"(?im)^(\*ELEMENT\s*,\s*TYPE\s*=\s*)C3D(?:8|20)[A-Z]*", rf"\g<1>{name}", text)
    if named != text:
        with open(path + ".part", "w", encoding="utf-8") as stream:
            stream.write(named)
        os.replace(path + ".part", path)

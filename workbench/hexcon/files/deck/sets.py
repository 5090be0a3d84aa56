# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sets and surfaces of a deck, and the groups that they are of its mesh."""
import re

import numpy as np

from hexcon.femmesh.hexahedron import FACES as HEX_FACES

from ..contents import FACES, NODES, Group

MOST = 50_000_000   # members that a generated set may have


def add(card, of, scope, kind, instance):
    """Take a *NSET or *ELSET card: scope gets the set, whose numbers are of the scope `of`.

    kind "nodes" or "elements";  instance(card, name) -> Scope. Raises the card's fault."""
    name = card.value("NSET" if kind == "nodes" else "ELSET")
    if not name:
        raise card.fault("the set has no name")
    scope.add_to_set(kind, name, of, np.zeros(0, np.int64))
    if "GENERATE" in card.parameters:
        for number, parts in card.fields():
            scope.add_to_set(kind, name, of, _generated(card, number, parts))
        return
    if kind == "nodes" and card.value("ELSET"):
        _add_nodes_of(card, of, scope, name)
    found = card.numbers(np.int64, 1)
    if found is not None:
        scope.add_to_set(kind, name, of, found.ravel())
        return
    for number, parts in card.fields():
        for part in filter(None, parts):
            for holder, ids in _member(card, number, part, of, scope, kind, instance):
                scope.add_to_set(kind, name, holder, ids)


def _generated(card, number, parts):
    try:
        first, last = int(parts[0]), int(parts[1])
        step = int(parts[2]) if len(parts) > 2 and parts[2] else 1
    except (ValueError, IndexError) as error:
        raise card.fault(f"{', '.join(parts)[:80]!r}: first, last and step are needed", number) from error
    if step < 1 or last < first or (last - first) // step > MOST:
        raise card.fault(f"from {first} to {last} by steps of {step} is not possible", number)
    return np.arange(first, last + 1, step, dtype=np.int64)


def _add_nodes_of(card, of, scope, name):
    """Nodes of the elements of a set."""
    members = of.ids_of_set("elements", card.value("ELSET"))
    if members is None:
        raise card.fault(f"there is no element set {card.value('ELSET')!r} before")
    for holder, ids in members:
        for _, numbers, nodes in holder.elements:
            scope.add_to_set("nodes", name, holder, np.unique(nodes[np.isin(numbers, ids)]))


def _member(card, number, word, of, scope, kind, instance):
    """[(scope, ids)] of one member: a number, a set's name, or either behind an instance's name and a dot."""
    word = word.strip("\"' ")
    if re.fullmatch(r"[+-]?\d+", word):
        return [(of, np.array([int(word)], np.int64))]
    for holder in (of, scope):
        found = holder.ids_of_set(kind, word)
        if found is not None:
            return list(found)
    if "." in word:
        before, _, after = word.partition(".")
        return _member(card, number, after, instance(card, before), instance(card, before), kind, instance)
    raise card.fault(f"there is no set {word!r} before", number)


# ------------------------------------------------------------------------------ groups of the whole

def groups_of(scopes, cells, instance):
    """[Group] of all sets and surfaces; cells: {kind: [blocks]}. Sets of one name in several instances are one.

    Node sets that name nodes which are not there are without them, as in CalculiX, which passes them over."""
    hexes = {kind: np.vstack(cells[kind]) for kind in ("hexahedron", "hexahedron20", "hexahedron27") if kind in cells}
    groups = {}
    for scope in scopes:
        for name, members in scope.sets["nodes"].values():
            for holder, ids in members:
                _put(groups, name, NODES, holder.rows_of_nodes(ids))
        for name, members in scope.sets["elements"].values():
            for holder, ids in members:
                for kind, rows in holder.rows_of_elements(ids).items():
                    _put(groups, name, kind, rows)
        for card, holder in scope.surfaces:
            _put_surface(groups, card, holder, hexes, cells, instance)
    joined = [(name, kind, np.concatenate(blocks)) for (_, kind), (name, blocks) in groups.items()]
    return [Group(name, kind, np.unique(rows, axis=0)) for name, kind, rows in joined if len(rows)]


def _put(groups, name, kind, rows):
    groups.setdefault((name.upper(), kind), (name, []))[1].append(rows)


def _put_surface(groups, card, scope, hexes, cells, instance):
    """A *SURFACE: sides of hexes, whole quads (SPOS, SNEG or no side), or nodes (TYPE=NODE)."""
    name = card.value("NAME")
    if not name or card.value("TYPE", "ELEMENT").upper() not in ("ELEMENT", "NODE") or "COMBINE" in card.parameters:
        return
    kind = "nodes" if card.value("TYPE", "ELEMENT").upper() == "NODE" else "elements"
    by_side = {}
    for number, parts in card.fields():
        for holder, ids in _member(card, number, parts[0], scope, scope, kind, instance):
            by_side.setdefault((holder, parts[1].upper() if len(parts) > 1 and parts[1] else ""), []).append(ids)
    for (holder, side), blocks in by_side.items():
        ids = np.concatenate(blocks)
        if kind == "nodes":
            _put(groups, name, NODES, holder.rows_of_nodes(ids))
            continue
        for cell_kind, rows in holder.rows_of_elements(ids).items():
            if cell_kind in hexes and re.fullmatch(r"S[1-6]", side):
                _put(groups, name, FACES, hexes[cell_kind][rows][:, HEX_FACES[int(side[1]) - 1]])
            elif cell_kind in hexes and not side:
                _put(groups, name, FACES, hexes[cell_kind][rows][:, HEX_FACES].reshape(-1, 4))
            elif cell_kind.startswith("quad") and side in ("", "SPOS", "SNEG"):
                _put(groups, name, cell_kind, rows)

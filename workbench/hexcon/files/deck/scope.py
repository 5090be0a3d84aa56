# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes, elements and sets whose numbers are of one kind: those of a part, an instance, the assembly, or in the
open."""
import functools

import numpy as np

from hexcon.errors import FaultCode, ToolError
from hexcon.labels import Labels, rows_of

from ..text import real
from .cards import whole_numbers
from .element_types import kind_of
from .systems import System, to_cartesian


class Scope:
    """Everything is in lists of blocks until settle(), which makes arrays of it.

    nodes     [(ids (n,), places (n,3))];  elements [(type, ids (n,), node ids (n,k))]
    sets      {"nodes" | "elements": {NAME: (name as written, [(scope, ids)])}}
    surfaces  [(card, scope)];  move: callable (n,3) -> (n,3) of an instance
    """

    def __init__(self, path, name, move=None):
        self.path, self.name, self.move = path, name, move
        self.nodes, self.elements, self.surfaces, self.notes = [], [], [], []
        self.sets = {"nodes": {}, "elements": {}}
        self._system = System()
        self.node_ids = self.places = None
        self.first = 0
        self._places_of = {}    # of elements: {kind: [(ids, first row in cells)]}

    @property
    def is_empty(self):
        return not (self.nodes or self.elements or self.surfaces or any(self.sets.values()))

    def copy_of(self, part):
        """Take over a part's mesh and sets: an instance begins with them."""
        self.nodes, self.elements = list(part.nodes), list(part.elements)
        self.surfaces = [(card, self) for card, _ in part.surfaces]
        self.notes = list(part.notes)
        for kind, named in part.sets.items():
            self.sets[kind] = {key: (name, [(self, ids) for _, ids in members])
                               for key, (name, members) in named.items()}

    # ---- cards

    def add_nodes(self, card):
        found = _node_rows(card)
        if found is None:
            return
        try:
            ids = whole_numbers(found[:, 0])
        except ValueError as error:
            raise card.fault(str(error)) from error
        self.add_node_block(ids, self._system.applied(to_cartesian(found[:, 1:], card)))
        if card.value("NSET"):
            self.add_to_set("nodes", card.value("NSET"), self, ids)

    def add_node_block(self, ids, places):
        self.nodes.append((ids, places))

    def add_elements(self, card):
        if not card.value("TYPE"):
            raise card.fault("TYPE=... is missing")
        kind_name = card.value("TYPE").upper()
        try:
            kind, width = kind_of(kind_name)
        except ValueError as error:
            raise card.fault(f"elements of type {kind_name} are not known, and may be a part of the mesh") from error
        if kind is None:
            self._pass_over(card, kind_name)
            return
        rows = card.numbers(np.int64, width + 1)
        if rows is None:
            rows = _element_rows(card, kind_name, width)
        if len(rows):
            self.add_element_block(kind_name, rows[:, 0], rows[:, 1:])
        if card.value("ELSET"):
            self.add_to_set("elements", card.value("ELSET"), self, rows[:, 0])

    def add_element_block(self, kind_name, ids, nodes):
        self.elements.append((kind_name, ids, nodes))

    def _pass_over(self, card, kind_name):
        """Lines and points: counted by their lines, and their numbers known for sets."""
        ids = []
        for number, parts in card.fields():
            try:
                ids.append(int(parts[0]))
            except ValueError as error:
                raise card.fault(f"{parts[0]!r} is no number of an element", number) from error
        self.elements.append((kind_name, np.array(ids, np.int64), np.zeros((len(ids), 0), np.int64)))
        if card.value("ELSET"):
            self.add_to_set("elements", card.value("ELSET"), self, np.array(ids, np.int64))

    def set_system(self, card):
        self._system = System.of(card)

    def add_to_set(self, kind, name, scope, ids):
        """Members of a set: ids of nodes or elements of a scope."""
        self.sets[kind].setdefault(name.upper(), (name, []))[1].append((scope, np.asarray(ids, np.int64)))

    def ids_of_set(self, kind, name):
        """[(scope, ids)] of a set, or None."""
        found = self.sets[kind].get(name.upper())
        return None if found is None else found[1]

    # ---- lookups while cards are read

    def node_places(self, ids, card):
        """(n,3) places of nodes read so far. Raises the card's fault."""
        known = np.concatenate([np.zeros(0, np.int64), *(block for block, _ in self.nodes)])
        places = np.vstack([np.zeros((0, 3)), *(block for _, block in self.nodes)])
        try:
            return places[rows_of(known, ids)]
        except ValueError as error:
            raise card.fault(f"node {error}") from error

    def element_of(self, wanted, card):
        """(type, node ids) of an element read so far. Raises the card's fault."""
        for kind_name, ids, nodes in reversed(self.elements):
            found = np.flatnonzero(ids == wanted)
            if len(found):
                return kind_name, nodes[found[-1]]
        raise card.fault(f"element {wanted} is not defined before")

    # ---- the whole

    def settle(self):
        """Arrays of all nodes, each number once; the last place counts."""
        ids = np.concatenate([np.zeros(0, np.int64), *(block for block, _ in self.nodes)])
        places = np.vstack([np.zeros((0, 3)), *(block for _, block in self.nodes)])
        _, from_end = np.unique(ids[::-1], return_index=True)
        kept = np.sort(len(ids) - 1 - from_end)
        if len(kept) < len(ids):
            self.notes.append(f"{len(ids) - len(kept)} nodes are defined more than once: the last place counts")
        self.node_ids, self.places, self._nodes = ids[kept], places[kept], Labels(ids[kept])
        if self.move is not None:
            with np.errstate(invalid="ignore"):     # what is not finite is refused later
                self.places = self.move(self.places)
        self._refuse_twice()

    def _refuse_twice(self):
        """Raise for an element number that two different elements have."""
        ids = np.concatenate([np.zeros(0, np.int64), *(block for _, block, _ in self.elements)])
        found, counts = np.unique(ids, return_counts=True)
        if (counts > 1).any():
            twice = found[counts > 1]
            raise ToolError(f"{self.path}: {len(twice)} elements{self._where()} are defined more than once, numbers "
                            + ", ".join(map(str, twice[:10])), FaultCode.FILE_FORMAT)

    def _where(self):
        return f" of {self.name}" if self.name else ""

    def hand_over(self, cells, counts):
        """Put the elements into {kind: [blocks]} and {type: count}; remembers where each number went."""
        for kind_name, ids, nodes in self.elements:
            kind, _ = kind_of(kind_name)
            counts[kind_name] = counts.get(kind_name, 0) + len(ids)
            if kind is None or not len(ids):
                continue
            try:
                rows = self._nodes.rows_of(nodes) + self.first
            except ValueError as error:
                raise ToolError(f"{self.path}: elements of type {kind_name}{self._where()} name nodes that are not "
                                f"defined: "
                                f"{error}", FaultCode.FILE_FORMAT) from error
            first = sum(len(block) for block in cells.get(kind, ()))
            cells.setdefault(kind, []).append(rows)
            self._places_of.setdefault(kind, []).append((ids, first))

    def rows_of_elements(self, ids):
        """{kind: rows in its cells} of element numbers; numbers of lines and points, and unknown ones, are left out."""
        known = {kind: rows[labels.known(ids)] for kind, (labels, rows) in self._elements_by_kind.items()}
        return {kind: rows for kind, rows in known.items() if len(rows)}

    @functools.cached_property
    def _elements_by_kind(self):
        """{kind: (Labels of the elements, their rows in its cells)}, when all are handed over."""
        return {kind: (Labels(np.concatenate([ids for ids, _ in blocks])),
                       np.concatenate([first + np.arange(len(ids)) for ids, first in blocks]))
                for kind, blocks in self._places_of.items()}

    def rows_of_nodes(self, ids):
        """Rows of node numbers among all points; unknown ones are left out."""
        return self._nodes.known(ids) + self.first


def _node_rows(card):
    """(n,4) number, x, y, z of a *NODE card; coordinates that are left out are 0. None: there are none."""
    if not card.lines:
        return None
    counts = {text.count(",") for _, text in card.lines}
    if len(counts) == 1 and 3 <= (commas := counts.pop()) <= 6:
        for width in (commas + 1, commas):   # a comma may end the line
            found = card.numbers(float, width) if width >= 4 else None
            if found is not None and len(found) == len(card.lines):
                return found[:, :4]
    rows = []
    for number, parts in card.fields():
        try:
            values = [real(part) for part in parts[:4]]
        except ValueError as error:
            raise card.fault(f"{', '.join(parts)[:80]!r} is no node: a number and up to three coordinates are needed",
                             number) from error
        rows.append(values + [0.0] * (4 - len(values)))
    return np.array(rows, float).reshape(-1, 4)


def _element_rows(card, kind_name, width):
    """As Card.numbers, element by element, where that found other than whole rows; raises what is wrong, and where."""
    rows, row, begun = [], [], 0
    for number, parts in card.fields():
        try:
            values = [int(part) for part in parts]
        except ValueError as error:
            raise card.fault(f"{', '.join(parts)[:80]!r}: whole numbers are needed", number) from error
        begun = number if not row else begun
        row += values
        if len(row) == width + 1:
            rows.append(row)
            row = []
        elif len(row) > width + 1:
            break
    if row:
        raise card.fault(f"an element of type {kind_name} has a number and {width} nodes; here are {len(row)} "
                         f"numbers", begun)
    return np.array(rows, np.int64).reshape(-1, width + 1)

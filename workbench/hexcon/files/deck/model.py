# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the cards of a deck to its mesh: parts and instances, or nodes and elements in the open; sets and surfaces.

What could change the mesh and is not understood is refused by name and line. Other cards (materials, steps) are passed
over. Abaqus 2016, Keywords Reference Guide; CalculiX 2.20, chapter 7.
"""
import numpy as np

from hexcon.errors import FaultCode, ToolError

from ..contents import Contents
from . import generation, sets
from .cards import cards_of
from .instances import placed
from .scope import Scope

_REFUSED = {
    "NFILL": "nodes between two lines of nodes", "NMAP": "nodes moved by a mapping",
    "PARAMETER": "parameters, which may stand for any number", "IMPORT": "a mesh of another analysis",
    "SYMMETRIC MODEL GENERATION": "a model made of a part of it", "SUBSTRUCTURE GENERATE": "substructures",
    "ADAPTIVE MESH": "a mesh that changes", "MAP SOLUTION": "a mesh of another analysis", "INSTANCE IMPORT": "a mesh"}


def read_deck(path):
    """Contents of a deck: points, elements, node sets, element sets and surfaces, in instances at their places.

    Raises ToolError FILE_FORMAT (naming file and line), FILE_IO (a file that it includes).
    """
    model = _Model(path)
    for card in cards_of(path):
        model.take(card)
    return model.contents()


class _Model:
    """The deck as it is read: one scope in the open, one for each part, one for the assembly, one for each instance."""

    def __init__(self, path):
        self.path = path
        self.open, self.parts, self.instances, self.assembly = Scope(path, ""), {}, [], Scope(path, "")
        self._inside = [self.open]

    @property
    def scope(self):
        return self._inside[-1]

    def take(self, card):
        if card.name in _REFUSED:
            raise card.fault(f"{_REFUSED[card.name]}: this is not understood, and would change the mesh")
        method = _STRUCTURE.get(card.name) or _MESH.get(card.name)
        if method is not None:
            method(self, card)

    # ---- structure

    def begin_part(self, card):
        name = _name_of(card)
        if name.upper() in self.parts:
            raise card.fault(f"there are two parts {name!r}")
        self.parts[name.upper()] = Scope(self.path, name)
        self._inside.append(self.parts[name.upper()])

    def begin_assembly(self, card):
        self._inside.append(self.assembly)

    def begin_instance(self, card):
        name, part = _name_of(card), card.value("PART", "").upper()
        if "LIBRARY" in card.parameters:
            raise card.fault(f"instance {name!r} is of another analysis, {card.value('LIBRARY')!r}")
        if part and part not in self.parts:
            raise card.fault(f"instance {name!r} is of part {card.value('PART')!r}, which is not there")
        scope = placed(card, name, self.parts.get(part))
        if any(one.name.upper() == name.upper() for one in self.instances):
            raise card.fault(f"there are two instances {name!r}")
        self.instances.append(scope)
        self._inside.append(scope)

    def end(self, card):
        if len(self._inside) > 1:
            self._inside.pop()

    # ---- mesh

    def nodes(self, card):
        self.scope.add_nodes(card)

    def elements(self, card):
        self.scope.add_elements(card)

    def system(self, card):
        self.scope.set_system(card)

    def generated(self, card):
        generation.generate(card, self.scope)

    def node_set(self, card):
        sets.add(card, self._of_instance(card), self.scope, "nodes", self._instance)

    def element_set(self, card):
        sets.add(card, self._of_instance(card), self.scope, "elements", self._instance)

    def surface(self, card):
        self.scope.surfaces.append((card, self.scope))

    def _of_instance(self, card):
        """The scope whose numbers a set's members are."""
        name = card.value("INSTANCE")
        return self.scope if name is None else self._instance(card, name)

    def _instance(self, card, name):
        found = [one for one in self.instances if one.name.upper() == name.upper()]
        if not found:
            raise card.fault(f"there is no instance {name!r}")
        return found[0]

    # ---- the whole

    def contents(self):
        """Contents; scopes follow each other: in the open, instances (or parts, without any), the assembly's own."""
        notes, scopes = [], [self.open, *(self.instances or self.parts.values()), self.assembly]
        if self.parts and not self.instances:
            notes.append("there are parts, but no instances: each part is taken once, where it is")
        scopes = [scope for scope in scopes if not scope.is_empty]
        if not scopes:
            raise ToolError(f"{self.path}: there are no nodes and elements in it", FaultCode.FILE_FORMAT)
        for scope in scopes:
            scope.settle()
        count = 0
        for scope in scopes:
            scope.first, count = count, count + len(scope.node_ids)
        cells, counts = {}, {}
        for scope in scopes:
            scope.hand_over(cells, counts)
        if not cells:
            raise ToolError(f"{self.path}: there are no quads or volume elements in it"
                            + (f", only {', '.join(counts)}" if counts else ""), FaultCode.FILE_FORMAT)
        groups = sets.groups_of(scopes, cells, self._instance)
        points = np.vstack([scope.places for scope in scopes])
        joined = {kind: np.vstack(blocks) for kind, blocks in cells.items()}
        return Contents(points, joined, groups, [*notes, *(n for scope in scopes for n in scope.notes)], counts)


def _name_of(card):
    name = card.value("NAME")
    if not name:
        raise card.fault("NAME=... is missing")
    return name


_STRUCTURE = {"PART": _Model.begin_part, "END PART": _Model.end, "ASSEMBLY": _Model.begin_assembly,
              "END ASSEMBLY": _Model.end, "INSTANCE": _Model.begin_instance, "END INSTANCE": _Model.end}
_MESH = {"NODE": _Model.nodes, "ELEMENT": _Model.elements, "SYSTEM": _Model.system, "NSET": _Model.node_set,
         "ELSET": _Model.element_set, "SURFACE": _Model.surface,
         **dict.fromkeys(("NGEN", "ELGEN", "NCOPY", "ELCOPY"), _Model.generated)}

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A reader of Nastran bulk data (.bdf, .nas): grid points, quads and solids.

Ours, because gmsh's loses grid points in long fields, and neither it nor meshio looks at coordinate systems: such nodes
would be read as x, y, z. Cards: MSC Nastran, Quick Reference Guide.
"""
import os
import re

import numpy as np

from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.node_orders import HEX20, HEX27_GMSH, places_of
from hexcon.labels import rows_of

from .contents import Contents, Group
from .regular import regular_file
from .text import real

_FLAT = {"CQUAD4": (4,), "CQUADR": (4,), "CSHEAR": (4,), "CQUAD8": (8, 4), "CQUAD": (9, 8, 4), "CQUAD9": (9,),
         "CTRIA3": (3,), "CTRIAR": (3,), "CTRIA6": (6, 3)}
_SOLID = {"CHEXA": (27, 20, 8), "CTETRA": (10, 4), "CPENTA": (15, 6), "CPYRAM": (13, 5)}
_KIND = {3: "triangle", 6: "triangle6", 4: "quad", 8: "quad8", 9: "quad9"}
_SOLID_KIND = {"CHEXA": {8: "hexahedron", 20: "hexahedron20", 27: "hexahedron27"},
               "CTETRA": {4: "tetra", 10: "tetra10"},
               "CPENTA": {6: "wedge", 15: "wedge15"}, "CPYRAM": {5: "pyramid", 13: "pyramid13"}}
# Nastran has no hex of 27 nodes: gmsh writes its own as CHEXA, and CQUAD9, in its own sequence.
_SEQUENCE = {"hexahedron20": places_of(HEX20["Nastran CHEXA"]), "hexahedron27": places_of(HEX27_GMSH)}
_REFUSED = ("CQUADX", "CTRIAX", "CTRIAX6", "GRDSET", "CHEX", "CIHEX1", "CIHEX2", "CHEXA1", "CHEXA2")


def read_nastran(path):
    """Contents; the properties of quads (PID), if there are several, are groups "PID 1", "PID 2" ...

    Raises ToolError FILE_FORMAT naming card and line: coordinate systems other than the basic one, what is cut short.
    """
    deck = _Nastran(path)
    for line, fields in _cards(path, ()):
        deck.take(line, fields)
    return deck.contents()


def _fault(path, line, words):
    return ToolError(f"{path}, line {line}: {words}", FaultCode.FILE_FORMAT)


# ------------------------------------------------------------------------------ lines to cards

def _cards(path, chain):
    """((path, line), fields) of each card of the bulk data, continuations joined; INCLUDEs in their place."""
    with open(path, "rb") as stream:
        lines = stream.read().decode("latin-1").replace("\r\n", "\n").replace("\r", "\n").split("\n")
    starts = [k for k, line in enumerate(lines) if line.strip().upper().replace("  ", " ").startswith("BEGIN")]
    held, where = None, None
    for number, line in enumerate(lines[starts[0] + 1 if starts else 0:], (starts[0] + 2) if starts else 1):
        line = line.split("$", 1)[0].rstrip()
        if not line.strip():
            continue
        if line.strip().upper().startswith("ENDDATA"):
            break
        if line.strip().upper().startswith("INCLUDE"):
            if held:
                yield where, held
            held = None
            yield from _included(path, number, line, chain)
            continue
        fields, continues = _fields(line)
        if continues and held is not None:
            held += fields[1:]
            continue
        if held:
            yield where, held
        held, where = fields, (path, number)
    if held:
        yield where, held


def _included(path, number, line, chain):
    name = line.strip()[len("INCLUDE"):].strip().strip("'\"=, ")
    other = os.path.join(os.path.dirname(path), name)
    if not os.path.exists(other):
        raise ToolError(f"{path}, line {number}: INCLUDE: the file {name!r} is not there", FaultCode.FILE_IO)
    if os.path.realpath(other) in (*chain, os.path.realpath(path)) or len(chain) > 50:
        raise _fault(path, number, f"INCLUDE: {name!r} includes itself")
    yield from _cards(regular_file(other), (*chain, os.path.realpath(path)))


def _fields(line):
    """(fields, the card's name first; whether the line continues the one before). Each line has four (long fields) or
    eight
    fields behind the first, whether it is full or not."""
    if "," in line:
        parts = [part.strip() for part in line.split(",")]
        name = parts[0]
        width = 4 if name.endswith("*") else 8
        return [name.rstrip("*"), *(parts[1:1 + width] + [""] * width)[:width]], name[:1] in ("+", "*", "")
    line = line.expandtabs(8)
    name = line[:8].strip()
    long = name.endswith("*") or name.startswith("*")
    size, width = (16, 4) if long else (8, 8)
    cut = [line[8 + size * k:8 + size * (k + 1)].strip() for k in range(width)]
    return [name.rstrip("*"), *cut], name[:1] in ("+", "*", "")


def _real(text):
    """text.real, and Nastran's 1.5+3."""
    if re.fullmatch(r"[+-]?[\d.]+[+-]\d+", text):
        k = max(text.rfind("+"), text.rfind("-"))
        text = text[:k] + "E" + text[k:]
    return real(text)


# ------------------------------------------------------------------------------ cards to a mesh

class _Nastran:
    def __init__(self, path):
        self.path, self.ids, self.places, self.listed, self.properties, self.counts = path, [], [], {}, {}, {}

    def take(self, where, fields):
        name = fields[0].upper()
        try:
            if name == "GRID":
                self._grid(where, fields)
            elif name in _FLAT:
                self._element(where, name, fields, _FLAT[name])
            elif name in _SOLID:
                self._element(where, name, fields, _SOLID[name])
            elif name in _REFUSED:
                raise _fault(*where, f"{name} is not understood, and would change the mesh")
        except (ValueError, IndexError, OverflowError) as error:
            raise _fault(*where, f"{name}: {error}") from error

    def _grid(self, where, fields):
        if fields[2] not in ("", "0"):
            raise _fault(*where, f"GRID {fields[1]} is in coordinate system {fields[2]}: only the basic one is "
                                 f"understood")
        self.ids.append(int(fields[1]))
        self.places.append([_real(text) for text in (fields[3:6] + ["", "", ""])[:3]])

    def _element(self, where, name, fields, sizes):
        nodes = [int(text) if text else 0 for text in fields[3:3 + sizes[0]]]
        nodes += [0] * (sizes[0] - len(nodes))
        size = next((n for n in sizes if all(nodes[:n]) and not any(nodes[n:])), None)
        if size is None:
            raise _fault(*where, f"{name} {fields[1]}: {' or '.join(map(str, sizes))} nodes are possible, and all of "
                                 f"them needed")
        kind = _SOLID_KIND[name][size] if name in _SOLID else _KIND[size]
        self.listed.setdefault(kind, []).append(nodes[:size])
        self.properties.setdefault(kind, []).append(int(fields[2] or 0))
        self.counts[name] = self.counts.get(name, 0) + 1

    def contents(self):
        if not self.ids or not self.listed:
            raise ToolError(f"{self.path}: no GRID points, or no elements of a body, in it", FaultCode.FILE_FORMAT)
        ids, cells, groups = np.array(self.ids, np.int64), {}, []
        for kind, rows in self.listed.items():
            try:
                cells[kind] = rows_of(ids, np.array(rows, np.int64))
            except (ValueError, OverflowError) as error:
                raise ToolError(f"{self.path}: a {kind} names a GRID that is not defined: {error}",
                                FaultCode.FILE_FORMAT) from error
            if kind in _SEQUENCE:
                cells[kind] = cells[kind][:, _SEQUENCE[kind]]
            numbers = np.array(self.properties[kind])
            found = np.unique(numbers)
            if kind.startswith("quad") and len(found) > 1:
                groups += [Group(f"PID {number}", kind, np.flatnonzero(numbers == number)) for number in found.tolist()]
        return Contents(np.array(self.places, float).reshape(-1, 3), cells, groups, [], self.counts)

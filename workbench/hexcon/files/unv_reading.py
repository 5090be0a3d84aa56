# SPDX-License-Identifier: LGPL-2.1-or-later
"""A reader of I-DEAS universal files (.unv): nodes, elements, groups, coordinate systems, units.

Ours, because gmsh's leaves out coordinate systems and units, SMESH's some kinds and all units, and meshio has none.
Datasets as of the SDRC manual: nodes 15, 781, 2411; elements 780, 2412; groups 2417, 2429, 2430, 2432, 2435, 2452,
2467, 2477; coordinate systems 2420; units 164.
"""
import numpy as np

from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.node_orders import HEX20, HEX27_GMSH, places_of
from hexcon.labels import Labels

from .contents import NODES, Contents, Group
from .text import parse_numbers, real

# descriptor -> {number of nodes: (kind by meshio's names, positions of VTK's nodes among the element's)}; parabolic
# elements go round: corner, middle, corner, ...
_T3, _T6 = ("triangle", range(3)), ("triangle6", (0, 2, 4, 1, 3, 5))
_Q4, _Q8 = ("quad", range(4)), ("quad8", (0, 2, 4, 6, 1, 3, 5, 7))
# gmsh writes quads of 9 and hexes of 27 nodes as linear kinds, in its own order: corners, edges, faces, middle.
_GMSH_Q9 = ("quad9", range(9))
_GMSH_HEX27 = ("hexahedron27", places_of(HEX27_GMSH))
_SOLIDS = {
    111: {4: ("tetra", range(4))}, 118: {10: ("tetra10", (0, 2, 4, 9, 1, 3, 5, 6, 7, 8))},
    112: {6: ("wedge", range(6))}, 113: {15: ("wedge15", (0, 2, 4, 9, 11, 13, 1, 3, 5, 10, 12, 14, 6, 7, 8))},
    114: {5: ("pyramid", range(5))},
    115: {8: ("hexahedron", range(8)), 27: _GMSH_HEX27}, 116: {20: ("hexahedron20", places_of(HEX20["UNV 116"]))}}
_FLAT = {code: {4: _Q4, 9: _GMSH_Q9} for code in (44, 54, 64, 74, 84, 94, 122)}
_FLAT |= {code: {8: _Q8} for code in (45, 55, 65, 75, 85, 95)}
_FLAT |= {code: {3: _T3} for code in (41, 51, 61, 81, 91, 121)}
_FLAT |= {code: {6: _T6} for code in (42, 52, 62, 72, 82, 92)}
_KINDS = _SOLIDS | _FLAT
_BEAMS = (11, 21, 22, 23, 24)                           # these have one more line
_LINES = (*_BEAMS, 31, 32, 136, 137, 138, 139, 141, 151, 152, 161, 171, 172, 181)   # rods, springs, masses, points

_GROUPS = (2417, 2429, 2430, 2432, 2435, 2452, 2467, 2477)
_GROUPED_NODES, _GROUPED_ELEMENTS = 7, 8
_CARTESIAN, _CYLINDRICAL, _SPHERICAL = 0, 1, 2
_SMESH = "SMESH_Mesh"   # the part's name that SMESH (Salome, FreeCAD) writes, with units of metres whatever they are


def read_unv(path):
    """Contents of a .unv file, lengths in mm where the file tells its units. Raises ToolError FILE_FORMAT."""
    file = _File(path)
    with open(path, encoding="latin-1") as stream:
        for number, first, lines in _datasets(stream):
            file.take(number, first, lines)
    return file.contents()


def _datasets(stream):
    """(number, line number of the first line after it, lines) of each dataset between two lines that hold -1 alone."""
    lines, begun = None, 0
    for number, line in enumerate(stream, 1):
        if line.strip() == "-1":
            if lines and lines[0].split() and lines[0].split()[0].rstrip("b").isdigit():
                yield int(lines[0].split()[0].rstrip("b")), begun + 2, [text.rstrip("\r\n") for text in lines[1:]]
            lines, begun = ([], number) if lines is None else (None, 0)
        elif lines is not None:
            lines.append(line)
    if lines and lines[0].split()[:1] in (["2411"], ["2412"], ["781"], ["780"], ["15"]):
        raise ToolError(f"line {begun}: dataset {lines[0].split()[0]} does not end: the file is cut short",
                        FaultCode.FILE_FORMAT)


class _File:
    """What was read so far."""

    def __init__(self, path):
        self.path = path
        self.ids, self.places, self.systems_of, self.systems, self.part = [], [], [], {}, ""
        self.listed, self.named, self.counts = {}, [], {}
        self.factor, self.notes = None, []

    def take(self, number, first, lines):
        readers = {2411: self._nodes, 781: self._nodes, 15: self._nodes_in_lines, 2412: self._elements, 780:
                   self._elements,
                   2420: self._systems, 164: self._units, **dict.fromkeys(_GROUPS, self._groups)}
        if number == 71:
            raise self._fault(first, "elements of dataset 71 are not understood; export datasets 2411 and 2412")
        if number in readers:
            try:
                readers[number](number, first, lines)
            except (ValueError, IndexError, OverflowError) as error:
                raise self._fault(first, f"dataset {number} is damaged, or ends too soon: {error}") from error

    def _fault(self, line, words):
        return ToolError(f"{self.path}, line {line}: {words}", FaultCode.FILE_FORMAT)

    # ---- datasets

    def _nodes(self, number, first, lines):
        """Two lines a node: label, coordinate system ...; three coordinates."""
        if len(lines) % 2:
            raise ValueError("a node's coordinates are missing")
        heads = [line.split() for line in lines[::2]]
        self._add_nodes([head[0] for head in heads], [head[1] for head in heads], " ".join(lines[1::2]))

    def _nodes_in_lines(self, number, first, lines):
        rows = [line.split() for line in lines]
        if any(len(row) != 7 for row in rows):
            raise ValueError("a node has a label, three numbers and three coordinates")
        self._add_nodes([row[0] for row in rows], [row[1] for row in rows], " ".join(" ".join(row[4:]) for row in rows))

    def _add_nodes(self, labels, systems, text):
        places = parse_numbers(text, float).reshape(-1, 3)
        if len(places) != len(labels):
            raise ValueError("three coordinates for each node are needed")
        self.ids.append(np.array(labels).astype(np.int64))
        self.systems_of.append(np.array(systems).astype(np.int64))
        self.places.append(places)

    def _elements(self, number, first, lines):
        fields = 8 if number == 780 else 6
        at = 0
        while at < len(lines):
            head = [int(word) for word in lines[at].split()]
            if len(head) != fields:
                raise self._fault(first + at, f"{fields} numbers of an element are needed, not {len(head)}")
            label, descriptor, size = head[0], head[1], head[-1]
            begun, at = at, at + (2 if descriptor in _BEAMS else 1)
            if not 0 < size <= 1000:
                raise self._fault(first + begun, f"element {label} (kind {descriptor}) has {size} nodes")
            nodes = []
            while len(nodes) < size and at < len(lines):
                nodes += lines[at].split()
                at += 1
            if len(nodes) != size:
                raise self._fault(first + begun, f"element {label} has {len(nodes)} nodes, and should have {size}")
            self._add_element(label, descriptor, nodes, first + begun)

    def _add_element(self, label, descriptor, nodes, line):
        self.counts[f"kind {descriptor}"] = self.counts.get(f"kind {descriptor}", 0) + 1
        if descriptor in _LINES:
            return
        kinds = _KINDS.get(descriptor)
        if kinds is None:
            raise self._fault(line, f"element {label} is of kind {descriptor}, which is not known and may be a part "
                                    f"of the mesh")
        if len(nodes) not in kinds:
            raise self._fault(line, f"element {label} (kind {descriptor}) has {len(nodes)} nodes; "
                              f"{' or '.join(map(str, kinds))} are possible")
        kind, order = kinds[len(nodes)]
        ids, rows = self.listed.setdefault(kind, ([], []))
        ids.append(label)
        rows.append([nodes[k] for k in order])

    def _systems(self, number, first, lines):
        self.part = lines[1].strip()
        for at in range(2, len(lines), 6):
            label, kind = (int(word) for word in lines[at].split()[:2])
            if kind not in (_CARTESIAN, _CYLINDRICAL, _SPHERICAL):
                raise self._fault(first + at, f"coordinate system {label} is of type {kind}, which is not known")
            matrix = parse_numbers(" ".join(lines[at + 2:at + 6]), float)
            if len(matrix) != 12:
                raise ValueError(f"coordinate system {label} has not 4 rows of 3 numbers")
            self.systems[label] = (kind, matrix.reshape(4, 3))

    def _units(self, number, first, lines):
        self.factor = real(lines[1].split()[0])
        self.unit_name = " ".join(lines[0][10:30].split())
        if not 0.0 < self.factor < np.inf:
            raise ValueError(f"a unit of length of {self.factor}")

    def _groups(self, number, first, lines):
        """Head with the count of members at its end, name, members: kind, label and what is passed over."""
        at = 0
        while at < len(lines):
            head = lines[at].split()
            count, name = int(head[-1]), lines[at + 1].strip() if at + 1 < len(lines) else ""
            n_lines = (count + 1) // 2
            if count < 0 or at + 2 + n_lines > len(lines):
                raise self._fault(first + at, f"group {name!r} has {count} members, which do not follow")
            entries = parse_numbers(" ".join(lines[at + 2:at + 2 + n_lines]), np.int64)
            if len(entries) % count if count else len(entries):
                raise self._fault(first + at, f"group {name!r}: its members are cut short")
            entries = entries.reshape(count, -1) if count else np.zeros((0, 4), np.int64)
            for kind in (_GROUPED_NODES, _GROUPED_ELEMENTS):
                self.named.append((name, kind, entries[entries[:, 0] == kind, 1]))
            at += 2 + n_lines

    # ---- the whole

    def contents(self):
        if not self.ids or not self.listed:
            raise ToolError(f"{self.path}: no nodes (datasets 15, 781, 2411) or no elements of a body (780, 2412)",
                            FaultCode.FILE_FORMAT)
        nodes, cells, elements = Labels(np.concatenate(self.ids)), {}, {}
        for kind, (own, rows) in self.listed.items():
            try:
                cells[kind], elements[kind] = nodes.rows_of(np.array(rows).astype(np.int64)), Labels(own)
            except (ValueError, OverflowError) as error:
                raise ToolError(f"{self.path}: an element of kind {kind} names a node that is not defined: {error}",
                                FaultCode.FILE_FORMAT) from error
        places, told = self._scaled(self._placed()), self.factor is not None and self.part != _SMESH
        return Contents(places, cells, list(self._group_rows(nodes, elements)), self.notes, self.counts, told)

    def _placed(self):
        """Places in the whole, of nodes in coordinate systems of their own."""
        places, of = np.vstack(self.places), np.concatenate(self.systems_of)
        for label, (kind, matrix) in self.systems.items():
            rows = np.flatnonzero(of == label)
            if not len(rows) or (kind == _CARTESIAN and np.array_equal(matrix, np.eye(4)[:, :3])):
                continue
            # rows of the matrix: the axes, then the origin
            places[rows] = _cartesian(kind, places[rows]) @ matrix[:3] + matrix[3]
            self.notes.append(f"{len(rows)} nodes converted from coordinate system {label} of the file")
        return places

    def _scaled(self, places):
        """Lengths in mm: those of the file divided by its factor are metres (dataset 164)."""
        if self.factor is None or np.isclose(self.factor, 1000.0):
            return places
        if self.part == _SMESH:
            self.notes.append("the file says metres, as SMESH (FreeCAD, Salome) writes whatever the lengths are: "
                              "taken as mm; "
                              "--unit m if they are metres")
            return places
        self.notes.append(f"units: lengths converted from {self.unit_name or 'the units of the file'} to mm, times "
                          f"{1000.0 / self.factor:.6g}")
        return places * (1000.0 / self.factor)

    def _group_rows(self, nodes, elements):
        """The groups, by kinds; members that are not there are left out."""
        for name, kind, members in self.named:
            if kind == _GROUPED_NODES and len(members):
                yield Group(name, NODES, nodes.known(members))
            elif len(members):
                for cells, labels in elements.items():
                    rows = labels.known(members)
                    if len(rows):
                        yield Group(name, cells, rows)


def _cartesian(kind, values):
    """x, y, z of r, angle, z (cylindrical) or r, angle from z, angle about z (spherical), degrees."""
    if kind == _CARTESIAN:
        return values
    first, second = values[:, 0], np.radians(values[:, 1])
    if kind == _CYLINDRICAL:
        return np.column_stack([first * np.cos(second), first * np.sin(second), values[:, 2]])
    around = np.radians(values[:, 2])
    return np.column_stack([first * np.sin(second) * np.cos(around), first * np.sin(second) * np.sin(around),
                            first * np.cos(second)])

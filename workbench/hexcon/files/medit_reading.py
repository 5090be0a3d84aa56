# SPDX-License-Identifier: LGPL-2.1-or-later
"""A reader of Medit's .mesh (ASCII), in any layout and version.

Ours, because meshio wants keyword and number in certain lines and knows versions 1 and 2 only, and gmsh wants version 1
or 2, and certain lines, too. Format: Frey, MEDIT, INRIA technical report 0253, section 7.
"""
import numpy as np

from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.node_orders import HEX20, HEX27_GMSH, places_of

from .contents import Contents, Group
from .text import parse_numbers

# keyword -> (kind by meshio's names, corners); each has a reference number behind it
_CELLS = {"vertices": None, "edges": ("line", 2), "edgesp2": ("line", 2), "triangles": ("triangle", 3),
          "trianglesp2": ("triangle", 3), "quadrilaterals": ("quad", 4), "tetrahedra": ("tetra", 4),
          "tetrahedrons": ("tetra", 4), "hexahedra": ("hexahedron", 8),
          "hexaedra": ("hexahedron", 8), "hexahedrons": ("hexahedron", 8),
          "prisms": ("wedge", 6), "pentahedra": ("wedge", 6), "pyramids": ("pyramid", 5)}
# What gmsh writes at order 2 (4.15: edges as EdgesP2): (kind, nodes) -> kind, and places of VTK's nodes among gmsh's.
_SECOND = {("line", 3): ("line3", range(3)), ("triangle", 6): ("triangle6", range(6)),
           ("quad", 8): ("quad8", range(8)), ("quad", 9): ("quad9", range(9)),
           ("hexahedron", 20): ("hexahedron20", places_of(HEX20["gmsh, files of .msh"])),
           ("hexahedron", 27): ("hexahedron27", places_of(HEX27_GMSH))}
# keyword -> numbers in each row, of what is passed over; None: as many as the space has dimensions
_OTHERS = {"corners": 1, "requiredvertices": 1, "ridges": 1, "requirededges": 1, "requiredtriangles": 1,
           "requiredquadrilaterals": 1, "normals": None, "tangents": None, "normalatvertices": 2,
           "tangentatvertices": 2, "normalattrianglevertices": 3, "normalatquadrilateralvertices": 3,
           "tangentatedges": 3}
_SINGLE = ("meshversionformatted", "dimension")
_MOST_GROUPS = 1000


def read_medit(path):
    """Contents; the reference numbers of quads, if there are several, are groups "ref 1", "ref 2" ...

    Raises ToolError FILE_FORMAT: binary, cut short, a keyword that is not known and may be part of the mesh."""
    with open(path, "rb") as stream:
        data = stream.read()
    if data[:4] in (b"\x01\0\0\0", b"\0\0\0\x01"):
        raise ToolError(f"{path} is binary (.meshb): save it as ASCII", FaultCode.FILE_FORMAT)
    words = [line.split("#", 1)[0] for line in data.decode("latin-1").replace("\r", "\n").split("\n")]
    return _Medit(path, " ".join(words).split()).contents()


class _Medit:
    def __init__(self, path, words):
        self.path, self.words, self.at, self.dimension = path, words, 0, 3
        self.points, self.cells, self.references = None, {}, {}

    def fault(self, words):
        return ToolError(f"{self.path}: {words}", FaultCode.FILE_FORMAT)

    def contents(self):
        if not self.words or self.words[0].lower() != "meshversionformatted":
            raise self.fault("it does not begin with MeshVersionFormatted: no Medit file")
        while self.at < len(self.words):
            self.shown = self.words[self.at]
            keyword = self.shown.lower()
            self.at += 1
            if keyword == "end":
                break
            self._take(keyword)
        if self.points is None or not self.cells:
            raise self.fault("there are no Vertices, or no elements, in it")
        groups = []
        for kind, references in self.references.items():
            found = np.unique(references)
            if kind.startswith("quad") and 1 < len(found) <= _MOST_GROUPS:
                groups += [Group(f"ref {number}", kind, np.flatnonzero(references == number))
                           for number in found.tolist()]
        return Contents(self.points, self.cells, groups)

    def _take(self, keyword):
        if keyword in _SINGLE:
            value = self._whole()
            if keyword == "dimension":
                if value not in (2, 3):
                    raise self.fault(f"Dimension {value}; 2 or 3 is possible")
                self.dimension = value
        elif keyword == "vertices":
            rows = self._rows(self.dimension + 1, float)
            self.points = np.zeros((len(rows), 3))
            self.points[:, :self.dimension] = rows[:, :-1]
        elif keyword in _CELLS:
            self._elements(*_CELLS[keyword])
        elif keyword in _OTHERS:
            self._rows(_OTHERS[keyword] or self.dimension, float)
        else:
            raise self.fault(f"keyword {self.shown!r} is not known, and may be a part of the mesh")

    def _elements(self, kind, corners):
        """Corners and a reference in each row; gmsh writes elements of order 2 under the same keywords, with more
        nodes."""
        nodes = self._width() - 1
        kind, places = (kind, range(corners)) if nodes in (-1, corners) else _SECOND.get((kind, nodes), (kind, None))
        if places is None:
            raise self.fault(f"{self.shown}: rows of {nodes} nodes and a reference; {corners} nodes are possible")
        rows = self._rows(len(places) + 1, np.int64)
        if len(rows):
            before = self.cells.get(kind, np.zeros((0, len(places)), np.int64))
            self.cells[kind] = np.vstack([before, rows[:, list(places)] - 1])
            self.references[kind] = np.concatenate([self.references.get(kind, np.zeros(0, np.int64)), rows[:, -1]])

    def _width(self):
        """Numbers in a row, by all up to the next keyword; 0 where they are not the same many in each."""
        count = int(self.words[self.at]) if self.at < len(self.words) and self.words[self.at].isdigit() else 0
        end = start = self.at + 1
        while end < len(self.words) and not self.words[end][0].isalpha():
            end += 1
        return (end - start) // count if count and (end - start) % count == 0 else 0

    def _whole(self):
        try:
            self.at += 1
            return int(self.words[self.at - 1])
        except (ValueError, IndexError) as error:
            raise self.fault(f"{self.shown} has no whole number behind it") from error

    def _rows(self, width, kind):
        """(n, width) numbers behind a keyword and their count."""
        count = self._whole()
        if not 0 <= count <= len(self.words) // max(width, 1):
            raise self.fault(f"{self.shown}: {count} rows cannot be in a file of {len(self.words)} words")
        end = self.at + count * width
        if end > len(self.words):
            raise self.fault(f"{self.shown}: {count} rows of {width} numbers are needed; the file ends before")
        try:
            found = parse_numbers(" ".join(self.words[self.at:end]), kind)
        except ValueError as error:
            raise self.fault(f"{self.shown}: a row holds what is no number") from error
        if len(found) != count * width:
            raise self.fault(f"{self.shown}: {count} rows of {width} numbers are needed")
        self.at = end
        return found.reshape(count, width)

# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a VTK file is as long as it says: VTK dies of one that was cut short, or leaves out what is missing.

Legacy files: "VTK File Formats", VTK User's Guide, and version 5.1 of vtk.org's "vtk_legacy_file_format". What is not
in that text ends the check, not the reading.
"""
import contextlib
import itertools
import mmap
import re

from .refusal import Refusal

_BYTES = {"char": 1, "unsigned_char": 1, "short": 2, "unsigned_short": 2, "int": 4, "unsigned_int": 4, "long": 8,
          "unsigned_long": 8, "float": 4, "double": 8, "vtkidtype": 4, "vtktypeint64": 8, "vtktypeuint64": 8}
_LISTS = ("CELLS", "POLYGONS", "LINES", "VERTICES", "TRIANGLE_STRIPS")
_PER_TUPLE = {"VECTORS": 3, "NORMALS": 3, "TENSORS": 9, "TENSORS6": 6, "GLOBAL_IDS": 1, "PEDIGREE_IDS": 1,
              "EDGE_FLAGS": 1}
_WORDS_ALONE = {"DIMENSIONS": 3, "ORIGIN": 3, "SPACING": 3, "ASPECT_RATIO": 3}
_NEEDED = {"UNSTRUCTURED_GRID": ("POINTS", "CELLS", "CELL_TYPES"), "STRUCTURED_GRID": ("POINTS",),
           "RECTILINEAR_GRID": ("X_COORDINATES", "Y_COORDINATES", "Z_COORDINATES"), "POLYDATA": ("POINTS",)}
_WORD = re.compile(rb"\S+")
_PIECE = 1 << 20        # bytes that are cut into words at once


class _Unknown(Exception):
    """Something that the format's text does not have."""


def check_legacy(path):
    """Raise Refusal where a section of a legacy file has fewer numbers than it says. One pass over the bytes."""
    with open(path, "rb") as stream, mmap.mmap(stream.fileno(), 0, access=mmap.ACCESS_READ) as data:
        with contextlib.suppress(_Unknown, ValueError, KeyError):
            sections = _Sections(data)
            with contextlib.suppress(_Unknown, ValueError, KeyError):
                sections.go_through()
            sections.check_all_there()


def check_xml(path):
    """Raise Refusal where the last element of a .vtu (.vtp, ...) does not close."""
    with open(path, "rb") as stream:
        size = stream.seek(0, 2)
        stream.seek(max(0, size - 4096))
        if b"</VTKFile>" not in stream.read():
            raise Refusal("FILE_FORMAT", f"the file is cut short: it ends at byte {size} without </VTKFile>")


class _Sections:
    def __init__(self, data):
        self.data, self.at, self.tuples, self.needed = data, 0, 0, []
        head = [self._line() for _ in range(3)]
        self.old = float(head[0].split()[-1]) < 5.0
        self.binary = head[2].strip().upper() == b"BINARY"

    def go_through(self):
        while True:
            word = self._word().upper()
            if not word:
                return
            self._section(word)
            self.needed = [other for other in self.needed if other != word]

    def check_all_there(self):
        """Raise Refusal where the file has come to its end before a section that its kind needs."""
        if self.needed and self.at == len(self.data):
            raise Refusal("FILE_FORMAT", f"the file is cut short: it ends before or in {self.needed[0]} "
                                         f"(byte {self.at}{self._line_told()})")

    def _section(self, word):
        if word == "DATASET":
            self.needed = list(_NEEDED.get(self._word().upper(), ()))
        elif word in _WORDS_ALONE:
            for _ in range(_WORDS_ALONE[word]):
                self._word()
        elif word == "POINTS" or word.endswith("_COORDINATES") and word != "TEXTURE_COORDINATES":
            self._numbers(word, int(self._word()) * (3 if word == "POINTS" else 1), self._word())
        elif word in _LISTS:
            self._list(word, int(self._word()), int(self._word()))
        elif word == "CELL_TYPES":
            self._numbers(word, int(self._word()), "int")
        elif word == "METADATA":
            while self._line().strip():
                pass
        elif word in ("CELL_DATA", "POINT_DATA"):
            self.tuples = int(self._word())
        else:
            self._data(word)

    def _list(self, word, first, second):
        if self.old:
            self._numbers(word, second, "int")
            return
        for part, count in (("OFFSETS", first), ("CONNECTIVITY", second)):
            if self._word().upper() != part:
                raise _Unknown
            self._numbers(f"{word}, {part}", count, self._word())

    def _data(self, word):
        """What belongs to points or cells."""
        if word == "FIELD":
            self._word()
            for _ in range(int(self._word())):
                name, width, count = self._word(), int(self._word()), int(self._word())
                self._numbers(f"array {name}", width * count, self._word())
        elif word == "SCALARS":
            name, kind, width = self._word(), self._word(), self._word()
            if width.isdigit():
                self._word()
            self._word()        # LOOKUP_TABLE and its name
            self._numbers(f"SCALARS {name}", self.tuples * (int(width) if width.isdigit() else 1), kind)
        elif word in _PER_TUPLE:
            name = self._word()
            self._numbers(f"{word} {name}", self.tuples * _PER_TUPLE[word], self._word())
        else:
            raise _Unknown

    def _line(self):
        end = self.data.find(b"\n", self.at)
        end = len(self.data) if end < 0 else end
        found, self.at = self.data[self.at:end], min(end + 1, len(self.data))
        if not found and self.at == len(self.data):
            raise _Unknown      # the end
        return found

    def _word(self):
        found = _WORD.search(self.data, self.at)
        self.at = found.end() if found else len(self.data)
        return found.group().decode("latin-1") if found else ""

    def _numbers(self, what, count, kind):
        """Go behind the numbers of a section, whose first line has been read."""
        if self.binary:
            self._line()
            size = _BYTES[kind.lower()]
            if count * size > len(self.data) - self.at:
                self._cut_short(what, count, (len(self.data) - self.at) // size)
            self.at += count * size
        else:
            self._words(what, count)

    def _words(self, what, count):
        left = count
        while left > 0:
            piece = self.data[self.at:self.at + _PIECE]
            if not piece:
                self._cut_short(what, count, count - left)
            if self.at + len(piece) < len(self.data):       # the last word may go on
                piece = piece[:max(piece.rfind(b" "), piece.rfind(b"\n")) + 1] or piece
            words = len(piece.split())
            if words > left:
                self.at += next(itertools.islice(_WORD.finditer(piece), left - 1, None)).end()
                return
            left, self.at = left - words, self.at + len(piece)

    def _cut_short(self, what, count, there):
        raise Refusal("FILE_FORMAT", f"the file is cut short: {what} needs {count} numbers, and the file ends after "
                                     f"{there} of them (byte {len(self.data)}{self._line_told()})")

    def _line_told(self):
        return "" if self.binary else f", line {self.data[:].count(bytes([10])) + 1}"

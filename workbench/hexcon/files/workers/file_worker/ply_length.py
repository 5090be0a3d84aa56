# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a .ply file is as long as its header says: VTK's reader dies of one that was cut short.

Turk, "The PLY polygon file format", 1994.
"""
import mmap
import shutil

import numpy as np

from .refusal import Refusal

_TYPES = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4", "float": "f4",
          "double": "f8", "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4",
          "float32": "f4", "float64": "f8"}
_END = b"end_header"


def check_ply(path):
    """Raise Refusal where an element has fewer rows than the header says; what that misses is left to VTK."""
    with open(path, "rb") as stream, mmap.mmap(stream.fileno(), 0, access=mmap.ACCESS_READ) as data:
        end = data.find(_END)
        if end < 0:
            raise Refusal("FILE_FORMAT", f"the file is cut short: it ends at byte {len(data)} without end_header")
        try:
            form, elements = _header(data[:end].decode("latin-1"))
        except (ValueError, IndexError, KeyError):
            return
        begin = data.find(b"\n", end) + 1 or len(data)
        if form == "ascii":
            _check_lines(data, begin, elements)
        else:
            _check_bytes(data, begin, elements, "<" if form == "binary_little_endian" else ">")


def with_line_end(path):
    """The path, or that of a copy in this process's folder: VTK aborts where the last line has no end."""
    with open(path, "rb") as stream:
        stream.seek(-1, 2)
        if stream.read() == b"\n":
            return path
    copy = "ended.ply"
    shutil.copyfile(path, copy)
    with open(copy, "ab") as stream:
        stream.write(b"\n")
    return copy


def _header(text):
    """(format, [(name, rows, [type, or (type of the count, type of its numbers)])])."""
    form, elements = "", []
    for words in (line.split() for line in text.splitlines()):
        if words[:1] == ["format"]:
            form = words[1]
        elif words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:1] == ["property"]:
            elements[-1][2].append((_TYPES[words[2]], _TYPES[words[3]]) if words[1] == "list" else _TYPES[words[1]])
    return form, elements


def _cut_short(data, name, rows, there):
    raise Refusal("FILE_FORMAT", f"the file is cut short: element {name} needs {rows} rows, and the file ends after "
                                 f"{there} of them (byte {len(data)})")


def _check_lines(data, begin, elements):
    lines = [line for line in data[begin:].splitlines() if line.strip()]
    left = len(lines)
    for name, rows, properties in elements:
        whole = left > rows or left == rows and (not rows or len(lines[-1].split()) >= _words(lines[-1], properties))
        if not whole:
            _cut_short(data, name, rows, min(left, rows - 1))
        left -= rows


def _words(line, properties):
    """How many words a row of one list must have, by its first; of other rows their number of properties."""
    first = line.split()[0]
    is_list = len(properties) == 1 and isinstance(properties[0], tuple) and first.isdigit()
    return int(first) + 1 if is_list else len(properties)


def _check_bytes(data, begin, elements, order):
    at = begin
    for name, rows, properties in elements:
        width = _width(data, at, properties, order)
        if rows and (width is None or at + rows * width > len(data)):
            _cut_short(data, name, rows, 0 if width is None else (len(data) - at) // width)
        if any(isinstance(one, tuple) for one in properties) and not _even(data, at, rows, width, properties, order):
            return      # rows of several lengths: to go through them is VTK's work
        at += rows * (width or 0)


def _width(data, at, properties, order):
    """Bytes of the row that begins at this byte; None where the file ends in it."""
    begin = at
    for one in properties:
        if isinstance(one, tuple):
            kind = np.dtype(order + one[0])
            if at + kind.itemsize > len(data):
                return None
            count = int(np.frombuffer(data[at:at + kind.itemsize], kind)[0])
            at += kind.itemsize + max(count, 0) * np.dtype(one[1]).itemsize
        else:
            at += np.dtype(one).itemsize
    return at - begin


def _even(data, at, rows, width, properties, order):
    """Whether all rows begin with the same count, where a list is all that they have."""
    if len(properties) != 1:
        return False
    kind = np.dtype(order + properties[0][0])
    counts = np.frombuffer(data[at:at + rows * width], np.uint8).reshape(rows, width)[:, :kind.itemsize]
    return bool((counts == counts[:1]).all())

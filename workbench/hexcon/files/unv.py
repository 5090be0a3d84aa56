# SPDX-License-Identifier: LGPL-2.1-or-later
""".unv: I-DEAS universal file, datasets 2411 (nodes), 2412 (elements), 2467 (groups)."""
import re

import numpy as np

from hexcon.errors import FaultCode, ToolError
from hexcon.labels import rows_of

from .text import parse_numbers, write_numbered

# Element kinds: solid brick 115 / 116, thin shell quad 94 / 95 (linear / parabolic).
# Linear bricks have VTK's order; parabolic ones go round: corner, middle, corner, ...
_HEX_KIND = {1: 115, 2: 116}
_QUAD_KIND = {1: 94, 2: 95}
_NODES = {115: 8, 116: 20, 94: 4, 95: 8}
UNV_HEX = {1: list(range(8)),
           2: [0, 8, 1, 9, 2, 10, 3, 11, 16, 17, 18, 19, 4, 12, 5, 13, 6, 14, 7, 15]}
UNV_QUAD = {1: [0, 1, 2, 3], 2: [0, 4, 1, 5, 2, 6, 3, 7]}


def _element_row(kind, size):
    """%-format of one element: number, kind, property, material, colour, node count."""
    full, rest = divmod(size, 8)
    lines = ("%10d" * 8 + "\n") * full + ("%10d" * rest + "\n" if rest else "")
    return f"%10d{kind:10d}         1         1         7{size:10d}\n" + lines


def _group(stream, number, name, kind, ids):
    """One group of dataset 2467; kind 7 is nodes, 8 is elements."""
    stream.write(f"{number:10d}" + f"{0:10d}" * 6 + f"{len(ids):10d}\n{name}\n")
    entries = [f"{kind:10d}{i:10d}{0:10d}{0:10d}" for i in ids.tolist()]
    for k in range(0, len(entries), 2):
        stream.write("".join(entries[k:k + 2]) + "\n")


def write(path, elements):
    """Hexahedra 1..H, boundary quads H+1..H+n; groups "Face3" of quads, one per CAD face."""
    order = elements.order
    first_quad = len(elements.hexes) + 1
    with open(path, "w", encoding="ascii") as stream:
        stream.write("    -1\n  2411\n")
        write_numbered(stream, "%10d         1         1        11\n%25.16E%25.16E%25.16E\n",
                       elements.points)
        stream.write("    -1\n    -1\n  2412\n")
        hexes = elements.hexes[:, UNV_HEX[order]] + 1
        write_numbered(stream, _element_row(_HEX_KIND[order], hexes.shape[1]), hexes)
        quads = elements.quads[:, UNV_QUAD[order]] + 1
        write_numbered(stream, _element_row(_QUAD_KIND[order], quads.shape[1]), quads,
                       first=first_quad)
        stream.write("    -1\n")
        if elements.face_numbers():
            stream.write("    -1\n  2467\n")
            for k, number in enumerate(elements.face_numbers(), 1):
                _group(stream, k, f"Face{number}", 8,
                       elements.quads_of_face(number) + first_quad)
            stream.write("    -1\n")


def _datasets(path):
    """{number: token lines} of the file; several datasets of one number are joined."""
    with open(path, encoding="latin-1") as stream:
        lines = stream.read().splitlines()
    marks = [k for k, line in enumerate(lines) if line.strip() == "-1"]
    found = {}
    for start, end in zip(marks[::2], marks[1::2]):
        if end > start + 1:
            number = "".join(lines[start + 1].split()[:1])
            found.setdefault(number, []).extend(lines[start + 2:end])
    return found


def read(path):
    """(points, hexes, faces) of solid bricks 115 or 116, VTK order; see abaqus.read.

    Raises ToolError(FILE_FORMAT) for other solids or none."""
    sets = _datasets(path)
    nodes = sets.get("2411") or sets.get("781")
    if not nodes or "2412" not in sets:
        raise ToolError(f"{path}: no datasets 2411 and 2412 of nodes and elements",
                        FaultCode.FILE_FORMAT)
    ids = np.array([int(line[:10]) for line in nodes[::2]])
    points = parse_numbers(" ".join(nodes[1::2]), float).reshape(-1, 3)
    hexes, quads = _bricks_and_quads(sets["2412"], path)
    faces = _faces(sets.get("2467", []), quads)
    return points, rows_of(ids, hexes), None if faces is None else (rows_of(ids, faces[0]), faces[1])


def _bricks_and_quads(lines, path):
    """((H,8|20) node numbers, VTK order; {quad's number: its four corners})."""
    bricks, quads, k = {1: [], 2: []}, {}, 0
    while k < len(lines):
        head = lines[k].split()
        kind, size = int(head[1]), int(head[5])
        # beams carry a line of orientation before their nodes
        n_lines = (size + 7) // 8 + (1 if kind in (11, 21, 22, 23, 24) else 0)
        if size < 1 or k + n_lines >= len(lines) or size != _NODES.get(kind, size):
            raise ToolError(f"{path}: element {head[0]} (kind {kind}) has {size} nodes, or ends with the file",
                            FaultCode.FILE_FORMAT)
        if kind in (115, 116):
            bricks[kind - 114].extend(lines[k + 1:k + 1 + n_lines])
        elif kind in (94, 95):
            quads[int(head[0])] = [int(n) for n in lines[k + 1].split()[::kind - 93]]
        elif kind in (111, 112, 113, 118):
            raise ToolError(f"{path}: element {head[0]} (kind {kind}) is no hexahedron",
                            FaultCode.FILE_FORMAT)
        k += 1 + n_lines
    if bool(bricks[1]) == bool(bricks[2]):
        raise ToolError(f"{path}: hexahedra of both orders, or none", FaultCode.FILE_FORMAT)
    order = 1 if bricks[1] else 2
    listed = parse_numbers(" ".join(bricks[order]), np.int64)
    listed = listed.reshape(-1, len(UNV_HEX[order]))
    hexes = np.empty_like(listed)
    hexes[:, UNV_HEX[order]] = listed
    return hexes, quads


def _faces(lines, quads):
    """(quads (k,4) node numbers, CAD face numbers (k,)) of the groups Face<number>."""
    corners, numbers, k = [], [], 0
    while k + 1 < len(lines):
        count, name = int(lines[k].split()[-1]), lines[k + 1].strip()
        n_lines = (count + 1) // 2
        if count < 0 or k + 1 + n_lines >= len(lines):
            raise ValueError(f"group {name!r} of dataset 2467 has {count} members, which do not follow")
        entries = np.array(" ".join(lines[k + 2:k + 2 + n_lines]).split()).astype(int)
        if re.match(r"^Face\d{1,9}$", name):
            members = [i for kind, i in entries.reshape(-1, 4)[:, :2].tolist()
                       if kind == 8 and i in quads]
            corners += [quads[i] for i in members]
            numbers += [int(name[4:])] * len(members)
        k += 2 + n_lines
    return (np.array(corners), np.array(numbers)) if corners else None

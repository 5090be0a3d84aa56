# SPDX-License-Identifier: LGPL-2.1-or-later
""".inp: CalculiX and Abaqus mesh input. C3D8 and C3D20 have VTK's node order there.

C3D8I is never written: it fails the patch test on any hexahedron that is not a
parallelepiped (stress error 19 % at scaled Jacobian 0.66, measured with ccx 2.20).
"""
import re

import numpy as np

from hexcon.errors import FaultCode, ToolError
from hexcon.femmesh.hexahedron import FACES
from hexcon.labels import rows_of

from .text import parse_numbers, write_list, write_numbered, write_rows

STEEL_YOUNG, STEEL_POISSON, STEEL_DENSITY = 210000, 0.3, 7.9e-9     # N, mm, MPa, tonne
STEEL = f"*MATERIAL, NAME=STEEL\n*ELASTIC\n{STEEL_YOUNG}, {STEEL_POISSON}\n*DENSITY\n7.9e-9\n"


def _field(value):
    """A float in the at most 20 characters that ccx reads, exact where they suffice."""
    text = repr(value)
    if len(text) <= 20:
        return text
    return "%.13e" % value if abs(value) > 1e-99 else "0.0"


def write_mesh(stream, elements):
    """*NODE, *ELEMENT, one *NSET and one *SURFACE per CAD face.

    Names: NALL, EALL, FACE3_NODES, FACE3. Node and element numbers are rows + 1. A comment says
    so where the mesh is topological.
    """
    if elements.topological:
        stream.write("** TOPOLOGICAL: topology only, some Jacobians are zero or negative; not for "
                     "solving\n")
    stream.write("*NODE, NSET=NALL\n")
    text = np.array([_field(x) for x in elements.points.ravel().tolist()], object)
    write_numbered(stream, "%d, %s, %s, %s\n", text.reshape(-1, 3))
    kind = "C3D20" if elements.order == 2 else "C3D8"
    stream.write(f"*ELEMENT, TYPE={kind}, ELSET=EALL\n")
    # ccx takes at most 16 entries a line: a 20-node element needs two
    row = ("%d" + ", %d" * 8 if elements.order == 1
           else "%d" + ", %d" * 15 + ",\n" + ", ".join(["%d"] * 5)) + "\n"
    write_numbered(stream, row, elements.hexes + 1)
    for number in elements.face_numbers():
        stream.write(f"*NSET, NSET=FACE{number}_NODES\n")
        write_list(stream, elements.nodes_of_face(number) + 1)
    for number in elements.face_numbers():
        rows = elements.quads_of_face(number)
        stream.write(f"*SURFACE, NAME=FACE{number}, TYPE=ELEMENT\n")
        write_rows(stream, "%d, S%d\n", np.column_stack(
            [elements.hex_of_quad[rows] + 1, elements.side_of_quad[rows] + 1]))


def write(path, elements):
    """The mesh with a default material (steel, N and mm): add a step and ccx runs it."""
    names = [f"FACE{n}" for n in elements.face_numbers()]
    with open(path, "w", encoding="ascii") as stream:
        stream.write("** Hex mesh by HexCon; CalculiX / Abaqus, lengths in mm\n")
        if names:
            stream.write("** node sets " + names[0] + "_NODES ..., surfaces "
                         + names[0] + " ... : one per CAD face\n")
        write_mesh(stream, elements)
        stream.write("** Default material (steel; N, mm, MPa, tonne): replace as needed.\n")
        stream.write(STEEL + "*SOLID SECTION, ELSET=EALL, MATERIAL=STEEL\n")
        stream.write("** To solve, add for example:\n** *BOUNDARY\n** FACE1_NODES, 1, 3, 0\n"
                     "** *STEP\n** *STATIC\n** *DSLOAD\n** FACE2, P, 1.0\n** *NODE FILE\n"
                     "** U\n** *EL FILE\n** S\n** *END STEP\n")


def _blocks(path):
    """(keyword, parameters dict, data text) of each card; *INCLUDE is not followed."""
    with open(path, encoding="utf-8", errors="replace") as stream:
        text = stream.read()
    text = re.sub(r"(?m)^\*\*.*\n?", "", text)
    for card in re.split(r"(?m)^(?=\*)", text):
        if not card.startswith("*"):
            continue
        lines, last = card.split("\n"), 0
        while lines[last].rstrip().endswith(",") and last + 1 < len(lines):
            last += 1   # a card may continue on the next line
        head, data = "".join(line.rstrip() for line in lines[:last + 1]), "\n".join(lines[last + 1:])
        words = [w.strip().upper() for w in head[1:].split(",")]
        parameters = dict((w + "=").split("=")[:2] for w in words[1:])
        yield words[0], {k.strip(): v.strip() for k, v in parameters.items()}, data


def _numbers(data, width, what):
    """(rows, width) int64 of comma-separated data whose rows may run over several lines."""
    numbers = parse_numbers(data, np.int64)
    if len(numbers) % width:
        raise ToolError(f"{what}: {len(numbers)} numbers are no multiple of {width}",
                        FaultCode.FILE_FORMAT)
    return numbers.reshape(-1, width)


def _node_rows(data):
    """(n,4) float64: number, x, y, z; coordinates that are left out are 0."""
    lines = [line for line in data.splitlines() if line.strip()]
    if all(line.count(",") == 3 for line in lines) and ",\n" not in data.replace(" ", ""):
        return parse_numbers(data, float).reshape(-1, 4)
    rows = [[field.strip() or "0" for field in (line.split(",") + ["0"] * 3)[:4]]
            for line in lines]
    return parse_numbers(" ".join(" ".join(row) for row in rows), float).reshape(-1, 4)


def read(path):
    """(points (P,3), hexes (H,8|20), faces) of C3D8 / C3D20 elements (also R, I variants).

    faces: (quads (k,4), CAD face numbers (k,)) of the surfaces called FACE<number>, or None.
    Raises ToolError(FILE_FORMAT) for other solid elements or none at all."""
    nodes, hexes, others, surfaces = [], [], set(), []
    for keyword, parameters, data in _blocks(path):
        if keyword == "NODE":
            nodes.append(_node_rows(data))
        elif keyword == "ELEMENT":
            kind = parameters.get("TYPE", "")
            match = re.match(r"^(?:F?C3D|DC3D)(8|20)[A-Z]*$", kind)
            if match:
                hexes.append(_numbers(data, int(match.group(1)) + 1, kind))
            elif "3D" in kind:
                others.add(kind)
        elif keyword == "SURFACE" and re.match(r"^FACE\d{1,9}$", parameters.get("NAME", "")):
            surfaces.append((int(parameters["NAME"][4:]), data))
    if others:
        raise ToolError(f"{path}: elements {', '.join(sorted(others))} are no hexahedra",
                        FaultCode.FILE_FORMAT)
    if not nodes or not hexes or len({h.shape[1] for h in hexes}) != 1:
        raise ToolError(f"{path}: no *NODE and *ELEMENT blocks of C3D8 or of C3D20",
                        FaultCode.FILE_FORMAT)
    nodes, hexes = np.vstack(nodes), np.vstack(hexes)
    rows = _rows_of_ids(_node_numbers(nodes[:, 0], path), hexes[:, 1:], path, "nodes")
    return nodes[:, 1:], rows, _faces(surfaces, hexes[:, 0], rows, path)


def _faces(surfaces, element_ids, hexes, path):
    """(quads, numbers) of "element, S<k>" lines; lines that name a set are passed over."""
    quads, numbers = [np.zeros((0, 4), np.int64)], [np.zeros(0, np.int64)]
    for number, data in surfaces:
        found = re.findall(r"(?m)^\s*(\d+)\s*,\s*[sS]([1-6])", data)
        if found:
            ids, sides = np.array(found).astype(np.int64).T
            rows = _rows_of_ids(element_ids, ids, path, "elements")
            quads.append(hexes[rows[:, None], FACES[sides - 1]])
            numbers.append(np.full(len(ids), number))
    return (np.vstack(quads), np.concatenate(numbers)) if len(quads) > 1 else None


def _node_numbers(numbers, path):
    """(n,) int64 of numbers read as floats."""
    if not (np.abs(numbers) < 2.0 ** 53).all() or (numbers != np.rint(numbers)).any():
        raise ToolError(f"{path}: a *NODE line does not begin with a whole number", FaultCode.FILE_FORMAT)
    return numbers.astype(np.int64)


def _rows_of_ids(ids, wanted, path, what):
    """Row of each wanted number; the last definition of a number counts."""
    try:
        return rows_of(ids, wanted)
    except ValueError as error:
        raise ToolError(f"{path} names {what} that are not defined: {error}", FaultCode.FILE_FORMAT) from error

# SPDX-License-Identifier: LGPL-2.1-or-later
"""A reader for the part of I-DEAS universal files that holds a mesh: datasets 2411 and 2412."""
import numpy as np

from .cell_kinds import CORNERS

# descriptor -> (kind, positions of the corners among the element's nodes)
_LINEAR = {41: "triangle", 91: "triangle", 44: "quad", 94: "quad", 111: "tetra", 112: "wedge", 115: "hexahedron",
           114: "pyramid"}
_SECOND = {42: ("triangle", (0, 2, 4)), 92: ("triangle", (0, 2, 4)), 45: ("quad", (0, 2, 4, 6)),
           95: ("quad", (0, 2, 4, 6)), 118: ("tetra", (0, 2, 4, 9)), 113: ("wedge", (0, 2, 4, 9, 11, 13)),
           116: ("hexahedron", (0, 2, 4, 6, 12, 14, 16, 18))}
_CORNERS_OF = {**{code: (kind, range(CORNERS[kind])) for code, kind in _LINEAR.items()}, **_SECOND}
_COUNT = {**{code: CORNERS[kind] for code, kind in _LINEAR.items()}, 42: 6, 92: 6, 45: 8, 95: 8, 118: 10, 113: 15,
          116: 20}
_BEAMS = (11, 21, 22, 23, 24)      # these have one more line


def read_unv(path):
    """(points (P,3), dict kind -> rows into points, whether second-order elements were cut to their corners).

    Raises ValueError where the file is not such a file.
    """
    nodes, elements = {}, []
    with open(path, encoding="ascii", errors="replace") as stream:
        for number, lines in _datasets(stream):
            if number == 2411:
                _read_nodes(lines, nodes)
            elif number == 2412:
                _read_elements(lines, elements)
    if not nodes or not elements:
        raise ValueError("no nodes (dataset 2411) or no elements (2412)")
    row = {label: k for k, label in enumerate(nodes)}
    parts, second = {}, False
    for descriptor, labels in elements:
        kind, corners = _CORNERS_OF[descriptor]
        if len(labels) != _COUNT[descriptor]:
            raise ValueError(f"an element of kind {descriptor} with {len(labels)} nodes")
        parts.setdefault(kind, []).append([row[labels[c]] for c in corners])
        second |= descriptor in _SECOND
    return np.array(list(nodes.values()), float).reshape(-1, 3), parts, second


def _datasets(stream):
    """(number, lines) of each dataset between two lines that hold -1 alone."""
    lines = None
    for line in stream:
        if line.strip() == "-1":
            if lines:
                yield int(lines[0]), lines[1:]
            lines = [] if lines is None else None
        elif lines is not None:
            lines.append(line)


def _read_nodes(lines, nodes):
    for head, place in zip(lines[::2], lines[1::2]):
        nodes[int(head.split()[0])] = [float(x.replace("D", "E").replace("d", "e")) for x in place.split()[:3]]


def _read_elements(lines, elements):
    at = 0
    while at < len(lines):
        head = [int(x) for x in lines[at].split()]
        descriptor, count = head[1], head[5]
        at += 2 if descriptor in _BEAMS else 1
        labels = []
        while len(labels) < count:
            labels += [int(x) for x in lines[at].split()]
            at += 1
        if descriptor in _CORNERS_OF:
            elements.append((descriptor, labels))

# SPDX-License-Identifier: LGPL-2.1-or-later
""".re2: the binary mesh of Nek5000 and NekRS, version 3: doubles, boundary conditions of one field.

The layout is what Nek5000's core/reader_re2.f reads: a header of 80 characters, the float 6.54321 that tells the byte
order, a record for each hex, then how many curved edges and their records, then how many boundary faces and theirs.
Its "preprocessor" order of corners and edges is VTK's; its faces count otherwise.
"""
import numpy as np

from hexcon.femmesh.second_order import curved_edges

from .text import ROWS_PER_BLOCK

NEK_FACE = np.array([5, 6, 1, 2, 3, 4])     # of the rows of hexahedron.FACES
BYTE_ORDER = 6.54321
RECORD = np.dtype([("element", "<f8"), ("place", "<f8"), ("values", "<f8", 5), ("kind", "S8")])
"""A curved edge: kind m, its middle point in values. A boundary face: kind EXO, its group's number in values[4]."""


def write(path, elements):
    """Corners, the middles of edges that are curved (kind m), and for every boundary face the number of its group.

    Groups are numbered as CAD faces are, faces on none get the next number: Elements.group_of_quad. Kind EXO says that
    the number stands for the boundary condition, which the solver's .par gives to it."""
    with open(path, "wb") as stream:
        stream.write(f"#v003{len(elements.hexes):9d}{3:3d}{len(elements.hexes):9d} by HexCon".ljust(80).encode("ascii"))
        stream.write(np.array([BYTE_ORDER], "<f4").tobytes())
        _write_corners(stream, elements)
        for records in (_curved(elements), _boundary(elements)):
            stream.write(np.array([len(records)], "<f8").tobytes())
            stream.write(records.tobytes())


def _write_corners(stream, elements):
    """Of each hex: a group that means nothing, then the x, the y and the z of its eight corners."""
    for start in range(0, len(elements.hexes), ROWS_PER_BLOCK):
        corners = elements.points[elements.hexes[start:start + ROWS_PER_BLOCK, :8]]
        rows = np.zeros((len(corners), 25), "<f8")
        rows[:, 1:] = corners.transpose(0, 2, 1).reshape(-1, 24)
        stream.write(rows.tobytes())


def _curved(elements):
    hexes, edges = np.nonzero(curved_edges(elements.points, elements.hexes))
    records = _records(hexes, edges + 1, b"m")
    records["values"][:, :3] = elements.points[elements.hexes[hexes, 8 + edges]] if len(hexes) else 0.0
    return records


def _boundary(elements):
    faces = NEK_FACE[elements.side_of_quad]
    order = np.lexsort((faces, elements.hex_of_quad))
    records = _records(elements.hex_of_quad[order], faces[order], b"EXO")
    records["values"][:, 4] = elements.group_of_quad()[order]
    return records


def _records(hexes, places, kind):
    """Empty records of hexes by their rows, and of places that count from 1."""
    records = np.zeros(len(hexes), RECORD)
    records["element"], records["place"], records["kind"] = hexes + 1, places, kind.ljust(8)
    return records

# SPDX-License-Identifier: LGPL-2.1-or-later
""".unv: I-DEAS universal file, datasets 2411 (nodes), 2412 (elements), 2467 (groups)."""
from hexcon.femmesh.node_orders import HEX20

from .text import write_numbered

# Element kinds: solid brick 115 / 116, thin shell quad 94 / 95 (linear / parabolic).
# Linear bricks have VTK's order; parabolic ones go round: corner, middle, corner, ...
_HEX_KIND = {1: 115, 2: 116}
_QUAD_KIND = {1: 94, 2: 95}
UNV_HEX = {1: list(range(8)), 2: HEX20["UNV 116"]}
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
    """Hexahedra 1..H, boundary quads H+1..H+n; groups of quads "Face3", one per CAD face, and by their
    names, groups of nodes by theirs."""
    order = elements.order
    first_quad = len(elements.hexes) + 1
    with open(path, "w", encoding="utf-8") as stream:
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
        groups = [(name, 8, rows + first_quad) for _, name, rows in elements.named()]
        groups += [(name, 7, elements.nodes_of_set(name) + 1) for name in elements.node_groups]
        if groups:
            stream.write("    -1\n  2467\n")
            for k, (name, kind, ids) in enumerate(groups, 1):
                _group(stream, k, name, kind, ids)
            stream.write("    -1\n")

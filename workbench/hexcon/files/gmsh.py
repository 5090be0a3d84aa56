# SPDX-License-Identifier: LGPL-2.1-or-later
""".msh: Gmsh's format 2.2 in ASCII, which every Gmsh and every reader takes."""
import numpy as np

from hexcon.femmesh.hexahedron import EDGES

from .text import write_numbered

# Gmsh's sequence of the 12 edges, as pairs of VTK corners (its corners are VTK's)
_GMSH_EDGES = [(0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3),
               (2, 6), (3, 7), (4, 5), (4, 7), (5, 6), (6, 7)]
_MIDDLE = {frozenset(edge): 8 + k for k, edge in enumerate(EDGES.tolist())}
GMSH_HEX = list(range(8)) + [_MIDDLE[frozenset(edge)] for edge in _GMSH_EDGES]

_HEX_TYPE = {1: 5, 2: 17}
_QUAD_TYPE = {1: 3, 2: 16}


def write(path, elements):
    """Physical volume "Solid" (1), physical surfaces "Face3" (3) one per CAD face.

    Quads without a CAD face form the physical surface "Boundary". Node i+1 is point i;
    the boundary quads come first, then the hexahedra.
    """
    unnamed = int(elements.face_of_quad.max(initial=0)) + 1
    faces = np.where(elements.face_of_quad > 0, elements.face_of_quad, unnamed)
    with open(path, "w", encoding="ascii") as stream:
        stream.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n")
        numbers = np.unique(faces).tolist()
        stream.write(f"{len(numbers) + 1}\n")
        for number in numbers:
            name = "Boundary" if number == unnamed else f"Face{number}"
            stream.write(f'2 {number} "{name}"\n')
        stream.write(f'3 1 "Solid"\n$EndPhysicalNames\n$Nodes\n{len(elements.points)}\n')
        write_numbered(stream, "%d %r %r %r\n", elements.points)
        n_quads, n_hexes = len(elements.quads), len(elements.hexes)
        stream.write(f"$EndNodes\n$Elements\n{n_quads + n_hexes}\n")
        quads = np.column_stack([faces, faces, elements.quads + 1])
        write_numbered(stream, f"%d {_QUAD_TYPE[elements.order]} 2"
                       + " %d" * quads.shape[1] + "\n", quads)
        hexes = elements.hexes[:, GMSH_HEX[:elements.hexes.shape[1]]] + 1
        write_numbered(stream, f"%d {_HEX_TYPE[elements.order]} 2 1 1"
                       + " %d" * hexes.shape[1] + "\n", hexes, first=n_quads + 1)
        stream.write("$EndElements\n")

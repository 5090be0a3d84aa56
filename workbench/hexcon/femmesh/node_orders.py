# SPDX-License-Identifier: LGPL-2.1-or-later
"""In which sequence programs list the 20 nodes of a second-order hex: one table for all readers and writers.

Entry k is the node of VTK_QUADRATIC_HEXAHEDRON that stands at the program's place k; the first 8 are the corners, whose
sequence of first order is the same. Here, in the core and in numpy arrays the order is VTK's.
"""

HEX20 = {
    "VTK": [*range(20)],
    "CalculiX, Abaqus": [*range(20)],       # C3D20, C3D20R
    "gmsh, files of .msh": [*range(8), 8, 11, 16, 9, 17, 10, 18, 19, 12, 15, 13, 14],       # element type 17
    "FreeCAD (SMESH)": [0, 3, 2, 1, 4, 7, 6, 5, 11, 10, 9, 8, 15, 14, 13, 12, 16, 19, 18, 17],     # the other way round
    "Exodus II": [*range(12), 16, 17, 18, 19, 12, 13, 14, 15],
    "Nastran CHEXA": [*range(12), 16, 17, 18, 19, 12, 13, 14, 15],      # bottom, uprights, top
    "UNV 116": [0, 8, 1, 9, 2, 10, 3, 11, 16, 17, 18, 19, 4, 12, 5, 13, 6, 14, 7, 15],     # corner, middle, corner ...
}

# The same of 27 nodes (VTK_TRIQUADRATIC_HEXAHEDRON), the last seven those of faces and of the hex; gmsh writes it as
# linear bricks into .unv, and into .mesh, too.
HEX27_GMSH = [*HEX20["gmsh, files of .msh"], 24, 22, 20, 21, 23, 25, 26]


def places_of(order):
    """Of a row of the table: at which of the program's places each of VTK's nodes stands, for readers."""
    return sorted(range(len(order)), key=order.__getitem__)

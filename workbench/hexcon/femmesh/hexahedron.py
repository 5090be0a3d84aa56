# SPDX-License-Identifier: LGPL-2.1-or-later
"""The hexahedron's tables, in VTK node order (VTK_HEXAHEDRON, VTK_QUADRATIC_HEXAHEDRON).

Abaqus and CalculiX number C3D8 and C3D20 in the same order, so the rows of FACES are also
CalculiX's element faces S1..S6 (row k is S<k+1> in *SURFACE and P<k+1> in *DLOAD).
"""
import numpy as np

# EDGES[k] are the ends of the edge whose middle node is node 8 + k of the 20.
EDGES = np.array(
    [(0, 1), (1, 2), (2, 3), (3, 0),
     (4, 5), (5, 6), (6, 7), (7, 4),
     (0, 4), (1, 5), (2, 6), (3, 7)])

# Counter-clockwise seen from outside a hexahedron of positive orientation.
FACES = np.array(
    [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4),
     (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)])


def _middle_nodes_of_faces():
    """(6,4) middle nodes (8..19) that follow FACES: entry j lies between corners j and j+1."""
    middle = {frozenset(edge): 8 + k for k, edge in enumerate(EDGES.tolist())}
    return np.array([[middle[frozenset((face[j], face[(j + 1) % 4]))] for j in range(4)]
                     for face in FACES.tolist()])


FACE_MIDDLES = _middle_nodes_of_faces()
FACES_8 = np.hstack([FACES, FACE_MIDDLES])  # (6,8), the order of VTK_QUADRATIC_QUAD

# For each corner its three neighbours, so that the triple product is positive.
CORNERS = np.array(
    [(1, 3, 4), (2, 0, 5), (3, 1, 6), (0, 2, 7),
     (7, 5, 0), (4, 6, 1), (5, 7, 2), (6, 4, 3)])

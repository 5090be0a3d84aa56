/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The hexahedron in VTK order: faces outward, edges, corner frames. */
#ifndef HEXCON_HEXMESH_HEX_TABLES_H
#define HEXCON_HEXMESH_HEX_TABLES_H

/** Corners of each face, counter-clockwise seen from outside. */
static const unsigned char hex_faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                              {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

/** Ends of each edge. */
static const unsigned char hex_edges[12][2] = {{0, 1}, {1, 2}, {3, 2}, {0, 3}, {4, 5}, {5, 6},
                                               {7, 6}, {4, 7}, {0, 4}, {1, 5}, {3, 7}, {2, 6}};

/** Neighbours of each corner, right-handed in a positive hex. */
static const unsigned char hex_corner_neighbours[8][3] = {
    {1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};

/** The other corners, seen from each: its three neighbours n, the diagonals of the faces through
 * neighbours n and n + 1, the opposite corner. */
static const unsigned char hex_corner_others[8][7] = {
    {1, 3, 4, 2, 7, 5, 6}, {2, 0, 5, 3, 4, 6, 7}, {3, 1, 6, 0, 5, 7, 4}, {0, 2, 7, 1, 6, 4, 5},
    {7, 5, 0, 6, 1, 3, 2}, {4, 6, 1, 7, 2, 0, 3}, {5, 7, 2, 4, 3, 1, 0}, {6, 4, 3, 5, 0, 2, 1}};

/** The face at each corner through its neighbours n and n + 1. */
static const unsigned char hex_corner_faces[8][3] = {{0, 5, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5},
                                                     {1, 2, 5}, {1, 3, 2}, {1, 4, 3}, {1, 5, 4}};

/** Steps from corner to corner as bits: 1 along the first axis, 2 the second, 4 the third. */
static const unsigned char hex_corner_bits[8] = {0, 1, 3, 2, 4, 5, 7, 6};

#endif

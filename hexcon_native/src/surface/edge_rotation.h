/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * Rotation of an edge in the hexagon of its two quads: it comes to join the next pair of opposite
 * corners, or the one before. Points and quads stay, the dual loops through the hexagon change
 * partners. Rotations lead from any quadrangulation of the sphere to any other with as many points
 * (Nakamoto, Diagonal transformations in quadrangulations of surfaces, 1996, who needs one more
 * operation in between).
 */
#ifndef HEXCON_SURFACE_EDGE_ROTATION_H
#define HEXCON_SURFACE_EDGE_ROTATION_H

#include "half_edges.h"

typedef struct edge_rotation {
  int32_t half_edge; /**< the edge, seen from one of its quads */
  uint8_t step;      /**< the new edge joins corners step and step + 3 of the hexagon: 1 or 2 */
} edge_rotation;

/** What a rotation overwrites. */
typedef struct rotation_undo {
  int32_t quads[2];   /**< the two quads of the hexagon */
  int32_t corners[8]; /**< of both */
  int32_t twins[8];   /**< of their half-edges */
} rotation_undo;

/** Corners of the hexagon about an edge, counter-clockwise from the edge's end: it joins corners 3
 * and 0. */
void rotation_hexagon(const surface *s, int32_t half_edge, int32_t corners[6]);

/** Number of quads about the point where a half-edge starts. Linear in it. */
size_t surface_degree(const surface *s, int32_t half_edge);

/**
 * Rotate an edge. The hexagon's first quad keeps the number of half_edge's, and the new edge is
 * side 3 of both.
 * @return false, and nothing is changed: a point would have fewer than three quads, an edge would
 * be double, or two quads would have two opposite corners in common. Linear in the quads about the
 * hexagon.
 */
bool surface_rotate(surface *s, edge_rotation r, rotation_undo *undo);
/** The same, but only the hexagon's own corners are checked: for rotations whose order is of no
 * importance, which may be improper in between. */
bool surface_rotate_unchecked(surface *s, edge_rotation r, rotation_undo *undo);
/** What surface_rotate checks, after it. */
bool surface_rotation_is_proper(const surface *s, const int32_t quads[2]);
/** Undo the last rotation that is not undone. */
void surface_rotate_back(surface *s, const rotation_undo *undo);

#endif

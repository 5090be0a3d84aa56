/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Which grid of quads suits the angles of a rim? */
#ifndef HEXCON_SOLVE_CUTS_DISC_SHAPES_H
#define HEXCON_SOLVE_CUTS_DISC_SHAPES_H

#include "construct/disc_pattern.h"
#include "surface/half_edges.h"

/** Shapes of one ring that are compared. */
enum { DISC_SHAPES_MOST = 48 };

typedef struct rated_shape {
  disc_shape shape;
  double misfit; /**< square radians between the rim's angles and right ones at the grid's corners,
                  * flat ones elsewhere
                  */
} rated_shape;

/**
 * The grids whose four corners lie best where both rails of a ring turn by a right angle, those
 * first; among equals the squarest.
 * @param ring    [length] entries; length even and at least 4
 * @param shapes  [DISC_SHAPES_MOST] @param count  receives their number
 * @param flat    receives the misfit without corners: that of a ring of quads around a grid
 * Errors: OUT_OF_MEMORY, CANCELLED, OUT_OF_TIME. Cost: quadratic in the ring.
 */
hexcon_status disc_shapes_find(hexcon_context *context, const surface *s, const int32_t *ring,
                               size_t length, rated_shape *shapes, size_t *count, double *flat);

#endif

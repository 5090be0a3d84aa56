/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Tetrahedra cut into four hexes each, which join on to surfaces that are diced already. */
#ifndef HEXCON_CONSTRUCT_DICE_H
#define HEXCON_CONSTRUCT_DICE_H

#include "base/context.h"

/** Triangles whose edges and face have their middle points already. */
typedef struct diced_triangles {
  size_t count;
  const int32_t *corners;      /**< [count][3] */
  const int32_t *means;        /**< [count] */
  const int32_t *side_middles; /**< [count][3] of edges i, i + 1 */
} diced_triangles;

typedef struct diced_complex {
  size_t hex_count;
  int32_t *hexes;     /**< [hex_count][8] VTK order */
  size_t point_count; /**< of new points: first_point .. */
  int32_t *means;     /**< [point_count][4] corners whose mean each new point is; -1: fewer */
} diced_complex;

/**
 * Dice: every edge is halved, every face cut about its mean, every tetrahedron about its own.
 * @param tetrahedra   [count][4] positively oriented, ids of points
 * @param known        what is diced already, in the same ids
 * @param first_point  id of the first new point
 * @param out          free with dice_free, also after an error
 * Errors: OUT_OF_MEMORY, TOO_LARGE. Linear (expected: hashing).
 */
hexcon_status dice(hexcon_context *context, const int32_t *tetrahedra, size_t count,
                   const diced_triangles *known, size_t first_point, diced_complex *out);
void dice_free(hexcon_context *context, diced_complex *d);

#endif

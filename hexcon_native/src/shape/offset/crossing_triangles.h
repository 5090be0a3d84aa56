/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Where a copy of a surface inside it meets itself, or the surface. */
#ifndef HEXCON_SHAPE_OFFSET_CROSSING_TRIANGLES_H
#define HEXCON_SHAPE_OFFSET_CROSSING_TRIANGLES_H

#include "surface/half_edges.h"

/**
 * Mark the points of quads that cross others, as two triangles each. Quads with a point in common,
 * or above each other's, are not compared: there it is a question of folds.
 * @param inner   [point_count][3] the copy's points
 * @param marked  [point_count] set to 1 there; others are left as they are
 * @param count   receives how many triangles of the copy cross another
 * Errors: OUT_OF_MEMORY, TOO_LARGE. Expected linear.
 */
hexcon_status crossing_triangles_mark(hexcon_context *context, const surface *s,
                                      const double *inner, uint8_t *marked, size_t *count);

#endif

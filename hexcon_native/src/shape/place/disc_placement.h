/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** First placement of the points inside a disc of quads. */
#ifndef HEXCON_SHAPE_PLACE_DISC_PLACEMENT_H
#define HEXCON_SHAPE_PLACE_DISC_PLACEMENT_H

#include "base/context.h"

/**
 * Put each inner point in the mean of its neighbours. Exact for affine images of even grids.
 * @param quads      [quad_count][4] rim points come first
 * @param points     [point_count][3] rows from rim_count on are written
 * Errors: OUT_OF_MEMORY, CANCELLED, OUT_OF_TIME. Cost: conjugate gradients (quad_count^1.5).
 * Source: Tutte, How to draw a graph (1963).
 */
hexcon_status disc_place(hexcon_context *context, const int32_t *quads, size_t quad_count,
                         size_t rim_count, size_t point_count, double *points);

#endif

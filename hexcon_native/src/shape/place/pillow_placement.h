/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** First placement of pillowed hexes. */
#ifndef HEXCON_SHAPE_PLACE_PILLOW_PLACEMENT_H
#define HEXCON_SHAPE_PLACE_PILLOW_PLACEMENT_H

#include "base/context.h"

/**
 * Put the copies of points between their originals and the middles of the hexes that got them.
 * @param set        [set_count] those hexes
 * @param originals  [count] of the points first .. first + count - 1
 * @param points     [][3] the copies' rows are written
 * Errors: OUT_OF_MEMORY. Linear.
 */
hexcon_status place_pillow(hexcon_context *context, const int32_t *hexes, const int32_t *set,
                           size_t set_count, const int32_t *originals, size_t first, size_t count,
                           double *points);

#endif

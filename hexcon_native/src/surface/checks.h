/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Checks of the arrays that describe a surface, before any adjacency is built. */
#ifndef HEXCON_SURFACE_CHECKS_H
#define HEXCON_SURFACE_CHECKS_H

#include "base/context.h"

/** Volumes of bodies larger than this leave the range of a double. */
static const double largest_coordinate = 1e100;

/**
 * EMPTY, TOO_LARGE, INDEX_OUT_OF_RANGE, REPEATED_VERTEX, and with points NOT_FINITE and
 * UNUSED_POINT. Linear.
 */
hexcon_status check_arrays(hexcon_context *context, const double *points, size_t point_count,
                           const int32_t *quads, size_t quad_count);

/** INDEX_OUT_OF_RANGE: rows of `width` ids that leave 0 .. point_count - 1. @param rows their name
 */
hexcon_status check_ids(hexcon_context *context, size_t point_count, const int32_t *ids,
                        size_t row_count, size_t width, const char *rows);

/** NOT_FINITE: points with a coordinate that is NaN or beyond `largest`. */
hexcon_status check_points(hexcon_context *context, const double *points, size_t point_count,
                           double largest);

#endif

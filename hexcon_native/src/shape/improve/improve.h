/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Untangling and improvement of a hex mesh, never for the worse. */
#ifndef HEXCON_SHAPE_IMPROVE_IMPROVE_H
#define HEXCON_SHAPE_IMPROVE_IMPROVE_H

#include "base/context.h"

/**
 * As hexcon_optimize, in place, for callers that hold checked arrays.
 * @param rounds  receives the number of neighbourhoods that were tried; may be NULL
 */
hexcon_status improve_mesh(hexcon_context *context, double *points, size_t point_count,
                           const int32_t *hexes, size_t hex_count, const uint8_t *fixed,
                           const hexcon_optimize_options *options, size_t *rounds);

#endif

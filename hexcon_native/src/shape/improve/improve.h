/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Untangling and improvement of a hex mesh, never for the worse. */
#ifndef HEXCON_SHAPE_IMPROVE_IMPROVE_H
#define HEXCON_SHAPE_IMPROVE_IMPROVE_H

#include "shape/slide/sliding_points.h"

/**
 * As hexcon_optimize, in place, for callers that hold checked arrays.
 * @param rounds  receives the number of neighbourhoods that were tried; may be NULL
 */
hexcon_status improve_mesh(hexcon_context *context, double *points, size_t point_count,
                           const int32_t *hexes, size_t hex_count, const uint8_t *fixed,
                           const hexcon_optimize_options *options, size_t *rounds);

/**
 * As improve_mesh, while points slide on what they lie on, where that has a closed form: those that
 * would have to be asked for, and those that do not move, stay.
 * @param points  on what they lie on, and so afterwards
 */
hexcon_status improve_sliding_mesh(hexcon_context *context, double *points, const int32_t *hexes,
                                   size_t hex_count, const sliding_points *sliding,
                                   const hexcon_optimize_options *options);

#endif

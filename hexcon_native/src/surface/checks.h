/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Checks of the arrays that describe a surface, before any adjacency is built. */
#ifndef HEXCON_SURFACE_CHECKS_H
#define HEXCON_SURFACE_CHECKS_H

#include "base/context.h"

/**
 * EMPTY, TOO_LARGE, INDEX_OUT_OF_RANGE, REPEATED_VERTEX, and with points NOT_FINITE and
 * UNUSED_POINT. Linear.
 */
hexcon_status check_arrays(hexcon_context *context, const double *points, size_t point_count,
                           const int32_t *quads, size_t quad_count);

#endif

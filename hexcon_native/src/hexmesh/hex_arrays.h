/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Checks of the arrays that describe a hex mesh. */
#ifndef HEXCON_HEXMESH_HEX_ARRAYS_H
#define HEXCON_HEXMESH_HEX_ARRAYS_H

#include "base/context.h"

/** EMPTY, TOO_LARGE, INDEX_OUT_OF_RANGE, NOT_FINITE. Linear. */
hexcon_status check_hex_arrays(hexcon_context *context, const double *points, size_t point_count,
                               const int32_t *hexes, size_t hex_count);

/** The same of hexes of 20 nodes. */
hexcon_status check_second_order_arrays(hexcon_context *context, const double *points,
                                        size_t point_count, const int32_t *hexes, size_t hex_count);

/** REPEATED_VERTEX: a hex with a corner twice. Linear. */
hexcon_status check_hex_corners(hexcon_context *context, const int32_t *hexes, size_t hex_count);

#endif

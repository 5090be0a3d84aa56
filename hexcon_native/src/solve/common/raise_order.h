/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Second-order meshes on straight edges. */
#ifndef HEXCON_SOLVE_COMMON_RAISE_ORDER_H
#define HEXCON_SOLVE_COMMON_RAISE_ORDER_H

#include "base/context.h"

/** As hexcon_raise_order, for callers that hold checked arrays. */
hexcon_status raise_order(hexcon_context *context, const double *points, size_t point_count,
                          const int32_t *hexes, size_t hex_count, hexcon_second_order *out);

#endif

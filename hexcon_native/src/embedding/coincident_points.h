/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Points that stand at the same place. */
#ifndef HEXCON_EMBEDDING_COINCIDENT_POINTS_H
#define HEXCON_EMBEDDING_COINCIDENT_POINTS_H

#include "base/context.h"

/**
 * @param points  [count][3]
 * @param first   [count] receives the lowest point at the same place, often the point itself
 * @param found   receives how many points are not the lowest at their place
 * Errors: OUT_OF_MEMORY. Expected linear.
 */
hexcon_status coincident_points_find(hexcon_context *context, const double *points, size_t count,
                                     int32_t *first, size_t *found);

#endif

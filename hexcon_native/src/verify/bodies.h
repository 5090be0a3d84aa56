/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Bodies whose boundaries meet nowhere may still lie in one another. */
#ifndef HEXCON_VERIFY_BODIES_H
#define HEXCON_VERIFY_BODIES_H

#include "base/context.h"

/**
 * Prove a boundary embedded, and that its shells face out of what they bound, going inwards in turn
 * out and in: otherwise a body lies in the material of another, and `embedding` becomes NO, with a
 * quad of each of two such shells.
 * @param quads  [quad_count][4] closed and consistent; other points may be unused
 * Errors: OUT_OF_MEMORY, CANCELLED, OUT_OF_TIME. Expected n log n, but for the nesting of many
 * shells.
 */
hexcon_status bodies_prove(hexcon_context *context, const double *points, size_t point_count,
                           const int32_t *quads, size_t quad_count, hexcon_embedding *embedding);

#endif

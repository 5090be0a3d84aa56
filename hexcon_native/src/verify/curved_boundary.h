/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The proof that the curved boundary of a mesh of 20-node hexes crosses itself nowhere. */
#ifndef HEXCON_VERIFY_CURVED_BOUNDARY_H
#define HEXCON_VERIFY_CURVED_BOUNDARY_H

#include "base/context.h"

/**
 * Judge the quads as they are curved. Of several shells YES says besides that they face out of what
 * they bound, going inwards in turn out and in.
 * @param hexes  [hex_count][20] conforming and proper
 * @param quads  [quad_count][4] the corners of their boundary, outward
 * Errors: OUT_OF_MEMORY, CANCELLED, OUT_OF_TIME. Expected linear in hexes, n log n in quads.
 */
hexcon_status curved_boundary_check(hexcon_context *context, const double *points,
                                    size_t point_count, const int32_t *hexes, size_t hex_count,
                                    const int32_t *quads, size_t quad_count,
                                    hexcon_embedding *embedding);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** What the surface allows of a mesh's quality, wherever the inner points lie. */
#ifndef HEXCON_SOLVE_COMMON_QUALITY_BOUND_H
#define HEXCON_SOLVE_COMMON_QUALITY_BOUND_H

#include "surface/half_edges.h"

/**
 * No placement of the inner points has a higher worst scaled Jacobian: from the surface's own
 * corners, and the hex corners that have all four points on it. Linear.
 * @param points  of the mesh; those of the surface come first
 * @return CANCELLED, OUT_OF_TIME
 */
hexcon_status quality_bound(hexcon_context *context, const surface *s, const double *points,
                            const int32_t *hexes, size_t hex_count, double *bound);

#endif

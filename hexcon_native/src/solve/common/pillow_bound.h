/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** What a boundary allows of hexes that have one of its quads each, as those of a pillow have. */
#ifndef HEXCON_SOLVE_COMMON_PILLOW_BOUND_H
#define HEXCON_SOLVE_COMMON_PILLOW_BOUND_H

#include "base/context.h"

/**
 * The scaled Jacobian that no hex of a pillow can surpass at a point of the boundary, wherever the
 * inner end of the one edge is that all of them share there: the largest that the smallest of n_q .
 * d can be for a unit vector d, n_q the product of the unit edges of quad q at the point, inward.
 * By duality that is the distance of the convex hull of the n_q from the origin; it is found by
 * Gilbert's algorithm, from above, to 0.1 %.
 * @param quads   [quad_count][4] closed, outward
 * @param bounds  [point_count] is filled; 1 at points of no quad; not below 0
 * Errors: OUT_OF_MEMORY, CANCELLED, OUT_OF_TIME. Linear.
 * Source: Gilbert, An iterative procedure for computing the minimum of a quadratic form on a convex
 * set (1966).
 */
hexcon_status pillow_bounds(hexcon_context *context, const double *points, size_t point_count,
                            const int32_t *quads, size_t quad_count, double *bounds);

/** The least of them. @param worst  receives the point where it is, the first of equals */
double pillow_bound_least(const double *bounds, size_t point_count, size_t *worst);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** First placement of the inner points of a sweep. */
#ifndef HEXCON_SHAPE_PLACE_SWEEP_PLACEMENT_H
#define HEXCON_SHAPE_PLACE_SWEEP_PLACEMENT_H

#include "base/context.h"

/** A sweep as a table of points: levels 0 .. rings, the same cap at each. */
typedef struct sweep_levels {
  size_t rings, cap_quad_count, cap_point_count;
  const int32_t *cap_quads; /**< [cap_quad_count][4] cap points */
  const uint8_t *on_rim;    /**< [cap_point_count] */
  const int32_t *ids;       /**< [rings + 1][cap_point_count] rows of `points` */
} sweep_levels;

/**
 * Place the points of the levels between the caps that are not on the rim. Each level is the
 * blend of both caps, moved by the affine map that fits the rims best (Knupp, "Next-generation
 * sweep tool", 1998); what the maps leave at the rim is spread inside as a harmonic function.
 * Exact where the levels are affine images of the caps: prisms, sheared ones, frusta, and bodies
 * swept about an axis.
 * @param points  [][3] rows of both caps and of all rims are read, the others written
 * Linear for affine levels and for rims that vary smoothly; for others, each level costs the
 * conjugate gradients of its cap (cap quads^1.5).
 * Errors: OUT_OF_MEMORY, CANCELLED.
 */
hexcon_status sweep_place(hexcon_context *context, const sweep_levels *levels, double *points);

#endif

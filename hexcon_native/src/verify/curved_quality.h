/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The scaled Jacobian of a curved hex of 20 nodes. */
#ifndef HEXCON_VERIFY_CURVED_QUALITY_H
#define HEXCON_VERIFY_CURVED_QUALITY_H

#include "base/context.h"

/** Places along each direction where it is looked at. */
enum { CURVED_QUALITY_PLACES = 5 };

/**
 * The least of det(X_r, X_s, X_t) / (|X_r| |X_s| |X_t|) at 5 places in each direction, corners
 * included; 0 at most of a hex that is not proved positive everywhere.
 * @param nodes  [20][3], VTK_QUADRATIC_HEXAHEDRON order
 * @param room   curved_jacobian_room() bytes, aligned for doubles
 * @return in [-1, 1]; -1 where some derivative vanishes at such a place
 */
double curved_scaled_jacobian(double nodes[20][3], void *room);

/** curved_scaled_jacobian of each of checked hexes. @param qualities [hex_count] */
hexcon_status curved_qualities(hexcon_context *context, const double *points, const int32_t *hexes,
                               size_t hex_count, double *qualities);

#endif

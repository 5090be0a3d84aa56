/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** What narrow corners of a body, such as the tip of a cone, allow of a mesh's quality. */
#ifndef HEXCON_SOLVE_COMMON_NARROW_CORNERS_H
#define HEXCON_SOLVE_COMMON_NARROW_CORNERS_H

#include "base/context.h"

/**
 * No placement of the inner points has a higher worst scaled Jacobian: the hex corners at a point
 * of the surface share the solid angle there, so one of k has at most a k-th of it; and a corner of
 * edges a, b, c of length 1 and solid angle w has the determinant tan(w / 2) (1 + ab + bc + ca)
 * (Van Oosterom and Strackee 1983), at most 4 tan(w / 2). The sum of the corners' signed angles is
 * that solid angle wherever the inner points lie, but for multiples of 4 pi. Linear.
 * @param surface_points  the first so many points are on the surface
 * @param bound           is lowered to it
 * @return OUT_OF_MEMORY, CANCELLED, OUT_OF_TIME
 */
hexcon_status narrow_corner_bound(hexcon_context *context, const double *points,
                                  const int32_t *hexes, size_t hex_count, size_t surface_points,
                                  double *bound);

#endif

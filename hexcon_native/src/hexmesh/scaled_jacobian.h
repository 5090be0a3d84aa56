/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Verdict's scaled Jacobian of a hex. */
#ifndef HEXCON_HEXMESH_SCALED_JACOBIAN_H
#define HEXCON_HEXMESH_SCALED_JACOBIAN_H

#include <stdint.h>

/** Minimum over the 8 corners; -1 where an edge has no length. @param hex 8 ids */
double scaled_jacobian(const double *points, const int32_t *hex);

/** The value at one corner, 0 .. 7. */
double corner_scaled_jacobian(const double *points, const int32_t *hex, int corner);

#endif

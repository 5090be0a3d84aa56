/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The scaled Jacobian of a curved hex of 20 nodes. */
#ifndef HEXCON_VERIFY_CURVED_QUALITY_H
#define HEXCON_VERIFY_CURVED_QUALITY_H

#include "base/context.h"

/**
 * A bound from below of det(X_r, X_s, X_t) / (|X_r| |X_s| |X_t|) on the whole hex, and not more
 * than HEXCON_CURVED_QUALITY_TOLERANCE below its least value; of a hex that is not proved positive
 * everywhere the least at 27 places, and 0 at most.
 *
 * With m_a near |X_a| on a box, |X_a| <= m_a (1 + x_a), where x_a = (|X_a|^2 / m_a^2 - 1) / 2 is a
 * polynomial of degree 4. The mean x of the three has (1 + x_r) (1 + x_s) (1 + x_t) <= (1 + x)^3,
 * which lies below its chord between bounds of x. So the lengths' product is below a polynomial q,
 * and where every Bernstein coefficient of the determinant is at least c times that of q the
 * quotient is at least c. All of this is off by the square of the box's width, so few bisections
 * do.
 * @param nodes  [20][3], VTK_QUADRATIC_HEXAHEDRON order
 * @param room   curved_quality_room() bytes, aligned for doubles
 * @return in [-1, 1]; -1 where some derivative vanishes at such a place
 */
double curved_scaled_jacobian(double nodes[20][3], void *room);

/** Bytes that it may work in. */
size_t curved_quality_room(void);

/** curved_scaled_jacobian of each of checked hexes. @param qualities [hex_count] */
hexcon_status curved_qualities(hexcon_context *context, const double *points, const int32_t *hexes,
                               size_t hex_count, double *qualities);

#endif

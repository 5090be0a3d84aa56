/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The point deepest inside the kernel of a surface. */
#ifndef HEXCON_SURFACE_STAR_CENTER_H
#define HEXCON_SURFACE_STAR_CENTER_H

#include "half_edges.h"

/**
 * The point farthest behind the planes of all corner triangles (four a quad), by linear
 * programming: maximise r with normal . x + r <= offset for every plane.
 * @param center  receives the point
 * @param margin  receives its distance to the nearest plane, evaluated afresh at `center`; positive
 *                exactly where the surface is star-shaped about it
 * Expected cost linear: Seidel, Small-dimensional linear programming and convex hulls made easy
 * (1991), in four dimensions. Deterministic.
 */
hexcon_status surface_star_center(hexcon_context *context, const surface *s, double center[3],
                                  double *margin);
/** As surface_star_center for the mean planes of whole quads: a single folded corner does not
 * count.
 */
hexcon_status surface_mean_center(hexcon_context *context, const surface *s, double center[3],
                                  double *margin);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Corners of quads on which no hex with a positive Jacobian can stand. */
#ifndef HEXCON_SURFACE_CORNER_ANGLES_H
#define HEXCON_SURFACE_CORNER_ANGLES_H

#include "half_edges.h"

/** Angle in radians of a quad's corner, 0 .. 2 pi, seen along the quad's mean normal. */
double surface_corner_angle(const surface *s, int32_t half_edge);

/**
 * UNFILLABLE_QUAD for quads with a corner of 180 degrees or more, or of none at all, and for pairs
 * of quads that share two edges: between them, those leave a corner no room. The words name the
 * first of them with their angles. Linear.
 * @param star_shaped  a point inside sees every corner: none then has more than 180 degrees
 */
hexcon_status surface_check_fillable(hexcon_context *context, const surface *s, bool star_shaped);

#endif

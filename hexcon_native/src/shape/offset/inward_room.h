/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** How far a point of a surface may go inward before it meets another part of it. */
#ifndef HEXCON_SHAPE_OFFSET_INWARD_ROOM_H
#define HEXCON_SHAPE_OFFSET_INWARD_ROOM_H

#include "surface/half_edges.h"

/**
 * Follow a ray from every point to the first quad, none of its own, that it leaves the body
 * through.
 * @param directions  [point_count][3] unit vectors
 * @param room        [point_count] how far to look; receives the way to that quad where it is
 *                    nearer
 * Errors: OUT_OF_MEMORY. Expected linear where rays are a few edges long.
 */
hexcon_status inward_room_find(hexcon_context *context, const surface *s, const double *directions,
                               double *room);

/** Two triangles a quad, 0 1 2 and 0 2 3, of the surface's points. @param out [2 quad_count][3] */
void surface_triangles(const surface *s, int32_t *out);

#endif

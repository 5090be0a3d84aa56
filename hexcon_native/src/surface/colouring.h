/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** 2-colouring of a surface's points along its edges. */
#ifndef HEXCON_SURFACE_COLOURING_H
#define HEXCON_SURFACE_COLOURING_H

#include "half_edges.h"

/**
 * Colour the points 0 / 1 along edges; the lowest id of each component gets 0. Linear.
 * @param colours  [point_count]; unused points get 0
 * @return NOT_BIPARTITE with the points of an odd cycle in order, OUT_OF_MEMORY
 */
hexcon_status surface_colour(hexcon_context *context, const surface *s, uint8_t *colours);

/**
 * Tell the two sides of disjoint dual loops: a point gets another side than its neighbour exactly
 * where the edge between them is crossed. The lowest id of each component gets 0. Linear.
 * @param crossed  [4 * quad_count] of every half-edge, alike on twins
 * @param sides    [point_count]; unused points get 0
 * @return NO_SIDES with the points of a closed path that crosses the loops an odd number of times
 *         (never on a sphere), OUT_OF_MEMORY
 */
hexcon_status surface_sides(hexcon_context *context, const surface *s, const uint8_t *crossed,
                            uint8_t *sides);

#endif

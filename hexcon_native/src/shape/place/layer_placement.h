/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** First placement of the points under a layer of hexes. */
#ifndef HEXCON_SHAPE_PLACE_LAYER_PLACEMENT_H
#define HEXCON_SHAPE_PLACE_LAYER_PLACEMENT_H

#include "base/context.h"

/** What placing a layer needs, kept from one to the next. */
typedef struct layer_placement {
  size_t point_room;
  int32_t *slots; /**< [point_room] local number of a point, -1 but while a layer is placed */
} layer_placement;

void layer_placement_free(hexcon_context *context, layer_placement *p);

/**
 * Place the new points of a layer: those at its rim exist on both ends, and show by how much the
 * layer's outer side has to move; the others move by the harmonic function of that. Exact where the
 * rim moves as one.
 * @param hexes      [hex_count][8] of the layer: corner k lies under corner k + 4
 * @param first_new  points from here on are to be placed
 * @param points     [][3] their rows are written, the others read
 * Cost: linear where the rim moves as one, else conjugate gradients (hex_count^1.5).
 */
hexcon_status layer_place(hexcon_context *context, layer_placement *p, const int32_t *hexes,
                          size_t hex_count, size_t first_new, size_t point_count, double *points);

#endif

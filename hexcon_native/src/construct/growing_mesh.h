/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Hexes and point ids that stage after stage adds to. */
#ifndef HEXCON_CONSTRUCT_GROWING_MESH_H
#define HEXCON_CONSTRUCT_GROWING_MESH_H

#include <string.h>

#include "base/context.h"

typedef struct growing_mesh {
  size_t point_count, hex_count;
  int32_t *hexes; /**< [hex_count][8] VTK order, and room for those promised */
} growing_mesh;

/** Where a stage's new points lie: each in the mean of up to four older ones, then drawn towards
 * the inside by an amount that the first `near_count` and the others have in common. */
typedef struct mean_points {
  size_t first, count, near_count;
  int32_t *means; /**< [count][4] ids of points, -1: fewer */
} mean_points;

/** Make room for so many hexes and check that so many points can be told apart.
 * @return OUT_OF_MEMORY, TOO_LARGE */
hexcon_status growing_mesh_reserve(hexcon_context *context, growing_mesh *mesh, size_t more_hexes,
                                   size_t more_points);

/** Add a hex over a quad of points, seen counter-clockwise from its outer side, down to an inner
 * copy of the quad. There must be room. */
static inline void growing_mesh_add(growing_mesh *mesh, const int32_t outer[4],
                                    const int32_t inner[4]) {
  int32_t *hex = mesh->hexes + 8 * mesh->hex_count++;
  memcpy(hex, inner, 4 * sizeof *hex);
  memcpy(hex + 4, outer, 4 * sizeof *hex);
}

#endif

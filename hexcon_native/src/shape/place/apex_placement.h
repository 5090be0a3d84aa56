/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Where the apices of pyramids on the quads of a coarse surface lie. */
#ifndef HEXCON_SHAPE_PLACE_APEX_PLACEMENT_H
#define HEXCON_SHAPE_PLACE_APEX_PLACEMENT_H

#include "base/context.h"

/** The faces of a coarse surface; ids are rows of points. */
typedef struct coarse_faces {
  size_t triangle_count, quad_count; /**< triangles come first */
  const int32_t *corner_ids;         /**< ids of the coarse corners */
  const int32_t *corners; /**< [..][4] rows of corner_ids, counter-clockwise from outside */
  const int32_t *middles; /**< [..][4] ids in the middle of sides i, i + 1 */
  const int32_t *centers; /**< [..] ids */
} coarse_faces;

/**
 * Place an apex under each quad's middle: half a side deep, but so flat that pyramids leave room
 * between them along every edge, however sharp. It says nothing of what is opposite: `scale` them
 * down where they come too close.
 * @param point_count  of the points that faces name
 * @param apices       [quad_count] rows of points that are written
 * Errors: OUT_OF_MEMORY. Linear.
 */
hexcon_status place_apices(hexcon_context *context, const coarse_faces *faces, double scale,
                           const int32_t *apices, size_t point_count, double *points);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Layers of hexes inside a surface, and the core that they leave. */
#ifndef HEXCON_SOLVE_SHEETS_LAYERED_CORE_H
#define HEXCON_SOLVE_SHEETS_LAYERED_CORE_H

#include "sheet_search.h"

typedef struct layered_core {
  size_t point_count, hex_count, layer_count;
  bool covered;        /**< the first layer lies on the whole surface */
  double *points;      /**< [point_count][3] placed; the outer surface's come first */
  int32_t *hexes;      /**< [hex_count][8] of the layers */
  surface s;           /**< of the core, in numbers of its own; s.points is `core_points` */
  double *core_points; /**< [s.point_count][3] copies of those in `points` */
  int32_t *ids;        /**< [s.point_count] of the core's points in the mesh */
  int32_t *quad_ids;   /**< [s.quad_count] of the core's quads in the surface, moved or not */
} layered_core;

/**
 * Take over what a search found that did not come to a cube.
 * @param search  loses its points and hexes
 * @param out     free with layered_core_free, also after an error. Linear. Errors: OUT_OF_MEMORY.
 */
hexcon_status layered_core_take(hexcon_context *context, sheet_search *search, layered_core *out);

/** Cover what fills a copy of the surface inside it with a layer from the surface to the copy.
 * Linear. Errors: OUT_OF_MEMORY (nothing has changed then), TOO_LARGE. */
hexcon_status layered_core_cover(hexcon_context *context, const surface *s, layered_core *core);
void layered_core_free(hexcon_context *context, layered_core *core);

/** Copy the core's points anew from the mesh's, after those have moved. */
void layered_core_follow(layered_core *core);

#endif

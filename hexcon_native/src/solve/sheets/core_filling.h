/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Ways to fill the core that layers of hexes leave. */
#ifndef HEXCON_SOLVE_SHEETS_CORE_FILLING_H
#define HEXCON_SOLVE_SHEETS_CORE_FILLING_H

#include "hexcon.h"
#include "surface/half_edges.h"

typedef enum core_way {
  CORE_NONE,       /**< the layers left none */
  CORE_TABLE,      /**< a small filling */
  CORE_TETRAHEDRA, /**< cells, and tetrahedra inside by the caller's mesher, which
 there must be */
  CORE_STAR        /**< cells, and tetrahedra that meet in one point */
} core_way;

/** Points and hexes in a core; inner points are placed, but nothing is improved. */
typedef struct core_filling {
  size_t point_count, hex_count;
  double *points; /**< [point_count][3] the core's first */
  int32_t *hexes; /**< [hex_count][8] */
} core_filling;

/**
 * Fill a core: its points are about where they will be; it need not be star-shaped, nor free of
 * folds.
 * @param thickness  of cells, in lengths of the edges above
 * @param out        no points: this way leads nowhere; free with core_filling_free, also after an
 *                   error
 * Errors: OUT_OF_MEMORY, TOO_LARGE, CANCELLED, OUT_OF_TIME.
 */
hexcon_status core_filling_build(hexcon_context *context, const surface *core, core_way way,
                                 double thickness, const hexcon_mesh_options *options,
                                 core_filling *out);
void core_filling_free(hexcon_context *context, core_filling *f);

#endif

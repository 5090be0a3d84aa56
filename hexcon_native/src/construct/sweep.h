/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The hexes of a sweep: a cap's quads times the rings of the sides. */
#ifndef HEXCON_CONSTRUCT_SWEEP_H
#define HEXCON_CONSTRUCT_SWEEP_H

#include "reflection.h"

typedef struct sweep {
  size_t rings; /**< layers of hexes */
  size_t cap_quad_count;
  size_t cap_point_count;   /**< cap points are numbered 0 .. cap_point_count - 1 */
  size_t inner_point_count; /**< of them not on the rim */
  size_t point_count;       /**< of the whole mesh: the surface's, then the new ones */
  int32_t *cap_quads;       /**< [cap_quad_count][4] cap points, outward on the first cap */
  uint8_t *on_rim;          /**< [cap_point_count] */
  int32_t *ids;             /**< [rings + 1][cap_point_count] points of the mesh; level 0 is the
                                 first cap, level `rings` the second */
  const char *failure;      /**< NULL if the sweep exists */
} sweep;

/**
 * Cut a reflected surface into caps and `rings` rings of sides. Linear in the hexes.
 * @param rings  1 .. r->max_rings, of the parity of r->max_rings
 * @param out    free with sweep_free, also after an error; out->failure tells why there is none
 * @return OUT_OF_MEMORY, TOO_LARGE
 */
hexcon_status sweep_build(hexcon_context *context, const surface *s, const surface_loops *loops,
                          const strip_table *strips, const reflection *r, size_t rings, sweep *out);
void sweep_free(hexcon_context *context, sweep *w);

/** Write the cap_quad_count * rings hexes [][8], layer by layer from the first cap.
 * @return CANCELLED, OUT_OF_TIME */
hexcon_status sweep_write_hexes(hexcon_context *context, const sweep *w, int32_t *hexes);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Hexes to be worked on, grouped with their neighbours. */
#ifndef HEXCON_SHAPE_IMPROVE_GROUPS_H
#define HEXCON_SHAPE_IMPROVE_GROUPS_H

#include "region.h"

typedef struct hex_groups {
  size_t count;
  size_t *starts;  /**< [count + 1] into hexes */
  int32_t *hexes;  /**< ids of hexes, group by group */
  uint8_t *wanted; /**< [mesh_hex_count] scratch: all zero between calls */
} hex_groups;

/** Room for any grouping of the mesh's hexes. @param out free with hex_groups_free. Linear. */
hexcon_status hex_groups_new(hexcon_context *context, size_t hex_count, hex_groups *out);
void hex_groups_free(hexcon_context *context, hex_groups *groups);

/**
 * Group seeds that share free points, breadth first from each seed in turn.
 * @param seeds  [seed_count] ids of hexes with a free point each
 * @param limit  seeds in a group at most; a larger cluster is cut into several
 * Linear in the hexes at the seeds' points.
 */
hexcon_status hex_groups_fill(hexcon_context *context, const region_set *set, const int32_t *seeds,
                              size_t seed_count, size_t limit, hex_groups *groups);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Parts of a hex mesh whose points may be moved at the same time. */
#ifndef HEXCON_SHAPE_IMPROVE_REGION_H
#define HEXCON_SHAPE_IMPROVE_REGION_H

#include "base/context.h"
#include "hexmesh/corner_table.h"

/**
 * Disjoint regions: each is a set of free points and all hexes at them, and no hex is in two. So
 * what one region's points do is not seen by another's hexes.
 */
typedef struct region_set {
  size_t mesh_point_count, mesh_hex_count;
  const int32_t *mesh_hexes; /**< [mesh_hex_count][8], the caller's */
  const uint8_t *fixed;      /**< [mesh_point_count], the caller's */
  corner_table corners;      /**< hexes at each point */
  int32_t *region_of_hex;    /**< [mesh_hex_count] or -1 */
  uint8_t *point_taken;      /**< [mesh_point_count] */
  size_t count;              /**< of regions */
  size_t *point_starts;      /**< [mesh_hex_count + 1] region r has points from point_starts[r] */
  size_t *hex_starts;        /**< [mesh_hex_count + 1] */
  int32_t *points;           /**< [mesh_point_count] */
  int32_t *hexes;            /**< [mesh_hex_count] */
} region_set;

/** @param out free with region_set_free, also after an error. Linear in the mesh. */
hexcon_status region_set_new(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                             size_t point_count, const uint8_t *fixed, region_set *out);
void region_set_free(hexcon_context *context, region_set *set);

/**
 * Add the region of the free points of the seed hexes and of `layers` more layers of hexes around.
 * @return false, with nothing added, if one of its hexes is in another region, or if there is no
 * free point. Linear in the region.
 */
bool region_set_add(region_set *set, const int32_t *seeds, size_t seed_count, int layers);

/** Take all regions out. Linear in them. */
void region_set_clear(region_set *set);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** A part of a hex mesh whose points are moved together while all else stays. */
#ifndef HEXCON_SHAPE_REGION_H
#define HEXCON_SHAPE_REGION_H

#include "base/context.h"
#include "verify/corner_table.h"

/** The mesh that regions are cut from; arrays are the caller's. */
typedef struct region_mesh {
  size_t point_count, hex_count;
  const int32_t *hexes;
  const uint8_t *fixed;
  corner_table corners;
  int32_t *slot_of_point; /**< [point_count] place in region.points while a region is open, or -1 */
  uint8_t *hex_seen;      /**< [hex_count] in region.hexes while a region is open */
} region_mesh;

typedef struct region {
  int32_t *points; /**< [point_count] the free points that move */
  int32_t *hexes;  /**< [hex_count] all hexes at them */
  size_t point_count, hex_count;
} region;

/** @param mesh free with region_mesh_free, also after an error. Linear in the mesh. */
hexcon_status region_mesh_build(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                                size_t point_count, const uint8_t *fixed, region_mesh *mesh);
void region_mesh_free(hexcon_context *context, region_mesh *mesh);

/** Buffers large enough for any region of the mesh. @param out free with region_free */
hexcon_status region_new(hexcon_context *context, const region_mesh *mesh, region *out);
void region_free(hexcon_context *context, region *r);

/**
 * Open a region: the free points of the seed hexes and of `layers` more layers of hexes around.
 * Cost: linear in the region.
 */
void region_open(region_mesh *mesh, const int32_t *seeds, size_t seed_count, int layers, region *r);
/** Undo the marks of region_open. */
void region_close(region_mesh *mesh, region *r);

#endif

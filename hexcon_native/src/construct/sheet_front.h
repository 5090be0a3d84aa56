/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * The front of a mesh that grows inward by layers of hexes, each of which takes dual loops away.
 *
 * A layer lies on a region of the front that is bounded by rings: the quads of simple dual loops.
 * One hex stands on each quad of the region; the rings are the layer's outer walls. So the new
 * front is the old one without the rings, and the region's rim comes to lie where the rings' other
 * rims are. All other loops stay as they are: what a front is depends on the loops left alone, how
 * many hexes were laid on the regions chosen.
 *
 * Source: Mueller-Hannemann, "Hexahedral mesh generation by successive dual cycle elimination",
 * Engineering with Computers 15 (1999). There a layer ends at one loop; here it may at several, as
 * in a sweep of a cap that has closed loops inside.
 */
#ifndef HEXCON_CONSTRUCT_SHEET_FRONT_H
#define HEXCON_CONSTRUCT_SHEET_FRONT_H

#include "growing_mesh.h"
#include "surface/loops.h"

/** A layer laid: from where its rungs, hexes and points begin; it ends where the next begins. */
typedef struct sheet_layer {
  size_t first_rung, first_hex, first_point;
} sheet_layer;

typedef struct sheet_front {
  surface s;            /**< quads keep their numbers while the front moves; those of rings taken
                             away are stale. s.points is the caller's, and may change */
  size_t alive_count;   /**< quads of the front */
  uint8_t *alive;       /**< [s.quad_count] */
  surface_loops loops;  /**< of the first front; only the passages of quads alive count */
  int32_t *loop_starts; /**< [loops.count] an entry, which may be stale: see front_loop_start */
  uint8_t *gone;        /**< [loops.count] taken away */
  growing_mesh mesh;    /**< points 0 .. s.point_count - 1 are the surface's */
  int32_t *quad_of_hex; /**< [mesh.hex_count] the quad that the hex stands on */
  size_t point_room;
  int32_t *below;  /**< [point_room] of a new point, the one under it when it was laid */
  int32_t *image;  /**< [point_room] -1, but while a layer is checked or laid */
  uint32_t *marks; /**< [point_room] == mark: met in the present check */
  uint32_t mark;
  size_t rung_count, layer_count;
  int32_t *rungs;      /**< [s.quad_count] entries to ring quads, the region on their left */
  sheet_layer *layers; /**< [loops.count] */
} sheet_front;

/** A part of the front and the rings about it. */
typedef struct front_region {
  size_t rung_count, quad_count;
  int32_t *rungs;  /**< [rung_count] entries to the rings' quads; the region lies on their left */
  int32_t *quads;  /**< [quad_count] */
  uint32_t *marks; /**< [slots] == mark: in a ring; == mark + 1: in the region */
  uint32_t mark;
} front_region;

/** Start at a surface of one component. Linear. @param out free with front_free, also after an
 * error */
hexcon_status front_begin(hexcon_context *context, const surface *s, sheet_front *out);
void front_free(hexcon_context *context, sheet_front *front);

/** An entry of a loop that is not gone. Amortised: constant. */
int32_t front_loop_start(sheet_front *front, size_t loop);

hexcon_status front_region_new(hexcon_context *context, const sheet_front *front,
                               front_region *out);
void front_region_free(hexcon_context *context, front_region *region);

/** Empty the region and take the ring of the loop that passes `entry`, the region on its left. */
void front_region_begin(const sheet_front *front, int32_t entry, front_region *region);

/** Let the region end at a further ring. @return false: that one shares a quad with the others; the
 * region is then of no use */
bool front_region_add_ring(const sheet_front *front, int32_t entry, front_region *region);

/** Find the quads between the rings. @return false: there are more than `limit`, or the rings do
 * not bound one region. Linear in them. */
bool front_region_fill(const sheet_front *front, size_t limit, front_region *region);

/**
 * True if the front stays a proper surface without the region's rings: rims that do not touch
 * themselves, and around every point three quads or more and no other point twice. Then the hexes
 * meet properly too. It does not matter on which side the region lies. Linear in the quads at the
 * rims.
 */
bool front_can_lay(sheet_front *front, const front_region *region);

/** Lay a layer on a region that is filled and can be laid. Errors: OUT_OF_MEMORY, TOO_LARGE (the
 * front is then as before). Linear in the region and its rings. */
hexcon_status front_lay(hexcon_context *context, sheet_front *front, const front_region *region);

/** Take the last layer back. As linear. */
void front_take_back(sheet_front *front);

/** True if the front is the surface of a cube. */
static inline bool front_is_hex(const sheet_front *front) {
  return front->alive_count == 6;
}

/** Fill the surface of a cube with its hex. */
hexcon_status front_close(hexcon_context *context, sheet_front *front);

#endif

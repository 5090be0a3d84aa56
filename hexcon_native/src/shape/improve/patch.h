/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** A part of a hex mesh, copied out and numbered anew, whose free points are moved together. */
#ifndef HEXCON_SHAPE_IMPROVE_PATCH_H
#define HEXCON_SHAPE_IMPROVE_PATCH_H

#include "base/context.h"

/**
 * Corners of a hex of a patch are numbered by bits: corner r + 2 s + 4 t lies at (r, s, t) of the
 * unit cube. Edge 4 axis + m runs along `axis` from low to high; the bits of m are its place
 * across, lower axis first.
 */
enum { PATCH_EDGES = 12, PATCH_WATCH_MOST = 3 };

typedef struct patch {
  size_t free_count;  /**< points 0 .. free_count - 1 move */
  size_t point_count; /**< the others stay */
  size_t hex_count;
  int32_t *points;      /**< [point_count] ids in the mesh */
  int32_t *hexes;       /**< [hex_count] ids in the mesh */
  int32_t *corners;     /**< [hex_count][8] points of the patch */
  double *x;            /**< [point_count][3] */
  double *stretch;      /**< [hex_count][PATCH_EDGES] 1 / target length of each edge */
  double *shares;       /**< [hex_count][8] what the energy of each corner counts; NULL: 1 */
  double smallest_edge; /**< guarded steps take no edge for shorter than this part of the longest
                             of its hex: scaled Jacobians do not see thin hexes */
  struct tangent_spaces *spaces; /**< where the free points may go, the caller's; NULL: anywhere */
  uint8_t *watched;              /**< [hex_count] how closely the energy looks inside the hex, up to
                                      PATCH_WATCH_MOST: on a grid of 2^watched parts; 0: at the corners only */
} patch;

/** smallest_edge at first: lest edges vanish. */
#define PATCH_SMALLEST_EDGE 0.01

/** The corner at which edge 4 axis + m begins; it ends at that plus 1 << axis. */
static inline int patch_edge_start(int edge) {
  int axis = edge / 4, m = edge % 4;
  int low = axis == 0 ? 1 : 0, high = axis == 2 ? 1 : 2;
  return ((m & 1) << low) | ((m >> 1) << high);
}

/**
 * Copy a part of a mesh. Targets are left unset, no hex is watched.
 * @param hexes       [.][8] of the mesh, VTK order
 * @param positions   [.][3] of the mesh
 * @param free_points [free_count] ids of those that move
 * @param hex_ids     [hex_count] all hexes at them
 * @param slots       [points of the mesh] all -1, and so again afterwards
 * @param out         free with patch_free, also after an error. Linear in the patch.
 */
hexcon_status patch_copy(hexcon_context *context, const int32_t *hexes, const double *positions,
                         const int32_t *free_points, size_t free_count, const int32_t *hex_ids,
                         size_t hex_count, int32_t *slots, patch *out);
void patch_free(hexcon_context *context, patch *p);

/** Present lengths of a hex's edges. @param lengths [PATCH_EDGES] */
void patch_edge_lengths(const patch *p, size_t hex, double *lengths);

/** Targets: every edge's own present length, but at least `smallest` times the longest of its hex;
 * 1 in a hex that has collapsed to a point. */
void patch_target_own_lengths(patch *p, double smallest);

#endif

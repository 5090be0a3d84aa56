/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The hexes around one point, gathered in one place: ids of a large mesh lie anywhere in memory,
 * so each hex is fetched once a corner, and all that is asked of the point is asked there. */
#ifndef HEXCON_HEXMESH_POINT_STAR_H
#define HEXCON_HEXMESH_POINT_STAR_H

#include "corner_table.h"

/** What lies across a side, where it is not another side. */
enum { STAR_BOUNDARY = -1, STAR_CROWDED = -2 };

/** Of hex i around the point, side n is the face through its neighbours n and n + 1. */
typedef struct point_star {
  int32_t point;
  size_t point_count;     /**< of the mesh */
  size_t most;            /**< hexes around any point */
  size_t count;           /**< hexes around this one */
  const int32_t *corners; /**< [count] 8 * hex + corner, ascending */
  int32_t (*others)[7];   /**< [count] ids in the order of hex_corner_others */
  int32_t (*firsts)[7]; /**< [count] where, as 7 * i + k, that id occurs first; -1 below `point` */
  int32_t *opposite;    /**< [3 * count] of side 3 i + n: the matching side of another hex,
                             STAR_BOUNDARY, or STAR_CROWDED for a side beyond the second of its
                             face or against its direction */
  int32_t *slots;       /**< of a hash table */
} point_star;

/** Room for the star of any point. @param out free with point_star_free, also after an error */
hexcon_status point_star_new(hexcon_context *context, const corner_table *table, size_t point_count,
                             point_star *out);
void point_star_free(hexcon_context *context, point_star *star);

/** Gather the star of a point. Expected linear in its hexes (hashing). */
void point_star_gather(point_star *star, const int32_t *hexes, const corner_table *table,
                       int32_t point);

/** Ids of a side of the star but the point: the next, the diagonal and the previous one, counter-
 * clockwise seen from outside its hex. */
void point_star_side(const point_star *star, size_t side, int32_t ids[3]);

#endif

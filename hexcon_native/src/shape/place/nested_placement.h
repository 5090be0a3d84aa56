/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Points of nested layers: each lies where older points lie, but nearer to its anchor inside. */
#ifndef HEXCON_SHAPE_PLACE_NESTED_PLACEMENT_H
#define HEXCON_SHAPE_PLACE_NESTED_PLACEMENT_H

#include "base/context.h"

/** Where points are drawn to: one place for all, such as the centre of a star-shaped body, or each
 * to its own, on a copy of the surface inside it. */
typedef struct anchors {
  const double *places;
  size_t stride; /**< 0: one for all; 3: one for every point of the mesh */
} anchors;

static inline const double *anchor_of(const anchors *to, size_t point) {
  return to->places + to->stride * point;
}

/**
 * Put points at the means of up to four others.
 * @param means  [count][4] rows of `points`, -1: fewer
 * @param points [][3] rows first .. first + count - 1 are written. Linear.
 */
hexcon_status place_plain_means(hexcon_context *context, const int32_t *means, size_t count,
                                size_t first, double *points);

/** As place_plain_means, then draw the points towards their anchors, which are known.
 * @param share  of the way */
hexcon_status place_drawn_means(hexcon_context *context, const int32_t *means, size_t count,
                                size_t first, const anchors *to, double share, double *points);

/** Where a template's point lies over a quad that is split in four: a mean of the base's nine
 * points and the anchors of its corners. */
typedef struct split_place {
  int rows[8]; /**< of the template's points: a part of the base, then the corners */
  double weights[8];
  double anchor_weights[4]; /**< of the corners' anchors */
} split_place;

/**
 * A point on the straight line from a place in the split base to the same place in the two
 * triangles of its corners, the diagonal from corner 0 to 2, drawn towards their anchors: however
 * uneven the base, the inner end is plane.
 * @param local    u, v in the base, 0 .. 1 each, and the part of the way along the line
 * @param corners, edges, middle  rows of the base's nine points: edge i from corner i to i + 1
 * @param share    of the way to the anchors that the inner end is drawn
 */
split_place split_place_at(const double local[3], const int corners[4], const int edges[4],
                           int middle, double share);

/** Put a point of a template where it lies over a quad with the given points. */
void place_over_split_quad(const split_place *place, const int32_t *quad_points, int32_t id,
                           const anchors *to, double *points);

#endif

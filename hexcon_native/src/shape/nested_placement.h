/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Points of nested layers: seen from a centre, each lies where older points lie, but nearer. */
#ifndef HEXCON_SHAPE_NESTED_PLACEMENT_H
#define HEXCON_SHAPE_NESTED_PLACEMENT_H

#include <stddef.h>
#include <stdint.h>

/**
 * Put points at the means of up to four others, drawn towards the centre.
 * @param means  [count][4] rows of `points`, -1: fewer
 * @param share  of the way to the centre
 * @param points [][3] rows first .. first + count - 1 are written. Linear.
 */
void place_drawn_means(const int32_t *means, size_t count, size_t first, const double center[3],
                       double share, double *points);

/** Where a template's point lies over a quad that is split in four: a mean of the base's nine
 * points and the centre. */
typedef struct split_place {
  int rows[8]; /**< of the template's points */
  double weights[8];
  double center_weight;
} split_place;

/**
 * A point on the straight line from a place in the split base to the same place in the two
 * triangles of its corners, the diagonal from corner 0 to 2, drawn towards the centre: however
 * uneven the base, the inner end is plane.
 * @param local    u, v in the base, 0 .. 1 each, and the part of the way along the line
 * @param corners, edges, middle  rows of the base's nine points: edge i from corner i to i + 1
 * @param share    of the way to the centre that the inner end is drawn; 1: it is the centre
 */
split_place split_place_at(const double local[3], const int corners[4], const int edges[4],
                           int middle, double share);

/** Put a point of a template where it lies over a quad with the given points. */
void place_over_split_quad(const split_place *place, const int32_t *quad_points, int32_t id,
                           const double center[3], double *points);

#endif

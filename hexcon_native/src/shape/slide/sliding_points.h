/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The points of a mesh and what they slide on. */
#ifndef HEXCON_SHAPE_SLIDE_SLIDING_POINTS_H
#define HEXCON_SHAPE_SLIDE_SLIDING_POINTS_H

#include "facet_carriers.h"

/** A checked hexcon_sliding, which stays the caller's. */
typedef struct sliding_points {
  size_t point_count;
  const int32_t *carrier_of_point;
  const int32_t *starts;
  hexcon_carrier *pieces; /**< normalised */
  facet_carriers facets;
  hexcon_project project;
  void *project_user;
} sliding_points;

/** BAD_ARGUMENT (carriers, listed), INDEX_OUT_OF_RANGE (points, or facets, listed), TOO_LARGE,
 * OUT_OF_MEMORY.
 * @param out free with sliding_points_free, also after an error. Linear. */
hexcon_status sliding_points_new(hexcon_context *context, const hexcon_sliding *given,
                                 size_t point_count, sliding_points *out);
void sliding_points_free(hexcon_context *context, sliding_points *points);

/** In how many directions a point moves: 0 to 3. */
uint8_t sliding_freedom(const sliding_points *points, int32_t point);

/** Whether hexcon_project is asked where a point is to be. */
bool sliding_is_asked(const sliding_points *points, int32_t point);

/**
 * Put points onto what they lie on: the nearest place on the nearest piece of their carrier. Those
 * without one stay as they are.
 * @param ids         [count] ids in the mesh; NULL: 0 .. count - 1
 * @param x           [count][3] in place
 * @param directions  [count][3] unit tangents of curves, normals of surfaces; others are left as
 * they are; NULL: not wanted Errors: CANCELLED, BAD_ARGUMENT (what `project` answered),
 * OUT_OF_MEMORY; x is then as it was, or put on in part. Linear in the points and their carriers'
 * pieces, and one call of `project`.
 */
hexcon_status sliding_points_project(hexcon_context *context, const sliding_points *points,
                                     const int32_t *ids, size_t count, double *x,
                                     double *directions);

#endif

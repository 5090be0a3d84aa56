/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Which way is in, at every point of a surface. */
#ifndef HEXCON_SHAPE_OFFSET_INWARD_DIRECTIONS_H
#define HEXCON_SHAPE_OFFSET_INWARD_DIRECTIONS_H

#include "surface/half_edges.h"

typedef struct inward_directions {
  double *normals;    /**< [4 quad_count][3] of corner triangles, outward, unit; zero where flat */
  int32_t *starts;    /**< [point_count + 1] into corners */
  int32_t *corners;   /**< [4 quad_count] half-edges that start at each point */
  double *directions; /**< [point_count][3] unit: along it the slowest of the point's corner planes
                           sinks fastest */
  double *sinking;    /**< [point_count] how fast that is, 1 at most; not positive where no way is
                           in for all of them */
} inward_directions;

/** Find them. Linear. @param out free with inward_directions_free, also after an error
 * Errors: OUT_OF_MEMORY. */
hexcon_status inward_directions_new(hexcon_context *context, const surface *s,
                                    inward_directions *out);
void inward_directions_free(hexcon_context *context, inward_directions *in);

/** Cross product of the edges at a corner, outward, where the surface's points are at `points`. */
void corner_normal(const surface *s, int32_t half_edge, const double *points, double normal[3]);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Which triangles lie near a place: a uniform grid of boxes over them. */
#ifndef HEXCON_SHAPE_OFFSET_TRIANGLE_GRID_H
#define HEXCON_SHAPE_OFFSET_TRIANGLE_GRID_H

#include "base/context.h"

typedef struct triangle_grid {
  const double *points;     /**< [][3], the caller's */
  const int32_t *triangles; /**< [triangle_count][3], the caller's */
  size_t triangle_count;
  double low[3], size; /**< of the boxes */
  size_t counts[3];    /**< of boxes along the axes */
  size_t *starts;      /**< [number of boxes + 1] into items */
  int32_t *items;      /**< the triangles that may meet each box: their bounds do */
} triangle_grid;

/**
 * Boxes are about as large as the mean triangle, and no more than there are triangles. Expected
 * linear in time and memory: triangles of very different sizes cost more.
 * @param out  free with triangle_grid_free, also after an error; keeps the arrays
 * Errors: OUT_OF_MEMORY, TOO_LARGE.
 */
hexcon_status triangle_grid_new(hexcon_context *context, const double *points,
                                const int32_t *triangles, size_t triangle_count,
                                triangle_grid *out);
void triangle_grid_free(hexcon_context *context, triangle_grid *grid);

/** The box along an axis in which a coordinate lies, or the nearest one. */
size_t triangle_grid_box(const triangle_grid *grid, size_t axis, double coordinate);

static inline size_t triangle_grid_index(const triangle_grid *grid, const size_t box[3]) {
  return (box[2] * grid->counts[1] + box[1]) * grid->counts[0] + box[0];
}

/** Bounds of a triangle: low[3], then high[3]. */
void triangle_bounds(const triangle_grid *grid, size_t triangle, double bounds[6]);

/** A block of boxes, from first to last along each axis. */
typedef struct box_range {
  size_t first[3], last[3];
} box_range;

/** The boxes that bounds meet. */
box_range triangle_grid_boxes(const triangle_grid *grid, const double bounds[6]);

static inline const double *triangle_corner(const triangle_grid *grid, size_t triangle, size_t i) {
  return grid->points + 3 * (size_t)grid->triangles[3 * triangle + i];
}

#endif

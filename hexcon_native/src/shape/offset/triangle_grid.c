/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "triangle_grid.h"

#include <math.h>
#include <string.h>

void triangle_bounds(const triangle_grid *grid, size_t triangle, double bounds[6]) {
  for (size_t k = 0; k < 3; k++)
    bounds[k] = bounds[3 + k] = triangle_corner(grid, triangle, 0)[k];
  for (size_t i = 1; i < 3; i++)
    for (size_t k = 0; k < 3; k++) {
      bounds[k] = fmin(bounds[k], triangle_corner(grid, triangle, i)[k]);
      bounds[3 + k] = fmax(bounds[3 + k], triangle_corner(grid, triangle, i)[k]);
    }
}

/** Bounds of all, and the mean of the longest sides of the triangles' own. */
static double measure(const triangle_grid *grid, double all[6]) {
  double mean = 0, bounds[6];
  triangle_bounds(grid, 0, all);
  for (size_t t = 0; t < grid->triangle_count; t++) {
    double longest = 0;
    triangle_bounds(grid, t, bounds);
    for (size_t k = 0; k < 3; k++) {
      all[k] = fmin(all[k], bounds[k]);
      all[3 + k] = fmax(all[3 + k], bounds[3 + k]);
      longest = fmax(longest, bounds[3 + k] - bounds[k]);
    }
    mean += longest / (double)grid->triangle_count;
  }
  return mean;
}

/** Boxes of the mean size, larger where they would be too many. */
static void choose_boxes(triangle_grid *grid) {
  const double growth = 1.25;
  double all[6], most = (double)grid->triangle_count + 1;
  grid->size = measure(grid, all);
  if (!(grid->size > 0))
    grid->size = 1; /* all triangles are one point */
  memcpy(grid->low, all, sizeof grid->low);
  double boxes;
  do {
    boxes = 1;
    grid->size *= growth;
    for (size_t k = 0; k < 3; k++)
      boxes *= floor((all[3 + k] - all[k]) / grid->size) + 1;
  } while (boxes > most);
  for (size_t k = 0; k < 3; k++)
    grid->counts[k] = (size_t)floor((all[3 + k] - all[k]) / grid->size) + 1;
}

size_t triangle_grid_box(const triangle_grid *grid, size_t axis, double coordinate) {
  double place = (coordinate - grid->low[axis]) / grid->size;
  if (!(place > 0))
    return 0;
  return place < (double)grid->counts[axis] ? (size_t)place : grid->counts[axis] - 1;
}

box_range triangle_grid_boxes(const triangle_grid *grid, const double bounds[6]) {
  box_range range;
  for (size_t k = 0; k < 3; k++) {
    range.first[k] = triangle_grid_box(grid, k, bounds[k]);
    range.last[k] = triangle_grid_box(grid, k, bounds[3 + k]);
  }
  return range;
}

typedef enum filing { COUNTING, LISTING } filing;

/** Go through the boxes of every triangle: count it there, or list it, from the box's end on. */
static hexcon_status file_all(hexcon_context *context, triangle_grid *grid, filing what) {
  hexcon_status status = HEXCON_OK;
  for (size_t t = grid->triangle_count; !status && t-- > 0;) {
    double bounds[6];
    size_t box[3];
    triangle_bounds(grid, t, bounds);
    box_range r = triangle_grid_boxes(grid, bounds);
    for (box[2] = r.first[2]; box[2] <= r.last[2]; box[2]++)
      for (box[1] = r.first[1]; box[1] <= r.last[1]; box[1]++)
        for (box[0] = r.first[0]; box[0] <= r.last[0]; box[0]++) {
          size_t *start = &grid->starts[triangle_grid_index(grid, box)];
          if (what == COUNTING)
            ++*start;
          else
            grid->items[--*start] = (int32_t)t;
        }
    status = context_pass(context, t);
  }
  return status;
}

hexcon_status triangle_grid_new(hexcon_context *context, const double *points,
                                const int32_t *triangles, size_t triangle_count,
                                triangle_grid *out) {
  *out = (triangle_grid){.points = points, .triangles = triangles};
  out->triangle_count = triangle_count;
  choose_boxes(out);
  size_t boxes = out->counts[0] * out->counts[1] * out->counts[2];
  out->starts = context_allocate_zeroed(context, boxes + 1, sizeof *out->starts);
  if (!out->starts)
    return HEXCON_OUT_OF_MEMORY;
  hexcon_status status = file_all(context, out, COUNTING);
  if (status)
    return status;
  for (size_t i = 0; i < boxes; i++)
    out->starts[i + 1] += out->starts[i];
  out->items = context_allocate(context, out->starts[boxes], sizeof *out->items);
  if (!out->items)
    return HEXCON_OUT_OF_MEMORY;
  return file_all(context, out, LISTING);
}

void triangle_grid_free(hexcon_context *context, triangle_grid *grid) {
  context_free(context, grid->starts);
  context_free(context, grid->items);
  memset(grid, 0, sizeof *grid);
}

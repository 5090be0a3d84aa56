/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "crossing_triangles.h"

#include <string.h>

#include "base/vector.h"
#include "inward_room.h"
#include "triangle_grid.h"

/** Six times the volume over a triangle; whose sign tells on which side of it a place lies. */
static double volume(const double *a, const double *b, const double *c, const double *place) {
  double edges[3][3];
  vector_subtract(b, a, edges[0]);
  vector_subtract(c, a, edges[1]);
  vector_subtract(place, a, edges[2]);
  return vector_determinant(edges[0], edges[1], edges[2]);
}

/** Whether a triangle's edge goes through the inside of another triangle. */
static bool pierces(const triangle_grid *grid, size_t triangle, size_t other) {
  const double *a = triangle_corner(grid, other, 0), *b = triangle_corner(grid, other, 1),
               *c = triangle_corner(grid, other, 2);
  double over[3];
  for (size_t i = 0; i < 3; i++)
    over[i] = volume(a, b, c, triangle_corner(grid, triangle, i));
  for (size_t i = 0; i < 3; i++) {
    const double *from = triangle_corner(grid, triangle, i),
                 *to = triangle_corner(grid, triangle, (i + 1) % 3);
    if ((over[i] > 0) == (over[(i + 1) % 3] > 0))
      continue;
    double x = volume(from, to, a, b), y = volume(from, to, b, c), z = volume(from, to, c, a);
    if ((x > 0) == (y > 0) && (y > 0) == (z > 0))
      return true;
  }
  return false;
}

static bool bounds_meet(const double a[6], const double b[6]) {
  bool meet = true;
  for (size_t k = 0; k < 3; k++)
    meet &= a[k] <= b[3 + k] && b[k] <= a[3 + k];
  return meet;
}

/** Whether two triangles have a point in common, the copy's counted as those they lie under. */
static bool are_neighbours(const triangle_grid *grid, size_t a, size_t b, int32_t point_count) {
  bool found = false;
  for (size_t i = 0; i < 9; i++)
    found |= grid->triangles[3 * a + i / 3] % point_count ==
             grid->triangles[3 * b + i % 3] % point_count;
  return found;
}

static void mark_points(const triangle_grid *grid, size_t triangle, int32_t point_count,
                        uint8_t *marked) {
  for (size_t i = 0; i < 3; i++)
    marked[grid->triangles[3 * triangle + i] % point_count] = 1;
}

typedef struct comparison {
  const triangle_grid *grid;
  size_t outer_count; /* triangles of the surface, before the copy's */
  int32_t point_count;
  uint8_t *marked;
} comparison;

/** Compare a triangle of the copy with those in a box: with earlier ones of the copy it has been.
 */
static bool crosses_in_box(const comparison *c, size_t triangle, const double bounds[6],
                           const size_t box[3]) {
  const triangle_grid *grid = c->grid;
  size_t index = triangle_grid_index(grid, box);
  bool found = false;
  for (size_t i = grid->starts[index]; i < grid->starts[index + 1]; i++) {
    size_t other = (size_t)grid->items[i];
    double others[6];
    if (other >= c->outer_count && other <= triangle)
      continue;
    triangle_bounds(grid, other, others);
    if (!bounds_meet(bounds, others) || are_neighbours(grid, triangle, other, c->point_count))
      continue;
    if (pierces(grid, triangle, other) || pierces(grid, other, triangle)) {
      mark_points(grid, other, c->point_count, c->marked);
      found = true;
    }
  }
  return found;
}

static bool crosses_any(const comparison *c, size_t triangle) {
  double bounds[6];
  size_t box[3];
  bool found = false;
  triangle_bounds(c->grid, triangle, bounds);
  box_range r = triangle_grid_boxes(c->grid, bounds);
  for (box[2] = r.first[2]; box[2] <= r.last[2]; box[2]++)
    for (box[1] = r.first[1]; box[1] <= r.last[1]; box[1]++)
      for (box[0] = r.first[0]; box[0] <= r.last[0]; box[0]++)
        found |= crosses_in_box(c, triangle, bounds, box);
  if (found)
    mark_points(c->grid, triangle, c->point_count, c->marked);
  return found;
}

/** The surface, then its copy. */
static hexcon_status gather(hexcon_context *context, const surface *s, const double *inner,
                            double **points, int32_t **triangles) {
  size_t corners = 6 * s->quad_count;
  *points = context_allocate(context, 2 * s->point_count, 3 * sizeof **points);
  *triangles = context_allocate(context, 2 * corners, sizeof **triangles);
  if (!*points || !*triangles)
    return HEXCON_OUT_OF_MEMORY;
  memcpy(*points, s->points, 3 * s->point_count * sizeof **points);
  memcpy(*points + 3 * s->point_count, inner, 3 * s->point_count * sizeof **points);
  surface_triangles(s, *triangles);
  for (size_t i = 0; i < corners; i++)
    (*triangles)[corners + i] = (*triangles)[i] + (int32_t)s->point_count;
  return HEXCON_OK;
}

hexcon_status crossing_triangles_mark(hexcon_context *context, const surface *s,
                                      const double *inner, uint8_t *marked, size_t *count) {
  triangle_grid grid = {0};
  double *points = NULL;
  int32_t *triangles = NULL;
  size_t outer = 2 * s->quad_count;
  *count = 0;
  hexcon_status status = gather(context, s, inner, &points, &triangles);
  if (!status)
    status = triangle_grid_new(context, points, triangles, 2 * outer, &grid);
  comparison c = {&grid, outer, (int32_t)s->point_count, marked};
  for (size_t t = outer; !status && t < 2 * outer; t++) {
    *count += crosses_any(&c, t);
    status = context_pass(context, t);
  }
  triangle_grid_free(context, &grid);
  context_free(context, points);
  context_free(context, triangles);
  return status;
}

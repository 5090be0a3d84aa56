/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "inward_room.h"

#include <string.h>

#include "base/vector.h"
#include "triangle_grid.h"

void surface_triangles(const surface *s, int32_t *out) {
  for (size_t q = 0; q < s->quad_count; q++) {
    const int32_t *v = s->quads + 4 * q;
    const int32_t halves[6] = {v[0], v[1], v[2], v[0], v[2], v[3]};
    memcpy(out + 6 * q, halves, sizeof halves);
  }
}

typedef struct ray {
  const double *from, *direction;
  double length; /* to the first quad found, or to the end */
} ray;

/** Shorten the ray to where it leaves through a triangle. Source: Moeller and Trumbore, Fast,
 * minimum storage ray-triangle intersection (1997). */
static void meet(const triangle_grid *grid, size_t triangle, ray *r) {
  double a[3], b[3], across[3], to[3], turned[3];
  const double *corner = triangle_corner(grid, triangle, 0);
  vector_subtract(triangle_corner(grid, triangle, 1), corner, a);
  vector_subtract(triangle_corner(grid, triangle, 2), corner, b);
  vector_cross(r->direction, b, across);
  double scale = -vector_dot(a, across); /* positive where the ray leaves the body */
  if (!(scale > 0))
    return;
  vector_subtract(r->from, corner, to);
  double u = -vector_dot(to, across);
  vector_cross(to, a, turned);
  double v = -vector_dot(r->direction, turned), way = -vector_dot(b, turned);
  if (u >= 0 && v >= 0 && u + v <= scale && way > 0 && way < scale * r->length)
    r->length = way / scale;
}

static bool has_corner(const surface *s, size_t quad, size_t point) {
  bool found = false;
  for (size_t i = 0; i < 4; i++)
    found |= (size_t)s->quads[4 * quad + i] == point;
  return found;
}

static void meet_box(const surface *s, const triangle_grid *grid, const size_t box[3], size_t point,
                     ray *r) {
  size_t index = triangle_grid_index(grid, box);
  for (size_t i = grid->starts[index]; i < grid->starts[index + 1]; i++) {
    size_t triangle = (size_t)grid->items[i];
    if (!has_corner(s, triangle / 2, point))
      meet(grid, triangle, r);
  }
}

/** Way along the ray to where it leaves the box along an axis. */
static double way_out(const triangle_grid *grid, const ray *r, size_t axis, size_t box) {
  double d = r->direction[axis];
  if (d == 0)
    return INFINITY;
  double side = grid->low[axis] + grid->size * (double)(box + (d > 0));
  return (side - r->from[axis]) / d;
}

/** Box after box. Source: Amanatides and Woo, A fast voxel traversal algorithm (1987). */
static void follow(const surface *s, const triangle_grid *grid, size_t point, ray *r) {
  size_t box[3];
  for (size_t k = 0; k < 3; k++)
    box[k] = triangle_grid_box(grid, k, r->from[k]);
  for (;;) {
    size_t axis = 0;
    double next = INFINITY;
    meet_box(s, grid, box, point, r);
    for (size_t k = 0; k < 3; k++) {
      double way = way_out(grid, r, k, box[k]);
      if (way < next) {
        next = way;
        axis = k;
      }
    }
    bool up = r->direction[axis] > 0;
    if (!(next < r->length) || box[axis] == (up ? grid->counts[axis] - 1 : 0))
      return;
    box[axis] = up ? box[axis] + 1 : box[axis] - 1;
  }
}

hexcon_status inward_room_find(hexcon_context *context, const surface *s, const double *directions,
                               double *room) {
  triangle_grid grid = {0};
  int32_t *triangles = context_allocate(context, 6 * s->quad_count, sizeof *triangles);
  if (!triangles)
    return HEXCON_OUT_OF_MEMORY;
  surface_triangles(s, triangles);
  hexcon_status status = triangle_grid_new(context, s->points, triangles, 2 * s->quad_count, &grid);
  for (size_t v = 0; !status && v < s->point_count; v++) {
    ray r = {s->points + 3 * v, directions + 3 * v, room[v]};
    follow(s, &grid, v, &r);
    room[v] = r.length;
    status = context_pass(context, v);
  }
  triangle_grid_free(context, &grid);
  context_free(context, triangles);
  return status;
}

/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "disc_shapes.h"

#include "base/vector.h"

static const double pi = 3.14159265358979324;

/** A grid as square as this counts as much as so many square radians in its corners. */
static const double squareness = 0.05;

static const double *rail_point(const surface *s, const int32_t *ring, size_t length, size_t i,
                                int side) {
  const int32_t entry = ring[i % length];
  return s->points + 3 * (size_t)(side == 0 ? half_edge_start(s, entry) : half_edge_end(s, entry));
}

/** Add the angles inside a rail, seen along its vector area. */
static void add_angles(const surface *s, const int32_t *ring, size_t length, int side,
                       double *angles) {
  double normal[3] = {0, 0, 0}, a[3], b[3], cross[3];
  const double *origin = rail_point(s, ring, length, 0, side);
  for (size_t i = 1; i + 1 < length; i++) {
    vector_subtract(rail_point(s, ring, length, i, side), origin, a);
    vector_subtract(rail_point(s, ring, length, i + 1, side), origin, b);
    vector_cross(a, b, cross);
    vector_add_scaled(normal, 1, cross);
  }
  double area = vector_length(normal);
  for (size_t i = 0; i < length; i++) {
    const double *here = rail_point(s, ring, length, i, side);
    vector_subtract(rail_point(s, ring, length, i + 1, side), here, a);
    vector_subtract(rail_point(s, ring, length, i + length - 1, side), here, b);
    if (area > 0) { /* as seen along the normal */
      vector_add_scaled(a, -vector_dot(a, normal) / (area * area), normal);
      vector_add_scaled(b, -vector_dot(b, normal) / (area * area), normal);
    }
    vector_cross(a, b, cross);
    double angle = atan2(area > 0 ? vector_dot(cross, normal) / area : 0, vector_dot(a, b));
    angles[i] += angle < 0 ? angle + 2 * pi : angle;
  }
}

/** What a corner with one quad loses against one with two. */
static double corner_loss(double angle) {
  double from_right = angle - pi / 2, from_flat = angle - pi;
  return from_right * from_right - from_flat * from_flat;
}

/** Keep a shape if it is among the best. */
static void keep(rated_shape *best, size_t *count, rated_shape shape) {
  size_t at = *count < DISC_SHAPES_MOST ? (*count)++ : DISC_SHAPES_MOST;
  if (at == DISC_SHAPES_MOST && shape.misfit >= best[--at].misfit)
    return;
  for (; at > 0 && shape.misfit < best[at - 1].misfit; at--)
    best[at] = best[at - 1];
  best[at] = shape;
}

/** Half a turn of a grid, a quarter of a square one, makes no other. @param losses  [length] by
 * corner */
static hexcon_status rate(hexcon_context *context, const double *losses, size_t length, double flat,
                          rated_shape *best, size_t *count) {
  const size_t half = length / 2;
  hexcon_status status = HEXCON_OK;
  for (size_t a = 1; !status && a <= half - a; a++) {
    const size_t b = half - a, firsts = a == b ? a : half;
    for (size_t first = 0; first < firsts; first++) {
      double loss = flat + squareness * (double)(b - a) / (double)half;
      loss += losses[first] + losses[first + a];
      loss += losses[first + half] + losses[(first + half + a) % length];
      keep(best, count, (rated_shape){{a, b, 0, first}, loss});
    }
    status = context_after(context, firsts);
  }
  return status;
}

hexcon_status disc_shapes_find(hexcon_context *context, const surface *s, const int32_t *ring,
                               size_t length, rated_shape *shapes, size_t *count, double *flat) {
  *count = 0;
  *flat = 0;
  double *losses = context_allocate_zeroed(context, length, sizeof *losses);
  if (!losses)
    return HEXCON_OUT_OF_MEMORY;
  add_angles(s, ring, length, 0, losses);
  add_angles(s, ring, length, 1, losses);
  for (size_t i = 0; i < length; i++) {
    const double angle = losses[i] / 2;
    *flat += (angle - pi) * (angle - pi);
    losses[i] = corner_loss(angle);
  }
  hexcon_status status = rate(context, losses, length, *flat, shapes, count);
  context_free(context, losses);
  return status;
}

/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "pillow_bound.h"

#include <math.h>
#include <string.h>

#include "base/vector.h"

/** The quads' corners at each point, one point after the other. */
typedef struct corner_fan {
  size_t *starts;       /* [point_count + 1] */
  double (*normals)[3]; /* [4 quad_count] products of the unit edges, inward */
} corner_fan;

static void fan_free(hexcon_context *context, corner_fan *fan) {
  context_free(context, fan->starts);
  context_free(context, fan->normals);
}

/** Zero where an edge has no length. */
static void corner_normal(const double *points, const int32_t *quad, size_t corner,
                          double normal[3]) {
  const double *here = points + 3 * (size_t)quad[corner];
  double next[3], previous[3];
  vector_subtract(points + 3 * (size_t)quad[(corner + 1) % 4], here, next);
  vector_subtract(points + 3 * (size_t)quad[(corner + 3) % 4], here, previous);
  vector_cross(previous, next, normal);
  double lengths = vector_length(next) * vector_length(previous);
  for (size_t i = 0; i < 3; i++)
    normal[i] = lengths > 0 ? normal[i] / lengths : 0;
}

static hexcon_status fan_new(hexcon_context *context, const double *points, size_t point_count,
                             const int32_t *quads, size_t quad_count, corner_fan *out) {
  out->starts = context_allocate_zeroed(context, point_count + 2, sizeof *out->starts);
  out->normals = context_allocate(context, 4 * quad_count, sizeof *out->normals);
  if (!out->starts || !out->normals)
    return HEXCON_OUT_OF_MEMORY;
  size_t *ends = out->starts + 1; /* of what is filled so far: the starts, when all is */
  for (size_t i = 0; i < 4 * quad_count; i++)
    ends[(size_t)quads[i] + 1]++;
  for (size_t v = 0; v < point_count; v++)
    ends[v + 1] += ends[v];
  hexcon_status status = context_after(context, point_count);
  for (size_t i = 0; !status && i < 4 * quad_count; i++) {
    corner_normal(points, quads + i / 4 * 4, i % 4, out->normals[ends[quads[i]]++]);
    status = context_pass(context, i);
  }
  return status;
}

/** The point of the segment from `from` to `to` that is nearest to the origin. */
static void move_nearer(double from[3], const double to[3]) {
  double way[3];
  vector_subtract(to, from, way);
  double square = vector_dot(way, way);
  double part = square > 0 ? -vector_dot(from, way) / square : 0;
  vector_add_scaled(from, fmin(1, fmax(0, part)), way);
}

/** Distance of the convex hull of some points from the origin. */
static double hull_distance(double (*hull)[3], size_t count) {
  enum { MOST_STEPS = 200 };
  const double precise = 1e-3;
  double nearest[3] = {0, 0, 0};
  for (size_t i = 0; i < count; i++)
    vector_add_scaled(nearest, 1 / (double)count, hull[i]);
  for (int step = 0; step < MOST_STEPS; step++) {
    size_t lowest = 0;
    for (size_t i = 1; i < count; i++)
      if (vector_dot(hull[i], nearest) < vector_dot(hull[lowest], nearest))
        lowest = i;
    double square = vector_dot(nearest, nearest);
    if (square - vector_dot(hull[lowest], nearest) <= precise * square)
      break;
    move_nearer(nearest, hull[lowest]);
  }
  return vector_length(nearest);
}

hexcon_status pillow_bounds(hexcon_context *context, const double *points, size_t point_count,
                            const int32_t *quads, size_t quad_count, double *bounds) {
  corner_fan fan = {0};
  hexcon_status status = fan_new(context, points, point_count, quads, quad_count, &fan);
  for (size_t v = 0; !status && v < point_count; v++) {
    size_t count = fan.starts[v + 1] - fan.starts[v];
    bounds[v] = count > 0 ? hull_distance(fan.normals + fan.starts[v], count) : 1;
    status = context_pass(context, v);
  }
  fan_free(context, &fan);
  return status;
}

double pillow_bound_least(const double *bounds, size_t point_count, size_t *worst) {
  double least = 1;
  *worst = 0;
  for (size_t v = 0; v < point_count; v++)
    if (bounds[v] < least) {
      least = bounds[v];
      *worst = v;
    }
  return least;
}

/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "inward_directions.h"

#include <string.h>

#include "base/vector.h"

static void scale(double v[3], double factor) {
  for (int k = 0; k < 3; k++)
    v[k] *= factor;
}

void corner_normal(const surface *s, int32_t half_edge, const double *points, double normal[3]) {
  const double *here = points + 3 * (size_t)half_edge_start(s, half_edge);
  double next[3], previous[3];
  vector_subtract(points + 3 * (size_t)half_edge_end(s, half_edge), here, next);
  vector_subtract(points + 3 * (size_t)half_edge_start(s, half_edge_turn(half_edge, -1)), here,
                  previous);
  vector_cross(next, previous, normal);
}

static void collect_corners(const surface *s, inward_directions *out) {
  int32_t corner_count = (int32_t)(4 * s->quad_count);
  memset(out->starts, 0, (s->point_count + 1) * sizeof *out->starts);
  for (int32_t h = 0; h < corner_count; h++)
    out->starts[s->quads[h] + 1]++;
  for (size_t v = 0; v < s->point_count; v++)
    out->starts[v + 1] += out->starts[v];
  for (int32_t h = corner_count; h-- > 0;)
    out->corners[--out->starts[s->quads[h] + 1]] = h;
  memmove(out->starts, out->starts + 1, s->point_count * sizeof *out->starts);
  out->starts[s->point_count] = corner_count;
  for (int32_t h = 0; h < corner_count; h++) {
    double *normal = out->normals + 3 * (size_t)h;
    corner_normal(s, h, s->points, normal);
    double length = vector_length(normal);
    scale(normal, length > 0 ? 1 / length : 0);
  }
}

/** How fast the slowest plane at a point sinks along a unit direction. */
static double slowest(const inward_directions *in, size_t v, const double direction[3],
                      int32_t *corner) {
  double least = 2;
  for (int32_t i = in->starts[v]; i < in->starts[v + 1]; i++) {
    double sinking = -vector_dot(in->normals + 3 * (size_t)in->corners[i], direction);
    if (sinking < least) {
      least = sinking;
      *corner = in->corners[i];
    }
  }
  return least;
}

/** The centre of the smallest cap about the normals, nearly. Source: Badoiu and Clarkson, Smaller
 * core-sets for balls (2003).
 * @return how fast the slowest plane sinks then */
static double deepest_direction(const inward_directions *in, size_t v, double direction[3]) {
  const int most_steps = 64;
  double best_sinking = -2, current[3] = {0};
  memset(direction, 0, 3 * sizeof *direction);
  for (int32_t i = in->starts[v]; i < in->starts[v + 1]; i++)
    vector_add_scaled(current, -1, in->normals + 3 * (size_t)in->corners[i]);
  for (int step = 0; step < most_steps; step++) {
    double length = vector_length(current);
    if (!(length > 0))
      break;
    scale(current, 1 / length);
    int32_t corner = in->corners[in->starts[v]];
    double sinking = slowest(in, v, current, &corner);
    if (sinking > best_sinking) {
      best_sinking = sinking;
      memcpy(direction, current, sizeof current);
    }
    vector_add_scaled(current, -1.0 / (step + 2), in->normals + 3 * (size_t)corner);
  }
  return best_sinking;
}

hexcon_status inward_directions_new(hexcon_context *context, const surface *s,
                                    inward_directions *out) {
  size_t points = s->point_count, corners = 4 * s->quad_count;
  out->normals = context_allocate(context, corners, 3 * sizeof *out->normals);
  out->starts = context_allocate(context, points + 1, sizeof *out->starts);
  out->corners = context_allocate(context, corners, sizeof *out->corners);
  out->directions = context_allocate(context, points, 3 * sizeof *out->directions);
  out->sinking = context_allocate(context, points, sizeof *out->sinking);
  if (!out->normals || !out->starts || !out->corners || !out->directions || !out->sinking)
    return HEXCON_OUT_OF_MEMORY;
  collect_corners(s, out);
  hexcon_status status = context_after(context, corners);
  for (size_t v = 0; !status && v < points; v++) {
    out->sinking[v] = deepest_direction(out, v, out->directions + 3 * v);
    status = context_pass(context, v);
  }
  return status;
}

void inward_directions_free(hexcon_context *context, inward_directions *in) {
  context_free(context, in->normals);
  context_free(context, in->starts);
  context_free(context, in->corners);
  context_free(context, in->directions);
  context_free(context, in->sinking);
  memset(in, 0, sizeof *in);
}

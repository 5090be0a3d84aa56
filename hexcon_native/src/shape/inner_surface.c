/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "inner_surface.h"

#include <string.h>

#include "base/vector.h"

/** A point sinks no farther than this times its depth, however sharp the rim it is on. */
static const double longest_step = 2.0;

/** Boxes and triangles count as folded below this part of what they have in the shrunk copy. */
static const double least_part = 0.1;

typedef struct offsetting {
  const surface *s;
  const inner_surface_options *options;
  double *normals;  /* [4 quad_count][3] of corner triangles, outward, unit */
  int32_t *starts;  /* [point_count + 1] into corners */
  int32_t *corners; /* [4 quad_count] half-edges that start at each point */
  double *depth;    /* [point_count] */
  double *smooth;   /* [point_count] */
  double *offset;   /* [point_count][3] the offset copy */
  double *drawn;    /* [point_count] 0: at the offset, 1: at the shrunk copy */
  uint8_t *folded;  /* [point_count] */
} offsetting;

static const double *corner_place(const offsetting *o, int32_t h, const double *points) {
  return points + 3 * (size_t)o->s->quads[h];
}

/** Cross product of the edges at a corner, outward. */
static void corner_normal(const offsetting *o, int32_t h, const double *points, double normal[3]) {
  double next[3], previous[3];
  vector_subtract(corner_place(o, half_edge_turn(h, 1), points), corner_place(o, h, points), next);
  vector_subtract(corner_place(o, half_edge_turn(h, -1), points), corner_place(o, h, points),
                  previous);
  vector_cross(next, previous, normal);
}

static void scale(double v[3], double factor) {
  for (int k = 0; k < 3; k++)
    v[k] *= factor;
}

static void collect_corners(offsetting *o) {
  const surface *s = o->s;
  int32_t corner_count = (int32_t)(4 * s->quad_count);
  memset(o->starts, 0, (s->point_count + 1) * sizeof *o->starts);
  for (int32_t h = 0; h < corner_count; h++)
    o->starts[s->quads[h] + 1]++;
  for (size_t v = 0; v < s->point_count; v++)
    o->starts[v + 1] += o->starts[v];
  for (int32_t h = corner_count; h-- > 0;)
    o->corners[--o->starts[s->quads[h] + 1]] = h;
  memmove(o->starts, o->starts + 1, s->point_count * sizeof *o->starts);
  o->starts[s->point_count] = corner_count;
  for (int32_t h = 0; h < corner_count; h++) {
    double *normal = o->normals + 3 * (size_t)h;
    corner_normal(o, h, s->points, normal);
    double length = vector_length(normal);
    scale(normal, length > 0 ? 1 / length : 0);
  }
}

/** How fast the slowest plane at a point sinks along a unit direction. */
static double slowest(const offsetting *o, size_t v, const double direction[3], int32_t *corner) {
  double least = 2;
  for (int32_t i = o->starts[v]; i < o->starts[v + 1]; i++) {
    double sinking = -vector_dot(o->normals + 3 * (size_t)o->corners[i], direction);
    if (sinking < least) {
      least = sinking;
      *corner = o->corners[i];
    }
  }
  return least;
}

/** The unit direction along which the slowest plane sinks fastest, nearly: the centre of the
 * smallest cap about the normals. Source: Badoiu and Clarkson, Smaller core-sets for balls (2003).
 * @return how fast that is */
static double deepest_direction(const offsetting *o, size_t v, double direction[3]) {
  const int most_steps = 64;
  double best_sinking = -2, current[3] = {0};
  for (int32_t i = o->starts[v]; i < o->starts[v + 1]; i++)
    vector_add_scaled(current, -1, o->normals + 3 * (size_t)o->corners[i]);
  for (int step = 0; step < most_steps; step++) {
    double length = vector_length(current);
    if (!(length > 0))
      break;
    scale(current, 1 / length);
    int32_t corner = o->corners[o->starts[v]];
    double sinking = slowest(o, v, current, &corner);
    if (sinking > best_sinking) {
      best_sinking = sinking;
      memcpy(direction, current, sizeof current);
    }
    vector_add_scaled(current, -1.0 / (step + 2), o->normals + 3 * (size_t)corner);
  }
  return best_sinking;
}

/** Wanted depth at a point, as the sizes and the planes there allow. */
static double local_depth(const offsetting *o, size_t v) {
  double size = 0, room = INFINITY;
  const double *here = o->s->points + 3 * v;
  for (int32_t i = o->starts[v]; i < o->starts[v + 1]; i++) {
    int32_t h = o->corners[i];
    double edge[3], inward[3];
    vector_subtract(corner_place(o, half_edge_turn(h, 1), o->s->points), here, edge);
    vector_subtract(o->options->center, here, inward);
    size += vector_length(edge) / (o->starts[v + 1] - o->starts[v]);
    room = fmin(room, -vector_dot(o->normals + 3 * (size_t)h, inward));
  }
  double wanted = o->options->thickness * size;
  return o->options->no_center ? wanted : fmin(wanted, o->options->depth * room);
}

/** Depths that vary smoothly, none larger than before. */
static void smooth_depths(offsetting *o) {
  const int passes = 3;
  for (int pass = 0; pass < passes; pass++) {
    for (size_t v = 0; v < o->s->point_count; v++) {
      double sum = 0, count = o->starts[v + 1] - o->starts[v];
      for (int32_t i = o->starts[v]; i < o->starts[v + 1]; i++)
        sum += o->depth[half_edge_end(o->s, o->corners[i])];
      o->smooth[v] = fmin(o->depth[v], (o->depth[v] + sum / count) / 2);
    }
    memcpy(o->depth, o->smooth, o->s->point_count * sizeof *o->depth);
  }
}

static void place_offset(offsetting *o) {
  for (size_t v = 0; v < o->s->point_count; v++)
    o->depth[v] = local_depth(o, v);
  smooth_depths(o);
  for (size_t v = 0; v < o->s->point_count; v++) {
    double direction[3] = {0}, *place = o->offset + 3 * v;
    double sinking = deepest_direction(o, v, direction);
    memcpy(place, o->s->points + 3 * v, 3 * sizeof *place);
    o->drawn[v] = sinking > 0 || o->options->no_center ? 0 : 1;
    if (sinking > 0)
      vector_add_scaled(place, o->depth[v] * fmin(1 / sinking, longest_step), direction);
  }
}

/** Between the offset and the copy shrunk to the centre. */
static void blend(const offsetting *o, double *inner) {
  for (size_t v = 0; v < o->s->point_count; v++)
    for (size_t k = 0; k < 3; k++) {
      double p = o->s->points[3 * v + k];
      double shrunk = p + o->options->depth * (o->options->center[k] - p);
      inner[3 * v + k] = (1 - o->drawn[v]) * o->offset[3 * v + k] + o->drawn[v] * shrunk;
    }
}

/** The upright edge's height over the outer and the inner corner triangle, and the inner one's over
 * the centre, each relative to what the shrunk copy has. */
static double corner_worth(const offsetting *o, int32_t h, const double *inner) {
  const double *outer_corner = corner_place(o, h, o->s->points),
               *inner_corner = corner_place(o, h, inner);
  double upright[3], to_center[3], outer_normal[3], inner_normal[3], depth = o->options->depth;
  vector_subtract(inner_corner, outer_corner, upright);
  vector_subtract(o->options->center, outer_corner, to_center);
  corner_normal(o, h, o->s->points, outer_normal);
  corner_normal(o, h, inner, inner_normal);
  double height = -vector_dot(outer_normal, to_center) * depth;
  if (!(height > 0))
    return 1; /* a folded corner, which the centre does not see: nothing to compare with */
  double outer = -vector_dot(outer_normal, upright) / height;
  double shrink = (1 - depth) * (1 - depth);
  double inside = -vector_dot(inner_normal, upright) / (height * shrink);
  vector_subtract(o->options->center, inner_corner, to_center);
  double core = -vector_dot(inner_normal, to_center) / (height / depth * shrink * (1 - depth));
  /* a thin layer is no fold: its boxes are as flat outside as inside */
  return fmin(fmin(inside / fmin(1, fmax(outer, 1e-6)), core), outer > 0 ? 1 : outer);
}

static size_t mark_folded(offsetting *o, const double *inner) {
  size_t count = 0;
  memset(o->folded, 0, o->s->point_count);
  for (int32_t h = 0; h < (int32_t)(4 * o->s->quad_count); h++) {
    if (corner_worth(o, h, inner) >= least_part)
      continue;
    count++;
    for (int turn = -1; turn <= 1; turn++)
      o->folded[o->s->quads[half_edge_turn(h, turn)]] = 1;
  }
  return count;
}

/** Draw folded corners, and their neighbours half as much, towards the shrunk copy. */
static void draw_folded(offsetting *o) {
  const double step = 0.25;
  for (size_t v = 0; v < o->s->point_count; v++)
    o->smooth[v] = o->drawn[v];
  for (size_t v = 0; v < o->s->point_count; v++) {
    if (!o->folded[v])
      continue;
    o->smooth[v] = fmin(1, o->drawn[v] + step);
    for (int32_t i = o->starts[v]; i < o->starts[v + 1]; i++) {
      size_t w = (size_t)half_edge_end(o->s, o->corners[i]);
      o->smooth[w] = fmax(o->smooth[w], (o->smooth[v] + o->drawn[w]) / 2);
    }
  }
  memcpy(o->drawn, o->smooth, o->s->point_count * sizeof *o->drawn);
}

static hexcon_status offsetting_new(hexcon_context *context, const surface *s, offsetting *o) {
  size_t points = s->point_count, corners = 4 * s->quad_count;
  o->s = s;
  o->normals = context_allocate(context, corners, 3 * sizeof *o->normals);
  o->starts = context_allocate(context, points + 1, sizeof *o->starts);
  o->corners = context_allocate(context, corners, sizeof *o->corners);
  o->depth = context_allocate(context, points, sizeof *o->depth);
  o->smooth = context_allocate(context, points, sizeof *o->smooth);
  o->offset = context_allocate(context, points, 3 * sizeof *o->offset);
  o->drawn = context_allocate(context, points, sizeof *o->drawn);
  o->folded = context_allocate(context, points, sizeof *o->folded);
  bool complete = o->normals && o->starts && o->corners && o->depth && o->smooth && o->offset &&
                  o->drawn && o->folded;
  return complete ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

static void offsetting_free(hexcon_context *context, offsetting *o) {
  context_free(context, o->normals);
  context_free(context, o->starts);
  context_free(context, o->corners);
  context_free(context, o->depth);
  context_free(context, o->smooth);
  context_free(context, o->offset);
  context_free(context, o->drawn);
  context_free(context, o->folded);
}

hexcon_status inner_surface_place(hexcon_context *context, const surface *s,
                                  const inner_surface_options *options, double *inner) {
  const int most_rounds = 20;
  offsetting o = {.options = options};
  hexcon_status status = offsetting_new(context, s, &o);
  if (!status) {
    collect_corners(&o);
    place_offset(&o);
    blend(&o, inner);
    size_t folded = options->no_center ? 0 : mark_folded(&o, inner);
    for (int round = 0; folded > 0 && round < most_rounds; round++) {
      draw_folded(&o);
      blend(&o, inner);
      folded = mark_folded(&o, inner);
    }
    for (size_t v = 0; folded > 0 && v < s->point_count; v++)
      o.drawn[v] = 1;
    blend(&o, inner);
  }
  offsetting_free(context, &o);
  return status;
}

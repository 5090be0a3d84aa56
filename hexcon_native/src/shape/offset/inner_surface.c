/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "inner_surface.h"

#include <string.h>

#include "base/vector.h"
#include "crossing_triangles.h"
#include "inward_directions.h"
#include "inward_room.h"

/** A point sinks no farther than this times its depth, however sharp the rim it is on. */
static const double longest_step = 2.0;

/** Boxes and triangles count as folded below this part of what they have in the shrunk copy. */
static const double least_part = 0.1;

/** Without a centre: of the way to the opposite side, so that both sides' copies keep apart; .. */
static const double part_of_room = 0.35;
/** .. where the copy folds, or crosses something, its points rise to this part of their depth; ..
 */
static const double rising = 0.6;
/** .. a box between the surface and the copy counts as folded whose upright edge has less than this
 * part of its length over the copy's corner, or over the surface's by less than there. */
static const double least_sine = 0.15, least_of_outer = 0.5;

typedef struct offsetting {
  const surface *s;
  const inner_surface_options *options;
  inward_directions in;
  double *depth;   /* [point_count] */
  double *smooth;  /* [point_count] */
  double *offset;  /* [point_count][3] the offset copy */
  double *drawn;   /* [point_count] 0: at the offset, 1: at the shrunk copy */
  uint8_t *folded; /* [point_count] */
} offsetting;

static const double *corner_place(const offsetting *o, int32_t h, const double *points) {
  return points + 3 * (size_t)o->s->quads[h];
}

/** Wanted depth at a point, as the sizes and the planes there allow. */
static double local_depth(const offsetting *o, size_t v) {
  double size = 0, room = INFINITY;
  const double *here = o->s->points + 3 * v;
  for (int32_t i = o->in.starts[v]; i < o->in.starts[v + 1]; i++) {
    int32_t h = o->in.corners[i];
    double edge[3], inward[3];
    vector_subtract(corner_place(o, half_edge_turn(h, 1), o->s->points), here, edge);
    vector_subtract(o->options->center, here, inward);
    size += vector_length(edge) / (o->in.starts[v + 1] - o->in.starts[v]);
    room = fmin(room, -vector_dot(o->in.normals + 3 * (size_t)h, inward));
  }
  double wanted = o->options->thickness * size;
  return o->options->no_center ? wanted : fmin(wanted, o->options->depth * room);
}

/** Depths that vary smoothly, none larger than before. */
static void smooth_depths(offsetting *o) {
  const int passes = 3;
  for (int pass = 0; pass < passes; pass++) {
    for (size_t v = 0; v < o->s->point_count; v++) {
      double sum = 0, count = o->in.starts[v + 1] - o->in.starts[v];
      for (int32_t i = o->in.starts[v]; i < o->in.starts[v + 1]; i++)
        sum += o->depth[half_edge_end(o->s, o->in.corners[i])];
      o->smooth[v] = fmin(o->depth[v], (o->depth[v] + sum / count) / 2);
    }
    memcpy(o->depth, o->smooth, o->s->point_count * sizeof *o->depth);
  }
}

/** Way along a point's direction, by which its slowest plane sinks so deep, if it can. */
static double way_for(const offsetting *o, size_t v, double depth) {
  double sinking = o->in.sinking[v];
  return depth * (sinking > 0 ? fmin(1 / sinking, longest_step) : longest_step);
}

static void place_offset(offsetting *o) {
  for (size_t v = 0; v < o->s->point_count; v++) {
    double *place = o->offset + 3 * v;
    bool stays = !(o->in.sinking[v] > 0) && !o->options->no_center;
    memcpy(place, o->s->points + 3 * v, 3 * sizeof *place);
    o->drawn[v] = stays;
    if (!stays)
      vector_add_scaled(place, way_for(o, v, o->depth[v]), o->in.directions + 3 * v);
  }
}

static void find_depths(offsetting *o) {
  for (size_t v = 0; v < o->s->point_count; v++)
    o->depth[v] = local_depth(o, v);
  smooth_depths(o);
}

/* ---------------------------------------------------------------------------------- with a centre
 */

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
  corner_normal(o->s, h, o->s->points, outer_normal);
  corner_normal(o->s, h, inner, inner_normal);
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
    for (int32_t i = o->in.starts[v]; i < o->in.starts[v + 1]; i++) {
      size_t w = (size_t)half_edge_end(o->s, o->in.corners[i]);
      o->smooth[w] = fmax(o->smooth[w], (o->smooth[v] + o->drawn[w]) / 2);
    }
  }
  memcpy(o->drawn, o->smooth, o->s->point_count * sizeof *o->drawn);
}

static hexcon_status draw_to_center(hexcon_context *context, offsetting *o, double *inner) {
  const int most_rounds = 20;
  place_offset(o);
  blend(o, inner);
  size_t folded = mark_folded(o, inner);
  hexcon_status status = context_after(context, o->s->quad_count);
  for (int round = 0; !status && folded > 0 && round < most_rounds; round++) {
    draw_folded(o);
    blend(o, inner);
    folded = mark_folded(o, inner);
    status = context_after(context, o->s->quad_count);
  }
  for (size_t v = 0; folded > 0 && v < o->s->point_count; v++)
    o->drawn[v] = 1;
  blend(o, inner);
  return status;
}

/* ------------------------------------------------------------------------------- without a centre
 */

/** Keep away from the opposite side. */
static hexcon_status keep_room(hexcon_context *context, offsetting *o) {
  double *room = o->smooth;
  for (size_t v = 0; v < o->s->point_count; v++)
    room[v] = way_for(o, v, o->depth[v]) / part_of_room;
  hexcon_status status = inward_room_find(context, o->s, o->in.directions, room);
  for (size_t v = 0; !status && v < o->s->point_count; v++)
    o->depth[v] = fmin(o->depth[v], part_of_room * room[v] / way_for(o, v, 1));
  return status;
}

/** Sine of the angle between an upright edge and a corner triangle; negative on its outside. */
static double sine_over(const double normal[3], const double upright[3]) {
  double scale = vector_length(normal) * vector_length(upright);
  return scale > 0 ? -vector_dot(normal, upright) / scale : 0;
}

/** Whether a corner of the copy is turned over, where the surface's is not. */
static bool is_folded(const offsetting *o, int32_t h) {
  double upright[3], normal[3];
  vector_subtract(corner_place(o, h, o->offset), corner_place(o, h, o->s->points), upright);
  double outer = sine_over(o->in.normals + 3 * (size_t)h, upright);
  corner_normal(o->s, h, o->offset, normal);
  return outer > 0 && sine_over(normal, upright) < fmin(least_sine, least_of_outer * outer);
}

static hexcon_status mark_faults(hexcon_context *context, offsetting *o, size_t *count) {
  size_t crossing = 0;
  *count = 0;
  memset(o->folded, 0, o->s->point_count);
  for (int32_t h = 0; h < (int32_t)(4 * o->s->quad_count); h++) {
    if (!is_folded(o, h))
      continue;
    ++*count;
    for (int turn = -1; turn <= 1; turn++)
      o->folded[o->s->quads[half_edge_turn(h, turn)]] = 1;
  }
  hexcon_status status = crossing_triangles_mark(context, o->s, o->offset, o->folded, &crossing);
  *count += crossing;
  return status;
}

/** Raise the copy where it is at fault until it is not: on the surface itself it would be none. */
static hexcon_status rise_from_faults(hexcon_context *context, offsetting *o) {
  const int most_rounds = 16;
  size_t faults = 1;
  hexcon_status status = keep_room(context, o);
  memset(o->folded, 0, o->s->point_count);
  for (int round = 0; !status && faults > 0 && round < most_rounds; round++) {
    for (size_t v = 0; v < o->s->point_count; v++)
      o->depth[v] *= o->folded[v] ? rising : 1;
    smooth_depths(o);
    place_offset(o);
    status = context_after(context, o->s->point_count);
    if (!status)
      status = mark_faults(context, o, &faults);
  }
  return status;
}

/* ------------------------------------------------------------------------------------------------
 */

static hexcon_status offsetting_new(hexcon_context *context, const surface *s, offsetting *o) {
  size_t points = s->point_count;
  o->s = s;
  o->depth = context_allocate(context, points, sizeof *o->depth);
  o->smooth = context_allocate(context, points, sizeof *o->smooth);
  o->offset = context_allocate(context, points, 3 * sizeof *o->offset);
  o->drawn = context_allocate(context, points, sizeof *o->drawn);
  o->folded = context_allocate(context, points, sizeof *o->folded);
  bool complete = o->depth && o->smooth && o->offset && o->drawn && o->folded;
  return complete ? inward_directions_new(context, s, &o->in) : HEXCON_OUT_OF_MEMORY;
}

static void offsetting_free(hexcon_context *context, offsetting *o) {
  inward_directions_free(context, &o->in);
  context_free(context, o->depth);
  context_free(context, o->smooth);
  context_free(context, o->offset);
  context_free(context, o->drawn);
  context_free(context, o->folded);
}

hexcon_status inner_surface_place(hexcon_context *context, const surface *s,
                                  const inner_surface_options *options, double *inner) {
  offsetting o = {.options = options};
  hexcon_status status = offsetting_new(context, s, &o);
  if (!status) {
    find_depths(&o);
    status = context_after(context, s->point_count);
  }
  if (!status)
    status =
        options->no_center ? rise_from_faults(context, &o) : draw_to_center(context, &o, inner);
  if (!status && options->no_center)
    memcpy(inner, o.offset, 3 * s->point_count * sizeof *inner);
  offsetting_free(context, &o);
  return status;
}

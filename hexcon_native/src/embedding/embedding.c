/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "embedding.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ball.h"
#include "base/vector.h"
#include "box_tree.h"
#include "coincident_points.h"
#include "curved_pair.h"
#include "curved_patch.h"
#include "surface/checks.h"
#include "touching.h"

enum {
  MAX_PAIRS = HEXCON_MAX_EMBEDDING_PAIRS,
  MAX_OPEN_PAIRS = 64,
  PATIENCE = 1 << 12, /* pairs of cells for a pair of quads: some milliseconds */
  CURVED_PATIENCE = 1 << 14,
  HASTE = 1 << 7 /* the same once the verdict is known */
};

/** The points in use, scaled along each axis by a power of two: that keeps what crosses. */
typedef struct scene {
  size_t point_count, quad_count, node_count; /* nodes of a quad: 4, or 8 if it is curved */
  double *points;
  int32_t *quads;        /* [quad_count][node_count] by ids of these points, corners first */
  const int32_t *shells; /* [quad_count] of curved quads, if there are several; else NULL */
  box *boxes;            /* of the quads */
  int32_t (*meeting_pairs)[2], (*open_pairs)[2];
  size_t meeting_count, open_count, twin_count;
} scene;

static void scene_free(hexcon_context *context, scene *s) {
  context_free(context, s->points);
  context_free(context, s->quads);
  context_free(context, s->boxes);
  context_free(context, s->meeting_pairs);
  context_free(context, s->open_pairs);
}

/* ------------------------------------------------------------------------------------- the scene
 */

static hexcon_status number_points(hexcon_context *context, size_t point_count,
                                   const int32_t *quads, int32_t *number, scene *s) {
  memset(number, -1, point_count * sizeof *number);
  for (size_t i = 0; i < s->node_count * s->quad_count; i++) {
    if (number[quads[i]] < 0)
      number[quads[i]] = (int32_t)s->point_count++;
    s->quads[i] = number[quads[i]];
  }
  s->points = context_allocate(context, s->point_count, 3 * sizeof *s->points);
  return s->points ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

/** Whether every coordinate is still exact: not where one becomes subnormal. */
static bool scale_points(scene *s) {
  bool exact = true;
  for (size_t k = 0; k < 3; k++) {
    double largest = 0;
    int exponent = 0;
    for (size_t v = 0; v < s->point_count; v++)
      largest = fmax(largest, fabs(s->points[3 * v + k]));
    if (largest > 0)
      (void)frexp(largest, &exponent);
    double scale = ldexp(1, exponent < -1000 ? 1000 : -exponent);
    for (size_t v = 0; v < s->point_count; v++) {
      double *x = &s->points[3 * v + k], scaled = *x * scale;
      exact &= *x == 0 || fabs(scaled) >= DBL_MIN;
      *x = scaled;
    }
  }
  return exact;
}

static const int32_t *quad_of(const scene *s, size_t q) {
  return s->quads + s->node_count * q;
}

static void box_around(ball (*points)[3], int count, box *out) {
  for (int k = 0; k < 3; k++) {
    out->low[k] = INFINITY;
    out->high[k] = -INFINITY;
    for (int c = 0; c < count; c++) {
      out->low[k] = fmin(out->low[k], ball_low(points[c][k]));
      out->high[k] = fmax(out->high[k], ball_high(points[c][k]));
    }
  }
}

/** Of the control points. */
static void set_curved_box(const scene *s, const int32_t *quad, box *out) {
  static const double origin[3] = {0, 0, 0};
  const double *nodes[8];
  curved_patch curved;
  for (int n = 0; n < 8; n++)
    nodes[n] = s->points + 3 * (size_t)quad[n];
  curved_patch_set(&curved, nodes, origin);
  box_around(curved.controls, CURVED_CONTROLS, out);
}

/** Of the corners, which are exact. */
static void set_straight_box(const scene *s, const int32_t *quad, box *out) {
  for (int k = 0; k < 3; k++) {
    double low = INFINITY, high = -INFINITY;
    for (int c = 0; c < 4; c++) {
      double x = s->points[3 * (size_t)quad[c] + (size_t)k];
      low = fmin(low, x);
      high = fmax(high, x);
    }
    out->low[k] = low;
    out->high[k] = high;
  }
}

static void set_boxes(scene *s) {
  for (size_t q = 0; q < s->quad_count; q++)
    if (s->node_count == 8)
      set_curved_box(s, quad_of(s, q), &s->boxes[q]);
    else
      set_straight_box(s, quad_of(s, q), &s->boxes[q]);
}

/** @param quads  [quad_count][node_count] */
static hexcon_status scene_new(hexcon_context *context, const double *points, size_t point_count,
                               const int32_t *quads, size_t node_count, size_t quad_count,
                               scene *s) {
  *s = (scene){.quad_count = quad_count, .node_count = node_count};
  int32_t *number = context_allocate(context, point_count, sizeof *number);
  s->quads = context_allocate(context, node_count * quad_count, sizeof *s->quads);
  s->boxes = context_allocate(context, quad_count, sizeof *s->boxes);
  s->meeting_pairs = context_allocate(context, MAX_PAIRS, sizeof *s->meeting_pairs);
  s->open_pairs = context_allocate(context, MAX_PAIRS, sizeof *s->open_pairs);
  bool complete = number && s->quads && s->boxes && s->meeting_pairs && s->open_pairs;
  hexcon_status status =
      complete ? number_points(context, point_count, quads, number, s) : HEXCON_OUT_OF_MEMORY;
  for (size_t v = 0; !status && v < point_count; v++)
    if (number[v] >= 0)
      memcpy(s->points + 3 * (size_t)number[v], points + 3 * v, 3 * sizeof *points);
  context_free(context, number);
  return status;
}

/* ----------------------------------------------------------------------------------------- pairs
 */

static void add_pair(int32_t (*pairs)[2], size_t *count, int32_t a, int32_t b) {
  if (*count == MAX_PAIRS)
    return;
  pairs[*count][0] = a < b ? a : b;
  pairs[(*count)++][1] = a < b ? b : a;
}

/** A quad of each of two points that stand at the same place. */
static hexcon_status find_twins(hexcon_context *context, scene *s) {
  int32_t *first = context_allocate(context, s->point_count, sizeof *first);
  int32_t *quad_at = context_allocate(context, s->point_count, sizeof *quad_at);
  hexcon_status status = first && quad_at ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status)
    status = coincident_points_find(context, s->points, s->point_count, first, &s->twin_count);
  for (size_t i = 0; !status && s->twin_count > 0 && i < s->node_count * s->quad_count; i++)
    quad_at[s->quads[i]] = (int32_t)(i / s->node_count);
  for (size_t v = 0; !status && s->twin_count > 0 && v < s->point_count; v++)
    if (first[v] != (int32_t)v)
      add_pair(s->meeting_pairs, &s->meeting_count, quad_at[first[v]], quad_at[v]);
  context_free(context, first);
  context_free(context, quad_at);
  return status;
}

/** Proved without exact arithmetic: seen along some direction, every corner turns the same way;
 * then the quad is convex there, and its patch lies over it once. */
static bool turns_one_way(const double *points, const int32_t *quad) {
  ball sides[4][3];
  for (int c = 0; c < 4; c++)
    for (int k = 0; k < 3; k++)
      sides[c][k] = ball_difference(points[3 * (size_t)quad[(c + 1) & 3] + (size_t)k],
                                    points[3 * (size_t)quad[c] + (size_t)k]);
  double diagonals[2][3], normal[3];
  for (int k = 0; k < 3; k++) {
    diagonals[0][k] = sides[0][k].mid + sides[1][k].mid;
    diagonals[1][k] = sides[1][k].mid + sides[2][k].mid;
  }
  vector_cross(diagonals[0], diagonals[1], normal);
  for (int c = 0; c < 4; c++) {
    ball turn[3];
    ball_cross(sides[c], sides[(c + 1) & 3], turn);
    if (ball_sign(ball_dot_exact(normal, turn)) <= 0)
      return false;
  }
  return true;
}

/** Whether a quad has some place twice. */
static meeting judge_alone(const scene *s, const int32_t *quad) {
  if (s->node_count == 8)
    return curved_patch_meets_itself(s->points, quad, CURVED_PATIENCE);
  if (turns_one_way(s->points, quad))
    return MEETING_NONE;
  flat_quad flat;
  flat_quad_set(&flat, s->points, quad);
  return flat.form == QUAD_FOLDED    ? MEETING_PROVED
         : flat.form == QUAD_UNKNOWN ? MEETING_OPEN
                                     : MEETING_NONE;
}

static void note(scene *s, meeting found, int32_t a, int32_t b) {
  if (found == MEETING_PROVED)
    add_pair(s->meeting_pairs, &s->meeting_count, a, b);
  if (found == MEETING_OPEN)
    add_pair(s->open_pairs, &s->open_count, a, b);
}

static void find_folded(scene *s) {
  for (size_t q = 0; q < s->quad_count && s->open_count < MAX_OPEN_PAIRS; q++)
    note(s, judge_alone(s, quad_of(s, q)), (int32_t)q, (int32_t)q);
}

static meeting judge_straight_pair(const scene *s, const int32_t *a, const int32_t *b) {
  meeting found = patches_meet(s->points, a, b, 1);
  if (found != MEETING_OPEN)
    return found;
  flat_quad one, other;
  flat_quad_set(&one, s->points, a);
  flat_quad_set(&other, s->points, b);
  if (one.form == QUAD_FOLDED || other.form == QUAD_FOLDED)
    return MEETING_NONE; /* told already, as folded */
  if (one.form == QUAD_CONVEX && other.form == QUAD_CONVEX)
    return flat_quads_meet(&one, &other);
  found = patches_meet(s->points, a, b, s->meeting_count ? HASTE : PATIENCE);
  if (found == MEETING_OPEN && quads_touch(&one, &other))
    found = MEETING_PROVED;
  return found;
}

/** Ends the search, as if with a fault, where enough has been found. */
static hexcon_status visit_pair(void *user, hexcon_context *context, int32_t a, int32_t b) {
  scene *s = user;
  (void)context;
  const int32_t *one = quad_of(s, (size_t)a), *other = quad_of(s, (size_t)b);
  bool joint = s->shells && s->shells[a] != s->shells[b];
  int patience = s->meeting_count ? HASTE : CURVED_PATIENCE;
  note(s,
       s->node_count == 8 ? curved_patches_meet(s->points, one, other, joint, patience)
                          : judge_straight_pair(s, one, other),
       a, b);
  bool enough = s->meeting_count == MAX_PAIRS || s->open_count >= MAX_OPEN_PAIRS;
  return enough ? HEXCON_STATUS_COUNT : HEXCON_OK;
}

/* -------------------------------------------------------------------------------------- the
 * verdict */

static int compare_pairs(const void *a, const void *b) {
  const int32_t *one = a, *other = b;
  int place = one[0] != other[0] ? 0 : 1;
  return (one[place] > other[place]) - (one[place] < other[place]);
}

static hexcon_status hand_over(hexcon_context *context, int32_t (*pairs)[2], size_t count,
                               hexcon_embedding *out) {
  qsort(pairs, count, sizeof *pairs, compare_pairs);
  out->pairs = context_allocate(context, count, sizeof *pairs);
  if (!out->pairs)
    return HEXCON_OUT_OF_MEMORY;
  size_t kept = 0;
  for (size_t i = 0; i < count; i++)
    if (i == 0 || compare_pairs(pairs[i], pairs[i - 1]) != 0)
      memcpy(out->pairs + 2 * kept++, pairs[i], sizeof *pairs);
  out->pair_count = kept;
  return HEXCON_OK;
}

static hexcon_status conclude(hexcon_context *context, scene *s, hexcon_embedding *out) {
  out->twin_count = s->twin_count;
  out->embedded = s->meeting_count ? HEXCON_EMBEDDED_NO
                  : s->open_count  ? HEXCON_EMBEDDED_UNKNOWN
                                   : HEXCON_EMBEDDED_YES;
  bool all = s->meeting_count < MAX_PAIRS && s->open_count < MAX_OPEN_PAIRS;
  const char *more = all ? "" : "at least ";
  if (s->meeting_count == 0 && s->open_count == 0)
    return HEXCON_OK;
  hexcon_status status = s->meeting_count
                             ? hand_over(context, s->meeting_pairs, s->meeting_count, out)
                             : hand_over(context, s->open_pairs, s->open_count, out);
  if (s->twin_count > 0)
    (void)snprintf(out->reason, sizeof out->reason,
                   "%zu points stand twice: not merged, so that quads touch there", s->twin_count);
  else if (s->meeting_count > 0)
    (void)snprintf(out->reason, sizeof out->reason, "%s%zu pairs of quads cross or touch", more,
                   out->pair_count);
  else
    (void)snprintf(out->reason, sizeof out->reason,
                   "%s%zu pairs of quads touch, or come nearer to each other than can be told",
                   more, out->pair_count);
  return status;
}

static hexcon_status judge_scene(hexcon_context *context, scene *s, hexcon_embedding *out) {
  if (!scale_points(s)) {
    (void)snprintf(out->reason, sizeof out->reason,
                   "the coordinates span too many orders of magnitude for exact arithmetic");
    return HEXCON_OK;
  }
  hexcon_status status = find_twins(context, s);
  if (!status && s->twin_count == 0) {
    set_boxes(s);
    find_folded(s);
    status = box_tree_visit_pairs(context, s->boxes, s->quad_count, STAGE_EMBEDDING, visit_pair, s);
    if (status == HEXCON_STATUS_COUNT)
      status = HEXCON_OK;
  }
  return status ? status : conclude(context, s, out);
}

/** @param status  of scene_new */
static hexcon_status finish(hexcon_context *context, hexcon_status status, scene *s,
                            hexcon_embedding *out) {
  memset(out, 0, sizeof *out);
  if (!status)
    status = judge_scene(context, s, out);
  scene_free(context, s);
  if (status)
    hexcon_embedding_free(context, out);
  return status;
}

hexcon_status embedding_prove(hexcon_context *context, const double *points, size_t point_count,
                              const int32_t *quads, size_t quad_count, hexcon_embedding *out) {
  scene s;
  hexcon_status status = scene_new(context, points, point_count, quads, 4, quad_count, &s);
  return finish(context, status, &s, out);
}

hexcon_status embedding_prove_curved(hexcon_context *context, const double *points,
                                     size_t point_count, const int32_t *quads,
                                     const int32_t *shells, size_t quad_count,
                                     hexcon_embedding *out) {
  scene s;
  hexcon_status status = scene_new(context, points, point_count, quads, 8, quad_count, &s);
  s.shells = shells;
  return finish(context, status, &s, out);
}

hexcon_status hexcon_surface_embedding(hexcon_context *context, const double *points,
                                       size_t point_count, const int32_t *quads, size_t quad_count,
                                       hexcon_embedding *out) {
  context_clear(context);
  memset(out, 0, sizeof *out);
  hexcon_status status = check_arrays(context, points, point_count, quads, quad_count);
  return status ? status : embedding_prove(context, points, point_count, quads, quad_count, out);
}

void hexcon_embedding_free(hexcon_context *context, hexcon_embedding *embedding) {
  context_free(context, embedding->pairs);
  memset(embedding, 0, sizeof *embedding);
}

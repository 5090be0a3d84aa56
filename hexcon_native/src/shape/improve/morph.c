/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include <float.h>
#include <math.h>
#include <string.h>

#include "hexmesh/hex_arrays.h"
#include "hexmesh/hex_tables.h"
#include "improve.h"
#include "reference_placement.h"
#include "repair.h"
#include "sharpen.h"
#include "surface/checks.h"

/** The way from a valid mesh to a goal: fraction 0 is the start, 1 the goal. */
typedef struct journey {
  patch p; /* the whole mesh */
  newton n;
  double *goal;    /* [3 point_count] rows of the patch */
  double *valid;   /* [3 point_count] the last valid state */
  double fraction; /* of the way done, where `valid` is */
} journey;

/** Points that move freely: no hex holds the others of those that are not fixed.
 * @param slots  [point_count] all -1, and so again afterwards */
static size_t find_free_points(size_t point_count, const int32_t *hexes, size_t hex_count,
                               const uint8_t *fixed, int32_t *slots, int32_t *free_points) {
  size_t count = 0;
  for (size_t i = 0; i < 8 * hex_count; i++)
    slots[hexes[i]] = 0;
  for (size_t v = 0; v < point_count; v++) {
    if (!fixed[v] && slots[v] == 0)
      free_points[count++] = (int32_t)v;
    slots[v] = -1;
  }
  return count;
}

/** The whole mesh, hexes of fixed points only as well: they too must stay positive. */
static hexcon_status copy_mesh(hexcon_context *context, const double *points, size_t point_count,
                               const int32_t *hexes, size_t hex_count, const uint8_t *fixed,
                               patch *p) {
  int32_t *slots = context_allocate(context, point_count, sizeof *slots);
  int32_t *free_points = context_allocate(context, point_count, sizeof *free_points);
  int32_t *ids = context_allocate(context, hex_count, sizeof *ids);
  hexcon_status status = slots && free_points && ids ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status) {
    memset(slots, -1, point_count * sizeof *slots);
    size_t free_count = find_free_points(point_count, hexes, hex_count, fixed, slots, free_points);
    for (size_t h = 0; h < hex_count; h++)
      ids[h] = (int32_t)h;
    status = patch_copy(context, hexes, points, free_points, free_count, ids, hex_count, slots, p);
  }
  context_free(context, slots);
  context_free(context, free_points);
  context_free(context, ids);
  return status;
}

/** Free points go along with the fixed ones: their displacement is extended as by springs. */
static hexcon_status extend_goal(hexcon_context *context, journey *j) {
  patch *p = &j->p;
  for (size_t i = 0; i < 3 * p->point_count; i++)
    p->x[i] = i < 3 * p->free_count ? 0 : j->goal[i] - j->valid[i];
  hexcon_status status = reference_placement(context, p);
  for (size_t i = 0; i < 3 * p->free_count; i++)
    j->goal[i] = j->valid[i] + p->x[i];
  memcpy(p->x, j->valid, 3 * p->point_count * sizeof *p->x);
  return status;
}

/** Step to a fraction of the way: straight on towards the goal, untangled there if need be.
 * @param arrived  receives whether the mesh is valid there; it is as it was before otherwise */
static hexcon_status try_fraction(hexcon_context *context, journey *j, double fraction,
                                  bool patient, bool *arrived) {
  patch *p = &j->p;
  double share = (fraction - j->fraction) / (1 - j->fraction);
  hexcon_status status = HEXCON_OK;
  patch_target_own_lengths(p, 0.05);
  for (size_t i = 0; i < 3 * p->point_count; i++)
    p->x[i] = fraction < 1 ? j->valid[i] + share * (j->goal[i] - j->valid[i]) : j->goal[i];
  size_t bad = patch_count_bad(p, NULL);
  if (bad > 0)
    status = untangle_watching(context, &j->n, p, patient, &bad);
  *arrived = !status && bad == 0;
  if (!*arrived)
    memcpy(p->x, j->valid, 3 * p->point_count * sizeof *p->x);
  return status;
}

/** Steps that double where they succeed and are halved where they fail; long ones are tried in
 * haste only. A better shape is a better place to go on from. */
static hexcon_status travel(hexcon_context *context, journey *j) {
  const double smallest_step = 1.0 / 256, patient_step = 1.0 / 16;
  double step = 1;
  hexcon_status status = HEXCON_OK;
  while (!status && j->fraction < 1 && step >= smallest_step) {
    bool arrived = false;
    double fraction = fmin(1, j->fraction + step);
    status = try_fraction(context, j, fraction, step <= patient_step, &arrived);
    if (arrived && !status && fraction < 1)
      status = sharpen_patch(context, &j->n, &j->p, step <= patient_step ? 0.1 : 0.3, 1);
    if (arrived) {
      j->fraction = fraction;
      memcpy(j->valid, j->p.x, 3 * j->p.point_count * sizeof *j->valid);
    }
    step = arrived ? 2 * step : step / 2;
    if (!status)
      status = context_progress(context, STAGE_HOMOTOPY, j->fraction);
  }
  return status;
}

/** Where no step leads on, go to the goal all the same and have the mesh repaired there. */
static hexcon_status leap(hexcon_context *context, journey *j) {
  patch *p = &j->p;
  const hexcon_optimize_options options = {.target = 1e-6, .threads = 1};
  uint8_t *fixed = context_allocate_zeroed(context, p->point_count, sizeof *fixed);
  int32_t *hexes = context_allocate(context, p->hex_count, 8 * sizeof *hexes);
  hexcon_status status = fixed && hexes ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status) {
    memset(fixed + p->free_count, 1, p->point_count - p->free_count);
    for (size_t i = 0; i < 8 * p->hex_count; i++)
      hexes[i] = p->corners[(i & ~(size_t)7) + hex_corner_bits[i & 7]];
    memcpy(p->x + 3 * p->free_count, j->goal + 3 * p->free_count,
           3 * (p->point_count - p->free_count) * sizeof *p->x);
    status =
        improve_mesh(context, p->x, p->point_count, hexes, p->hex_count, fixed, &options, NULL);
  }
  if (!status && patch_count_bad(p, NULL) == 0) {
    j->fraction = 1;
    memcpy(j->valid, p->x, 3 * p->point_count * sizeof *j->valid);
  }
  memcpy(p->x, j->valid, 3 * p->point_count * sizeof *p->x);
  context_free(context, fixed);
  context_free(context, hexes);
  return status;
}

static hexcon_status begin(hexcon_context *context, const double *points, size_t point_count,
                           const int32_t *hexes, size_t hex_count, const uint8_t *fixed,
                           const double *goal, journey *j) {
  hexcon_status status = copy_mesh(context, points, point_count, hexes, hex_count, fixed, &j->p);
  if (!status)
    status = newton_new(context, &j->p, &j->n);
  j->goal = context_allocate(context, j->p.point_count, 3 * sizeof *j->goal);
  j->valid = context_allocate(context, j->p.point_count, 3 * sizeof *j->valid);
  if (status || !j->goal || !j->valid)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < j->p.point_count; i++)
    memcpy(j->goal + 3 * i, goal + 3 * (size_t)j->p.points[i], 3 * sizeof *goal);
  memcpy(j->valid, j->p.x, 3 * j->p.point_count * sizeof *j->valid);
  patch_target_own_lengths(&j->p, 0.05);
  return HEXCON_OK;
}

/** Raise the worst at the end of the way. Every state is positive; a coarse pass may lower the
 * worst by what the fine ones then win back. */
static hexcon_status finish(hexcon_context *context, journey *j, double target) {
  static const double distances[] = {0.3, 0.1, 0.03, 0.01};
  hexcon_status status = HEXCON_OK;
  for (size_t i = 0; !status && i < sizeof distances / sizeof *distances; i++)
    status = sharpen_patch(context, &j->n, &j->p, distances[i], target);
  return status;
}

static hexcon_status check_morph(hexcon_context *context, const double *points, size_t point_count,
                                 const int32_t *hexes, size_t hex_count, const double *goal,
                                 const hexcon_morph_options *options) {
  if (options && !(options->target >= 0 && options->target <= 1))
    return context_fail(context, HEXCON_BAD_ARGUMENT, "morph: the target %g must lie in 0 .. 1",
                        options->target);
  hexcon_status status = check_hex_arrays(context, points, point_count, hexes, hex_count);
  if (!status)
    status = check_hex_corners(context, hexes, hex_count);
  if (!status)
    status = check_points(context, goal, point_count, DBL_MAX);
  return status;
}

/** Where the way ended. Points of no hex have no part in it: those that are fixed are put where the
 * others are, the free ones stay.
 * @param positions  holds the start */
static void write_positions(const journey *j, size_t point_count, const uint8_t *fixed,
                            const double *goal, double *positions) {
  for (size_t v = 0; v < point_count; v++)
    for (size_t i = 3 * v; fixed[v] && i < 3 * v + 3; i++)
      positions[i] =
          j->fraction < 1 ? (1 - j->fraction) * positions[i] + j->fraction * goal[i] : goal[i];
  for (size_t i = 0; i < j->p.point_count; i++)
    memcpy(positions + 3 * (size_t)j->p.points[i], j->p.x + 3 * i, 3 * sizeof *positions);
}

hexcon_status hexcon_morph(hexcon_context *context, const double *points, size_t point_count,
                           const int32_t *hexes, size_t hex_count, const uint8_t *fixed,
                           const double *goal, const hexcon_morph_options *options,
                           double *positions, double *reached) {
  context_clear(context);
  hexcon_morph_options chosen = options ? *options : (hexcon_morph_options){0};
  *reached = 0;
  hexcon_status status = check_morph(context, points, point_count, hexes, hex_count, goal, options);
  if (status)
    return status;
  journey j = {0};
  memmove(positions, points, 3 * point_count * sizeof *points);
  status = begin(context, points, point_count, hexes, hex_count, fixed, goal, &j);
  size_t bad = status ? 0 : patch_count_bad(&j.p, NULL);
  if (bad > 0)
    status = context_fail(context, HEXCON_NOT_CERTIFIED,
                          "morph: %zu of the %zu hexes are not positive at the start; optimize "
                          "the mesh first",
                          bad, hex_count);
  if (!status && chosen.boundary_only)
    status = extend_goal(context, &j);
  if (!status)
    status = travel(context, &j);
  if (!status && j.fraction < 1)
    status = leap(context, &j);
  if (!status)
    status = finish(context, &j, chosen.target > 0 ? chosen.target : 1);
  if (j.fraction > 0)
    write_positions(&j, point_count, fixed, goal, positions);
  *reached = j.fraction;
  newton_free(context, &j.n);
  patch_free(context, &j.p);
  context_free(context, j.goal);
  context_free(context, j.valid);
  return status;
}

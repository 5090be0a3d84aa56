/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include <math.h>
#include <string.h>

#include "base/system_clock.h"
#include "corner_targets.h"
#include "hexmesh/hex_arrays.h"
#include "hexmesh/hex_tables.h"
#include "hexmesh/scaled_jacobian.h"
#include "shape/improve/canonical_order.h"
#include "shape/improve/improve.h"
#include "shape/improve/newton.h"
#include "shape/improve/sliding_patch.h"

/** What a state is judged by, in this order. */
typedef struct standing {
  size_t inverted; /* hexes with a corner that is not positive */
  double worst;    /* scaled Jacobian */
} standing;

/** A mesh that is relaxed as a whole. */
typedef struct relaxation {
  const sliding_points *sliding;
  const canonical_order *mesh;
  patch p; /* all hexes; its free points are those that move */
  newton n;
  sliding_patch on;
  double *best;   /* [3 free_count] */
  double *shares; /* [8 hex_count] of p, while it has any */
  standing reached;
  int rounds;
} relaxation;

static bool is_better(standing a, standing b) {
  return a.inverted != b.inverted ? a.inverted < b.inverted : a.worst > b.worst;
}

static standing judge(const relaxation *r) {
  standing s = {0, 1};
  for (size_t h = 0; h < r->p.hex_count; h++) {
    int32_t hex[8];
    for (size_t c = 0; c < 8; c++)
      hex[c] = r->p.corners[8 * h + hex_corner_bits[c]];
    double quality = scaled_jacobian(r->p.x, hex);
    s.inverted += !(quality > 0);
    s.worst = fmin(s.worst, quality);
  }
  return s;
}

/** Keep the present state if it is the best so far. @return how it stands */
static standing keep_best(hexcon_context *context, relaxation *r) {
  standing now = judge(r);
  if (is_better(now, r->reached)) {
    r->reached = now;
    memcpy(r->best, r->p.x, 3 * r->p.free_count * sizeof *r->best);
  }
  context_tell_mesh(context, r->p.hex_count, r->reached.inverted, r->reached.worst);
  return now;
}

/** Epsilon of a round. It goes down to sharpen the barrier, and is wide again every fifth round: a
 * narrow barrier holds what is stuck behind it. */
static double epsilon_of(int round, double determinant) {
  const double least = 1e-3, of_positive = 1e-4, widest = 0.16, fall = 0.4, of_worst = 0.3;
  const int period = 5;
  if (determinant >= least)
    return of_positive;
  return fmax(fmax(-of_worst * determinant, widest * pow(fall, round % period)), least);
}

/** Rounds towards cubes, until nothing is inverted and little changes, or there is no gain. */
static hexcon_status untangle(hexcon_context *context, relaxation *r) {
  const int steps = 4, patience = 5, least_rounds = 10;
  const double still = 0.02, gain = 0.003, good = 0.02;
  double best = -INFINITY, recent = -INFINITY;
  hexcon_status status = HEXCON_OK;
  for (int round = 0; !status && round < r->rounds; round++) {
    frame_energy_options options = {0};
    status = context_progress(context, STAGE_UNTANGLING, (double)round / r->rounds);
    if (status)
      break;
    target_cubes(&r->p);
    options.epsilon = epsilon_of(round, patch_worst_frame(&r->p, r->p.x, &options).determinant);
    double left = newton_descend(&r->n, &r->p, &options, 1e-3, steps);
    status = r->n.status;
    (void)keep_best(context, r);
    double determinant = patch_worst_frame(&r->p, r->p.x, &options).determinant;
    if (determinant > good && left > 1 - still)
      break;
    recent = fmax(recent, determinant);
    if ((round + 1) % patience == 0) {
      if (round + 1 >= least_rounds && recent < 0 && recent < best + gain)
        break;
      best = fmax(best, recent);
      recent = -INFINITY;
    }
  }
  return status;
}

/** Rounds towards right angles, from a mesh without inverted corners. */
static hexcon_status square(hexcon_context *context, relaxation *r) {
  const int rounds = 10;
  const double still = 5e-4;
  hexcon_status status = HEXCON_OK;
  memcpy(r->p.x, r->best, 3 * r->p.free_count * sizeof *r->best);
  status = patch_put_on(context, &r->p);
  r->p.shares = r->shares;
  for (int round = 0; !status && round < rounds; round++) {
    const frame_energy_options options = {0};
    status = context_progress(context, STAGE_OPTIMISATION, (double)round / rounds);
    if (status)
      break;
    target_right_angles(&r->p);
    double decrease = newton_step(&r->n, &r->p, &options);
    status = r->n.status;
    (void)keep_best(context, r);
    if (decrease < still)
      break;
  }
  return status;
}

static hexcon_status copy_mesh(hexcon_context *context, relaxation *r) {
  const canonical_order *m = r->mesh;
  int32_t *slots = context_allocate(context, m->point_count, sizeof *slots);
  int32_t *moving = context_allocate(context, m->point_count, sizeof *moving);
  int32_t *hexes = context_allocate(context, m->hex_count, sizeof *hexes);
  hexcon_status status = slots && moving && hexes ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  size_t count = 0;
  if (!status) {
    memset(slots, -1, m->point_count * sizeof *slots);
    for (size_t i = 0; i < 8 * m->hex_count; i++)
      slots[m->hexes[i]] = 0;
    for (size_t v = 0; v < m->point_count; v++) {
      if (slots[v] == 0 && !m->fixed[v])
        moving[count++] = (int32_t)v;
      slots[v] = -1;
    }
    for (size_t h = 0; h < m->hex_count; h++)
      hexes[h] = (int32_t)h;
    status =
        patch_copy(context, m->hexes, m->points, moving, count, hexes, m->hex_count, slots, &r->p);
  }
  context_free(context, slots);
  context_free(context, moving);
  context_free(context, hexes);
  return status;
}

static hexcon_status begin(hexcon_context *context, relaxation *r) {
  hexcon_status status = copy_mesh(context, r);
  if (!status)
    status = sliding_patch_new(context, r->sliding, r->mesh->point_ids, &r->p, &r->on);
  if (!status)
    status = newton_new(context, &r->p, &r->n);
  if (status)
    return status;
  r->shares = context_allocate(context, r->p.hex_count, 8 * sizeof *r->shares);
  r->best = context_allocate(context, r->p.free_count, 3 * sizeof *r->best);
  if (!r->shares || !r->best)
    return HEXCON_OUT_OF_MEMORY;
  memcpy(r->best, r->p.x, 3 * r->p.free_count * sizeof *r->best);
  r->reached = judge(r);
  return HEXCON_OK;
}

static void relaxation_free(hexcon_context *context, relaxation *r) {
  newton_free(context, &r->n);
  sliding_patch_free(context, &r->on);
  patch_free(context, &r->p);
  context_free(context, r->best);
  context_free(context, r->shares);
}

/** The best state, in the numbering of `mesh`. */
static void write_best(const relaxation *r, canonical_order *mesh) {
  for (size_t i = 0; i < r->p.free_count; i++)
    memcpy(mesh->points + 3 * (size_t)r->p.points[i], r->best + 3 * i, 3 * sizeof *r->best);
}

static hexcon_status improve_relaxed(hexcon_context *context, const sliding_points *sliding,
                                     const int32_t *hexes, size_t hex_count,
                                     const hexcon_relax_options *options, double *positions) {
  const hexcon_optimize_options passes = {.max_rounds = options->passes,
                                          .mean_passes = options->mean_passes,
                                          .threads = options->threads};
  return improve_sliding_mesh(context, positions, hexes, hex_count, sliding, &passes);
}

/** @param positions  on their carriers; receives the best, also where it is cancelled */
static hexcon_status relax_placed(hexcon_context *context, const sliding_points *sliding,
                                  const int32_t *hexes, size_t hex_count,
                                  const hexcon_relax_options *options, double *positions) {
  const int default_rounds = 16;
  size_t point_count = sliding->point_count;
  canonical_order mesh = {0};
  relaxation r = {.sliding = sliding,
                  .mesh = &mesh,
                  .rounds = options->max_rounds > 0 ? options->max_rounds : default_rounds};
  uint8_t *fixed = context_allocate(context, point_count, sizeof *fixed);
  hexcon_status status = fixed ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  for (size_t v = 0; !status && v < point_count; v++)
    fixed[v] = sliding_freedom(sliding, (int32_t)v) == 0;
  if (!status)
    status = canonical_order_new(context, positions, point_count, hexes, hex_count, fixed, &mesh);
  context_free(context, fixed);
  if (!status)
    status = begin(context, &r);
  bool begun = !status;
  if (begun)
    status = untangle(context, &r);
  if (!status && r.reached.inverted == 0)
    status = square(context, &r);
  if (begun) {
    write_best(&r, &mesh);
    canonical_order_write(&mesh, positions);
  }
  context_tell_mesh(context, 0, 0, NAN);
  relaxation_free(context, &r);
  canonical_order_free(context, &mesh);
  if (!status && options->passes > 0)
    status = improve_relaxed(context, sliding, hexes, hex_count, options, positions);
  if (begun && status == HEXCON_OUT_OF_TIME) {
    context_clear(context);
    status = HEXCON_OK;
  }
  return status;
}

static hexcon_status check_relax(hexcon_context *context, const double *points, size_t point_count,
                                 const int32_t *hexes, size_t hex_count,
                                 const hexcon_relax_options *options) {
  if (options && !(options->max_rounds >= 0 && options->passes >= 0 && options->mean_passes >= 0 &&
                   options->threads >= 0 && options->budget >= 0))
    return context_fail(
        context, HEXCON_BAD_ARGUMENT,
        "relax: rounds %d, passes %d, mean passes %d, threads %d and budget %g must "
        "not be negative",
        options->max_rounds, options->passes, options->mean_passes, options->threads,
        options->budget);
  hexcon_status status = check_hex_arrays(context, points, point_count, hexes, hex_count);
  return status ? status : check_hex_corners(context, hexes, hex_count);
}

hexcon_status hexcon_relax(hexcon_context *context, const double *points, size_t point_count,
                           const int32_t *hexes, size_t hex_count, const hexcon_sliding *sliding,
                           const hexcon_relax_options *options, double *positions) {
  hexcon_relax_options chosen = options ? *options : (hexcon_relax_options){0};
  context_clear(context);
  sliding_points s = {0};
  hexcon_status status = check_relax(context, points, point_count, hexes, hex_count, options);
  if (!status)
    status = sliding_points_new(context, sliding, point_count, &s);
  if (!status) {
    memmove(positions, points, 3 * point_count * sizeof *points);
    context_limit(context, system_clock(), chosen.budget);
    status = sliding_points_project(context, &s, NULL, point_count, positions, NULL);
  }
  if (!status)
    status = relax_placed(context, &s, hexes, hex_count, &chosen, positions);
  context_limit(context, 0, 0);
  sliding_points_free(context, &s);
  return status;
}

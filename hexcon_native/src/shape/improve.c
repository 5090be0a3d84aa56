/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "improve.h"

#include <math.h>
#include <string.h>

#include "minimise.h"
#include "region.h"
#include "verify/hex_arrays.h"
#include "verify/jacobian_sign.h"
#include "verify/scaled_jacobian.h"

/** What is never made worse, in this order. */
typedef struct standing {
  size_t inverted; /* hexes not proved positive */
  double worst;    /* scaled Jacobian */
} standing;

typedef struct improvement {
  region_mesh mesh;
  region r;
  double *points, *backup; /* backup: the region's points before a trial, by slot */
  double *quality;         /* [hex_count] scaled Jacobian, minus 2 where not proved positive */
  int32_t *seeds;          /* [hex_count] */
  size_t seed_count;
} improvement;

static double measure(const improvement *m, int32_t hex) {
  const int32_t *ids = m->mesh.hexes + 8 * (size_t)hex;
  double value = scaled_jacobian(m->points, ids);
  return prove_jacobian_sign(m->points, ids) == JACOBIAN_POSITIVE ? value : value - 2;
}

static standing summarise(const double *quality, const int32_t *hexes, size_t count) {
  standing s = {0, 1};
  for (size_t i = 0; i < count; i++) {
    double value = quality[hexes ? hexes[i] : (int32_t)i];
    s.inverted += value < -0.999999;
    s.worst = fmin(s.worst, value);
  }
  return s;
}

static bool is_better(standing a, standing b) {
  return a.inverted != b.inverted ? a.inverted < b.inverted : a.worst > b.worst + 1e-6;
}

/** Hexes up to a threshold; ids ascending. */
static void collect_seeds(improvement *m, double threshold) {
  m->seed_count = 0;
  for (size_t h = 0; h < m->mesh.hex_count; h++)
    if (m->quality[h] <= threshold)
      m->seeds[m->seed_count++] = (int32_t)h;
}

/** Minimise over a neighbourhood of the seeds; keep the result only if it is better there. */
static hexcon_status try_region(hexcon_context *context, improvement *m, int layers,
                                const minimise_options *options, bool *improved) {
  region_open(&m->mesh, m->seeds, m->seed_count, layers, &m->r);
  standing before = summarise(m->quality, m->r.hexes, m->r.hex_count);
  for (size_t i = 0; i < m->r.point_count; i++)
    memcpy(m->backup + 3 * i, m->points + 3 * (size_t)m->r.points[i], 3 * sizeof(double));
  hexcon_status status = region_minimise(context, &m->mesh, &m->r, options, m->points);
  for (size_t i = 0; i < m->r.hex_count; i++)
    m->quality[m->r.hexes[i]] = measure(m, m->r.hexes[i]);
  *improved = is_better(summarise(m->quality, m->r.hexes, m->r.hex_count), before);
  if (!*improved) {
    for (size_t i = 0; i < m->r.point_count; i++)
      memcpy(m->points + 3 * (size_t)m->r.points[i], m->backup + 3 * i, 3 * sizeof(double));
    for (size_t i = 0; i < m->r.hex_count; i++)
      m->quality[m->r.hexes[i]] = measure(m, m->r.hexes[i]);
  }
  region_close(&m->mesh, &m->r);
  return status;
}

/** Inverted hexes first, with their neighbourhood growing as long as it does not help; then the
 * worst hexes, with rising powers. */
static hexcon_status improve(hexcon_context *context, improvement *m,
                             const hexcon_optimize_options *options, size_t *rounds) {
  static const int powers[] = {2, 4, 8, 1};
  int failures = 0;
  for (*rounds = 0; *rounds < (size_t)options->max_rounds; ++*rounds) {
    standing now = summarise(m->quality, NULL, m->mesh.hex_count);
    if (now.worst >= options->target || failures > 3)
      break;
    bool tangled = now.inverted > 0, improved = false;
    collect_seeds(m, tangled ? 0 : fmin(now.worst + 0.1 * (1 - now.worst), options->target));
    minimise_options run = {options->max_iterations, tangled ? 1 : powers[failures], tangled};
    hexcon_status status = try_region(context, m, 2 + 2 * failures, &run, &improved);
    if (status)
      return status;
    failures = improved ? 0 : failures + 1;
  }
  return HEXCON_OK;
}

static void default_options(hexcon_optimize_options *options) {
  if (options->max_rounds == 0)
    options->max_rounds = 40;
  if (options->max_iterations == 0)
    options->max_iterations = 100;
  if (options->target == 0)
    options->target = 1;
}

hexcon_status improve_mesh(hexcon_context *context, double *points, size_t point_count,
                           const int32_t *hexes, size_t hex_count, const uint8_t *fixed,
                           const hexcon_optimize_options *options, size_t *rounds) {
  hexcon_optimize_options chosen = options ? *options : (hexcon_optimize_options){0};
  default_options(&chosen);
  size_t unused;
  improvement m = {.points = points};
  hexcon_status status = region_mesh_build(context, hexes, hex_count, point_count, fixed, &m.mesh);
  if (!status)
    status = region_new(context, &m.mesh, &m.r);
  m.backup = context_allocate(context, 3 * point_count, sizeof *m.backup);
  m.quality = context_allocate(context, hex_count, sizeof *m.quality);
  m.seeds = context_allocate(context, hex_count, sizeof *m.seeds);
  if (!status && (!m.backup || !m.quality || !m.seeds))
    status = HEXCON_OUT_OF_MEMORY;
  for (size_t h = 0; !status && h < hex_count; h++)
    m.quality[h] = measure(&m, (int32_t)h);
  if (!status)
    status = improve(context, &m, &chosen, rounds ? rounds : &unused);
  context_free(context, m.backup);
  context_free(context, m.quality);
  context_free(context, m.seeds);
  region_free(context, &m.r);
  region_mesh_free(context, &m.mesh);
  return status;
}

static hexcon_status check_options(hexcon_context *context,
                                   const hexcon_optimize_options *options) {
  if (!options || (options->max_rounds >= 0 && options->max_iterations >= 0 &&
                   options->target >= 0 && options->target <= 1))
    return HEXCON_OK;
  return context_fail(context, HEXCON_BAD_ARGUMENT,
                      "optimize: rounds %d and iterations %d must not be negative, the target %g "
                      "must lie in 0 .. 1",
                      options->max_rounds, options->max_iterations, options->target);
}

hexcon_status hexcon_optimize(hexcon_context *context, const double *points, size_t point_count,
                              const int32_t *hexes, size_t hex_count, const uint8_t *fixed,
                              const hexcon_optimize_options *options, double *positions) {
  context_clear(context);
  hexcon_status status = check_options(context, options);
  if (!status)
    status = check_hex_arrays(context, points, point_count, hexes, hex_count);
  if (!status)
    status = check_hex_corners(context, hexes, hex_count);
  if (status)
    return status;
  memmove(positions, points, 3 * point_count * sizeof *points);
  return improve_mesh(context, positions, point_count, hexes, hex_count, fixed, options, NULL);
}

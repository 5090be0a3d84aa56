/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "improve.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "base/sorting.h"
#include "base/workers.h"
#include "canonical_order.h"
#include "groups.h"
#include "hexmesh/hex_arrays.h"
#include "hexmesh/scaled_jacobian.h"
#include "raise_mean.h"
#include "repair.h"
#include "sharpen.h"
#include "sliding_patch.h"
#include "verify/jacobian_sign.h"

enum {
  MEASURED_AT_ONCE = 4096, /* hexes */
  SHARPENED_AT_ONCE = 3000 /* hexes of a group: a patch that a cache holds */
};

/** A scaled Jacobian that nobody needs better. */
static const double good_enough = 0.999;

/** Quality of a hex that is not proved positive: its scaled Jacobian less this. */
static const double penalty = 2;

/** What a pass does to the regions it works on. Only the first looks at inverted hexes; the others
 * leave alone what is near them. */
typedef enum pass_kind { REPAIR, SHARPEN, RAISE_MEAN } pass_kind;

typedef struct improvement {
  region_set set;
  hex_groups groups;
  const sliding_points *sliding; /* NULL: free points move anywhere */
  const int32_t *point_ids;      /* [point_count] as sliding numbers them */
  double *points;
  double *quality;             /* [hex_count] */
  int32_t *seeds;              /* [hex_count] */
  uint8_t *postponed;          /* [hex_count] by group: its region met another */
  int32_t *slots[WORKERS_MAX]; /* [point_count] each, all -1 */
  int threads;
  double target;
  pass_kind kind;
  bool patient;         /* of repair_patch */
  double distance;      /* of sharpen_patch */
  double floor;         /* of raise_mean_patch */
  progress_stage stage; /* for the user */
  atomic_bool moved;    /* the pass has made some region better */
} improvement;

/** What is never made worse, in this order. */
typedef struct standing {
  size_t inverted; /* hexes not proved positive */
  double worst;    /* scaled Jacobian */
  double burden;   /* sum of 1 / scaled Jacobian: falls as the low ones rise */
  double sum;      /* of scaled Jacobians */
} standing;

static double measure(const improvement *m, size_t hex) {
  const int32_t *ids = m->set.mesh_hexes + 8 * hex;
  double value = scaled_jacobian(m->points, ids);
  return prove_jacobian_sign(m->points, ids) == JACOBIAN_POSITIVE ? value : value - penalty;
}

/** Below this a quality carries the penalty; rounding may bring a positive hex to 0. */
static const double least_positive = -1e-6;

static bool is_inverted(double quality) {
  return quality < least_positive;
}

static standing summarise(const improvement *m, const int32_t *hexes, size_t count) {
  standing s = {0, 1, 0, 0};
  for (size_t i = 0; i < count; i++) {
    double value = m->quality[hexes ? (size_t)hexes[i] : i];
    s.inverted += is_inverted(value);
    s.worst = fmin(s.worst, is_inverted(value) ? value + penalty : value);
    s.burden += 1 / fmax(value, 1e-3);
    s.sum += value;
  }
  return s;
}

/** The mesh as it is, to the user with every stage. */
static void tell(hexcon_context *context, const improvement *m) {
  standing now = summarise(m, NULL, m->set.mesh_hex_count);
  context_tell_mesh(context, m->set.mesh_hex_count, now.inverted, now.worst);
}

static bool is_better(const improvement *m, standing a, standing b) {
  if (m->kind == RAISE_MEAN)
    return a.inverted == b.inverted && a.sum > b.sum &&
           a.worst * RAISE_MEAN_CLEARANCE * (1 + 1e-9) >= fmin(b.worst, m->floor);
  if (a.inverted != b.inverted)
    return a.inverted < b.inverted;
  return a.worst > b.worst + 1e-6 || (a.worst >= b.worst && a.burden < b.burden * (1 - 1e-6));
}

static hexcon_status measure_range(void *user, hexcon_context *context, int worker, size_t item) {
  (void)worker;
  improvement *m = user;
  size_t end = (item + 1) * MEASURED_AT_ONCE;
  end = end < m->set.mesh_hex_count ? end : m->set.mesh_hex_count;
  for (size_t h = item * MEASURED_AT_ONCE; h < end; h++)
    m->quality[h] = measure(m, h);
  return context_progress(context, STAGE_MEASURING, (double)end / (double)m->set.mesh_hex_count);
}

/** Positions and qualities of a region as they are in the patch. */
static void write_back(improvement *m, const patch *p) {
  for (size_t i = 0; i < p->free_count; i++)
    memcpy(m->points + 3 * (size_t)p->points[i], p->x + 3 * i, 3 * sizeof *p->x);
  for (size_t h = 0; h < p->hex_count; h++)
    m->quality[p->hexes[h]] = measure(m, (size_t)p->hexes[h]);
}

static hexcon_status repair(hexcon_context *context, improvement *m, patch *p) {
  uint8_t *healthy = context_allocate(context, p->hex_count, sizeof *healthy);
  if (!healthy)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t h = 0; h < p->hex_count; h++)
    healthy[h] = !is_inverted(m->quality[p->hexes[h]]);
  size_t bad;
  hexcon_status status = repair_patch(context, p, healthy, m->patient, &bad);
  context_free(context, healthy);
  return status;
}

static hexcon_status optimise(hexcon_context *context, improvement *m, patch *p) {
  newton n;
  hexcon_status status = newton_new(context, p, &n);
  if (!status)
    status = m->kind == SHARPEN ? sharpen_patch(context, &n, p, m->distance, m->target)
                                : raise_mean_patch(context, &n, p, m->floor);
  newton_free(context, &n);
  return status;
}

/** Work on a copy of a region, and keep the outcome only if it is better. */
static hexcon_status improve_region(void *user, hexcon_context *context, int worker, size_t item) {
  improvement *m = user;
  const region_set *set = &m->set;
  const int32_t *hexes = set->hexes + set->hex_starts[item];
  size_t hex_count = set->hex_starts[item + 1] - set->hex_starts[item];
  standing before = summarise(m, hexes, hex_count);
  patch p;
  hexcon_status status =
      patch_copy(context, set->mesh_hexes, m->points, set->points + set->point_starts[item],
                 set->point_starts[item + 1] - set->point_starts[item], hexes, hex_count,
                 m->slots[worker], &p);
  size_t bytes = 3 * p.free_count * sizeof *p.x;
  sliding_patch on = {0};
  double *start = status ? NULL : context_allocate(context, p.free_count, 3 * sizeof *start);
  if (!start) {
    patch_free(context, &p);
    return HEXCON_OUT_OF_MEMORY;
  }
  memcpy(start, p.x, bytes);
  if (m->sliding)
    status = sliding_patch_new(context, m->sliding, m->point_ids, &p, &on);
  if (!status)
    status = m->kind == REPAIR ? repair(context, m, &p) : optimise(context, m, &p);
  write_back(m, &p);
  standing after = summarise(m, hexes, hex_count);
  if (is_better(m, after, before)) {
    atomic_store(&m->moved, true);
  } else {
    memcpy(p.x, start, bytes);
    write_back(m, &p);
  }
  context_free(context, start);
  sliding_patch_free(context, &on);
  patch_free(context, &p);
  return status;
}

/** Work on all groups, in batches of regions that do not meet. */
static hexcon_status improve_groups(hexcon_context *context, improvement *m, int layers) {
  hexcon_status status = context_progress(context, m->stage, 0);
  memset(m->postponed, 1, m->groups.count);
  atomic_store(&m->moved, false);
  for (size_t left = m->groups.count; !status && left > 0;) {
    region_set_clear(&m->set);
    for (size_t g = 0; !status && g < m->groups.count; g++) {
      if (m->postponed[g] && region_set_add(&m->set, m->groups.hexes + m->groups.starts[g],
                                            m->groups.starts[g + 1] - m->groups.starts[g], layers))
        m->postponed[g] = 0;
      status = context_pass(context, g);
    }
    left -= m->set.count;
    if (!status)
      status = workers_run(context, m->threads, m->set.count, m->stage, improve_region, m);
  }
  region_set_clear(&m->set);
  return status;
}

static bool has_free_point(const improvement *m, size_t hex) {
  for (size_t c = 0; c < 8; c++)
    if (!m->set.fixed[m->set.mesh_hexes[8 * hex + c]])
      return true;
  return false;
}

/** How hard it is tried to repair what an easier try left inverted. */
typedef struct effort {
  int layers; /* of hexes around the inverted ones whose points may move */
  bool patient;
} effort;

static const effort efforts[] = {{0, false}, {1, false}, {2, false},
                                 {4, false}, {4, true},  {10, true}};

/** Where more than this part of the hexes are inverted, and a round mends less than that part of
 * those, it would go on for hours and not come to an end: hexes between walls that are closer than
 * what is to lie between them. Few hexes, of which that part is none, are soon done with. */
static const double hopeless = 0.1, slow = 0.02;

static bool is_hopeless(const improvement *m, size_t count, size_t before) {
  return slow * (double)count >= 1 && (double)count > hopeless * (double)m->set.mesh_hex_count &&
         (double)count > (1 - slow) * (double)before;
}

/** Inverted hexes in neighbourhoods that grow while they do not come right. */
static hexcon_status repair_mesh(hexcon_context *context, improvement *m, int rounds,
                                 size_t *done) {
  const size_t most = sizeof efforts / sizeof *efforts;
  hexcon_status status = HEXCON_OK;
  size_t before = SIZE_MAX, harder = 0;
  m->kind = REPAIR;
  m->stage = STAGE_UNTANGLING;
  for (; !status && *done < (size_t)rounds; ++*done) {
    size_t count = 0;
    for (size_t h = 0; !status && h < m->set.mesh_hex_count; h++) {
      if (is_inverted(m->quality[h]) && has_free_point(m, h))
        m->seeds[count++] = (int32_t)h;
      status = context_pass(context, h);
    }
    harder += count >= before;
    if (status || count == 0 || harder == most || (harder > 1 && is_hopeless(m, count, before)))
      break;
    before = count;
    m->patient = efforts[harder].patient;
    tell(context, m);
    status = hex_groups_fill(context, &m->set, m->seeds, count, SIZE_MAX, &m->groups);
    if (!status)
      status = improve_groups(context, m, efforts[harder].layers);
  }
  return status;
}

typedef struct ranked_hex {
  double quality;
  int32_t hex;
} ranked_hex;

static int compare_ranked(const void *a, const void *b) {
  const ranked_hex *left = a, *right = b;
  if (left->quality != right->quality)
    return left->quality < right->quality ? -1 : 1;
  return (left->hex > right->hex) - (left->hex < right->hex);
}

/** What one pass of sharpening works on: the coarse ones everywhere, the fine ones where it counts.
 */
typedef struct sharpening {
  double distance; /* of the wall, see sharpen_patch */
  double reach;    /* hexes up to that part of the way from the worst to the mean are worked on */
  int layers;      /* of hexes around them that may move too */
} sharpening;

static const sharpening schedule[] = {{0.3, 0.5, 3},    {0.3, INFINITY, 0}, {0.1, 0.5, 1},
                                      {0.03, 0.3, 3},   {0.01, 0.15, 3},    {0.003, 0.05, 4},
                                      {0.001, 0.03, 4}, {0.0003, 0.02, 4},  {0.0001, 0.02, 4}};
enum { SHARPENINGS = sizeof schedule / sizeof *schedule };

/** Hexes within reach and below the target, worst first: groups form around the worst.
 * @param worst  receives the worst scaled Jacobian */
static hexcon_status rank_seeds(hexcon_context *context, improvement *m, double reach,
                                double target, size_t *count, double *worst) {
  size_t hex_count = m->set.mesh_hex_count;
  double mean = 0;
  *worst = 1;
  *count = 0;
  ranked_hex *ranked = context_allocate(context, hex_count, sizeof *ranked);
  if (!ranked)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t h = 0; h < hex_count; h++) {
    double value = is_inverted(m->quality[h]) ? 1 : m->quality[h];
    *worst = fmin(*worst, value);
    mean += value / (double)hex_count;
  }
  tell(context, m);
  double limit = fmin(*worst + reach * fmax(mean - *worst, 1e-3), target);
  hexcon_status status = HEXCON_OK;
  for (size_t h = 0; !status && h < hex_count; h++) {
    if (m->quality[h] < limit && !is_inverted(m->quality[h]) && has_free_point(m, h))
      ranked[(*count)++] = (ranked_hex){m->quality[h], (int32_t)h};
    status = context_pass(context, h);
  }
  if (!status)
    status = context_sort(context, ranked, *count, sizeof *ranked, compare_ranked);
  for (size_t i = 0; i < *count; i++)
    m->seeds[i] = ranked[i].hex;
  context_free(context, ranked);
  return status;
}

static hexcon_status sharpen_mesh(hexcon_context *context, improvement *m, int rounds,
                                  size_t *done) {
  hexcon_status status = HEXCON_OK;
  m->kind = SHARPEN;
  m->stage = STAGE_OPTIMISATION;
  for (; !status && *done < (size_t)rounds; ++*done) {
    const sharpening *pass = &schedule[*done < SHARPENINGS ? *done : SHARPENINGS - 1];
    size_t count;
    double worst;
    status = rank_seeds(context, m, pass->reach, m->target, &count, &worst);
    if (status || count == 0)
      break;
    m->distance = pass->distance;
    status = hex_groups_fill(context, &m->set, m->seeds, count, SHARPENED_AT_ONCE, &m->groups);
    if (!status)
      status = improve_groups(context, m, pass->layers);
    if (!status && *done + 1 >= SHARPENINGS && !atomic_load(&m->moved)) {
      ++*done; /* all that follow would be alike */
      break;
    }
  }
  return status;
}

/** What a hex may be lowered to for the mean's sake: this part of the worst, and this value. */
static const double floor_part = 0.76, lowest_floor = 0.101, least_floor = 1e-6;

static hexcon_status raise_mean(hexcon_context *context, improvement *m, int passes) {
  hexcon_status status = HEXCON_OK;
  m->kind = RAISE_MEAN;
  m->stage = STAGE_OPTIMISATION;
  for (int pass = 0; !status && pass < passes; pass++) {
    size_t count;
    double worst;
    status = rank_seeds(context, m, INFINITY, good_enough, &count, &worst);
    if (status || count == 0)
      break;
    if (pass == 0)
      m->floor = fmax(fmin(worst, fmax(floor_part * worst, lowest_floor)), least_floor);
    status = hex_groups_fill(context, &m->set, m->seeds, count, SHARPENED_AT_ONCE, &m->groups);
    if (!status)
      status = improve_groups(context, m, 0);
    if (!status && !atomic_load(&m->moved))
      break; /* all that follow would be alike */
  }
  return status;
}

static hexcon_status improvement_new(hexcon_context *context, improvement *m, const int32_t *hexes,
                                     size_t hex_count, size_t point_count, const uint8_t *fixed) {
  hexcon_status status = region_set_new(context, hexes, hex_count, point_count, fixed, &m->set);
  if (!status)
    status = hex_groups_new(context, hex_count, &m->groups);
  m->quality = context_allocate(context, hex_count, sizeof *m->quality);
  m->seeds = context_allocate(context, hex_count, sizeof *m->seeds);
  m->postponed = context_allocate(context, hex_count, sizeof *m->postponed);
  if (!m->quality || !m->seeds || !m->postponed)
    return HEXCON_OUT_OF_MEMORY;
  for (int t = 0; !status && t < m->threads; t++) {
    m->slots[t] = context_allocate(context, point_count, sizeof *m->slots[t]);
    if (!m->slots[t])
      return HEXCON_OUT_OF_MEMORY;
    memset(m->slots[t], -1, point_count * sizeof *m->slots[t]);
  }
  return status;
}

static void improvement_free(hexcon_context *context, improvement *m) {
  region_set_free(context, &m->set);
  hex_groups_free(context, &m->groups);
  context_free(context, m->quality);
  context_free(context, m->seeds);
  context_free(context, m->postponed);
  for (int t = 0; t < m->threads; t++)
    context_free(context, m->slots[t]);
}

/** The mesh in its canonical numbering. */
static hexcon_status improve_ordered(hexcon_context *context, canonical_order *mesh,
                                     const sliding_points *sliding,
                                     const hexcon_optimize_options *options, size_t *rounds) {
  int most = options->max_rounds > 0 ? options->max_rounds : SHARPENINGS;
  size_t ranges = (mesh->hex_count + MEASURED_AT_ONCE - 1) / MEASURED_AT_ONCE, repairs = 0,
         sharpenings = 0;
  improvement m = {.points = mesh->points,
                   .sliding = sliding,
                   .point_ids = mesh->point_ids,
                   .threads = workers_count(options->threads),
                   .target = fmin(options->target > 0 ? options->target : 1, good_enough)};
  hexcon_status status =
      improvement_new(context, &m, mesh->hexes, mesh->hex_count, mesh->point_count, mesh->fixed);
  context_tell_mesh(context, mesh->hex_count, 0, NAN);
  if (!status)
    status = workers_run(context, m.threads, ranges, STAGE_MEASURING, measure_range, &m);
  if (!status)
    status = repair_mesh(context, &m, most, &repairs);
  if (!status && summarise(&m, NULL, mesh->hex_count).inverted == 0)
    context_reserve(context, mesh->hex_count, true);
  if (!status)
    status = sharpen_mesh(context, &m, most, &sharpenings);
  if (!status)
    status = raise_mean(context, &m, options->mean_passes);
  if (rounds)
    *rounds = repairs + sharpenings;
  context_tell_mesh(context, 0, 0, NAN);
  improvement_free(context, &m);
  return status;
}

/** @param sliding  NULL: free points move anywhere */
static hexcon_status improve(hexcon_context *context, double *points, size_t point_count,
                             const int32_t *hexes, size_t hex_count, const uint8_t *fixed,
                             const sliding_points *sliding, const hexcon_optimize_options *options,
                             size_t *rounds) {
  const hexcon_optimize_options defaults = {0};
  canonical_order mesh;
  context_reserve(context, hex_count, false);
  hexcon_status status =
      canonical_order_new(context, points, point_count, hexes, hex_count, fixed, &mesh);
  if (!status) {
    status = improve_ordered(context, &mesh, sliding, options ? options : &defaults, rounds);
    canonical_order_write(&mesh, points); /* the best so far, if cancelled */
  }
  canonical_order_free(context, &mesh);
  return status;
}

hexcon_status improve_mesh(hexcon_context *context, double *points, size_t point_count,
                           const int32_t *hexes, size_t hex_count, const uint8_t *fixed,
                           const hexcon_optimize_options *options, size_t *rounds) {
  return improve(context, points, point_count, hexes, hex_count, fixed, NULL, options, rounds);
}

hexcon_status improve_sliding_mesh(hexcon_context *context, double *points, const int32_t *hexes,
                                   size_t hex_count, const sliding_points *sliding,
                                   const hexcon_optimize_options *options) {
  uint8_t *fixed = context_allocate(context, sliding->point_count, sizeof *fixed);
  if (!fixed)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t v = 0; v < sliding->point_count; v++)
    fixed[v] = sliding_freedom(sliding, (int32_t)v) == 0 || sliding_is_asked(sliding, (int32_t)v);
  hexcon_status status = improve(context, points, sliding->point_count, hexes, hex_count, fixed,
                                 sliding, options, NULL);
  context_free(context, fixed);
  return status;
}

static hexcon_status check_options(hexcon_context *context,
                                   const hexcon_optimize_options *options) {
  if (!options || (options->max_rounds >= 0 && options->threads >= 0 && options->mean_passes >= 0 &&
                   options->target >= 0 && options->target <= 1))
    return HEXCON_OK;
  return context_fail(context, HEXCON_BAD_ARGUMENT,
                      "optimize: rounds %d, threads %d and mean passes %d must not be negative, "
                      "the target %g must lie in 0 .. 1",
                      options->max_rounds, options->threads, options->mean_passes, options->target);
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

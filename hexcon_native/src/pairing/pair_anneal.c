/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "pair_anneal.h"

#include <math.h>

enum {
  STEPS = 64,           /* of the temperature */
  WORK_OF_A_CHANGE = 8, /* in passages walked, apart from walking */
  WORK_PATIENCE = 1 << 22,
  WINDOW = 1 << 12 /* quads */
};

/** Its 64th power is a fifth. */
static const double cooling = 0.975;

/** Share of a self-crossing that is added for a loop of an odd number of them. On the sphere the
 * parity of all together stays as it is: odd loops vanish two by two only, when they are joined, so
 * better early, while there are other self-crossings to get rid of. */
static const double oddity = 0.5;

/** splitmix64 (Steele, Lea and Flood 2014). */
static uint64_t random_bits(uint64_t *state) {
  uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
  z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
  return z ^ (z >> 31);
}

/** Even in [0, 1). */
static double random_unit(uint64_t *state) {
  return (double)(random_bits(state) >> 11) * 0x1p-53;
}

/* ------------------------------------------------------------------------------------ record */

static void mark_stale(pair_record *record, int32_t quad) {
  if (!record->is_stale[quad]) {
    record->is_stale[quad] = 1;
    record->stale[record->stale_count++] = quad;
  }
}

/** The quads of a change, and the partners they had. */
static void mark_change(const pair_rewiring *r, const pair_change *change, pair_record *record) {
  mark_stale(record, half_edge_quad(change->half_edge));
  mark_stale(record, half_edge_quad(r->sides[change->half_edge].twin));
  for (int i = 0; i < 2; i++)
    if (change->before[i] != PAIR_FREE)
      mark_stale(record, half_edge_quad(r->sides[change->before[i]].twin));
}

/** Take the pairs over where they are better. Costs no more than the changes since. */
static void keep_record(const pair_rewiring *r, pair_record *record) {
  if (r->crossing_count > 0 || r->pair_count >= record->pair_count)
    return;
  record->pair_count = r->pair_count;
  for (size_t i = 0; i < record->stale_count; i++) {
    int32_t quad = record->stale[i];
    record->half_edges[quad] = r->half_edges[quad];
    record->is_stale[quad] = 0;
  }
  record->stale_count = 0;
}

/* --------------------------------------------------------------------------------- annealing */

/** Changes are tried in a window that goes over the surface once a step, so that what they read is
 * in the cache, provided that quads near each other have numbers near each other. */
static int32_t random_half_edge(pair_rewiring *r, double focus, double way, uint64_t *random) {
  int32_t quad = PAIR_FREE;
  if (r->crossing_count > 0 && random_unit(random) < focus)
    quad = pair_rewiring_crossed_quad(r, random_bits(random));
  if (quad != PAIR_FREE)
    return 4 * quad + (int32_t)(random_bits(random) & 3);
  size_t count = r->quad_count, window = count < WINDOW ? count : WINDOW;
  double first = way * (double)(count - window);
  return (int32_t)(4 * (first + random_unit(random) * (double)window));
}

static bool is_accepted(const pair_change *change, double penalty, double temperature,
                        uint64_t *random) {
  double crossings = change->more_crossings + oddity * change->more_odd;
  double cost = change->more_pairs + penalty * crossings;
  return cost <= 0 || random_unit(random) < exp(-cost / temperature);
}

static void change_one(pair_rewiring *r, const pair_schedule *schedule, double temperature,
                       double way, uint64_t *random, pair_record *record) {
  pair_change change;
  pair_rewiring_try(r, random_half_edge(r, schedule->focus, way, random), &change);
  if (is_accepted(&change, schedule->penalty, temperature, random)) {
    pair_rewiring_accept(r, &change);
    mark_change(r, &change, record);
    keep_record(r, record);
  } else {
    pair_rewiring_reject(r, &change);
  }
  r->work += WORK_OF_A_CHANGE;
}

static hexcon_status tell(pair_rewiring *r, const pair_schedule *schedule, int step) {
  if (r->work - r->told < WORK_PATIENCE)
    return HEXCON_OK;
  r->told = r->work;
  return context_progress(r->context, STAGE_PAIRING,
                          schedule->done + schedule->share * step / (double)STEPS);
}

static hexcon_status run_step(pair_rewiring *r, const pair_schedule *schedule, int step,
                              double temperature, uint64_t *random, pair_record *record) {
  double work = (double)schedule->work / (double)STEPS, way = 0;
  uint64_t before = r->work;
  hexcon_status status = HEXCON_OK;
  while (!status && way < 1) {
    change_one(r, schedule, temperature, way, random, record);
    way = (double)(r->work - before) / work;
    status = tell(r, schedule, step);
  }
  return status;
}

hexcon_status pair_anneal(pair_rewiring *r, const pair_schedule *schedule, uint64_t *random,
                          pair_record *record) {
  double temperature = schedule->temperature;
  hexcon_status status = HEXCON_OK;
  for (size_t q = 0; q < r->quad_count; q++)
    mark_stale(record, (int32_t)q);
  keep_record(r, record);
  for (int step = 0; !status && step < STEPS; step++) {
    status = run_step(r, schedule, step, temperature, random, record);
    temperature *= cooling;
  }
  return status;
}

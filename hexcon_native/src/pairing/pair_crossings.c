/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "pair_crossings.h"

#include <stdint.h>

#include "pair_anneal.h"
#include "pair_order.h"
#include "pairing.h"

typedef enum start { FROM_ALL, FROM_NONE, FROM_LAST, FROM_BEST } start;

typedef struct attempt {
  start from;
  double temperature, penalty, focus;
} attempt;

/** Cheap self-crossings suit surfaces where few pairs do, dear ones those that need many; with
 * focus the last ones vanish sooner, by more pairs. Of the values tried, these found the fewest. */
static const attempt attempts[] = {
    {FROM_ALL, 0.3, 3, 0},    {FROM_NONE, 1, 0.7, 0},     {FROM_LAST, 0.7, 3, 0.1},
    {FROM_NONE, 1.6, 3, 0},   {FROM_LAST, 1, 3, 0.1},     {FROM_LAST, 1, 3, 0.6},
    {FROM_NONE, 1.6, 3, 0.6}, {FROM_BEST, 0.7, 2.5, 0.1}, {FROM_BEST, 0.6, 2.5, 0},
};

/** On large surfaces: hardly any self-crossing is let in, so loops stay short. */
static const attempt descent = {FROM_ALL, 0.1, 3, 0};

enum {
  ATTEMPTS = sizeof attempts / sizeof *attempts,
  MOST_QUADS_FOR_ALL = 4000,
  WORK_PER_SQUARE = 4000, /* of the quad count, in passages */
  MOST_WORK_OF_ATTEMPT = 100000000,
  WORK_PER_QUAD = 20000,
  LEAST_WORK_PER_QUAD = 1000,
  MOST_WORK_OF_DESCENT = 1000000000 /* unless the least per quad is more */
};

static uint64_t at_most(uint64_t value, uint64_t limit) {
  return value < limit ? value : limit;
}

static uint64_t work_of_attempt(uint64_t quad_count) {
  return at_most(WORK_PER_SQUARE * quad_count * quad_count, MOST_WORK_OF_ATTEMPT);
}

static uint64_t work_of_descent(uint64_t quad_count) {
  uint64_t least = LEAST_WORK_PER_QUAD * quad_count;
  uint64_t work = at_most(WORK_PER_QUAD * quad_count, MOST_WORK_OF_DESCENT);
  return work > least ? work : least;
}

static hexcon_status run_attempts(pair_rewiring *r, const int32_t *all_pairs, pair_record *record) {
  bool small = r->quad_count <= MOST_QUADS_FOR_ALL;
  uint64_t random = 0;
  hexcon_status status = HEXCON_OK;
  int count = small ? ATTEMPTS : 1;
  for (int i = 0; !status && i < count; i++) {
    const attempt *a = small ? &attempts[i] : &descent;
    pair_schedule schedule = {.temperature = a->temperature,
                              .penalty = a->penalty,
                              .focus = a->focus,
                              .work = small ? work_of_attempt(r->quad_count)
                                            : work_of_descent(r->quad_count),
                              .done = (double)i / count,
                              .share = 1.0 / count};
    if (a->from != FROM_LAST)
      pair_rewiring_set(r, a->from == FROM_ALL    ? all_pairs
                           : a->from == FROM_BEST ? record->half_edges
                                                  : NULL);
    status = pair_anneal(r, &schedule, &random, record);
  }
  return status;
}

/** @param half_edges  receives the pairs; it and all_pairs are numbered as the rewiring is */
static hexcon_status reduce(pair_rewiring *r, const int32_t *all_pairs, int32_t *half_edges,
                            size_t *pair_count) {
  size_t count = r->quad_count;
  pair_record record = {.half_edges = half_edges,
                        .pair_count = SIZE_MAX,
                        .stale = context_allocate(r->context, count, sizeof *record.stale),
                        .is_stale = context_allocate_zeroed(r->context, count, 1)};
  hexcon_status status =
      record.stale && record.is_stale ? run_attempts(r, all_pairs, &record) : HEXCON_OUT_OF_MEMORY;
  *pair_count = record.pair_count;
  context_free(r->context, record.stale);
  context_free(r->context, record.is_stale);
  return status;
}

/** Replaces all pairs of the surface by few. */
static hexcon_status reduce_in_order(pair_rewiring *r, const pair_order *order,
                                     int32_t *half_edge_of_quad, size_t *pair_count) {
  size_t count = r->quad_count;
  int32_t *all_pairs = context_allocate(r->context, count, sizeof *all_pairs);
  int32_t *few_pairs = context_allocate(r->context, count, sizeof *few_pairs);
  hexcon_status status = all_pairs && few_pairs ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  for (size_t q = 0; !status && q < count; q++)
    all_pairs[q] = pair_order_new(order, half_edge_of_quad[order->quads[q]]);
  if (!status)
    status = reduce(r, all_pairs, few_pairs, pair_count);
  for (size_t q = 0; !status && q < count; q++)
    half_edge_of_quad[order->quads[q]] =
        few_pairs[q] == PAIR_FREE ? PAIR_FREE : pair_order_old(order, few_pairs[q]);
  context_free(r->context, all_pairs);
  context_free(r->context, few_pairs);
  return status;
}

static hexcon_status pair_where_crossed(pair_rewiring *r, const surface *s, const pair_order *order,
                                        int32_t *half_edge_of_quad, size_t *pair_count) {
  pair_rewiring_set(r, NULL);
  for (size_t q = 0; q < s->quad_count; q++)
    half_edge_of_quad[q] = PAIR_FREE;
  if (r->crossing_count == 0)
    return HEXCON_OK;
  hexcon_status status = surface_pair(r->context, s, NULL, half_edge_of_quad);
  return status ? status : reduce_in_order(r, order, half_edge_of_quad, pair_count);
}

hexcon_status surface_pair_crossings(hexcon_context *context, const surface *s,
                                     int32_t *half_edge_of_quad, size_t *pair_count) {
  pair_order order;
  pair_rewiring r = {.context = context};
  *pair_count = 0;
  hexcon_status status = pair_order_create(context, s, &order);
  if (!status)
    status = pair_rewiring_create(context, &order.s, &r);
  if (!status)
    status = pair_where_crossed(&r, s, &order, half_edge_of_quad, pair_count);
  pair_rewiring_free(&r);
  pair_order_free(context, &order);
  return status;
}

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Fewer pairs by simulated annealing of a rewiring. */
#ifndef HEXCON_PAIRING_PAIR_ANNEAL_H
#define HEXCON_PAIRING_PAIR_ANNEAL_H

#include "pair_rewiring.h"

/** The fewest pairs so far after which no loop crosses itself. */
typedef struct pair_record {
  int32_t *half_edges; /* [quad_count] */
  size_t pair_count;   /* SIZE_MAX: none yet */
  int32_t *stale;      /* [quad_count] quads whose half-edges may differ from the rewiring's */
  uint8_t *is_stale;   /* [quad_count] */
  size_t stale_count;
} pair_record;

/** How long, and how freely. Costs are counted in pairs. */
typedef struct pair_schedule {
  double temperature; /* at the start; falls to a fifth */
  double penalty;     /* of a self-crossing */
  double focus;       /* share of the changes that are tried at a self-crossed quad */
  uint64_t work;      /* passages to walk */
  double done, share; /* progress before, and of this run */
} pair_schedule;

/**
 * Change pairs at random, each change accepted by what it costs (Metropolis), from what is set in
 * the rewiring. The record is kept up, never worse than before. Deterministic: the length is given
 * by work, not by time.
 * Source: Kirkpatrick, Gelatt and Vecchi, Optimization by simulated annealing (1983).
 * @param random  state, any start will do
 * @return CANCELLED
 */
hexcon_status pair_anneal(pair_rewiring *r, const pair_schedule *schedule, uint64_t *random,
                          pair_record *record);

#endif

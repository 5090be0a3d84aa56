/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Fewer hexes: the smallest fillings of a target met so far, and a walk from them to smaller ones.
 */
#ifndef TEMPLATE_SEARCH_SHRINK_H
#define TEMPLATE_SEARCH_SHRINK_H

#include "beam.h"
#include "support.h"

enum { MOST_KEPT = 32 };

/** The smallest fillings, fewest hexes first, all different. */
typedef struct pool {
  const target *goal;
  int room, count; /**< room: 1 .. MOST_KEPT */
  filling kept[MOST_KEPT];
  uint64_t names[MOST_KEPT];
} pool;

/** Keep it if it is among the smallest. */
void pool_offer(pool *p, const filling *f);

/** Re-fill random parts of random ones of the pool from a table for so long, and offer the results.
 */
void shrink(const table *t, pool *p, double seconds, dice *random);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Large neighbourhoods: a part of a filling that is a ball is filled otherwise, from a table. */
#ifndef TEMPLATE_SEARCH_REFILL_H
#define TEMPLATE_SEARCH_REFILL_H

#include "beam.h"
#include "support.h"

typedef struct refill_options {
  int tries;      /**< random parts to look at */
  int slack;      /**< hexes that the new part may have more than the old one */
  int most_hexes; /**< in the result */
  int focus;      /**< hex to begin with, or -1 for any */
  int most_part;  /**< hexes in the part */
} refill_options;

/**
 * @param point_count  ids in use; new points get higher ones
 * @return false if none was found; otherwise `after` is another proper filling
 */
bool refill(const table *t, const target *goal, const filling *before, int point_count,
            const refill_options *options, dice *random, filling *after);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "pillow_placement.h"

/** How far a copy goes from its original towards the middles of its hexes. */
static const double drawn_back = 0.5;

/** Add a hex's middle, as it was before, to what its copies are drawn to. */
static void add_middle(const int32_t *hex, const int32_t *originals, size_t first,
                       const double *points, double (*sums)[3], int32_t *counts) {
  double middle[3] = {0};
  for (size_t i = 0; i < 8; i++) {
    size_t point =
        (size_t)hex[i] < first ? (size_t)hex[i] : (size_t)originals[(size_t)hex[i] - first];
    for (size_t k = 0; k < 3; k++)
      middle[k] += points[3 * point + k] / 8;
  }
  for (size_t i = 0; i < 8; i++) {
    if ((size_t)hex[i] < first)
      continue;
    size_t copy = (size_t)hex[i] - first;
    counts[copy]++;
    for (size_t k = 0; k < 3; k++)
      sums[copy][k] += middle[k];
  }
}

hexcon_status place_pillow(hexcon_context *context, const int32_t *hexes, const int32_t *set,
                           size_t set_count, const int32_t *originals, size_t first, size_t count,
                           double *points) {
  double(*sums)[3] = context_allocate_zeroed(context, count, sizeof *sums);
  int32_t *counts = context_allocate_zeroed(context, count, sizeof *counts);
  for (size_t i = 0; sums && counts && i < set_count; i++)
    add_middle(hexes + 8 * (size_t)set[i], originals, first, points, sums, counts);
  for (size_t copy = 0; sums && counts && copy < count; copy++)
    for (size_t k = 0; k < 3; k++) {
      double from = points[3 * (size_t)originals[copy] + k];
      points[3 * (first + copy) + k] =
          from + drawn_back * (sums[copy][k] / (double)counts[copy] - from);
    }
  hexcon_status status = sums && counts ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  context_free(context, sums);
  context_free(context, counts);
  return status;
}

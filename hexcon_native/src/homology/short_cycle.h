/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Short closed paths of an odd number of edges with a given property, near a point. */
#ifndef HEXCON_HOMOLOGY_SHORT_CYCLE_H
#define HEXCON_HOMOLOGY_SHORT_CYCLE_H

#include "surface/half_edges.h"

typedef struct short_cycle_search {
  const surface *s;
  const uint64_t *labels;      /* [4 quad_count] alike on twins: the sum over a wanted path is 0 */
  int32_t *half_edge_of_point; /* [point_count] one that starts there */
  int32_t *depth;              /* [point_count] */
  int32_t *reached_by;         /* [point_count] half-edge that leads there */
  int32_t *queue;              /* [point_count] */
  uint64_t *sums;              /* [point_count] of labels on the way there */
} short_cycle_search;

/** @param out  free with short_cycle_free, also after an error. Linear. @return OUT_OF_MEMORY */
hexcon_status short_cycle_new(hexcon_context *context, const surface *s, const uint64_t *labels,
                              short_cycle_search *out);
void short_cycle_free(hexcon_context *context, short_cycle_search *search);

/**
 * Of the cycles that single edges close in a breadth-first tree, the shortest odd one whose labels
 * sum up to 0; often the shortest that passes the root.
 * @param most   only cycles of fewer edges count; bounds the search as well
 * @param cycle  [point_count] receives the points in order
 * @return their number; 0: there is none. Cost: linear in the edges within most / 2 of the root,
 *         but for a reset of all points.
 */
size_t short_cycle_find(short_cycle_search *search, int32_t root, size_t most, int32_t *cycle);

#endif

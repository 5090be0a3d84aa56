/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** How far the dual loops are from crossing like the great circles of a sphere. */
#ifndef HEXCON_SURFACE_LOOP_CROSSINGS_H
#define HEXCON_SURFACE_LOOP_CROSSINGS_H

#include "half_edges.h"

/** What counting needs, for surfaces of so many quads. */
typedef struct crossing_counter {
  int32_t *loop_of_passage; /**< [2 quads] */
  int32_t *passages;        /**< [2 quads] loop after loop */
  int32_t *counts;          /**< [2 quads] by loop; zero between calls */
} crossing_counter;

typedef struct loop_crossings {
  size_t loops;
  size_t of_themselves; /**< quads that one loop passes twice */
  size_t in_excess;     /**< pairs of crossings that two loops have beyond the first pair */
} loop_crossings;

/** @param out  free with crossing_counter_free, also after an error */
hexcon_status crossing_counter_new(hexcon_context *context, size_t quad_count,
                                   crossing_counter *out);
void crossing_counter_free(hexcon_context *context, crossing_counter *counter);

/** Linear. */
loop_crossings count_crossings(const surface *s, crossing_counter *counter);

#endif

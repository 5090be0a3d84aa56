/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Dual loops of a surface. */
#ifndef HEXCON_SURFACE_LOOPS_H
#define HEXCON_SURFACE_LOOPS_H

#include "half_edges.h"

/**
 * Loops as passages: passage i of a loop enters quad `entries[i] / 4` through half-edge
 * `entries[i]` and leaves it through the opposite one.
 */
typedef struct surface_loops {
  size_t count;
  size_t *offsets;          /**< [count + 1] into entries */
  int32_t *entries;         /**< [2 * quad_count] */
  size_t *self_crossings;   /**< [count] */
  int32_t *loop_of_passage; /**< [2 * quad_count] at 2 * quad + side % 2 of the entry */
} surface_loops;

/** Linear. @param out free with surface_loops_free, also after an error */
hexcon_status surface_find_loops(hexcon_context *context, const surface *s, surface_loops *out);
void surface_loops_free(hexcon_context *context, surface_loops *loops);

static inline size_t surface_passage(int32_t half_edge) {
  return 2 * (size_t)half_edge_quad(half_edge) + (size_t)(half_edge & 1);
}

#endif

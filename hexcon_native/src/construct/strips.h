/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Strips: maximal runs of simple loops that lie side by side, such as the sides of a sweep. */
#ifndef HEXCON_CONSTRUCT_STRIPS_H
#define HEXCON_CONSTRUCT_STRIPS_H

#include "surface/loops.h"

/** Rings of a strip are numbered from its left end: ring r is order[first + r]. */
typedef struct strip {
  size_t first, ring_count, length; /**< length: quads in each ring */
  bool cyclic;                      /**< ring_count - 1 has ring 0 on its right */
} strip;

typedef struct strip_table {
  size_t count;
  strip *strips;          /**< [count] */
  int32_t *entries;       /**< [loop count] by first + ring: a half-edge that enters a quad of that
                               ring in the direction common to the strip */
  int32_t *strip_of_loop; /**< [loop count], -1 for a loop that crosses itself */
  int32_t *ring_of_loop;  /**< [loop count] */
} strip_table;

/** Every simple loop is in exactly one strip. Linear. @param out free with strips_free */
hexcon_status strips_build(hexcon_context *context, const surface *s, const surface_loops *loops,
                           strip_table *out);
void strips_free(hexcon_context *context, strip_table *table);

/** The next entry along a ring. */
static inline int32_t ring_next(const surface *s, int32_t entry) {
  return s->twins[half_edge_turn(entry, 2)];
}

/** The entry beside this one in the ring on the left; meaningful inside a strip. */
static inline int32_t ring_left(const surface *s, int32_t entry) {
  return half_edge_turn(s->twins[half_edge_turn(entry, -1)], -1);
}

/** The entry beside this one in the ring on the right; meaningful inside a strip. */
static inline int32_t ring_right(const surface *s, int32_t entry) {
  return half_edge_turn(s->twins[half_edge_turn(entry, 1)], 1);
}

#endif

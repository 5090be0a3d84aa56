/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Two bases of a surface's first homology over Z2, dual to each other. */
#ifndef HEXCON_HOMOLOGY_HANDLE_CYCLES_H
#define HEXCON_HOMOLOGY_HANDLE_CYCLES_H

#include "surface/half_edges.h"

/**
 * A pair of bases: cycle i runs along edges, ring i crosses edges, and ring j crosses edges of
 * cycle i an odd number of times if and only if i = j: once, the first half-edge of both.
 */
typedef struct handle_cycles {
  size_t count;         /**< of each: twice the genus, over all components */
  size_t *first_along;  /**< [count + 1] into along */
  int32_t *along;       /**< half-edges of each cycle in order, head to tail */
  size_t *first_across; /**< [count + 1] into across */
  int32_t *across;      /**< half-edges that each ring crosses in order, out of their quads */
} handle_cycles;

/** Above this many half-edges in all the bases are not written. */
#define HANDLE_CYCLES_MOST ((size_t)1 << 26)

/**
 * Find both by a tree and a cotree, breadth-first, so that cycles are short. Linear, and linear in
 * what is written.
 * @param out  filled; free with handle_cycles_free, also after an error
 * @param complete  false if the bases are too long; `out` has then only `count`
 * Source: Eppstein, Dynamic generators of topologically embedded graphs (2003).
 * @return OUT_OF_MEMORY
 */
hexcon_status handle_cycles_find(hexcon_context *context, const surface *s, handle_cycles *out,
                                 bool *complete);
void handle_cycles_free(hexcon_context *context, handle_cycles *cycles);

#endif

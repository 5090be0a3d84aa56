/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * The paired transition: two hexes on each pair of quads, whose six inner quads no dual loop
 * passes twice.
 * Source: Carbonera and Shepherd, A constructive approach to constrained hexahedral mesh generation
 * (2006), section 4.1, theorem 2.
 */
#ifndef HEXCON_CONSTRUCT_PAIRED_TRANSITION_H
#define HEXCON_CONSTRUCT_PAIRED_TRANSITION_H

#include "growing_mesh.h"
#include "surface/half_edges.h"

/** What becomes of the surface. */
typedef struct paired_quads {
  size_t quad_count;
  int32_t *quads; /**< [quad_count][4] oriented as the surface: the six of each pair, pair by pair
                       in the order of their first quads, then the quads of no pair; a pair that
                       shares two edges leaves four */
  int32_t *hexes; /**< [quad_count] the hex behind each; -1: none */
  mean_points points;
} paired_quads;

/**
 * Build it: 2 hexes and 4 points a pair.
 * @param partner  [quad_count] the half-edge of each quad across which its partner lies, -1 without
 * @param mesh     has the surface's points; grows
 * @param out      free with paired_quads_free, also after an error
 * Errors: OUT_OF_MEMORY, TOO_LARGE. Linear.
 */
hexcon_status paired_transition_build(hexcon_context *context, const surface *s,
                                      const int32_t *partner, growing_mesh *mesh,
                                      paired_quads *out);
/** The point of the surface at whose end of the shared edge a transition's point lies; points of
 * the surface are their own.
 * @param first  the surface's point count
 * @param pairs  number of pairs
 * @param hexes  [2 * pairs][8] the transition's */
int32_t paired_transition_end(size_t first, size_t pairs, const int32_t *hexes, int32_t point);
void paired_quads_free(hexcon_context *context, paired_quads *paired);

#endif

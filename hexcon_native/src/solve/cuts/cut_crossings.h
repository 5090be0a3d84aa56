/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** How would the dual loops cross each other after a cut? */
#ifndef HEXCON_SOLVE_CUTS_CUT_CROSSINGS_H
#define HEXCON_SOLVE_CUTS_CUT_CROSSINGS_H

#include "construct/disc_pattern.h"
#include "surface/loops.h"

/**
 * The loops of a surface without one of its rings. Those that cross the ring fall into strands,
 * which end at its rungs; discs join these ends in pairs, the same on both sides. What remains to
 * be done for each disc is to follow the strands.
 */
typedef struct cut_crossings {
  size_t length;              /**< of the ring, and so the number of strands */
  size_t thread_count;        /**< strands, then the loops that the ring does not meet */
  size_t *first;              /**< [thread_count + 1] into passages */
  int32_t *passages;          /**< of each thread */
  int32_t *thread_of_passage; /**< [2 quad_count] -1 in the ring */
  int32_t *ends;              /**< [length][2] of strands: 2 * rung + side */
  int32_t *strands;           /**< [2 length] that end there */
  int32_t *roots;             /**< [thread_count] the first thread of the loop it comes to be in */
  int32_t *order;             /**< [length] strands, loop after loop, each with .. */
  int32_t *joints;            /**< [length] .. the end by which it is left */
  size_t *counts;             /**< [thread_count] zero between calls */
  int32_t *met;               /**< [thread_count] those whose counts are not */
  size_t of_themselves, in_excess; /**< crossings of whole loops, whatever the disc */
} cut_crossings;

/** As count_crossings has them, of the surface after the cut. */
typedef struct crossing_counts {
  size_t of_themselves, in_excess;
} crossing_counts;

/** @param loop  that does not touch itself
 * @param out free with cut_crossings_free, also after an error. Linear. Errors: OUT_OF_MEMORY. */
hexcon_status cut_crossings_new(hexcon_context *context, const surface *s,
                                const surface_loops *loops, size_t loop, cut_crossings *out);
void cut_crossings_free(hexcon_context *context, cut_crossings *c);

/** Count them; those with rings around a grid are left out. Linear in the strands' passages and the
 * disc. */
crossing_counts cut_crossings_count(cut_crossings *c, const disc_shape *shape);

#endif

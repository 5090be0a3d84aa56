/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Which layers may be laid on a front, and which of them does its geometry suggest? */
#ifndef HEXCON_SOLVE_SHEETS_SHEET_CANDIDATES_H
#define HEXCON_SOLVE_SHEETS_SHEET_CANDIDATES_H

#include "construct/sheet_front.h"

/** How layers are weighed against each other. */
typedef struct sheet_taste {
  double hex_weight; /**< > 0: square radians that a hex may save */
  double noise;      /**< scores are stretched by up to this factor more, at random */
  uint64_t seed;
  double least_corner; /**< no corner of a layer's hex whose four points are all given may have a
                            lower scaled Jacobian; -1: it may have any */
} sheet_taste;

/** A layer that may be laid: the rings that pass these entries, the region on their left. */
typedef struct sheet_candidate {
  double score;       /**< the worse ones only know that they are worse */
  int32_t entries[2]; /**< the second is -1 where the layer ends at one loop */
} sheet_candidate;

/** One side of a loop. */
typedef struct loop_side {
  double rim_score; /**< a lower bound where it is above that of the best layer */
  int32_t entry;    /**< the side lies on the left */
} loop_side;

/** Candidates of one front on top of those of another. */
typedef struct candidate_stack {
  size_t count, room;
  sheet_candidate *items; /**< [count] */
  size_t side_count;
  loop_side *sides; /**< [2 loops] of the present front */
  uint64_t random;
  size_t work; /**< rungs and quads looked at since it was asked whether to go on */
} candidate_stack;

hexcon_status candidates_new(hexcon_context *context, const sheet_front *front, uint64_t seed,
                             candidate_stack *out);
void candidates_free(hexcon_context *context, candidate_stack *stack);

/** A region has been looked at: ask whether to go on once those were large, or many. */
hexcon_status candidates_count_work(hexcon_context *context, candidate_stack *stack,
                                    const front_region *region);

/**
 * Push the layers that end at one loop, and those that end at two and might be better than all of
 * these, best first. The best ones can be laid, others may turn out not to.
 * @param region  to work with
 * Cost: linear in the front and in the regions that may be best.
 */
hexcon_status candidates_push(hexcon_context *context, sheet_front *front, front_region *region,
                              const sheet_taste *taste, candidate_stack *stack);

/** Find the region of a candidate. @return false: the front would not stay proper */
bool candidate_find(sheet_front *front, const sheet_candidate *candidate, front_region *region);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Where may a body's handles be cut, and where best? */
#ifndef HEXCON_SOLVE_CUTS_CUT_CHOICE_H
#define HEXCON_SOLVE_CUTS_CUT_CHOICE_H

#include "cut_body.h"
#include "surface/loops.h"

/** A ring of quads round a handle and a disc for it. */
typedef struct cut_candidate {
  size_t loop;
  uint64_t kind; /**< alike for loops that go round the same handle */
  disc_shape shape;
  double worst; /**< scaled Jacobian of the layer between the two discs as they are placed */
  double cost;  /**< less is better: of crossings, of the layer's shape, of its quads */
} cut_candidate;

typedef struct cut_choice {
  surface_loops loops;
  size_t simple_count;  /**< loops that meet themselves nowhere */
  size_t cutting_count; /**< of these, that take a handle away */
  size_t count;
  cut_candidate *candidates; /**< [count] the best first */
} cut_choice;

/**
 * Find loops that do not touch themselves, whose rails bound inside and do not part the surface;
 * for each sort of them, the shortest ones are given discs.
 * @param out  free with cut_choice_free, also after an error
 * Errors: OUT_OF_MEMORY, TOO_LARGE, CANCELLED, OUT_OF_TIME. Cost: linear, and that of the discs
 * looked at: for each kind not many more quads than the surface has.
 */
hexcon_status cut_choice_find(hexcon_context *context, const cut_body *body, cut_choice *out);
void cut_choice_free(hexcon_context *context, cut_choice *choice);

static inline const int32_t *cut_choice_ring(const cut_choice *choice, const cut_candidate *one) {
  return choice->loops.entries + choice->loops.offsets[one->loop];
}

#endif

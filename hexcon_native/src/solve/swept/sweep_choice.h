/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Which sweeps does a surface allow, and which of them does its geometry suggest? */
#ifndef HEXCON_SOLVE_SWEPT_SWEEP_CHOICE_H
#define HEXCON_SOLVE_SWEPT_SWEEP_CHOICE_H

#include "construct/reflection.h"
#include "construct/strips.h"
#include "surface/half_edges.h"

/** A sweep to try: where the surface is reflected, and how many rings are sides. */
typedef struct sweep_candidate {
  mirror seed;
  size_t rings;
  double score; /**< mean radians by which the rims are not square and the sides not flat */
} sweep_candidate;

enum { MAX_SWEEP_CANDIDATES = 8 };

typedef struct sweep_choice {
  surface_loops loops;
  strip_table strips;
  reflection reflected; /**< the last one tried */
  size_t count;
  sweep_candidate candidates[MAX_SWEEP_CANDIDATES]; /**< best score first */
  size_t simple_loop_count, strip_tried_count;
  int32_t clash[2];    /**< where the most promising strip failed; -1 if unknown */
  const char *failure; /**< why, NULL if there is a candidate */
} sweep_choice;

/**
 * Find the sweeps of a surface. Strips are tried in the order of their geometry; the work on
 * strips that fail is limited to 64 visits a quad, so the cost is linear.
 * @param out  free with sweep_choice_free, also after an error
 */
hexcon_status sweep_choose(hexcon_context *context, const surface *s, sweep_choice *out);
void sweep_choice_free(hexcon_context *context, sweep_choice *choice);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** In which order do dual loops go, and on which side of each lies its layer? */
#ifndef HEXCON_SOLVE_SHEETS_SHEET_SEARCH_H
#define HEXCON_SOLVE_SHEETS_SHEET_SEARCH_H

#include "shape/place/layer_placement.h"
#include "sheet_candidates.h"
#include "solve/common/visited_sets.h"

/** The candidates of one front, in the search's stack. */
typedef struct sheet_level {
  size_t first, next;
} sheet_level;

/**
 * A mesh that grows inward by layers, and the search for them. What cannot be filled by layers
 * remains as a core: the front, a quad surface with points, which another method may fill and whose
 * hexes then join front.mesh.
 */
typedef struct sheet_search {
  sheet_front front; /**< as far as it came: the smallest core met */
  size_t point_room;
  double *points; /**< [point_room][3], those of front.mesh are placed; rows of the surface's points
                       are as given */
  bool complete;  /**< the front came to a cube, which is filled: there is no core */
  size_t step_count; /**< fronts whose layers were compared */
  /* Private. */
  front_region region;
  layer_placement placement;
  candidate_stack candidates;
  visited_sets visited; /* sets of loops taken away: what is left depends on nothing else */
  uint64_t key;         /* of the present one */
  size_t dead_ends;
  size_t level_count;
  sheet_level *levels;               /* [loops + 1] */
  sheet_candidate *path, *best_path; /* [loops] the layers laid, and to the smallest core */
  size_t best_count, best_alive;     /* layers of best_path, and the quads left */
} sheet_search;

/**
 * Lay layers until a cube is left or the limit is reached: the best first, and other ones where
 * that ends nowhere. Dead ends go back by one layer, now and then by 2, 4, 8 ..., and nothing is
 * visited twice.
 * @param limit  sum of the quads of fronts that are no smaller than the smallest one before
 * @param out    free with sheet_search_free, also after an error
 * Cost: a step is linear in the front; natural meshes need one for each loop, so n^1.5 in all.
 * Errors: OUT_OF_MEMORY, TOO_LARGE, CANCELLED.
 */
hexcon_status sheet_search_run(hexcon_context *context, const surface *s, const sheet_taste *taste,
                               size_t limit, sheet_search *out);
void sheet_search_free(hexcon_context *context, sheet_search *search);

#endif

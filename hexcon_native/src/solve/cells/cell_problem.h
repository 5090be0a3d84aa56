/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** What all ways to fill a surface with cells share. */
#ifndef HEXCON_SOLVE_CELLS_CELL_PROBLEM_H
#define HEXCON_SOLVE_CELLS_CELL_PROBLEM_H

#include "construct/cells.h"

typedef struct cell_problem {
  const surface *s;
  const hexcon_mesh_options *options;
  double center[3]; /**< the caller's to find, .. */
  bool no_center;   /**< .. where there is one */
  double bound;     /**< of the worst scaled Jacobian, from the surface's own corners */
  uint8_t *colours;
  double *weights; /**< [4 quad_count] of pairs */
  int32_t *partner;
  cell_complex cells;
  size_t pairing; /**< how often the pairs' weights were changed */
} cell_problem;

/** Colours, weights and bound of a surface. Linear.
 * @param out  free with cell_problem_free, also after an error
 * Errors: those of surface_colour. */
hexcon_status cell_problem_new(hexcon_context *context, const surface *s,
                               const hexcon_mesh_options *options, cell_problem *out);
void cell_problem_free(hexcon_context *context, cell_problem *p);

/** Pair the quads by their weights and build the cells over the pairs, under so many layers.
 * Errors: those of surface_pair and cells_build. */
hexcon_status cell_problem_build_cells(hexcon_context *context, cell_problem *p, size_t layers);

#endif

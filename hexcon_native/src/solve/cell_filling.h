/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** One way to fill a surface with cells: layers, cells, tetrahedra inside, all placed. */
#ifndef HEXCON_SOLVE_CELL_FILLING_H
#define HEXCON_SOLVE_CELL_FILLING_H

#include "closure.h"
#include "construct/cells.h"

/** What all attempts share. */
typedef struct cell_problem {
  const surface *s;
  const hexcon_mesh_options *options;
  double center[3];
  double bound; /* of the worst scaled Jacobian, from the surface's own corners */
  uint8_t *colours;
  double *weights; /* [4 quad_count] of pairs */
  int32_t *partner;
  cell_complex cells;
  size_t pairing; /* how often the pairs' weights were changed */
} cell_problem;

/** A filled surface and what it is worth. */
typedef struct cell_filling {
  double *points, *quality;
  int32_t *hexes;
  size_t point_count, hex_count, tetrahedron_count, rounds, layers;
  size_t pairing; /* the problem's number of it */
  closure_kind closure;
  double thickness;
  size_t inverted; /* not proved positive */
  double worst, mean;
} cell_filling;

/**
 * Fill with the problem's cells, of one thickness and with one closure.
 * @param thickness  of the cells, in lengths of the edges above
 * @param f          points, hexes and counts are filled; stays without points where no closure was
 *                   found; free with cell_filling_free
 * Errors: OUT_OF_MEMORY, TOO_LARGE, CANCELLED. Linear.
 */
hexcon_status cell_filling_build(hexcon_context *context, const cell_problem *p, double thickness,
                                 closure_kind kind, cell_filling *f);
void cell_filling_free(hexcon_context *context, cell_filling *f);

#endif

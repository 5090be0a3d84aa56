/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** One way to fill a surface with cells: layers, cells, tetrahedra inside, all placed. */
#ifndef HEXCON_SOLVE_CELLS_CELL_FILLING_H
#define HEXCON_SOLVE_CELLS_CELL_FILLING_H

#include "cell_problem.h"
#include "solve/common/closure.h"
#include "solve/common/filled_mesh.h"

/** A filled surface and what it is worth. */
typedef struct cell_filling {
  filled_mesh mesh; /* without points: no closure was found */
  size_t tetrahedron_count, layers;
  size_t pairing; /* the problem's number of it */
  closure_kind closure;
  double thickness;
} cell_filling;

/**
 * Fill with the problem's cells, of one thickness and with one closure.
 * @param thickness  of the cells, in lengths of the edges above
 * @param f          points, hexes and counts are filled; stays without points where no closure was
 *                   found; free its mesh with filled_mesh_free
 * Errors: OUT_OF_MEMORY, TOO_LARGE, CANCELLED. Linear.
 */
hexcon_status cell_filling_build(hexcon_context *context, const cell_problem *p, double thickness,
                                 closure_kind kind, cell_filling *f);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * Cells of two patches that have corners or sides in common: proofs that they meet nowhere else.
 * Each looks at the directions from what they share, so it does not matter how small the cells are.
 */
#ifndef HEXCON_EMBEDDING_PATCH_NEIGHBOURS_H
#define HEXCON_EMBEDDING_PATCH_NEIGHBOURS_H

#include <stdbool.h>

#include "patch_cell.h"

typedef struct placed_cell {
  const patch *patch;
  cell cell;
} placed_cell;

/** They share a corner: a plane through it has one cell on each side. */
bool corner_parts(const placed_cell *a, int corner_a, const placed_cell *b, int corner_b);

/** They share a side, which is part of a side of each quad: a plane through it has one cell on each
 * side. @param side_a, side_b  the sides' indices, whatever their directions */
bool side_parts(const placed_cell *a, int side_a, const placed_cell *b, int side_b);

/** They share the two sides at a corner, which is a point of two quads only: they meet on those two
 * sides alone. */
bool two_sides_part(const placed_cell *a, int corner_a, const placed_cell *b, int corner_b);

#endif

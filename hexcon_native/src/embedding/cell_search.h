/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Pairs of cells of two patches, halved until each pair is judged. */
#ifndef HEXCON_EMBEDDING_CELL_SEARCH_H
#define HEXCON_EMBEDDING_CELL_SEARCH_H

#include <stdbool.h>

#include "meeting.h"
#include "patch_cell.h"

/** Cells of the same depth. */
typedef struct cells {
  cell a, b;
} cells;

/** MEETING_OPEN: their children are to be looked at. */
typedef meeting (*cell_judge)(void *patches, const cells *c);

/** Whether they are one cell of one patch. */
bool cells_are_same(const cells *c);

/**
 * @param patches   what judge knows the patches by
 * @param itself    both patches are one: of a cell with itself no pair of children comes twice
 * @param patience  pairs of cells to look at, at most
 */
meeting cell_search(cell_judge judge, void *patches, bool itself, int patience);

#endif

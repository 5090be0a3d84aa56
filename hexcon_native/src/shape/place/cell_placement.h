/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** First placement of layers, cells and diced tetrahedra between given points. */
#ifndef HEXCON_SHAPE_PLACE_CELL_PLACEMENT_H
#define HEXCON_SHAPE_PLACE_CELL_PLACEMENT_H

#include "base/context.h"

/** A template over two boxes that share a side: the second is the first's mirror image at y = 0. */
typedef struct double_box {
  size_t point_count;
  const double (*local)[3]; /**< [point_count] the first box is 0 .. 1, in the second y < 0 */
  int rows[2][8];           /**< of each box the rows of its corners in VTK order */
} double_box;

/**
 * Put the points of cells where the trilinear maps of their boxes take them; boxes that share
 * corners agree on the side between them.
 * @param cells   [count][point_count] rows of `points`
 * @param points  [][3] rows of the boxes' corners are read, the others written. Linear.
 */
hexcon_status place_cells(hexcon_context *context, const double_box *box, const int32_t *cells,
                          size_t count, double *points);

/** Put points at the means of up to four others: means [count][4], -1 for none. Linear. */
hexcon_status place_means(hexcon_context *context, const int32_t *means, size_t count,
                          size_t first_point, double *points);

#endif

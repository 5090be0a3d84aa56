/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "cell_placement.h"

#include <math.h>
#include <stdbool.h>

#include "base/vector.h"

static bool is_corner(const double_box *box, int row) {
  for (size_t half = 0; half < 2; half++)
    for (size_t i = 0; i < 8; i++)
      if (box->rows[half][i] == row)
        return true;
  return false;
}

/** Weight of corner i, in VTK order, at local coordinates. */
static double corner_weight(size_t i, const double at[3]) {
  bool right = i % 4 == 1 || i % 4 == 2, back = i % 4 >= 2, up = i >= 4;
  return (right ? at[0] : 1 - at[0]) * (back ? at[1] : 1 - at[1]) * (up ? at[2] : 1 - at[2]);
}

hexcon_status place_cells(hexcon_context *context, const double_box *box, const int32_t *cells,
                          size_t count, double *points) {
  hexcon_status status = HEXCON_OK;
  for (size_t row = 0; !status && row < box->point_count; row++) {
    if (is_corner(box, (int)row))
      continue;
    const double *local = box->local[row], at[3] = {local[0], fabs(local[1]), local[2]};
    const int *corners = box->rows[local[1] < 0];
    double weights[8];
    for (size_t i = 0; i < 8; i++)
      weights[i] = corner_weight(i, at);
    for (size_t c = 0; c < count; c++) {
      const int32_t *cell = cells + c * box->point_count;
      double sum[3] = {0};
      for (size_t i = 0; i < 8; i++)
        vector_add_scaled(sum, weights[i], points + 3 * (size_t)cell[corners[i]]);
      for (size_t k = 0; k < 3; k++)
        points[3 * (size_t)cell[row] + k] = sum[k];
    }
    status = context_after(context, count);
  }
  return status;
}

hexcon_status place_means(hexcon_context *context, const int32_t *means, size_t count,
                          size_t first_point, double *points) {
  hexcon_status status = HEXCON_OK;
  for (size_t p = 0; !status && p < count; p++) {
    const int32_t *of = means + 4 * p;
    size_t corners = 0;
    double sum[3] = {0};
    for (; corners < 4 && of[corners] >= 0; corners++)
      vector_add_scaled(sum, 1, points + 3 * (size_t)of[corners]);
    for (size_t k = 0; k < 3; k++)
      points[3 * (first_point + p) + k] = sum[k] / (double)corners;
    status = context_pass(context, p);
  }
  return status;
}

/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "scaled_jacobian.h"

#include "base/vector.h"
#include "hex_arrays.h"
#include "hex_tables.h"

double scaled_jacobian(const double *points, const int32_t *hex) {
  double smallest = 1;
  for (int corner = 0; corner < 8; corner++) {
    double edges[3][3], lengths = 1;
    for (int i = 0; i < 3; i++) {
      vector_subtract(points + 3 * (size_t)hex[hex_corner_neighbours[corner][i]],
                      points + 3 * (size_t)hex[corner], edges[i]);
      lengths *= vector_length(edges[i]);
    }
    double value = lengths > 0 ? vector_determinant(edges[0], edges[1], edges[2]) / lengths : -1;
    smallest = fmin(smallest, value);
  }
  return smallest;
}

hexcon_status hexcon_quality(hexcon_context *context, const double *points, size_t point_count,
                             const int32_t *hexes, size_t hex_count, double *values) {
  context_clear(context);
  hexcon_status status = check_hex_arrays(context, points, point_count, hexes, hex_count);
  for (size_t h = 0; !status && h < hex_count; h++)
    values[h] = scaled_jacobian(points, hexes + 8 * h);
  return status;
}

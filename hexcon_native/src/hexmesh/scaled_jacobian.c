/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "scaled_jacobian.h"

#include "base/vector.h"
#include "hex_arrays.h"
#include "hex_tables.h"

/** Cubes of lengths within these bounds neither over- nor underflow. */
static const double tiny = 1e-90, huge = 1e90;

/** A power of two that brings the longest edge near 1; 1 where no scaling is needed. */
static double scale_of(const double *points, const int32_t *hex) {
  double largest = 0;
  for (int e = 0; e < 12; e++)
    for (int i = 0; i < 3; i++)
      largest = fmax(largest, fabs(points[3 * (size_t)hex[hex_edges[e][1]] + (size_t)i] -
                                   points[3 * (size_t)hex[hex_edges[e][0]] + (size_t)i]));
  if ((largest > tiny && largest < huge) || largest == 0 || !isfinite(largest))
    return 1;
  int exponent;
  (void)frexp(largest, &exponent);
  return ldexp(1, exponent < -1000 ? 1000 : -exponent);
}

static double corner_value(const double *points, const int32_t *hex, int corner, double scale) {
  double edges[3][3], lengths = 1;
  for (int i = 0; i < 3; i++) {
    vector_subtract(points + 3 * (size_t)hex[hex_corner_neighbours[corner][i]],
                    points + 3 * (size_t)hex[corner], edges[i]);
    for (int k = 0; k < 3; k++)
      edges[i][k] *= scale;
    lengths *= vector_length(edges[i]);
  }
  double value = lengths > 0 ? vector_determinant(edges[0], edges[1], edges[2]) / lengths : -1;
  return value >= -1 ? value : -1; /* also where it is no number */
}

double corner_scaled_jacobian(const double *points, const int32_t *hex, int corner) {
  return corner_value(points, hex, corner, scale_of(points, hex));
}

double scaled_jacobian(const double *points, const int32_t *hex) {
  double smallest = 1, scale = scale_of(points, hex);
  for (int corner = 0; corner < 8; corner++)
    smallest = fmin(smallest, corner_value(points, hex, corner, scale));
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

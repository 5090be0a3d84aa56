/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "pair_weights.h"

#include "base/vector.h"
#include "surface/geometry.h"

static double edge_length(const surface *s, int32_t half_edge) {
  double along[3];
  vector_subtract(s->points + 3 * (size_t)half_edge_end(s, half_edge),
                  s->points + 3 * (size_t)half_edge_start(s, half_edge), along);
  return vector_length(along);
}

/** Squared binary logarithm of a ratio, at most 2^10 or 2^-10: degenerate quads stay finite. */
static double disproportion(double a, double b) {
  const double most = 10;
  double exponent = a > 0 && b > 0   ? fmin(fabs(log2(a) - log2(b)), most)
                    : a > 0 || b > 0 ? most
                                     : 0;
  return exponent * exponent;
}

static double quad_area(const surface *s, int32_t quad) {
  double normal[3];
  surface_quad_normal(s, quad, normal);
  return vector_length(normal);
}

static double fold(const surface *s, int32_t half_edge) {
  const double right_angle = 1.5707963267948966;
  double bend = surface_bend(s, half_edge) / right_angle;
  return bend * bend * bend * bend;
}

/** Sums of the lengths of a pair's edges along and across its common edge; both are 4 for two unit
 * squares, where the pair is twice as high as wide. */
static void extent(const surface *s, int32_t half_edge, double *width, double *height) {
  int32_t twin = s->twins[half_edge];
  *width = 2 * edge_length(s, half_edge) + edge_length(s, half_edge_turn(half_edge, 2)) +
           edge_length(s, half_edge_turn(twin, 2));
  *height = edge_length(s, half_edge_turn(half_edge, 1)) +
            edge_length(s, half_edge_turn(half_edge, -1)) +
            edge_length(s, half_edge_turn(twin, 1)) + edge_length(s, half_edge_turn(twin, -1));
}

static double pair_weight(const surface *s, int32_t half_edge) {
  double width, height;
  extent(s, half_edge, &width, &height);
  double areas = disproportion(quad_area(s, half_edge_quad(half_edge)),
                               quad_area(s, half_edge_quad(s->twins[half_edge])));
  return -(fold(s, half_edge) + areas / 4 + disproportion(2 * height, width) / 8);
}

void surface_pair_weights(const surface *s, double *weights) {
  for (size_t h = 0; h < 4 * s->quad_count; h++) {
    int32_t twin = s->twins[h];
    if ((int32_t)h <= twin)
      weights[h] = weights[twin] = pair_weight(s, (int32_t)h);
  }
}

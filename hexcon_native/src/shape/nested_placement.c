/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "nested_placement.h"

#include <stdbool.h>

void place_drawn_means(const int32_t *means, size_t count, size_t first, const double center[3],
                       double share, double *points) {
  for (size_t p = 0; p < count; p++) {
    const int32_t *of = means + 4 * p;
    size_t parents = 0;
    double mean[3] = {0};
    for (; parents < 4 && of[parents] >= 0; parents++)
      for (size_t k = 0; k < 3; k++)
        mean[k] += points[3 * (size_t)of[parents] + k];
    for (size_t k = 0; k < 3; k++) {
      mean[k] /= (double)parents;
      points[3 * (first + p) + k] = mean[k] + share * (center[k] - mean[k]);
    }
  }
}

/** Weights of the corners of the triangle in which a place lies. */
static void triangle_weights(double u, double v, double weights[4]) {
  bool lower = v <= u;
  weights[0] = lower ? 1 - u : 1 - v;
  weights[1] = lower ? u - v : 0;
  weights[2] = lower ? v : u;
  weights[3] = lower ? 0 : v - u;
}

split_place split_place_at(const double local[3], const int corners[4], const int edges[4],
                           int middle, double share) {
  const int grid[3][3] = {{corners[0], edges[0], corners[1]},
                          {edges[3], middle, edges[1]},
                          {corners[3], edges[2], corners[2]}};
  size_t column = local[0] > 0.5, row = local[1] > 0.5;
  double u = 2 * local[0] - (double)column, v = 2 * local[1] - (double)row, inner[4];
  triangle_weights(local[0], local[1], inner);
  split_place place = {.center_weight = local[2] * share};
  for (size_t i = 0; i < 4; i++) {
    size_t right = i % 2, up = i / 2;
    place.rows[i] = grid[row + up][column + right];
    place.weights[i] = (1 - local[2]) * (right ? u : 1 - u) * (up ? v : 1 - v);
    place.rows[4 + i] = corners[i];
    place.weights[4 + i] = local[2] * (1 - share) * inner[i];
  }
  return place;
}

void place_over_split_quad(const split_place *place, const int32_t *quad_points, int32_t id,
                           const double center[3], double *points) {
  double *out = points + 3 * (size_t)id;
  for (size_t k = 0; k < 3; k++)
    out[k] = place->center_weight * center[k];
  for (size_t i = 0; i < 8 && (i < 4 || place->center_weight < 1); i++)
    for (size_t k = 0; k < 3; k++)
      out[k] += place->weights[i] * points[3 * (size_t)quad_points[place->rows[i]] + k];
}

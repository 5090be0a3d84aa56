/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "nested_placement.h"

#include <stdbool.h>
#include <string.h>

static void take_mean(const int32_t *of, const double *points, double mean[3]) {
  size_t parents = 0;
  memset(mean, 0, 3 * sizeof *mean);
  for (; parents < 4 && of[parents] >= 0; parents++)
    for (size_t k = 0; k < 3; k++)
      mean[k] += points[3 * (size_t)of[parents] + k];
  for (size_t k = 0; k < 3; k++)
    mean[k] /= (double)parents;
}

hexcon_status place_plain_means(hexcon_context *context, const int32_t *means, size_t count,
                                size_t first, double *points) {
  hexcon_status status = HEXCON_OK;
  for (size_t p = 0; !status && p < count; p++) {
    take_mean(means + 4 * p, points, points + 3 * (first + p));
    status = context_pass(context, p);
  }
  return status;
}

hexcon_status place_drawn_means(hexcon_context *context, const int32_t *means, size_t count,
                                size_t first, const anchors *to, double share, double *points) {
  hexcon_status status = HEXCON_OK;
  for (size_t p = 0; !status && p < count; p++) {
    double mean[3];
    const double *anchor = anchor_of(to, first + p);
    take_mean(means + 4 * p, points, mean);
    for (size_t k = 0; k < 3; k++)
      points[3 * (first + p) + k] = mean[k] + share * (anchor[k] - mean[k]);
    status = context_pass(context, p);
  }
  return status;
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
  split_place place = {0};
  for (size_t i = 0; i < 4; i++) {
    size_t right = i % 2, up = i / 2;
    place.rows[i] = grid[row + up][column + right];
    place.weights[i] = (1 - local[2]) * (right ? u : 1 - u) * (up ? v : 1 - v);
    place.rows[4 + i] = corners[i];
    place.weights[4 + i] = local[2] * (1 - share) * inner[i];
    place.anchor_weights[i] = local[2] * share * inner[i];
  }
  return place;
}

static void add_weighted(const double *place, double weight, double *out) {
  for (size_t k = 0; k < 3; k++)
    out[k] += weight * place[k];
}

void place_over_split_quad(const split_place *place, const int32_t *quad_points, int32_t id,
                           const anchors *to, double *points) {
  double *out = points + 3 * (size_t)id;
  memset(out, 0, 3 * sizeof *out);
  for (size_t i = 0; i < 8; i++)
    if (place->weights[i] != 0) /* corners may be of no use here, and not placed yet */
      add_weighted(points + 3 * (size_t)quad_points[place->rows[i]], place->weights[i], out);
  for (size_t i = 0; i < 4; i++)
    if (place->anchor_weights[i] != 0)
      add_weighted(anchor_of(to, (size_t)quad_points[place->rows[4 + i]]), place->anchor_weights[i],
                   out);
}

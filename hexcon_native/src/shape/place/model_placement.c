/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "model_placement.h"

#include <string.h>

#include "base/vector.h"
#include "hexmesh/hex_tables.h"

static void mean_of(const double *points, size_t count, double mean[3]) {
  memset(mean, 0, 3 * sizeof *mean);
  for (size_t i = 0; i < count; i++)
    vector_add_scaled(mean, 1 / (double)count, points + 3 * i);
}

/** x -> target + matrix (x - source). */
typedef struct affine {
  double matrix[3][3], source[3], target[3];
} affine;

/** Least squares: rows of the matrix solve the same symmetric system, by Cramer's rule. */
static affine fit(const double *model, const double *points, size_t count) {
  affine map;
  double spread[3][3] = {{0}}, products[3][3] = {{0}};
  mean_of(model, count, map.source);
  mean_of(points, count, map.target);
  for (size_t i = 0; i < count; i++) {
    double from[3], to[3];
    vector_subtract(model + 3 * i, map.source, from);
    vector_subtract(points + 3 * i, map.target, to);
    for (int k = 0; k < 3; k++) {
      vector_add_scaled(spread[k], from[k], from);
      vector_add_scaled(products[k], to[k], from);
    }
  }
  const double determinant = vector_determinant(spread[0], spread[1], spread[2]);
  for (int k = 0; k < 3; k++) {
    const double *b = products[k];
    map.matrix[k][0] = vector_determinant(b, spread[1], spread[2]) / determinant;
    map.matrix[k][1] = vector_determinant(spread[0], b, spread[2]) / determinant;
    map.matrix[k][2] = vector_determinant(spread[0], spread[1], b) / determinant;
  }
  return map;
}

static void apply(const affine *map, const double in[3], double out[3]) {
  double offset[3];
  vector_subtract(in, map->source, offset);
  for (int k = 0; k < 3; k++)
    out[k] = map->target[k] + vector_dot(map->matrix[k], offset);
}

void model_placement_affine(const placed_mesh *m, const double *model) {
  const affine map = fit(model, m->points, m->boundary_count);
  for (size_t i = m->boundary_count; i < m->point_count; i++)
    apply(&map, model + 3 * i, m->points + 3 * i);
}

double model_placement_misfit(const double *points, size_t count, const double *model) {
  const affine map = fit(model, points, count);
  double sum = 0;
  for (size_t i = 0; i < count; i++) {
    double there[3], gap[3];
    apply(&map, model + 3 * i, there);
    vector_subtract(there, points + 3 * i, gap);
    sum += vector_dot(gap, gap);
  }
  return sum / (double)count;
}

/** From `start` to the boundary in `m`, whose inner points follow. */
static hexcon_status travel(hexcon_context *context, const placed_mesh *m, double *start,
                            uint8_t *fixed, bool *arrived) {
  const hexcon_morph_options options = {.boundary_only = true};
  const size_t inner = m->point_count - m->boundary_count;
  double reached = 0;
  memset(fixed, 1, m->boundary_count);
  memset(fixed + m->boundary_count, 0, inner);
  hexcon_status status = hexcon_morph(context, start, m->point_count, m->hexes, m->hex_count, fixed,
                                      m->points, &options, start, &reached);
  *arrived = reached == 1;
  if (status == HEXCON_NOT_CERTIFIED) { /* the affine image is turned inside out, or flat */
    context_clear(context);
    status = HEXCON_OK;
  }
  memcpy(m->points + 3 * m->boundary_count, start + 3 * m->boundary_count,
         3 * inner * sizeof *start);
  return status;
}

hexcon_status model_placement_homotopy(hexcon_context *context, const placed_mesh *m,
                                       const double *model, bool *arrived) {
  double *start = context_allocate(context, m->point_count, 3 * sizeof *start);
  uint8_t *fixed = context_allocate(context, m->point_count, sizeof *fixed);
  hexcon_status status = start && fixed ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  *arrived = false;
  if (!status) {
    const affine map = fit(model, m->points, m->boundary_count);
    model_placement_affine(m, model);
    for (size_t i = 0; i < m->point_count; i++)
      apply(&map, model + 3 * i, start + 3 * i);
    status = travel(context, m, start, fixed, arrived);
  }
  context_free(context, start);
  context_free(context, fixed);
  return status;
}

/** One inner point to the mean of its neighbours, one counted as often as hexes have the edge. */
static void relax(const placed_mesh *m, int32_t point) {
  double sum[3] = {0};
  size_t count = 0;
  for (size_t h = 0; h < m->hex_count; h++)
    for (int e = 0; e < 12; e++) {
      const int32_t a = m->hexes[8 * h + hex_edges[e][0]], b = m->hexes[8 * h + hex_edges[e][1]];
      if (a != point && b != point)
        continue;
      vector_add_scaled(sum, 1, m->points + 3 * (a == point ? b : a));
      count++;
    }
  for (int k = 0; k < 3 && count > 0; k++)
    m->points[3 * (size_t)point + (size_t)k] = sum[k] / (double)count;
}

void mean_placement(const placed_mesh *m) {
  enum { SWEEPS = 60 };
  double mean[3];
  mean_of(m->points, m->boundary_count, mean);
  for (size_t i = m->boundary_count; i < m->point_count; i++)
    memcpy(m->points + 3 * i, mean, sizeof mean);
  for (int sweep = 0; sweep < SWEEPS; sweep++)
    for (size_t i = m->boundary_count; i < m->point_count; i++)
      relax(m, (int32_t)i);
}

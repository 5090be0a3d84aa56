/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "tangent_spaces.h"

#include <string.h>

#include "base/vector.h"

hexcon_status tangent_spaces_new(hexcon_context *context, size_t count, tangent_spaces *out) {
  *out = (tangent_spaces){.count = count};
  out->freedom = context_allocate(context, count, sizeof *out->freedom);
  out->directions = context_allocate_zeroed(context, count, 3 * sizeof *out->directions);
  out->trial = context_allocate_zeroed(context, count, 3 * sizeof *out->trial);
  if (!out->freedom || !out->directions || !out->trial)
    return HEXCON_OUT_OF_MEMORY;
  memset(out->freedom, 3, count);
  return HEXCON_OK;
}

void tangent_spaces_free(hexcon_context *context, tangent_spaces *spaces) {
  context_free(context, spaces->freedom);
  context_free(context, spaces->directions);
  context_free(context, spaces->trial);
  memset(spaces, 0, sizeof *spaces);
}

static void restrict_vector(const tangent_spaces *spaces, size_t point, double v[3]) {
  const double *direction = spaces->directions + 3 * point;
  double along = vector_dot(direction, v);
  if (spaces->freedom[point] == 2)
    vector_add_scaled(v, -along, direction);
  for (int k = 0; spaces->freedom[point] == 1 && k < 3; k++)
    v[k] = along * direction[k];
}

void tangent_spaces_restrict(const tangent_spaces *spaces, double *vector) {
  for (size_t i = 0; i < spaces->count; i++)
    restrict_vector(spaces, i, vector + 3 * i);
}

static void restrict_block(const tangent_spaces *spaces, size_t row, size_t column, double b[9]) {
  for (int i = 0; i < 3 && spaces->freedom[column] < 3; i++)
    restrict_vector(spaces, column, b + 3 * i);
  for (int j = 0; j < 3 && spaces->freedom[row] < 3; j++) {
    double v[3] = {b[j], b[3 + j], b[6 + j]};
    restrict_vector(spaces, row, v);
    for (int i = 0; i < 3; i++)
      b[3 * i + j] = v[i];
  }
}

/** A diagonal block, restricted, and `weight` across the space. */
static void stiffen(const tangent_spaces *spaces, size_t point, double weight, double b[9]) {
  const double *d = spaces->directions + 3 * point;
  bool curve = spaces->freedom[point] == 1;
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      b[3 * i + j] += weight * (curve ? (double)(i == j) - d[i] * d[j] : d[i] * d[j]);
}

void tangent_spaces_restrict_matrix(const tangent_spaces *spaces, block_matrix *m) {
  for (size_t i = 0; i < m->row_count; i++) {
    double *diagonal = m->blocks[m->starts[i]];
    double weight = (diagonal[0] + diagonal[4] + diagonal[8]) / 3;
    for (size_t k = m->starts[i]; k < m->starts[i + 1]; k++)
      restrict_block(spaces, i, (size_t)m->columns[k], m->blocks[k]);
    if (spaces->freedom[i] < 3)
      stiffen(spaces, i, weight > 0 ? weight : 1, diagonal);
  }
}

hexcon_status tangent_spaces_retract(hexcon_context *context, tangent_spaces *spaces, double *x) {
  return spaces->retract(spaces->user, context, x, spaces->trial);
}

void tangent_spaces_accept(tangent_spaces *spaces) {
  memcpy(spaces->directions, spaces->trial, 3 * spaces->count * sizeof *spaces->directions);
}

hexcon_status patch_put_on(hexcon_context *context, patch *p) {
  if (!p->spaces)
    return HEXCON_OK;
  hexcon_status status = tangent_spaces_retract(context, p->spaces, p->x);
  if (!status)
    tangent_spaces_accept(p->spaces);
  return status;
}

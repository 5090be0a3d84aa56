/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "block_matrix.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "shape/place/conjugate_gradients.h"

/** Hexes at each free point: starts[i] .. starts[i + 1]. */
static hexcon_status list_hexes_at(hexcon_context *context, const patch *p, size_t **starts,
                                   int32_t **hexes) {
  *starts = context_allocate_zeroed(context, p->free_count + 2, sizeof **starts);
  *hexes = context_allocate(context, p->hex_count, 8 * sizeof **hexes);
  if (!*starts || !*hexes)
    return HEXCON_OUT_OF_MEMORY;
  for (size_t i = 0; i < 8 * p->hex_count; i++)
    if ((size_t)p->corners[i] < p->free_count)
      (*starts)[p->corners[i] + 2]++;
  for (size_t v = 2; v < p->free_count + 2; v++)
    (*starts)[v] += (*starts)[v - 1];
  for (size_t i = 0; i < 8 * p->hex_count; i++)
    if ((size_t)p->corners[i] < p->free_count)
      (*hexes)[(*starts)[p->corners[i] + 1]++] = (int32_t)(i / 8);
  return HEXCON_OK;
}

static int compare_ids(const void *a, const void *b) {
  int32_t left = *(const int32_t *)a, right = *(const int32_t *)b;
  return (left > right) - (left < right);
}

/** Columns of one row behind the diagonal; seen[j] == row marks those listed. Returns their
 * number; with columns == NULL they are only counted. */
static size_t list_columns(const patch *p, const int32_t *hexes, size_t hex_count, int32_t row,
                           int32_t *seen, int32_t *columns) {
  size_t count = 0;
  for (size_t h = 0; h < hex_count; h++)
    for (size_t c = 0; c < 8; c++) {
      int32_t j = p->corners[8 * (size_t)hexes[h] + c];
      if (j <= row || (size_t)j >= p->free_count || seen[j] == row)
        continue;
      seen[j] = row;
      if (columns)
        columns[count] = j;
      count++;
    }
  if (columns)
    qsort(columns, count, sizeof *columns, compare_ids);
  return count;
}

static hexcon_status build_pattern(hexcon_context *context, const patch *p, const size_t *starts,
                                   const int32_t *hexes, int32_t *seen, block_matrix *m) {
  memset(seen, -1, p->free_count * sizeof *seen);
  m->starts[0] = 0;
  for (size_t i = 0; i < p->free_count; i++)
    m->starts[i + 1] =
        m->starts[i] + 1 +
        list_columns(p, hexes + starts[i], starts[i + 1] - starts[i], (int32_t)i, seen, NULL);
  m->columns = context_allocate(context, m->starts[p->free_count], sizeof *m->columns);
  m->blocks = context_allocate(context, m->starts[p->free_count], sizeof *m->blocks);
  if (!m->columns || !m->blocks)
    return HEXCON_OUT_OF_MEMORY;
  memset(seen, -1, p->free_count * sizeof *seen);
  for (size_t i = 0; i < p->free_count; i++) {
    int32_t *row = m->columns + m->starts[i];
    row[0] = (int32_t)i;
    (void)list_columns(p, hexes + starts[i], starts[i + 1] - starts[i], (int32_t)i, seen, row + 1);
  }
  return HEXCON_OK;
}

hexcon_status block_matrix_new(hexcon_context *context, const patch *p, block_matrix *out) {
  *out = (block_matrix){.row_count = p->free_count};
  size_t *starts = NULL;
  int32_t *hexes = NULL, *seen = context_allocate(context, p->free_count, sizeof *seen);
  out->starts = context_allocate(context, p->free_count + 1, sizeof *out->starts);
  out->inverse = context_allocate(context, p->free_count, sizeof *out->inverse);
  bool ready = seen && out->starts && out->inverse;
  for (int i = 0; i < 5; i++) {
    out->work[i] = context_allocate(context, p->free_count, 3 * sizeof *out->work[i]);
    ready = ready && out->work[i];
  }
  hexcon_status status = ready ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (!status)
    status = list_hexes_at(context, p, &starts, &hexes);
  if (!status)
    status = build_pattern(context, p, starts, hexes, seen, out);
  context_free(context, seen);
  context_free(context, starts);
  context_free(context, hexes);
  return status;
}

void block_matrix_free(hexcon_context *context, block_matrix *m) {
  context_free(context, m->starts);
  context_free(context, m->columns);
  context_free(context, m->blocks);
  context_free(context, m->inverse);
  for (int i = 0; i < 5; i++)
    context_free(context, m->work[i]);
  memset(m, 0, sizeof *m);
}

void block_matrix_clear(block_matrix *m) {
  memset(m->blocks, 0, m->starts[m->row_count] * sizeof *m->blocks);
}

double *block_matrix_at(const block_matrix *m, int32_t low, int32_t high) {
  size_t first = m->starts[low], last = m->starts[low + 1] - 1;
  while (first < last) {
    size_t middle = (first + last) / 2;
    if (m->columns[middle] < high)
      first = middle + 1;
    else
      last = middle;
  }
  return m->blocks[first];
}

/** out += B v. */
static inline void add_block(const double b[9], const double v[3], double out[3]) {
  for (int i = 0; i < 3; i++)
    out[i] += b[3 * i] * v[0] + b[3 * i + 1] * v[1] + b[3 * i + 2] * v[2];
}

/** out += factor B' v. */
static inline void add_transposed(const double b[9], double factor, const double v[3],
                                  double out[3]) {
  for (int i = 0; i < 3; i++)
    out[i] += factor * (b[i] * v[0] + b[3 + i] * v[1] + b[6 + i] * v[2]);
}

static void multiply(void *user, const double *v, double *out) {
  const block_matrix *m = user;
  memset(out, 0, 3 * m->row_count * sizeof *out);
  for (size_t i = 0; i < m->row_count; i++) {
    double sum[3] = {0, 0, 0};
    size_t k = m->starts[i];
    add_block(m->blocks[k], v + 3 * i, sum);
    for (k++; k < m->starts[i + 1]; k++) {
      size_t j = (size_t)m->columns[k];
      add_block(m->blocks[k], v + 3 * j, sum);
      add_transposed(m->blocks[k], 1, v + 3 * i, out + 3 * j);
    }
    for (size_t c = 0; c < 3; c++)
      out[3 * i + c] += sum[c];
  }
}

/** Inverse of a symmetric positive block by cofactors; a multiple of the identity where it is too
 * flat for that. */
static void invert_block(const double b[9], double inverse[9]) {
  double rows[3][3];
  vector_cross(b + 3, b + 6, rows[0]);
  vector_cross(b + 6, b, rows[1]);
  vector_cross(b, b + 3, rows[2]);
  double determinant = vector_dot(b, rows[0]), trace = b[0] + b[4] + b[8];
  bool flat = !(determinant > 1e-14 * trace * trace * trace);
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      inverse[3 * i + j] =
          flat ? (double)(i == j) / (trace > 0 ? trace : 1) : rows[j][i] / determinant;
}

/** z = (D + U)^-1 D (D + L)^-1 r; r is overwritten. */
static void precondition(const block_matrix *m, double *r, double *z) {
  for (size_t i = 0; i < m->row_count; i++) {
    double *solved = z + 3 * i;
    memset(solved, 0, 3 * sizeof *solved);
    add_block(m->inverse[i], r + 3 * i, solved);
    for (size_t k = m->starts[i] + 1; k < m->starts[i + 1]; k++)
      add_transposed(m->blocks[k], -1, solved, r + 3 * (size_t)m->columns[k]);
  }
  for (size_t i = m->row_count; i-- > 0;) {
    double sum[3] = {0, 0, 0}, correction[3] = {0, 0, 0};
    for (size_t k = m->starts[i] + 1; k < m->starts[i + 1]; k++)
      add_block(m->blocks[k], z + 3 * (size_t)m->columns[k], sum);
    add_block(m->inverse[i], sum, correction);
    vector_subtract(z + 3 * i, correction, z + 3 * i);
  }
}

static void precondition_copy(void *user, const double *in, double *out) {
  const block_matrix *m = user;
  memcpy(m->work[4], in, 3 * m->row_count * sizeof *in);
  precondition(m, m->work[4], out);
}

hexcon_status block_matrix_solve(hexcon_context *context, block_matrix *m, const double *b,
                                 double tolerance, size_t limit, double *x) {
  for (size_t i = 0; i < m->row_count; i++)
    invert_block(m->blocks[m->starts[i]], m->inverse[i]);
  memset(x, 0, 3 * m->row_count * sizeof *x);
  linear_system system = {3 * m->row_count,
                          multiply,
                          precondition_copy,
                          m,
                          {m->work[0], m->work[1], m->work[2], m->work[3]}};
  return conjugate_gradients(context, &system, b, tolerance, limit, x);
}

/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "bit_matrix.h"

#include <string.h>

hexcon_status bit_matrix_new(hexcon_context *context, size_t count, bit_matrix *out) {
  *out = (bit_matrix){.count = count, .words = (count + 63) / 64};
  size_t size = out->words > 0 && count > SIZE_MAX / out->words ? SIZE_MAX : count * out->words;
  out->rows = context_allocate_zeroed(context, size, sizeof *out->rows);
  return out->rows ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

void bit_matrix_free(hexcon_context *context, bit_matrix *matrix) {
  context_free(context, matrix->rows);
  *matrix = (bit_matrix){0};
}

static void add_row(uint64_t *to, const uint64_t *from, size_t words) {
  for (size_t w = 0; w < words; w++)
    to[w] ^= from[w];
}

hexcon_status bit_matrix_is_projection(hexcon_context *context, const bit_matrix *matrix,
                                       bool *projection) {
  const bit_matrix *m = matrix;
  uint64_t *row = context_allocate(context, m->words, sizeof *row);
  if (!row)
    return HEXCON_OUT_OF_MEMORY;
  hexcon_status status = HEXCON_OK;
  *projection = true;
  for (size_t i = 0; !status && i < m->count && *projection; i++) {
    memset(row, 0, m->words * sizeof *row);
    for (size_t k = 0; k < m->count; k++)
      if (bit_matrix_get(m, i, k))
        add_row(row, m->rows + k * m->words, m->words);
    *projection = memcmp(row, m->rows + i * m->words, m->words * sizeof *row) == 0;
    status = context_after(context, m->count * m->words);
  }
  context_free(context, row);
  return status;
}

static void swap_rows(uint64_t *a, uint64_t *b, size_t words) {
  for (size_t w = 0; w < words; w++) {
    uint64_t kept = a[w];
    a[w] = b[w];
    b[w] = kept;
  }
}

hexcon_status bit_matrix_rank(hexcon_context *context, const bit_matrix *matrix, size_t *rank) {
  bit_matrix m;
  hexcon_status status = bit_matrix_new(context, matrix->count, &m);
  if (status)
    return status;
  memcpy(m.rows, matrix->rows, m.count * m.words * sizeof *m.rows);
  *rank = 0;
  for (size_t column = 0; !status && column < m.count; column++) {
    size_t pivot = *rank;
    while (pivot < m.count && !bit_matrix_get(&m, pivot, column))
      pivot++;
    if (pivot == m.count)
      continue;
    uint64_t *head = m.rows + *rank * m.words;
    swap_rows(head, m.rows + pivot * m.words, m.words);
    for (size_t row = pivot + 1; row < m.count; row++)
      if (bit_matrix_get(&m, row, column))
        add_row(m.rows + row * m.words, head, m.words);
    ++*rank;
    status = context_after(context, m.count * m.words);
  }
  bit_matrix_free(context, &m);
  return status;
}

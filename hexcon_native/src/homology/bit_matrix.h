/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Square matrices over the field of two elements. */
#ifndef HEXCON_HOMOLOGY_BIT_MATRIX_H
#define HEXCON_HOMOLOGY_BIT_MATRIX_H

#include "base/context.h"

typedef struct bit_matrix {
  size_t count, words; /**< rows, and words of 64 bits in each */
  uint64_t *rows;      /**< [count][words] */
} bit_matrix;

/** All zero. @return OUT_OF_MEMORY */
hexcon_status bit_matrix_new(hexcon_context *context, size_t count, bit_matrix *out);
void bit_matrix_free(hexcon_context *context, bit_matrix *matrix);

static inline bool bit_matrix_get(const bit_matrix *m, size_t row, size_t column) {
  return m->rows[row * m->words + column / 64] >> (column % 64) & 1;
}

static inline void bit_matrix_add(bit_matrix *m, size_t row, size_t column, bool value) {
  m->rows[row * m->words + column / 64] ^= (uint64_t)value << (column % 64);
}

/** Whether the matrix is its own square. Cost: count^3 / 64. @return OUT_OF_MEMORY */
hexcon_status bit_matrix_is_projection(hexcon_context *context, const bit_matrix *matrix,
                                       bool *projection);
/** Cost: count^3 / 64. @return OUT_OF_MEMORY */
hexcon_status bit_matrix_rank(hexcon_context *context, const bit_matrix *matrix, size_t *rank);

#endif

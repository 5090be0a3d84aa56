/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Symmetric sparse matrices of 3 x 3 blocks over the free points of a patch. */
#ifndef HEXCON_SHAPE_IMPROVE_BLOCK_MATRIX_H
#define HEXCON_SHAPE_IMPROVE_BLOCK_MATRIX_H

#include "patch.h"

/** Blocks on and right of the diagonal; each row begins with its diagonal block. */
typedef struct block_matrix {
  size_t row_count;
  size_t *starts;       /**< [row_count + 1] into columns and blocks */
  int32_t *columns;     /**< ascending behind the diagonal */
  double (*blocks)[9];  /**< row-major */
  double (*inverse)[9]; /**< [row_count] of the diagonal blocks, see block_matrix_factor */
  double *work[5];      /**< [3 row_count] each */
} block_matrix;

/** Points are coupled if they share a hex. All blocks are left unset.
 * @param out free with block_matrix_free, also after an error. Linear in the patch. */
hexcon_status block_matrix_new(hexcon_context *context, const patch *p, block_matrix *out);
void block_matrix_free(hexcon_context *context, block_matrix *m);

void block_matrix_clear(block_matrix *m);

/** The block of two coupled points, low <= high. */
double *block_matrix_at(const block_matrix *m, int32_t low, int32_t high);

/**
 * Solve M x = b roughly, by conjugate gradients with a symmetric Gauss-Seidel preconditioner.
 * @param x  [3 row_count] receives the solution
 * @param tolerance  as for conjugate_gradients. Cost: two products per iteration.
 */
hexcon_status block_matrix_solve(hexcon_context *context, block_matrix *m, const double *b,
                                 double tolerance, size_t limit, double *x);

#endif

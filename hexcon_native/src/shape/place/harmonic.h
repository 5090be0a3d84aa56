/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Harmonic extension of functions given on the rim of a quad mesh. */
#ifndef HEXCON_SHAPE_PLACE_HARMONIC_H
#define HEXCON_SHAPE_PLACE_HARMONIC_H

#include "base/context.h"

/**
 * The extensions made so far are kept as a basis, orthonormal on the rim: extension is linear, so
 * a function in their span costs no solve. The rims of a sweep's levels differ smoothly, and a
 * handful of solves serves hundreds of levels.
 */
enum { HARMONIC_MAX_BASIS = 32 };

typedef struct harmonic {
  size_t point_count, quad_count, basis_count;
  const int32_t *quads; /**< [quad_count][4] */
  const uint8_t *fixed; /**< [point_count] non-zero on the rim */
  double *degree;       /**< [point_count] */
  double *work[7]; /**< [point_count] four for the solver, its right side and result, leftover */
  double *basis[HARMONIC_MAX_BASIS];
} harmonic;

/** @param out free with harmonic_free, also after an error. Linear. */
hexcon_status harmonic_new(hexcon_context *context, const int32_t *quads, size_t quad_count,
                           const uint8_t *fixed, size_t point_count, harmonic *out);
void harmonic_free(hexcon_context *context, harmonic *h);

/**
 * Fill the inner rows of `values` [point_count] with the function that is harmonic for the graph
 * Laplacian of the quads' edges and equals the given rows on the rim up to `tolerance`.
 * Cost: linear, plus conjugate gradients (quad_count^1.5) where the basis does not span it.
 */
hexcon_status harmonic_extend(hexcon_context *context, harmonic *h, double tolerance,
                              double *values);

#endif

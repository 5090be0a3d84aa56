/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Tetrahedra in what cells leave inside. */
#ifndef HEXCON_SOLVE_COMMON_CLOSURE_H
#define HEXCON_SOLVE_COMMON_CLOSURE_H

#include "base/context.h"

typedef enum closure_kind { CLOSURE_STAR, CLOSURE_TETRAHEDRA } closure_kind;

/** Corners are 0 .. inner_count - 1 for the inner surface's points, then the new ones. */
typedef struct closure {
  size_t tetrahedron_count, point_count; /**< of new points */
  int32_t *tetrahedra;                   /**< [tetrahedron_count][4] positive */
  double *points;                        /**< [point_count][3] */
} closure;

/** One tetrahedron from every triangle to the centre. Linear.
 * @param out free with closure_free, also after an error */
hexcon_status closure_star(hexcon_context *context, size_t inner_count, const int32_t *triangles,
                           size_t triangle_count, const double center[3], closure *out);

/**
 * Those that the caller's tetrahedral mesher finds, checked: positive, and bounded by exactly the
 * given triangles.
 * @param found  receives whether there are any: a mesher may fail. Linear (expected).
 */
hexcon_status closure_tetrahedra(hexcon_context *context, const double *inner, size_t inner_count,
                                 const int32_t *triangles, size_t triangle_count,
                                 const hexcon_mesh_options *options, closure *out, bool *found);
void closure_free(hexcon_context *context, closure *c);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Points and hexes in a surface that a method tries out, and what they are worth. */
#ifndef HEXCON_SOLVE_COMMON_FILLED_MESH_H
#define HEXCON_SOLVE_COMMON_FILLED_MESH_H

#include "base/context.h"

typedef struct filled_mesh {
  double *points, *quality;
  int32_t *hexes;
  size_t point_count, hex_count;
  size_t outer_hexes; /**< the first ones, of a stage of their own; 0: not told apart */
  size_t rounds;      /**< of improvement so far */
  size_t inverted;    /**< hexes not proved positive */
  double worst, mean;
} filled_mesh;

/** Errors: OUT_OF_MEMORY. @param out  free with filled_mesh_free, also after an error */
hexcon_status filled_mesh_new(hexcon_context *context, size_t point_count, size_t hex_count,
                              filled_mesh *out);
void filled_mesh_free(hexcon_context *context, filled_mesh *mesh);

/** Find the quality of every hex, the worst and the mean, and how many are not proved positive. */
hexcon_status filled_mesh_measure(hexcon_context *context, filled_mesh *mesh);

/** Improve it as improve_mesh does, the first fixed_count points at rest, and measure it. */
hexcon_status filled_mesh_improve(hexcon_context *context, size_t fixed_count,
                                  const hexcon_optimize_options *options, filled_mesh *mesh);

#endif

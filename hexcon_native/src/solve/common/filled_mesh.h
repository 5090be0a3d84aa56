/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Points and hexes in a surface that a method tries out, and what they are worth. */
#ifndef HEXCON_SOLVE_COMMON_FILLED_MESH_H
#define HEXCON_SOLVE_COMMON_FILLED_MESH_H

#include "mesh_result.h"

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

/** What makes one mesh better than another, after fewer inverted hexes. */
typedef struct mesh_taste {
  double enough;     /**< a worst scaled Jacobian above this counts as this */
  double clearly;    /**< the worst decides if they differ by more .. */
  double clear_mean; /**< .. then the mean if those do; INFINITY: it does not count .. */
  bool fewer;        /**< .. then fewer hexes are better; else neither is */
} mesh_taste;

/** What is compared. */
typedef struct mesh_worth {
  size_t inverted, hex_count;
  double worst, mean;
} mesh_worth;

bool mesh_worth_exceeds(const mesh_worth *a, const mesh_worth *b, const mesh_taste *taste);

/** Any mesh is better than one without points. */
bool filled_mesh_is_better(const filled_mesh *a, const filled_mesh *b, const mesh_taste *taste);

/**
 * Give the arrays to the result, with the figures that every method has; the mesh is empty then.
 * @param bound       of the worst scaled Jacobian that this topology can have on this surface
 * @param quad_count  of the surface
 */
void filled_mesh_hand_over(filled_mesh *from, double bound, size_t quad_count, hexcon_mesh *mesh);

/** Improve it as improve_mesh does, the first fixed_count points at rest, and measure it. */
hexcon_status filled_mesh_improve(hexcon_context *context, size_t fixed_count,
                                  const hexcon_optimize_options *options, filled_mesh *mesh);

/** The same with any points at rest. @param fixed [point_count] non-zero: the point stays */
hexcon_status filled_mesh_improve_free(hexcon_context *context, const uint8_t *fixed,
                                       const hexcon_optimize_options *options, filled_mesh *mesh);

#endif

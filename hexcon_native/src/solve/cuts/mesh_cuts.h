/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Bodies with holes through them, by methods that fill balls. */
#ifndef HEXCON_SOLVE_CUTS_MESH_CUTS_H
#define HEXCON_SOLVE_CUTS_MESH_CUTS_H

#include "solve/common/method_function.h"

/** When a method is tried on the ball which the cuts leave. */
typedef enum ball_turn {
  BALL_ALWAYS,     /**< for every way to cut */
  BALL_IF_NONE,    /**< for a few ways, where there is no mesh */
  BALL_IF_INVALID, /**< for a few ways and small balls, where no mesh is valid: it takes long */
  BALL_TURNS
} ball_turn;

typedef struct ball_method {
  method_function fill;
  const char *done; /**< in words: what became of the ball, "is swept" */
  ball_turn turn;
} ball_method;

/**
 * Cut a body to a ball: a layer of hexes across every handle, then a method for balls on what is
 * left, then all hexes are improved together. Of several ways to cut the best is kept: fewest
 * inverted hexes, then the highest worst scaled Jacobian, then the mean, then the fewest hexes.
 * @param s        of one component and with holes
 * @param methods  [method_count] tried in this order until a mesh is good
 * @param mesh     receives points, hexes, quality and figures; what it held before must be nothing
 * @return NO_SHEETS where no loop cuts a handle, or no ball that was left could be filled;
 * OUT_OF_MEMORY, TOO_LARGE, CANCELLED, OUT_OF_TIME. Cost: near-linear for each handle and way, and
 * that of the methods.
 */
hexcon_status mesh_cuts(hexcon_context *context, const surface *s,
                        const hexcon_mesh_options *options, const ball_method *methods,
                        size_t method_count, hexcon_mesh *mesh);

#endif

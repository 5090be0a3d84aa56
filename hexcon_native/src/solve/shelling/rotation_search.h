/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Which edges to rotate so that the dual loops of a surface can be taken away one by one. */
#ifndef HEXCON_SOLVE_SHELLING_ROTATION_SEARCH_H
#define HEXCON_SOLVE_SHELLING_ROTATION_SEARCH_H

#include "construct/rotated_shell.h"
#include "solve/common/visited_sets.h"
#include "surface/loop_crossings.h"

/** A surface after some rotations. */
typedef struct rotated_surface {
  surface s;      /**< without points */
  uint8_t *depth; /**< [quad_count] shells that the quad has been rotated in */
  loop_crossings crossings;
  double irregularity; /**< squares of what degrees lack or have too much */
  size_t core;         /**< quads left when loops are taken away as long as that is easy; 0: none */
  double score;
  uint64_t key;  /**< of the set of edges */
  uint32_t node; /**< its last rotation; NO_ROTATION: none */
} rotated_surface;

/** A rotation and the one before it. */
typedef struct rotation_node {
  edge_rotation rotation;
  uint8_t shell;
  uint32_t before;
} rotation_node;

typedef struct rotation_candidate {
  double score;
  uint64_t key;
  uint32_t parent;
  edge_rotation rotation;
} rotation_candidate;

/**
 * A beam: all surfaces of a step have as many rotations behind them. Better ones have loops that
 * cross themselves, or each other more than twice, less often, and degrees nearer to what the
 * corners' angles suggest.
 */
typedef struct rotation_search {
  size_t step;            /**< rotations of the present surfaces */
  size_t width, count;    /**< most of them, and how many there are */
  double core_weight;     /**< of a quad that remains when loops are taken away, in crossings */
  rotated_surface *kept;  /**< [width] best first */
  size_t candidate_count; /**< rotations that were weighed for the present surfaces */
  /* Private. */
  const double *points;
  rotated_surface *next; /* [BRANCHES * width] */
  double *ideal;         /* [point_count] degrees */
  int threads;
  crossing_counter *counters; /* [threads] */
  visited_sets visited;       /* surfaces met */
  size_t node_count, node_room, candidate_room;
  size_t *counts; /* [width] candidates of each surface */
  rotation_node *nodes;
  rotation_candidate *candidates;
} rotation_search;

/** Start at the surface itself.
 * @param s        with points
 * @param threads  0: one per processor; the result does not depend on it
 * @param out  free with rotation_search_free, also after an error */
hexcon_status rotation_search_begin(hexcon_context *context, const surface *s, size_t width,
                                    double core_weight, int threads, rotation_search *out);
void rotation_search_free(hexcon_context *context, rotation_search *search);

/** One rotation more in every surface kept; count is 0 if there are none left.
 * Cost: quadratic in the quads for each surface. Errors: OUT_OF_MEMORY. */
hexcon_status rotation_search_advance(hexcon_context *context, rotation_search *search);

/** The rotations that lead to surface number `index`.
 * @param out  free with rotation_plan_free, also after an error */
hexcon_status rotation_search_plan(hexcon_context *context, const rotation_search *search,
                                   size_t index, rotation_plan *out);
void rotation_plan_free(hexcon_context *context, rotation_plan *plan);

#endif

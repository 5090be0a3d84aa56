/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** A body whose handles are cut one after the other. */
#ifndef HEXCON_SOLVE_CUTS_CUT_BODY_H
#define HEXCON_SOLVE_CUTS_CUT_BODY_H

#include "construct/handle_cut.h"

typedef struct cut_body {
  surface s;        /**< what is left to fill; s.points is `points`. The points of the surface that
                         was cut first are the first ones, and all are still there */
  double *points;   /**< [s.point_count][3] */
  uint64_t *labels; /**< [4 s.quad_count] of half-edges: what they add up to along a closed path is
                         0 if it bounds inside; all 0: not known */
  size_t hex_count, cut_count;
  int32_t *hexes; /**< [hex_count][8] of the layers, corners are points of s */
} cut_body;

/** A cut with the places of its points. */
typedef struct placed_cut {
  disc_pattern disc;
  double *sides[2]; /**< [disc.point_count][3] of the left and the right disc, the rim's first */
} placed_cut;

/** Handles left: the genus. @param s  of one component */
static inline size_t body_handle_count(const surface *s) {
  return (s->quad_count + 2 - s->point_count) / 2;
}

/** Nothing is cut yet. Cost: that of linking_numbers_find. Errors: OUT_OF_MEMORY, CANCELLED,
 * OUT_OF_TIME. @param out free with cut_body_free, also after an error */
hexcon_status cut_body_begin(hexcon_context *context, const surface *s, cut_body *out);
void cut_body_free(hexcon_context *context, cut_body *body);

/**
 * Cut a handle.
 * @param ring  [cut->disc.rim_count] as handle_cut has it
 * @param out   the body after the cut, without points: what is left would be no proper surface, or
 *              not of one handle less. Free with cut_body_free, also after an error
 * Linear. Errors: OUT_OF_MEMORY, TOO_LARGE, CANCELLED, OUT_OF_TIME.
 */
hexcon_status cut_body_cut(hexcon_context *context, const cut_body *body, const int32_t *ring,
                           const placed_cut *cut, cut_body *out);

/** Place a disc's copies in both rails of a ring. @param disc  it goes to `out`
 * @param out free with placed_cut_free, also after an error */
hexcon_status placed_cut_new(hexcon_context *context, const surface *s, const int32_t *ring,
                             const disc_shape *shape, placed_cut *out);
void placed_cut_free(hexcon_context *context, placed_cut *cut);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** A copy of a surface inside it: an inward offset that keeps clear of itself. */
#ifndef HEXCON_SHAPE_OFFSET_INNER_SURFACE_H
#define HEXCON_SHAPE_OFFSET_INNER_SURFACE_H

#include "surface/half_edges.h"

typedef struct inner_surface_options {
  double center[3]; /**< sees the corner triangles of the surface, but for a few folded ones */
  double thickness; /**< wanted depth below the surface, in mean edge lengths there */
  double depth;     /**< at most this part of the way from a quad's plane to the centre, < 1 */
  bool no_center;   /**< no point sees the surface, of whatever genus and however many shells */
} inner_surface_options;

/**
 * Place the points of the copy. Each goes inward where it sees all its quads' planes sink alike,
 * by a depth that varies smoothly; where boxes between the quads and their copies would be folded,
 * or the centre would not see the copy, it is drawn towards a copy shrunk to the centre, which is
 * always possible. Without a centre a copy goes at most a third of the way to the opposite side,
 * and rises towards the surface where it is folded or crosses something, as long as that helps:
 * what comes of it is not proved.
 * @param inner  [point_count][3] receives the points
 * Errors: OUT_OF_MEMORY, TOO_LARGE. Linear; without a centre expected linear.
 */
hexcon_status inner_surface_place(hexcon_context *context, const surface *s,
                                  const inner_surface_options *options, double *inner);

#endif

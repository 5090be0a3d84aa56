/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Quads that fill a disc whose rim has given edges. */
#ifndef HEXCON_CONSTRUCT_DISC_PATTERN_H
#define HEXCON_CONSTRUCT_DISC_PATTERN_H

#include "base/context.h"

/** A grid of a * b quads, and rings of quads around it: of 2 (a + b) edges along the rim. */
typedef struct disc_shape {
  size_t a, b;
  size_t rings; /**< 0: the grid's corners lie on the rim */
  size_t first; /**< the rim's corner at, or outside, the grid's first one; a edges on, the next */
} disc_shape;

typedef struct disc_pattern {
  size_t rim_count, point_count, quad_count;
  int32_t *quads; /**< [quad_count][4] counter-clockwise; corners 0 .. rim_count - 1 are the rim's,
                       in this sense */
} disc_pattern;

size_t disc_shape_quads(const disc_shape *shape);

/** The rim's edge at the other end of the row of quads that begins at an edge; edge i follows
 * corner i. */
size_t disc_shape_across(const disc_shape *shape, size_t edge);

/** @param out free with disc_pattern_free, also after an error. Linear. Errors: OUT_OF_MEMORY,
 * TOO_LARGE. */
hexcon_status disc_pattern_build(hexcon_context *context, const disc_shape *shape,
                                 disc_pattern *out);
void disc_pattern_free(hexcon_context *context, disc_pattern *pattern);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * The coarse surface of triangles and quads that a quad surface is the subdivision of: every coarse
 * edge split in two, every coarse face cut about a point into a quad at each of its corners.
 *
 * So every quad has a coarse corner, the middle of an edge, the centre of a face, and another
 * middle, in this order either way round. Which of its four points is the corner decides the same
 * for its neighbours, and so for the whole shell: there are four ways at most to read one.
 */
#ifndef HEXCON_CONSTRUCT_COARSE_SURFACE_H
#define HEXCON_CONSTRUCT_COARSE_SURFACE_H

#include "surface/half_edges.h"

enum { COARSE_WAYS = 4 };

typedef struct coarse_surface {
  size_t point_count;
  int32_t *points; /**< [point_count] the surface's id of each coarse corner, ascending */
  size_t triangle_count, quad_count;
  int32_t *faces;   /**< [triangle_count + quad_count][4] coarse corners, counter-clockwise from
                         outside: triangles, with -1 last, then quads */
  int32_t *middles; /**< [..][4] the surface's ids in the middle of sides i, i + 1; -1 as above */
  int32_t *centers; /**< [..] the surface's ids */
  double departure; /**< of middles and centres from the means of their corners, in lengths of the
                         sides, on average; 0 without points */
} coarse_surface;

/**
 * Read a surface as a subdivision.
 * @param ways        [component_count] 0 .. 3: which corner of the first quad of each shell is a
 *                    coarse one
 * @param out         free with coarse_surface_free, also after an error
 * @param fault_count receives the number of points and edges that do not fit; may be NULL
 * Errors: NOT_DICED with the quads at which the classes of points contradict each other, at a
 * middle or centre of the wrong number of edges, or at one of two coarse edges between the same
 * points; OUT_OF_MEMORY. Linear (expected: hashing).
 */
hexcon_status coarse_surface_read(hexcon_context *context, const surface *s, const uint8_t *ways,
                                  coarse_surface *out, size_t *fault_count);
void coarse_surface_free(hexcon_context *context, coarse_surface *c);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * What a coarse surface leaves for tetrahedra once a template stands on each of its quads: diced
 * triangles only.
 *
 * Pyramids leave the coarse triangles and their own sides. Labels of the template: B corners, E the
 * middles of the edges from B i to B i + 1 and Bc the centre of the base, which is seen
 * counter-clockwise from inside; A the apex, M the middles of the edges from B i to it, G the
 * centres of the sides.
 *
 * Geodes, where all coarse faces are quads, leave a copy of the coarse surface inside it, each quad
 * cut into two triangles. Labels: split_closure.h.
 */
#ifndef HEXCON_CONSTRUCT_COARSE_FRONT_H
#define HEXCON_CONSTRUCT_COARSE_FRONT_H

#include "coarse_surface.h"
#include "hex_template.h"

typedef struct coarse_front {
  const hex_template *block; /**< what stands on every coarse quad */
  size_t block_count;
  int32_t *block_points;   /**< [block_count][block->point_count] ids of the mesh's points */
  size_t mesh_point_count; /**< the surface's points, then those of the blocks alone */
  size_t point_count;      /**< of the front: the coarse corners, then the apices; or the inner
                                copies of the corners */
  int32_t *points;         /**< [point_count] their ids in the mesh */
  size_t triangle_count;
  int32_t *triangles;    /**< [triangle_count][3] the front's points, counter-clockwise seen from
                              what is filled already */
  int32_t *means;        /**< [triangle_count] the mesh's ids, as dice wants them .. */
  int32_t *side_middles; /**< [triangle_count][3] .. of edges i, i + 1 */
} coarse_front;

/**
 * Number a front of pyramids.
 * @param surface_point_count  of the surface that was read
 * @param out                  free with coarse_front_free, also after an error
 * Errors: OUT_OF_MEMORY, TOO_LARGE, BAD_ARGUMENT (a damaged template). Linear.
 */
hexcon_status coarse_front_of_pyramids(hexcon_context *context, const coarse_surface *c,
                                       size_t surface_point_count, coarse_front *out);

/** The same of Geodes. @param s  the coarse surface as quads of coarse corners, in c's order */
hexcon_status coarse_front_of_geodes(hexcon_context *context, const coarse_surface *c,
                                     const surface *s, size_t surface_point_count,
                                     coarse_front *out);
void coarse_front_free(hexcon_context *context, coarse_front *front);

/** Room for so many blocks, points and triangles, whose counts are set. @return OUT_OF_MEMORY */
hexcon_status coarse_front_allocate(hexcon_context *context, coarse_front *front);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * What a coarse surface leaves for tetrahedra: its triangles, and the sides of a pyramid on each of
 * its quads, all of them diced.
 *
 * Labels of the pyramid's template: B corners, E the middles of the edges from B i to B i + 1 and
 * Bc the centre of the base, which is seen counter-clockwise from inside; A the apex, M the middles
 * of the edges from B i to it, G the centres of the sides.
 */
#ifndef HEXCON_CONSTRUCT_COARSE_FRONT_H
#define HEXCON_CONSTRUCT_COARSE_FRONT_H

#include "coarse_surface.h"
#include "hex_template.h"

typedef struct coarse_front {
  const hex_template *pyramid;
  size_t pyramid_count;
  int32_t *pyramid_points; /**< [pyramid_count][pyramid->point_count] ids of the mesh's points */
  size_t mesh_point_count; /**< the surface's points, then those of the pyramids alone */
  size_t point_count;      /**< of the front: the coarse corners, then the apices */
  int32_t *points;         /**< [point_count] their ids in the mesh */
  size_t triangle_count;
  int32_t *triangles;    /**< [triangle_count][3] the front's points, counter-clockwise seen from
                              what is filled already */
  int32_t *means;        /**< [triangle_count] the mesh's ids, as dice wants them .. */
  int32_t *side_middles; /**< [triangle_count][3] .. of edges i, i + 1 */
} coarse_front;

/**
 * Number it.
 * @param surface_point_count  of the surface that was read
 * @param out                  free with coarse_front_free, also after an error
 * Errors: OUT_OF_MEMORY, TOO_LARGE, BAD_ARGUMENT (a damaged template). Linear.
 */
hexcon_status coarse_front_build(hexcon_context *context, const coarse_surface *c,
                                 size_t surface_point_count, coarse_front *out);
void coarse_front_free(hexcon_context *context, coarse_front *front);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * What fills the inside of a four-split front: a template over every coarse quad.
 *
 * Labels of such a template: B corners, EB the middles of the edges from B i to B i + 1 and Bc the
 * centre of the base, which is seen counter-clockwise from inside; on side i the points F i, or
 * L i, R i, D i; at its inner end the apex A, or corners T, edge middles ET, and N, Ga, Gb of the
 * two triangles that the diagonal T0 - T2 makes. Templates that meet at a side share its points.
 * Source: Carbonera and Shepherd (2006), section 4.3; resources/templates/README.md.
 */
#ifndef HEXCON_CONSTRUCT_SPLIT_CLOSURE_H
#define HEXCON_CONSTRUCT_SPLIT_CLOSURE_H

#include "hex_template.h"
#include "split_front.h"

/** A template as the front's quads use it. */
typedef struct split_closure {
  const split_front *front;
  const hex_template *shape;
  uint8_t *turns; /**< [quad_count] which coarse corner, 0 or 1, is B0; NULL: 0 */
  struct closure_role *roles;
  size_t corner_points, edge_points, quad_points; /**< new ones at every coarse point, .. */
  size_t first_corner, first_edge, first_quad;    /**< ids of the first ones */
  bool has_apex;                                  /**< then its point is the last one */
  size_t point_count;                             /**< of the mesh then */
} split_closure;

/**
 * Number a closure's points. Linear.
 * @param turns  see above; kept, not copied
 * @param out    free with split_closure_free, also after an error
 * Errors: OUT_OF_MEMORY, BAD_ARGUMENT (a damaged template).
 */
hexcon_status split_closure_new(hexcon_context *context, const split_front *front,
                                const hex_template *shape, uint8_t *turns, size_t first_point,
                                split_closure *out);
void split_closure_free(hexcon_context *context, split_closure *c);

/** Ids of the template's points over one coarse quad. @param points [shape->point_count] */
void split_closure_points(const split_closure *c, size_t quad, int32_t *points);

/**
 * Choose the diagonals along which the coarse quads are cut into triangles: no two quads get one
 * between the same points, so that no triangle occurs twice (quads that share two edges have a
 * diagonal in common: cells of six have such quads).
 * @param turns  [quad_count] receives the corner, 0 or 1, from which the diagonal goes
 * Errors: OUT_OF_MEMORY. Linear (expected: hashing).
 */
hexcon_status split_closure_choose_diagonals(hexcon_context *context, const surface *s,
                                             uint8_t *turns);

#endif

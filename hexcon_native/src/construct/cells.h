/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * Cells: one domino over each pair of quads, below any layers of plain hexes.
 *
 * A domino carries two quads that share an edge to four triangles, each diced into three quads, so
 * what is left inside is bounded by a diced triangulation of the surface's points. Its six outer
 * sides are mirror images of each other, and are split by colour: any pairing fits.
 * Source: resources/templates/README.md; the problem is Eppstein's (Linear complexity hexahedral
 * mesh generation, 1999, section 4).
 */
#ifndef HEXCON_CONSTRUCT_CELLS_H
#define HEXCON_CONSTRUCT_CELLS_H

#include "hex_template.h"
#include "surface/half_edges.h"

typedef struct cell_complex {
  size_t layers;      /**< of plain hexes over the cells */
  size_t point_count; /**< the surface's points once for each level 0 .. layers, then the inner
                           ones in the same order, then those of the cells */
  size_t first_inner; /**< (layers + 1) * the surface's points */
  size_t hex_count;
  int32_t *hexes; /**< [hex_count][8] VTK order: layer by layer from outside, then cell by cell */
  const hex_template *domino;
  size_t cell_count;
  int32_t *cell_points;    /**< [cell_count][domino->point_count] */
  int32_t *triangles;      /**< [2 * quad_count][3] the surface's points, seen from outside
                                counter-clockwise: their inner ones bound what is left */
  int32_t *triangle_means; /**< [2 * quad_count] the point about which each is diced */
  int32_t *side_middles;   /**< [2 * quad_count][3] middles of edges i, i + 1 of each */
} cell_complex;

/**
 * Build it.
 * @param colours  [point_count] as surface_colour
 * @param partner  [quad_count] the half-edge of each quad across which its partner lies
 * @param out      free with cells_free, also after an error
 * Errors: OUT_OF_MEMORY, TOO_LARGE, BAD_ARGUMENT (a damaged template). Linear.
 */
hexcon_status cells_build(hexcon_context *context, const surface *s, const uint8_t *colours,
                          const int32_t *partner, size_t layers, cell_complex *out);
void cells_free(hexcon_context *context, cell_complex *cells);

#endif

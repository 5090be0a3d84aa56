/* SPDX-License-Identifier: LGPL-2.1-or-later */
/**
 * Pillowing: a set of hexes draws back from all that surrounds it, and a layer of hexes takes the
 * room between.
 * Source: Mitchell and Tautges, Pillowing doublets: refining a mesh to ensure that faces share at
 * most one edge (1995).
 */
#ifndef HEXCON_CONSTRUCT_PILLOW_H
#define HEXCON_CONSTRUCT_PILLOW_H

#include "growing_mesh.h"

/** The copies of points that the set got: of one point several, where parts of the set meet there
 * only. */
typedef struct pillow_points {
  size_t first, count;
  int32_t *originals; /**< [count] */
} pillow_points;

/**
 * Pillow a set of hexes in parts: where two parts meet, each draws back from the other.
 * @param set    [set_count] hexes, each once; they get the copies of the points on their outside
 * @param parts  [set_count] number of the part that each belongs to
 * @param mesh   grows by a hex for every face on the outside of the set
 * @param points originals are to be freed by the caller, also after an error
 * Errors: OUT_OF_MEMORY, TOO_LARGE. Cost: linear in the set, as long as few of its hexes have their
 * lowest point in common, plus points.
 */
hexcon_status pillow_hexes(hexcon_context *context, const int32_t *set, const int32_t *parts,
                           size_t set_count, growing_mesh *mesh, pillow_points *points);

#endif

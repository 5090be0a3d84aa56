/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The nearest of many triangles. */
#ifndef HEXCON_SHAPE_SLIDE_FACET_TREE_H
#define HEXCON_SHAPE_SLIDE_FACET_TREE_H

#include "base/context.h"

/** Triangles whose corners are the caller's, parted in halves by the longest side of their box,
 * down to a few. */
typedef struct facet_tree {
  const double *points;   /**< [][3] */
  const int32_t *corners; /**< [][3] */
  int32_t *order;         /**< [count] facets, those of one leaf side by side */
  double *boxes;          /**< [2 count][6] least, then largest coordinates, the root's first; of a
                             node's two halves the first follows it */
  size_t count;
} facet_tree;

/** OUT_OF_MEMORY, CANCELLED, OUT_OF_TIME. O(n log n).
 * @param facets  [count] which of them
 * @param out     free it also after an error */
hexcon_status facet_tree_new(hexcon_context *context, const double *points, const int32_t *corners,
                             const int32_t *facets, size_t count, facet_tree *out);
void facet_tree_free(hexcon_context *context, facet_tree *tree);

/** Where on a triangle a place is: the weights of its corners, which add up to 1. */
typedef struct facet_place {
  int32_t facet;
  double weights[3], foot[3];
} facet_place;

/** The place nearest to a point; of equally near ones some. O(log n) where facets are near. */
facet_place facet_tree_nearest(const facet_tree *tree, const double point[3]);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Is the complex of hexes a 3-manifold with boundary? */
#ifndef HEXCON_VERIFY_MANIFOLD_H
#define HEXCON_VERIFY_MANIFOLD_H

#include "hexmesh/point_star.h"

/** Facts of the stars entered so far. They mean something only if no side is crowded. */
typedef struct manifold {
  bool links_are_discs; /**< around every edge one fan, around every point a sphere or a disc */
  size_t edge_count;    /**< different pairs of points joined by an edge */
  size_t used_point_count;
  int32_t *hex_parent;  /**< disjoint sets of the hexes of a star, joined across faces */
  int32_t *edge_parent; /**< and of their edges at the point, 3 a hex: the fans */
  uint8_t *edge_seen;   /**< by where the other end occurs first */
} manifold;

/** @param out  free with manifold_free, also after an error */
hexcon_status manifold_new(hexcon_context *context, const point_star *star, manifold *out);
void manifold_free(hexcon_context *context, manifold *facts);

/** Enter a star; edges are entered by their lower end. All but linear in its hexes (union-find). */
void manifold_enter(manifold *facts, const point_star *star);

#endif

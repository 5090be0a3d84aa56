/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Is the complex of hexes a 3-manifold with boundary? */
#ifndef HEXCON_VERIFY_MANIFOLD_H
#define HEXCON_VERIFY_MANIFOLD_H

#include "corner_table.h"
#include "face_table.h"

typedef struct manifold_facts {
  bool links_are_discs; /**< around every edge one fan, around every point a sphere or a disc */
  size_t edge_count;    /**< different pairs of points joined by an edge */
  size_t used_point_count;
} manifold_facts;

/**
 * Check the links of all edges and points. Linear (union-find).
 * A face table without crowded sides is required for the answer to mean anything.
 */
hexcon_status manifold_check(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                             size_t point_count, const face_table *faces,
                             const corner_table *corners, manifold_facts *facts);

#endif

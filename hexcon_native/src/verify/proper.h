/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Do two hexes ever meet in more than one vertex, edge or face? */
#ifndef HEXCON_VERIFY_PROPER_H
#define HEXCON_VERIFY_PROPER_H

#include "hexmesh/face_table.h"

/** A growing list of ids. */
typedef struct id_list {
  int32_t *ids;
  size_t count, capacity;
} id_list;

/**
 * Hexes that meet another improperly, by the stars of all points. Linear: two hexes meet properly
 * exactly if every pair of points that both contain is an edge of both, or a diagonal of one face
 * of both. (Three corners of a hex contain a diagonal, as its graph has no triangle; a whole face
 * and a corner more contain a space diagonal.) So it is enough to look at the pairs of points at
 * the lower one.
 * @param improper  receives at most one id for every pair of points seen twice; free the ids
 */
hexcon_status proper_check(hexcon_context *context, const point_star *star, id_list *improper);

/**
 * Doublets: pairs of hexes that share two or more faces. Linear.
 * @param pairs  receives two ids a pair; free the ids
 */
hexcon_status proper_find_doublets(hexcon_context *context, size_t hex_count,
                                   const face_table *faces, id_list *pairs);

/** Append; OUT_OF_MEMORY. */
hexcon_status id_list_append(hexcon_context *context, id_list *list, int32_t id);

#endif

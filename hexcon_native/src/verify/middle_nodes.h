/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Do hexes of 20 nodes that share an edge share its middle node? */
#ifndef HEXCON_VERIFY_MIDDLE_NODES_H
#define HEXCON_VERIFY_MIDDLE_NODES_H

#include "proper.h"

/** Ends of the edge of each middle node, VTK_QUADRATIC_HEXAHEDRON order. */
static const unsigned char middle_node_ends[12][2] = {
    {0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};

/**
 * Hexes that meet another improperly by their middle nodes: an edge has one middle node, a middle
 * node one edge, and it is no corner. Sorts the edges of all hexes: H log H.
 * @param hexes     [hex_count][20] VTK_QUADRATIC_HEXAHEDRON order, ids in range
 * @param improper  receives hexes, some more than once; free the ids
 */
hexcon_status middle_nodes_check(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                                 size_t point_count, id_list *improper);

#endif

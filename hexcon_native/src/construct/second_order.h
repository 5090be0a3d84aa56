/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Mid-edge points of a hex mesh. */
#ifndef HEXCON_CONSTRUCT_SECOND_ORDER_H
#define HEXCON_CONSTRUCT_SECOND_ORDER_H

#include "base/context.h"

/** Every edge of a hex mesh once. */
typedef struct edge_table {
  size_t count;
  int32_t (*ends)[2]; /**< [count] points, the lower first */
  int32_t *of_hex;    /**< [12 * hex_count] edge ids in the order of VTK_QUADRATIC_HEXAHEDRON */
} edge_table;

/** Linear (expected: hashing). @param out free with edge_table_free, also after an error */
hexcon_status edge_table_build(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                               edge_table *out);
void edge_table_free(hexcon_context *context, edge_table *table);

#endif

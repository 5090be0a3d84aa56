/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** The hex corners at each point. */
#ifndef HEXCON_HEXMESH_CORNER_TABLE_H
#define HEXCON_HEXMESH_CORNER_TABLE_H

#include "base/context.h"

/** Corner 8 * hex + i; those at point v are corners[starts[v]] .. corners[starts[v + 1] - 1]. */
typedef struct corner_table {
  size_t *starts;   /**< [point_count + 1] */
  int32_t *corners; /**< [8 * hex_count] ascending at each point */
} corner_table;

/** Linear. @param out free with corner_table_free, also after an error */
hexcon_status corner_table_build(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                                 size_t point_count, corner_table *out);
void corner_table_free(hexcon_context *context, corner_table *table);

#endif

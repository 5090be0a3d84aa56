/* SPDX-License-Identifier: LGPL-2.1-or-later */
/** Numbers for sets of up to three ids, such as edges and triangles. */
#ifndef HEXCON_CONSTRUCT_TUPLE_TABLE_H
#define HEXCON_CONSTRUCT_TUPLE_TABLE_H

#include "base/context.h"

typedef struct tuple_entry {
  int32_t ids[3]; /**< ascending; an edge has -1 first */
  int32_t number;
} tuple_entry;

typedef struct tuple_table {
  size_t capacity, count; /**< capacity is a power of two */
  tuple_entry *entries;   /**< number < 0: free */
} tuple_table;

/** Room for `most` sets. @param out free with tuple_table_free, also after an error. Linear. */
hexcon_status tuple_table_new(hexcon_context *context, size_t most, tuple_table *out);
void tuple_table_free(hexcon_context *context, tuple_table *table);

/** The number of a set of ids in any order, c = -1 for an edge; `fresh` if it is new: it then has
 * that number from now on. Expected cost constant. */
int32_t tuple_table_number(tuple_table *table, int32_t a, int32_t b, int32_t c, int32_t fresh);

#endif

/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "tuple_table.h"

#include <string.h>

hexcon_status tuple_table_new(hexcon_context *context, size_t most, tuple_table *out) {
  memset(out, 0, sizeof *out);
  out->capacity = 16;
  while (out->capacity < 2 * most)
    out->capacity *= 2;
  out->entries = context_allocate(context, out->capacity, sizeof *out->entries);
  if (!out->entries)
    return HEXCON_OUT_OF_MEMORY;
  memset(out->entries, -1, out->capacity * sizeof *out->entries);
  return HEXCON_OK;
}

void tuple_table_free(hexcon_context *context, tuple_table *table) {
  context_free(context, table->entries);
  memset(table, 0, sizeof *table);
}

static void order(int32_t *low, int32_t *high) {
  if (*low > *high) {
    int32_t kept = *low;
    *low = *high;
    *high = kept;
  }
}

static size_t hash(const int32_t ids[3]) {
  uint64_t x = 0;
  for (int i = 0; i < 3; i++)
    x = (x ^ (uint32_t)ids[i]) * 0x9e3779b97f4a7c15u + (x >> 31);
  return (size_t)(x ^ (x >> 29));
}

int32_t tuple_table_number(tuple_table *table, int32_t a, int32_t b, int32_t c, int32_t fresh) {
  int32_t ids[3] = {a, b, c};
  order(&ids[0], &ids[1]);
  order(&ids[1], &ids[2]);
  order(&ids[0], &ids[1]);
  size_t slot = hash(ids) & (table->capacity - 1);
  for (; table->entries[slot].number >= 0; slot = (slot + 1) & (table->capacity - 1))
    if (memcmp(table->entries[slot].ids, ids, sizeof ids) == 0)
      return table->entries[slot].number;
  memcpy(table->entries[slot].ids, ids, sizeof ids);
  table->entries[slot].number = fresh;
  table->count++;
  return fresh;
}

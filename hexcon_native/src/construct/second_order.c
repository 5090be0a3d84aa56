/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "second_order.h"

#include <string.h>

static const unsigned char quadratic_edges[12][2] = {
    {0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};

static size_t edge_hash(int32_t low, int32_t high) {
  uint64_t x = ((uint64_t)(uint32_t)low << 32 | (uint32_t)high) * 0x9e3779b97f4a7c15u;
  return (size_t)(x ^ (x >> 29));
}

/** Id of the edge between two points, new or known. */
static int32_t edge_id(edge_table *table, int32_t *slots, size_t mask, int32_t a, int32_t b) {
  int32_t low = a < b ? a : b, high = a < b ? b : a;
  size_t slot = edge_hash(low, high) & mask;
  for (; slots[slot] >= 0; slot = (slot + 1) & mask)
    if (table->ends[slots[slot]][0] == low && table->ends[slots[slot]][1] == high)
      return slots[slot];
  slots[slot] = (int32_t)table->count;
  table->ends[table->count][0] = low;
  table->ends[table->count][1] = high;
  return (int32_t)table->count++;
}

hexcon_status edge_table_build(hexcon_context *context, const int32_t *hexes, size_t hex_count,
                               edge_table *out) {
  memset(out, 0, sizeof *out);
  size_t sides = 12 * hex_count, capacity = 16;
  while (capacity < sides)
    capacity *= 2;
  out->ends = context_allocate(context, sides, sizeof *out->ends);
  out->of_hex = context_allocate(context, sides, sizeof *out->of_hex);
  int32_t *slots = context_allocate(context, capacity, sizeof *slots);
  bool complete = out->ends && out->of_hex && slots;
  hexcon_status status = complete ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
  if (complete) {
    memset(slots, -1, capacity * sizeof *slots);
    for (size_t h = 0; !status && h < hex_count; h++) {
      for (size_t e = 0; e < 12; e++)
        out->of_hex[12 * h + e] =
            edge_id(out, slots, capacity - 1, hexes[8 * h + quadratic_edges[e][0]],
                    hexes[8 * h + quadratic_edges[e][1]]);
      status = context_pass(context, h);
    }
  }
  context_free(context, slots);
  return status;
}

void edge_table_free(hexcon_context *context, edge_table *table) {
  context_free(context, table->ends);
  context_free(context, table->of_hex);
  memset(table, 0, sizeof *table);
}

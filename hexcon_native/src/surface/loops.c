/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "loops.h"

#include <string.h>

void surface_loops_free(hexcon_context *context, surface_loops *loops) {
  context_free(context, loops->offsets);
  context_free(context, loops->entries);
  context_free(context, loops->self_crossings);
  context_free(context, loops->loop_of_passage);
  memset(loops, 0, sizeof *loops);
}

/** Follow one loop from an entry until it closes; returns the number of entries so far. */
static size_t follow(const surface *s, surface_loops *loops, int32_t start, size_t length) {
  int32_t entry = start;
  do {
    loops->entries[length++] = entry;
    loops->loop_of_passage[surface_passage(entry)] = (int32_t)loops->count;
    entry = s->twins[half_edge_turn(entry, 2)];
  } while (entry != start);
  return length;
}

static void count_self_crossings(const surface *s, surface_loops *loops) {
  for (size_t q = 0; q < s->quad_count; q++)
    if (loops->loop_of_passage[2 * q] == loops->loop_of_passage[2 * q + 1])
      loops->self_crossings[loops->loop_of_passage[2 * q]]++;
}

hexcon_status surface_find_loops(hexcon_context *context, const surface *s, surface_loops *out) {
  size_t passages = 2 * s->quad_count;
  memset(out, 0, sizeof *out);
  out->offsets = context_allocate(context, passages + 1, sizeof *out->offsets);
  out->entries = context_allocate(context, passages, sizeof *out->entries);
  out->self_crossings = context_allocate_zeroed(context, passages, sizeof *out->self_crossings);
  out->loop_of_passage = context_allocate(context, passages, sizeof *out->loop_of_passage);
  if (!out->offsets || !out->entries || !out->self_crossings || !out->loop_of_passage)
    return HEXCON_OUT_OF_MEMORY;
  memset(out->loop_of_passage, -1, passages * sizeof *out->loop_of_passage);
  size_t length = 0;
  out->offsets[0] = 0;
  for (size_t p = 0; p < passages; p++) {
    if (out->loop_of_passage[p] >= 0)
      continue;
    length = follow(s, out, (int32_t)(4 * (p / 2) + p % 2), length);
    out->offsets[++out->count] = length;
  }
  count_self_crossings(s, out);
  return context_after(context, passages);
}

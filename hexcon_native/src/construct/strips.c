/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "strips.h"

#include <string.h>

void strips_free(hexcon_context *context, strip_table *table) {
  context_free(context, table->strips);
  context_free(context, table->entries);
  context_free(context, table->strip_of_loop);
  context_free(context, table->ring_of_loop);
  memset(table, 0, sizeof *table);
}

static size_t loop_length(const surface_loops *loops, int32_t loop) {
  return loops->offsets[loop + 1] - loops->offsets[loop];
}

/**
 * The entry beside `entry` in a loop that runs parallel on one side, all the way round; -1 if
 * there is none. The quads on that side must follow each other as those of the loop do.
 */
static int32_t parallel_entry(const surface *s, const surface_loops *loops, int32_t entry,
                              int32_t (*beside)(const surface *, int32_t)) {
  int32_t here = loops->loop_of_passage[surface_passage(entry)];
  int32_t first = beside(s, entry), at = entry, side = first;
  int32_t there = loops->loop_of_passage[surface_passage(first)];
  if (there == here || loops->self_crossings[there] ||
      loop_length(loops, there) != loop_length(loops, here))
    return -1;
  do {
    at = ring_next(s, at);
    side = ring_next(s, side);
    if (beside(s, at) != side)
      return -1;
  } while (at != entry);
  return first;
}

/** From a loop to the left end of its strip; `cyclic` if there is no end. */
static int32_t left_end(const surface *s, const surface_loops *loops, int32_t entry, bool *cyclic) {
  int32_t start = loops->loop_of_passage[surface_passage(entry)];
  *cyclic = false;
  for (;;) {
    int32_t left = parallel_entry(s, loops, entry, ring_left);
    if (left < 0)
      return entry;
    if (loops->loop_of_passage[surface_passage(left)] == start) {
      *cyclic = true;
      return left;
    }
    entry = left;
  }
}

static void collect_strip(const surface *s, const surface_loops *loops, int32_t entry,
                          strip_table *table) {
  strip *collected = &table->strips[table->count];
  entry = left_end(s, loops, entry, &collected->cyclic);
  int32_t first = loops->loop_of_passage[surface_passage(entry)], loop = first;
  collected->first = table->count ? collected[-1].first + collected[-1].ring_count : 0;
  collected->length = loop_length(loops, loop);
  collected->ring_count = 0;
  for (;;) {
    table->entries[collected->first + collected->ring_count] = entry;
    table->strip_of_loop[loop] = (int32_t)table->count;
    table->ring_of_loop[loop] = (int32_t)collected->ring_count++;
    entry = parallel_entry(s, loops, entry, ring_right);
    if (entry < 0)
      break;
    loop = loops->loop_of_passage[surface_passage(entry)];
    if (loop == first)
      break;
  }
  table->count++;
}

hexcon_status strips_build(hexcon_context *context, const surface *s, const surface_loops *loops,
                           strip_table *out) {
  memset(out, 0, sizeof *out);
  out->strips = context_allocate(context, loops->count, sizeof *out->strips);
  out->entries = context_allocate(context, loops->count, sizeof *out->entries);
  out->strip_of_loop = context_allocate(context, loops->count, sizeof *out->strip_of_loop);
  out->ring_of_loop = context_allocate(context, loops->count, sizeof *out->ring_of_loop);
  if (!out->strips || !out->entries || !out->strip_of_loop || !out->ring_of_loop)
    return HEXCON_OUT_OF_MEMORY;
  memset(out->strip_of_loop, -1, loops->count * sizeof *out->strip_of_loop);
  memset(out->ring_of_loop, -1, loops->count * sizeof *out->ring_of_loop);
  for (size_t loop = 0; loop < loops->count; loop++)
    if (!loops->self_crossings[loop] && out->strip_of_loop[loop] < 0)
      collect_strip(s, loops, loops->entries[loops->offsets[loop]], out);
  return HEXCON_OK;
}

/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "loop_crossings.h"

#include <string.h>

#include "loops.h"

hexcon_status crossing_counter_new(hexcon_context *context, size_t quad_count,
                                   crossing_counter *out) {
  size_t passages = 2 * quad_count;
  out->loop_of_passage = context_allocate(context, passages, sizeof *out->loop_of_passage);
  out->passages = context_allocate(context, passages, sizeof *out->passages);
  out->counts = context_allocate_zeroed(context, passages, sizeof *out->counts);
  return out->loop_of_passage && out->passages && out->counts ? HEXCON_OK : HEXCON_OUT_OF_MEMORY;
}

void crossing_counter_free(hexcon_context *context, crossing_counter *counter) {
  context_free(context, counter->loop_of_passage);
  context_free(context, counter->passages);
  context_free(context, counter->counts);
  memset(counter, 0, sizeof *counter);
}

/** Follow all loops. @return their number */
static size_t follow_loops(const surface *s, crossing_counter *counter) {
  size_t loops = 0, length = 0;
  memset(counter->loop_of_passage, -1, 2 * s->quad_count * sizeof *counter->loop_of_passage);
  for (size_t p = 0; p < 2 * s->quad_count; p++) {
    if (counter->loop_of_passage[p] >= 0)
      continue;
    int32_t start = (int32_t)(4 * (p / 2) + p % 2), entry = start;
    do {
      size_t passage = surface_passage(entry);
      counter->loop_of_passage[passage] = (int32_t)loops;
      counter->passages[length++] = (int32_t)passage;
      entry = s->twins[half_edge_turn(entry, 2)];
    } while (entry != start);
    loops++;
  }
  return loops;
}

loop_crossings count_crossings(const surface *s, crossing_counter *counter) {
  loop_crossings c = {.loops = follow_loops(s, counter)};
  size_t passages = 2 * s->quad_count;
  for (size_t first = 0, end; first < passages; first = end) {
    int32_t loop = counter->loop_of_passage[counter->passages[first]];
    for (end = first; end < passages; end++) {
      int32_t passage = counter->passages[end];
      if (counter->loop_of_passage[passage] != loop)
        break;
      int32_t other = counter->loop_of_passage[passage ^ 1];
      c.of_themselves += other == loop && passage & 1;
      counter->counts[other]++;
    }
    for (size_t i = first; i < end; i++) {
      int32_t other = counter->loop_of_passage[counter->passages[i] ^ 1];
      if (other > loop && counter->counts[other] > 2)
        c.in_excess += (size_t)(counter->counts[other] - 2) / 2;
      counter->counts[other] = 0;
    }
  }
  return c;
}

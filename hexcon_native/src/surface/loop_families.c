/* SPDX-License-Identifier: LGPL-2.1-or-later */
#include "loop_families.h"

#include <string.h>

static hexcon_status check_simple(hexcon_context *context, const surface *s,
                                  const surface_loops *loops) {
  size_t count = 0;
  for (size_t q = 0; q < s->quad_count; q++)
    if (loops->loop_of_passage[2 * q] == loops->loop_of_passage[2 * q + 1]) {
      context_add_element(context, (int32_t)q);
      count++;
    }
  if (count)
    return context_fail(context, HEXCON_SELF_CROSSING,
                        "dual loops cross themselves at %zu quads (listed): such loops cannot be "
                        "split; pair these quads",
                        count);
  return HEXCON_OK;
}

/** The loop that crosses another one where that enters a quad. */
static int32_t crossing_loop(const surface_loops *loops, int32_t entry) {
  return loops->loop_of_passage[surface_passage(entry) ^ 1];
}

/** Two families, breadth first; false where a third is needed. */
static bool part_in_two(const surface_loops *loops, int32_t *families, int32_t *queue) {
  memset(families, -1, loops->count * sizeof *families);
  for (size_t root = 0; root < loops->count; root++) {
    if (families[root] >= 0)
      continue;
    size_t head = 0, tail = 0;
    families[root] = 0;
    queue[tail++] = (int32_t)root;
    while (head < tail) {
      int32_t loop = queue[head++];
      for (size_t i = loops->offsets[loop]; i < loops->offsets[loop + 1]; i++) {
        int32_t other = crossing_loop(loops, loops->entries[i]);
        if (families[other] == families[loop])
          return false;
        if (families[other] < 0) {
          families[other] = 1 - families[loop];
          queue[tail++] = other;
        }
      }
    }
  }
  return true;
}

/** Each loop gets the first family that no loop across it has yet. Returns how many there are. */
static size_t part_greedily(const surface_loops *loops, int32_t *families, int32_t *taken_by) {
  size_t count = 0;
  memset(families, -1, loops->count * sizeof *families);
  memset(taken_by, -1, loops->count * sizeof *taken_by);
  for (size_t loop = 0; loop < loops->count; loop++) {
    for (size_t i = loops->offsets[loop]; i < loops->offsets[loop + 1]; i++) {
      int32_t family = families[crossing_loop(loops, loops->entries[i])];
      if (family >= 0)
        taken_by[family] = (int32_t)loop;
    }
    size_t family = 0;
    while (taken_by[family] == (int32_t)loop)
      family++;
    families[loop] = (int32_t)family;
    count = family >= count ? family + 1 : count;
  }
  return count;
}

hexcon_status surface_loop_families(hexcon_context *context, const surface *s,
                                    const surface_loops *loops, int32_t *family_of_loop,
                                    size_t *family_count) {
  hexcon_status status = check_simple(context, s, loops);
  if (status)
    return status;
  int32_t *room = context_allocate(context, loops->count, sizeof *room);
  if (!room)
    return HEXCON_OUT_OF_MEMORY;
  *family_count =
      part_in_two(loops, family_of_loop, room) ? 2 : part_greedily(loops, family_of_loop, room);
  context_free(context, room);
  return HEXCON_OK;
}
